// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A cursor over the tokens of a formula, and the errors that show where it stands. Private to src/formula; users
// include parse.h. Guarantee: an error's place is "line:column". Cost: a token is read once.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "formula/language/lexer.h"

namespace findspace::formula {

class Cursor {
 public:
  static constexpr std::size_t kAhead = 2;
  explicit Cursor(std::string_view text);

  /// The token `ahead` of the next one, at most kAhead. Throws if it is a fault. Good until the next one is taken.
  const Token& peek(std::size_t ahead = 0) const;
  bool at(Token::Kind kind) const { return peek().kind == kind; }
  bool at_word(std::string_view word, std::size_t ahead = 0) const;
  /// Good until one more is taken.
  const Token& take();
  bool accept(Token::Kind kind);
  bool accept_word(std::string_view word);
  /// The text from the next token on.
  std::string_view rest() const { return source_.text().substr(peek().span.begin); }
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

 private:
  void read_ahead(std::size_t ahead);

  Source source_;
  Lexer lexer_;
  std::array<Token, kAhead + 2> window_;  // a ring: what comes next, from at_ on, and what was taken last
  std::size_t at_ = 0, end_ = 0;
};

}  // namespace findspace::formula
