// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/cursor.h"

#include "formula/language/text.h"

namespace findspace::formula {

Cursor::Cursor(std::string_view text) : source_(text), lexer_(text) {
  for (std::size_t ahead = 0; ahead <= kAhead; ++ahead) read_ahead(ahead);
}

const Token& Cursor::peek(std::size_t ahead) const {
  const Token& token = window_[(at_ + ahead) % window_.size()];
  if (token.kind == Token::Kind::kFault) fail_with(ErrorCode::kSyntax, token.span, token.text);
  return token;
}

bool Cursor::at_word(std::string_view word, std::size_t ahead) const {
  const Token& token = peek(ahead);
  return token.kind == Token::Kind::kName && token.text == word;
}

/// After the end, or a fault, there is nothing else.
void Cursor::read_ahead(std::size_t ahead) {
  const Token& before = window_[(at_ + ahead + kAhead + 1) % window_.size()];
  const bool last = ahead > 0 && (before.kind == Token::Kind::kEnd || before.kind == Token::Kind::kFault);
  window_[(at_ + ahead) % window_.size()] = last ? before : lexer_.next();
}

const Token& Cursor::take() {
  const Token& token = peek();
  if (token.kind == Token::Kind::kEnd) return token;
  end_ = token.span.end;
  at_ = (at_ + 1) % window_.size();
  read_ahead(kAhead);
  return token;
}

bool Cursor::accept(Token::Kind kind) {
  if (!at(kind)) return false;
  take();
  return true;
}

bool Cursor::accept_word(std::string_view word) {
  if (!at_word(word)) return false;
  take();
  return true;
}

void Cursor::fail_with(ErrorCode code, Span span, const std::string& message) const {
  throw source_.error(code, span, message);
}

std::string Cursor::found() const {
  const Token& token = peek();
  return token.kind == Token::Kind::kEnd ? "the end" : fmt::format("'{}'", printable(source_.text(token.span)));
}

void Cursor::fail_unclosed(Span open) const {
  fail_syntax("missing ')' for the '(' at {}, found {}", source_.place(open), found());
}

}  // namespace findspace::formula
