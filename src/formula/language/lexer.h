// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the text of a formula to its words and signs, each with its place, and from a place to a message that shows
// it: line, column, the line itself and a caret under the fault. UTF-8; the signs of the literature (∧ ∨ ¬ ≤ ≥ ≠ → −)
// give the same tokens as their ASCII spelling. Columns count characters, not bytes.
//
// A character that begins nothing becomes a token that says so; the fault is raised when the parser arrives there,
// so that the first mistake of a text is the one reported. Cost: linear. Never fails itself, whatever the bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/error.h"
#include "formula/language/names.h"

namespace findspace::formula {

/// Bytes [begin, end) of a text.
struct Span {
  std::size_t begin = 0, end = 0;
};

/// A text with the means to point into it.
class Source {
 public:
  explicit Source(std::string_view text) : text_(text) {}
  std::string_view text() const { return text_; }
  std::string_view text(Span span) const { return text_.substr(span.begin, span.end - span.begin); }
  /// "line:column", both from 1.
  std::string place(Span span) const;
  /// The error at `span`: its place is "line:column", its message is followed by the line and a caret.
  Error error(ErrorCode code, Span span, const std::string& message) const;

 private:
  std::string_view text_;
};

struct Token {
  enum class Kind : std::uint8_t {
    kName,    // a word: and, gamma1, board, mm
    kQuoted,  // "my part" or 'my part'; `text` holds it without quotes and escapes
    kNumber,  // digits without sign; `text` is ready for exact::Real::parse_decimal
    kRelation,
    kArrow,
    kAnd,  // the signs only; the words and, or, not are kName, for a shape may be called so
    kOr,
    kNot,
    kOpen,
    kClose,
    kOpenBracket,
    kCloseBracket,
    kComma,
    kPlus,
    kMinus,
    kTimes,
    kOver,
    kFault,  // `text` is the message
    kEnd
  };
  Kind kind = Kind::kEnd;
  Span span;
  std::string text;
  Relation relation = Relation::kEqual;  // of kRelation
};

/// The tokens of a text, one after another: nothing is kept of those that were read.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}
  /// Not to be called any more after kEnd or kFault.
  Token next();

 private:
  std::string_view rest() const { return text_.substr(at_); }
  void skip_blanks();
  Token token(Token::Kind kind, std::size_t size, std::string text = {});
  Token number(std::size_t size);
  Token quoted();
  Token sign();
  Token stray();

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t number_end_ = 0;  // of the last number; 0 if there was none
};

/// Whether a shape's name can stand in a formula without quotes.
bool is_identifier(std::string_view name);

/// A name as a formula has to spell it: itself, or in double quotes.
std::string quoted_if_needed(std::string_view name);

bool is_utf8(std::string_view text);

/// Text made fit for a message: control characters, marks that turn its direction and bytes that are not UTF-8 become
/// '?'.
std::string printable(std::string_view text);

/// "'a', 'b', 'c'" for a message; of more than eight names the first eight and an ellipsis.
std::string listed(const std::vector<std::string>& names);

}  // namespace findspace::formula
