// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances and predicates of a formula with their arguments. Private to src/formula; users include parse.h.
// Guarantee: what is returned speaks of known shapes only, of which one moves and the other stands still (or, where
// shapes move on their own, of two). Cost: linear, but for the message about an unknown name.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/language/cursor.h"
#include "formula/language/parse.h"

namespace findspace::formula {

/// A distance as written: the value is `distance`, times -1 if negated.
struct Term {
  Distance distance;
  bool negated = false;
  Span span;
};

struct Call;

/// Names that are kept elsewhere: an open table without an allocation a name.
class NameSet {
 public:
  explicit NameSet(std::size_t most);
  void add(std::string_view name);
  bool contains(std::string_view name) const { return !slots_[slot(name)].empty() || (has_empty_ && name.empty()); }

 private:
  /// Where the name is, or where it has to go.
  std::size_t slot(std::string_view name) const;

  std::vector<std::string_view> slots_;  // empty: free; a power of two, at least half of them free
  bool has_empty_ = false;
};

class CallReader {
 public:
  /// Reads on from where the cursor stands. Both outlive it.
  CallReader(Cursor& cursor, const Context& context);

  /// Whether a word is a distance, a predicate, or one of the shapes.
  bool at_distance() const;
  /// A distance, from its prefix or name to its ')'.
  Term distance();
  /// Whether a rule between two lists of shapes stands here: between(G, H).
  bool at_between() const;
  /// The gaps of what moves in one of the lists to the other shapes of the other list, of which the least is meant:
  /// one a list, or where shapes move on their own one a pair. None where neither list has a shape that moves.
  std::vector<Term> between();
  /// A predicate's atom, from its name to its ')'.
  Atom predicate();

 private:
  /// How a call is written, for messages.
  using Usage = std::function<std::string()>;
  Call call(std::string_view word, const Usage& usage, bool is_predicate);
  void last_argument(Call& call, std::string_view word, const Usage& usage, bool is_predicate);
  void direction(Call& call, std::string_view word, bool is_predicate);
  std::vector<std::string> shapes(std::string_view word);
  std::vector<std::string> listed_shapes(std::string_view word);
  std::string shape(std::string_view word);
  std::vector<std::string> standing(const std::vector<std::string>& without) const;
  [[noreturn]] void fail_unknown_shape(const Token& token) const;
  /// Fails for a word that is neither distance nor predicate.
  [[noreturn]] void fail_unknown_word() const;

  Cursor& cursor_;
  const Context& context_;
  plane::WorkBudget work_;
  NameSet known_;  // shapes, by names in the context
};

}  // namespace findspace::formula
