// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// S-expressions: lists in parentheses of words, quoted texts and lists, as KiCad writes its files. The tree keeps where
// each node begins and ends, so that a file can be changed in one place and stay the same in every other byte. `#` as
// the first sign of a line begins a comment. Guarantee: any bytes give a tree or an Error with the place
// "name:line:column"; lists nest kDeepest deep at most. Cost: linear. Keywords: Lisp, SPECCTRA DSN lexer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/number/real.h"
#include "findspace/error.h"

namespace findspace::io {

class SexprTree;

/// A node of a tree, which must outlive it.
class Sexpr {
 public:
  Sexpr(const SexprTree& tree, std::uint32_t index) : tree_(&tree), index_(index) {}

  bool is_list() const;
  /// The first word of a list, or nothing: "(at 1 2)" is `at`.
  std::string_view head() const;
  bool is(std::string_view name) const { return is_list() && head() == name; }
  /// A word, or a quoted text without its quotes.
  std::string text() const;
  /// The children after the head.
  std::vector<Sexpr> items() const;
  /// The first child list with that head, or nothing.
  std::optional<Sexpr> find(std::string_view head) const;
  /// The same; throws Error where there is none.
  Sexpr need(std::string_view head) const;
  /// Whether one of the children is that word: "(via blind ...)".
  bool has_word(std::string_view word) const;
  /// The child number k after the head; throws where there are fewer.
  Sexpr item(std::size_t k) const;
  /// A decimal number, exactly.
  exact::Real number() const;

  /// The bytes of the node: [begin, end).
  std::size_t begin() const;
  std::size_t end() const;
  /// "board.kicad_pcb:12:5".
  std::string place() const;
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const;

  template <class Visit>
  void each(Visit visit) const;

 private:
  const SexprTree* tree_;
  std::uint32_t index_;
};

class SexprTree {
 public:
  static constexpr int kDeepest = 200;
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30;

  /// Reads one list and nothing after it. The text is kept as a view: it must outlive the tree.
  SexprTree(std::string_view text, std::string name);

  Sexpr root() const { return {*this, 0}; }
  std::string_view text() const { return text_; }
  const std::string& name() const { return name_; }

 private:
  friend class Sexpr;
  enum class Kind : std::uint8_t { kList, kWord, kText };
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  struct Node {
    std::uint32_t begin, end;
    std::uint32_t next = kNone;   // the sibling after it
    std::uint32_t first = kNone;  // of a list: its first child
    Kind kind;
  };

  void parse();
  std::size_t skip_blanks(std::size_t at) const;
  std::size_t end_of_text(std::size_t at) const;
  std::size_t end_of_word(std::size_t at) const;
  [[noreturn]] void fail(std::size_t at, const std::string& message) const;

  std::string place(std::size_t at) const;

  std::string_view text_;
  std::string name_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> lines_{0};  // where each begins
};

template <class Visit>
void Sexpr::each(Visit visit) const {
  if (!is_list()) return;
  std::uint32_t child = tree_->nodes_[index_].first;
  if (child != SexprTree::kNone && tree_->nodes_[child].kind == SexprTree::Kind::kWord)
    child = tree_->nodes_[child].next;
  for (; child != SexprTree::kNone; child = tree_->nodes_[child].next) visit(Sexpr(*tree_, child));
}

}  // namespace findspace::io
