// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/sexpr.h"

#include <fmt/format.h>

#include <algorithm>

namespace findspace::io {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

}  // namespace

SexprTree::SexprTree(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text_.size() > kMostBytes) throw Error(ErrorCode::kUnsupported, "a file of more than 2^30 bytes", name_);
  nodes_.reserve(text_.size() / 8);
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n') lines_.push_back(static_cast<std::uint32_t>(i + 1));
  parse();
}

void SexprTree::fail(std::size_t at, const std::string& message) const {
  throw Error(ErrorCode::kSyntax, message, place(at));
}

std::string SexprTree::place(std::size_t at) const {
  const auto after = std::upper_bound(lines_.begin(), lines_.end(), at);
  return fmt::format("{}:{}:{}", name_, after - lines_.begin(), at - *(after - 1) + 1);
}

/// Past blanks and comment lines.
std::size_t SexprTree::skip_blanks(std::size_t at) const {
  bool fresh = at == 0;
  while (at < text_.size()) {
    if (fresh && text_[at] == '#') {
      while (at < text_.size() && text_[at] != '\n') ++at;
    } else if (is_blank(text_[at])) {
      fresh = fresh || text_[at] == '\n';
      ++at;
    } else {
      break;
    }
  }
  return at;
}

/// Past the quote that closes the text that opens at `at`.
std::size_t SexprTree::end_of_text(std::size_t at) const {
  for (std::size_t i = at + 1; i < text_.size(); ++i) {
    if (text_[i] == '\\') {
      ++i;
    } else if (text_[i] == '"') {
      return i + 1;
    }
  }
  fail(at, "a quoted text that does not end");
}

std::size_t SexprTree::end_of_word(std::size_t at) const {
  while (at < text_.size() && !is_blank(text_[at]) && text_[at] != '(' && text_[at] != ')' && text_[at] != '"') ++at;
  return at;
}

void SexprTree::parse() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;  // lists, each with its last child
  std::size_t at = skip_blanks(0);
  if (at == text_.size() || text_[at] != '(') fail(at, "a list in parentheses is meant here");
  const auto add = [&](Kind kind, std::size_t begin, std::size_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), kNone, kNone, kind});
    if (open.empty()) return index;
    auto& [list, last] = open.back();
    (last == kNone ? nodes_[list].first : nodes_[last].next) = index;
    last = index;
    return index;
  };
  do {
    const char c = text_[at];
    if (c == '(') {
      if (open.size() == kDeepest) fail(at, fmt::format("lists nested more than {} deep", kDeepest));
      open.emplace_back(add(Kind::kList, at, at), kNone);
      ++at;
    } else if (c == ')') {
      nodes_[open.back().first].end = static_cast<std::uint32_t>(++at);
      open.pop_back();
    } else {
      const std::size_t end = c == '"' ? end_of_text(at) : end_of_word(at);
      add(c == '"' ? Kind::kText : Kind::kWord, at, end);
      at = end;
    }
    at = skip_blanks(at);
  } while (at < text_.size() && !open.empty());
  if (!open.empty()) fail(nodes_[open.back().first].begin, "this '(' is not closed");
  if (at < text_.size()) fail(at, "nothing may stand after the list that is the file");
}

bool Sexpr::is_list() const { return tree_->nodes_[index_].kind == SexprTree::Kind::kList; }

std::string_view Sexpr::head() const {
  const std::uint32_t first = tree_->nodes_[index_].first;
  if (first == SexprTree::kNone || tree_->nodes_[first].kind != SexprTree::Kind::kWord) return {};
  const SexprTree::Node& word = tree_->nodes_[first];
  return tree_->text_.substr(word.begin, word.end - word.begin);
}

std::string Sexpr::text() const {
  const SexprTree::Node& node = tree_->nodes_[index_];
  if (node.kind == SexprTree::Kind::kList) fail(ErrorCode::kSyntax, "a word is meant here, not a list");
  if (node.kind == SexprTree::Kind::kWord) return std::string(tree_->text_.substr(node.begin, node.end - node.begin));
  std::string out;
  for (std::size_t i = node.begin + 1; i + 1 < node.end; ++i) {
    if (tree_->text_[i] == '\\' && i + 2 < node.end) ++i;
    out += tree_->text_[i];
  }
  return out;
}

std::vector<Sexpr> Sexpr::items() const {
  std::vector<Sexpr> out;
  each([&](const Sexpr& item) { out.push_back(item); });
  return out;
}

std::optional<Sexpr> Sexpr::find(std::string_view head) const {
  const std::vector<SexprTree::Node>& nodes = tree_->nodes_;
  for (std::uint32_t k = nodes[index_].first; k != SexprTree::kNone; k = nodes[k].next)
    if (const Sexpr child(*tree_, k); child.is(head)) return child;
  return std::nullopt;
}

Sexpr Sexpr::need(std::string_view head) const {
  if (const auto child = find(head)) return *child;
  fail(ErrorCode::kSyntax, fmt::format("({} ...) without ({} ...) in it", this->head(), head));
}

bool Sexpr::has_word(std::string_view word) const {
  bool found = false;
  each([&](const Sexpr& item) { found = found || (!item.is_list() && item.text() == word); });
  return found;
}

Sexpr Sexpr::item(std::size_t k) const {
  std::optional<Sexpr> out;
  each([&](const Sexpr& child) {
    if (k-- == 0) out = child;
  });
  if (!out) fail(ErrorCode::kSyntax, fmt::format("({} ...) ends too early", head()));
  return *out;
}

exact::Real Sexpr::number() const {
  try {
    return exact::Real::parse_decimal(text());
  } catch (const Error& e) {
    throw Error(e.code(), e.message(), place());
  }
}

std::size_t Sexpr::begin() const { return tree_->nodes_[index_].begin; }
std::size_t Sexpr::end() const { return tree_->nodes_[index_].end; }
std::string Sexpr::place() const { return tree_->place(begin()); }
void Sexpr::fail(ErrorCode code, const std::string& message) const { throw Error(code, message, place()); }

}  // namespace findspace::io
