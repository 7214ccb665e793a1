// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/lexer.h"

#include <algorithm>
#include <array>
#include <utility>

namespace findspace::formula {
namespace {

constexpr char32_t kNotUtf8 = 0xFFFFFFFF;

struct Character {
  char32_t code;
  std::size_t size;  // bytes; 1 for a byte that is not UTF-8
};

/// The character at the start of a non-empty text: no surrogates, no overlong forms.
Character decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {kNotUtf8, 1};
  char32_t code = lead & (0x7F >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {kNotUtf8, 1};
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[size] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return {kNotUtf8, 1};
  return {code, size};
}

bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }

bool is_blank(char32_t c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == 0xA0 || (c >= 0x2000 && c <= 0x200A) || c == 0x202F;
}

/// Letters of any script, by exclusion: outside ASCII everything but punctuation, arrows, operators and controls.
bool is_letter(char32_t c) {
  if (c < 0x80) return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  if (c < 0xC0) return c == 0xAA || c == 0xB5 || c == 0xBA;
  constexpr std::array<std::pair<char32_t, char32_t>, 8> kSigns{{{0xD7, 0xD7},
                                                                 {0xF7, 0xF7},
                                                                 {0x2000, 0x206F},
                                                                 {0x2190, 0x2BFF},
                                                                 {0x3000, 0x3020},
                                                                 {0xE000, 0xF8FF},
                                                                 {0xFE00, 0xFEFF},
                                                                 {0xFFF0, 0xFFFF}}};
  return c <= 0x10FFFF &&
         std::none_of(kSigns.begin(), kSigns.end(), [&](const auto& s) { return c >= s.first && c <= s.second; });
}

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

/// A mark that turns the direction of what follows: text is shown in another order than it has.
bool turns_text(char32_t c) { return (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069); }

/// The length of the name at the start of `text`, 0 if there is none.
std::size_t name_length(std::string_view text) {
  const auto is_plain = [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  std::size_t length = 0;
  while (length < text.size()) {
    if (const char c = text[length]; is_plain(c) || (length > 0 && c >= '0' && c <= '9')) {
      ++length;
      continue;
    }
    // A point within a name, as of the pad U3.14.
    if (length > 0 && text[length] == '.' && length + 1 < text.size() &&
        (is_plain(text[length + 1]) || is_digit(static_cast<unsigned char>(text[length + 1])))) {
      ++length;
      continue;
    }
    const Character c = decode(text.substr(length));
    if (!is_letter(c.code) && !(length > 0 && is_digit(c.code))) break;
    length += c.size;
  }
  return length;
}

/// The length of the number at the start of `text`: 12, 1.5, .5, 2e-3; 0 if there is none.
std::size_t number_length(std::string_view text) {
  std::size_t i = 0;
  const auto skip_digits = [&] {
    const std::size_t start = i;
    while (i < text.size() && is_digit(static_cast<unsigned char>(text[i]))) ++i;
    return i > start;
  };
  bool digits = skip_digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    const bool fraction = skip_digits();
    if (!fraction) --i;
    digits = digits || fraction;
  }
  if (!digits) return 0;
  const std::size_t mantissa = i;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (!skip_digits()) i = mantissa;  // not an exponent: 2em is 2 and em
  }
  return i;
}

struct Sign {
  std::string_view text;
  Token::Kind kind;
  Relation relation = Relation::kEqual;
};

// Longer signs before their beginnings.
using K = Token::Kind;
constexpr std::array<Sign, 15> kSigns{{
    {"->", K::kArrow},
    {"→", K::kArrow},
    {"<=", K::kRelation, Relation::kLessEqual},
    {"≤", K::kRelation, Relation::kLessEqual},
    {">=", K::kRelation, Relation::kGreaterEqual},
    {"≥", K::kRelation, Relation::kGreaterEqual},
    {"!=", K::kRelation, Relation::kNotEqual},
    {"≠", K::kRelation, Relation::kNotEqual},
    {"<", K::kRelation, Relation::kLess},
    {">", K::kRelation, Relation::kGreater},
    {"=", K::kRelation, Relation::kEqual},
    {"∧", K::kAnd},
    {"∨", K::kOr},
    {"¬", K::kNot},
    {"-", K::kMinus},
}};

// What programmers and mathematicians write instead.
constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kForeign{{{"==", "="},
                                                                                  {"=<", "<="},
                                                                                  {"=>", ">="},
                                                                                  {"<>", "!="},
                                                                                  {"&&", "and"},
                                                                                  {"&", "and"},
                                                                                  {"||", "or"},
                                                                                  {"|", "or"},
                                                                                  {"°", "deg"},
                                                                                  {"!", "not"},
                                                                                  {"∪", "+"},
                                                                                  {"“", "\""},
                                                                                  {"”", "\""},
                                                                                  {"„", "\""},
                                                                                  {"‘", "'"},
                                                                                  {"’", "'"}}};

/// The mark that is always a token of its own; kFault if it is none.
K mark(char c) {
  constexpr std::string_view kMarks = "()[],+*/";
  constexpr std::array kKinds{K::kOpen, K::kClose, K::kOpenBracket, K::kCloseBracket, K::kComma,
                              K::kPlus, K::kTimes, K::kOver,        K::kFault};
  return kKinds[std::min(kMarks.find(c), kMarks.size())];
}

std::size_t count_characters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(decode(text).size);
  return count;
}

/// The line around `span` and the place in it, cut to a width that a terminal shows.
std::string picture(std::string_view line, std::size_t begin, std::size_t end) {
  constexpr std::size_t kBefore = 60, kWidth = 100;
  std::vector<std::string> characters;
  for (std::string_view rest = line; !rest.empty();) {
    const std::size_t size = decode(rest).size;
    characters.push_back(printable(rest.substr(0, size)));
    rest.remove_prefix(size);
  }
  const std::size_t column = count_characters(line.substr(0, begin));
  const std::size_t width = std::max<std::size_t>(1, count_characters(line.substr(begin, end - begin)));
  const std::size_t first = column > kBefore ? column - kBefore : 0;
  const std::size_t last = std::min(characters.size(), first + kWidth);
  const std::string lead = first > 0 ? "..." : "";
  std::string result = "  " + lead;
  for (std::size_t i = first; i < last; ++i) result += characters[i];
  if (last < characters.size()) result += "...";
  const std::size_t tail = std::min(width, std::max(last, column + 1) - column) - 1;
  return result + "\n  " + std::string(lead.size() + column - first, ' ') + "^" + std::string(tail, '~');
}

}  // namespace

std::string Source::place(Span span) const {
  const std::string_view before = text_.substr(0, span.begin);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  return std::to_string(line) + ":" + std::to_string(count_characters(before.substr(line_start)) + 1);
}

Error Source::error(ErrorCode code, Span span, const std::string& message) const {
  const std::size_t start = text_.substr(0, span.begin).rfind('\n') + 1;
  std::string_view line = text_.substr(start, text_.substr(start).find('\n'));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  const std::size_t begin = std::min(span.begin - start, line.size());
  const std::size_t end = std::clamp(span.end - start, begin, line.size());
  return Error(code, message + "\n" + picture(line, begin, end), place(span));
}

Token Lexer::next() {
  if (number_end_ == at_ && at_ > 0 && rest().starts_with('.')) return token(K::kFault, 1, "stray '.' after a number");
  skip_blanks();
  if (at_ == text_.size()) return token(K::kEnd, 0);
  if (const std::size_t size = name_length(rest())) return token(K::kName, size, std::string(rest().substr(0, size)));
  if (const K kind = mark(text_[at_]); kind != K::kFault) return token(kind, 1);
  if (const std::size_t size = number_length(rest())) return number(size);
  return text_[at_] == '"' || text_[at_] == '\'' ? quoted() : sign();
}

void Lexer::skip_blanks() {
  while (at_ < text_.size()) {
    if (text_[at_] > ' ' && text_[at_] < 0x7F) return;
    const Character c = decode(rest());
    if (!is_blank(c.code)) return;
    at_ += c.size;
  }
}

Token Lexer::token(K kind, std::size_t size, std::string text) {
  const Span span{at_, at_ + size};
  at_ += size;
  return {kind, span, std::move(text)};
}

Token Lexer::number(std::size_t size) {
  std::string text(rest().substr(0, size));
  if (text.front() == '.') text.insert(text.begin(), '0');
  number_end_ = at_ + size;
  return token(K::kNumber, size, std::move(text));
}

Token Lexer::quoted() {
  const char quote = text_[at_];
  std::string name;
  for (std::size_t i = at_ + 1; i < text_.size();) {
    if (text_[i] == quote) return token(K::kQuoted, i + 1 - at_, std::move(name));
    if (text_[i] == '\\' && i + 1 < text_.size()) ++i;
    const Character c = decode(text_.substr(i));
    if (c.code == kNotUtf8 || is_control(c.code)) break;
    name += text_.substr(i, c.size);
    i += c.size;
  }
  return token(K::kFault, 1, "the name that begins here has no closing quote");
}

Token Lexer::sign() {
  for (const auto& [foreign, ours] : kForeign) {
    if (rest().starts_with(foreign) && !rest().starts_with("!="))
      return token(K::kFault, foreign.size(),
                   "unexpected '" + std::string(foreign) + "'; write '" + std::string(ours) + "'");
  }
  for (const Sign& sign : kSigns) {
    if (!rest().starts_with(sign.text)) continue;
    Token found = token(sign.kind, sign.text.size());
    found.relation = sign.relation;
    return found;
  }
  if (rest().starts_with("−")) return token(K::kMinus, std::string_view("−").size());
  return stray();
}

Token Lexer::stray() {
  const Character c = decode(rest());
  if (c.code == kNotUtf8) return token(K::kFault, 1, "a byte that is not UTF-8");
  return token(K::kFault, c.size, "stray character '" + printable(rest().substr(0, c.size)) + "'");
}

bool is_identifier(std::string_view name) { return !name.empty() && name_length(name) == name.size(); }

std::string quoted_if_needed(std::string_view name) {
  if (is_identifier(name)) return std::string(name);
  std::string result = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const Character c = decode(text);
    if (c.code == kNotUtf8) return false;
    text.remove_prefix(c.size);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character c = decode(text);
    if (c.code == '\t') {
      result += ' ';
    } else if (c.code == kNotUtf8 || is_control(c.code) || turns_text(c.code)) {
      result += '?';
    } else {
      result += text.substr(0, c.size);
    }
    text.remove_prefix(c.size);
  }
  return result;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::string result;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    result += (i == 0 ? "'" : ", '") + printable(names[i]) + "'";
  }
  return names.size() > kMost ? result + ", ..." : result;
}

}  // namespace findspace::formula
