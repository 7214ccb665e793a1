// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The lower half of the parser: a cursor over the tokens, and the parts that are no conditions themselves: numbers with
// units, names of shapes, vectors, calls. Private to src/formula; users include parse.h.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formula/language/lexer.h"
#include "formula/language/parse.h"

namespace findspace::formula {

/// A number as written: what it measures is known only when its distance has been read.
struct Number {
  bool negative = false;
  std::string digits, unit;  // unit: "" if it carries none
  Span span, unit_span;
};

enum class Quantity : std::uint8_t { kLength, kAngle, kPure };

/// A number in the scene's unit (or degrees), and as it was written.
struct Level {
  exact::Real value;
  std::string written;
};

/// A distance as written: the value is `distance`, times -1 if negated.
struct Term {
  Distance distance;
  bool negated = false;
  Span span;
};

/// What stands in the parentheses of a distance or predicate.
struct Call {
  std::vector<std::string> first, second;
  Span first_span, second_span, span;
  std::optional<Number> level;
  Mode mode = Mode::kPlain;
  Span mode_span;
  std::vector<exact::Real> vector;
  std::string vector_text;
};

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

class Reader {
 public:
  static constexpr std::size_t kAhead = 2;
  Reader(std::string_view text, const Context& context);

  /// The token `ahead` of the next one, at most kAhead. Throws if it is a fault. Good until the next one is taken.
  const Token& peek(std::size_t ahead = 0) const;
  bool at(Token::Kind kind) const { return peek().kind == kind; }
  bool at_word(std::string_view word, std::size_t ahead = 0) const;
  /// Whether a number begins here.
  bool at_number() const;
  /// Good until one more is taken.
  const Token& take();
  bool accept(Token::Kind kind);
  bool accept_word(std::string_view word);
  /// The end of what has been read.
  std::size_t end() const { return end_; }

  [[noreturn]] void fail_with(ErrorCode code, Span span, const std::string& message) const;
  template <class... Values>
  [[noreturn]] void fail(ErrorCode code, Span span, fmt::format_string<Values...> pattern, Values&&... values) const {
    fail_with(code, span, fmt::format(pattern, std::forward<Values>(values)...));
  }
  /// At the next token.
  template <class... Values>
  [[noreturn]] void fail_syntax(fmt::format_string<Values...> pattern, Values&&... values) const {
    fail_with(ErrorCode::kSyntax, peek().span, fmt::format(pattern, std::forward<Values>(values)...));
  }
  /// The next token as a message names it: "'board'", "the end".
  std::string found() const;
  /// Fails at the ')' that should stand here.
  [[noreturn]] void fail_unclosed(Span open) const;

  Number number();
  Level level(const Number& number, Quantity quantity) const;
  /// Numbers up to `close`, as many as the scene has dimensions, and their text without brackets: "1, 2".
  std::vector<exact::Real> coordinates(Quantity quantity, Token::Kind close, std::string& text);

  /// Whether a word is a distance, a predicate, or one of the shapes.
  bool at_distance() const;
  /// A distance, from its prefix or name to its ')'.
  Term distance();
  /// A predicate's atom, from its name to its ')'.
  Atom predicate();
  /// Fails for a word that is neither distance nor predicate.
  [[noreturn]] void fail_unknown_word() const;
  /// "; did you mean 'X'?" or "".
  static std::string question(std::string_view word, std::span<const std::string> candidates);

  const Context& context() const { return context_; }

 private:
  /// How a call is written, for messages.
  using Usage = std::function<std::string()>;
  Call call(std::string_view word, const Usage& usage, bool is_predicate);
  void last_argument(Call& call, std::string_view word, const Usage& usage, bool is_predicate);
  void direction(Call& call, std::string_view word, bool is_predicate);
  std::vector<std::string> shapes(std::string_view word);
  std::string shape(std::string_view word);
  std::vector<std::string> names() const;  // all known shapes, in the order given
  void read_ahead(std::size_t ahead);
  [[noreturn]] void fail_unknown_shape(const Token& token) const;
  bool moves(const std::string& name) const;
  bool moves(const std::vector<std::string>& names, Span span) const;
  void check_roles(const Call& call) const;

  Source source_;
  const Context& context_;
  Lexer lexer_;
  std::array<Token, kAhead + 2> window_;  // a ring: what comes next, from at_ on, and what was taken last
  std::size_t at_ = 0, end_ = 0;
  NameSet known_;  // shapes, by names in the context
};

}  // namespace findspace::formula
