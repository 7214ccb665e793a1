// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "text_check.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "problem.h"

namespace findspace::cad {
namespace {

using io::CadFault;

constexpr double kMost = 1e15;  // of any number: of millimetres, doubles then have no parts

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

std::string shown(std::string_view text) {
  constexpr std::size_t kShown = 30;
  return "'" + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "...'" : "'");
}

/// A sign, digits with one point at most, and an exponent: E, or D in IGES.
bool is_number(std::string_view text) {
  std::size_t at = 0, digits = 0;
  const auto skip_sign = [&] { at += at < text.size() && (text[at] == '+' || text[at] == '-'); };
  const auto skip_digits = [&] {
    for (; at < text.size() && is_digit(text[at]); ++at) ++digits;
  };
  skip_sign();
  skip_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    skip_digits();
  }
  if (digits == 0 || at == text.size()) return digits > 0;
  if (std::string_view("EeDd").find(text[at++]) == std::string_view::npos) return false;
  skip_sign();
  digits = 0;
  skip_digits();
  return digits > 0 && at == text.size();
}

void require_number(const std::string& where, std::string_view text) {
  if (!is_number(text)) fail(CadFault::kSyntax, where + ": " + shown(text) + " is not a number");
  std::string c(text);
  std::replace_if(
      c.begin(), c.end(), [](char x) { return x == 'D' || x == 'd'; }, 'e');
  if (!(std::abs(std::strtod(c.c_str(), nullptr)) <= kMost))
    fail(CadFault::kUnsupported, where + ": " + shown(text) + " is too large; numbers up to 1e15 are read");
}

class StepText {
 public:
  explicit StepText(std::string_view text) : text_(text) {}

  void check() {
    while (at_ < text_.size()) next();
    if (!ended_) fail(CadFault::kSyntax, "it is cut off, or no STEP file: END-ISO-10303-21 is missing");
  }

 private:
  char peek(std::size_t by = 0) const { return at_ + by < text_.size() ? text_[at_ + by] : '\0'; }

  void next() {
    const char c = peek();
    if (c == '\'' || c == '"')
      to(std::string_view(&c, 1), 1);
    else if (c == '/' && peek(1) == '*')
      to("*/", 2);
    else if (c == '#' && is_digit(peek(1)))
      reference();
    else if (is_digit(c) || c == '+' || c == '-')
      require_number(where(), run([](char x) { return is_word(x) || x == '.' || x == '+'; }));
    else if (c == '.' && std::isalpha(static_cast<unsigned char>(peek(1))) != 0)
      to(".", 1);
    else if (is_word(c))
      word();
    else
      mark(c);
  }

  void mark(char c) {
    ++at_;
    line_ += c == '\n';
    depth_ += c == '(';
    depth_ -= c == ')';
    if (c == ';') {
      depth_ = 0;
      entity_ = {};
    }
  }

  /// Past the next `end`, or to the end of the text.
  void to(std::string_view end, std::size_t from) {
    const std::size_t found = text_.find(end, at_ + from);
    const std::size_t past = found == std::string_view::npos ? text_.size() : found + end.size();
    for (; at_ < past; ++at_) line_ += text_[at_] == '\n';
  }

  template <class Of>
  std::string_view run(Of of) {
    const std::size_t from = at_;
    while (at_ < text_.size() && of(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }

  void reference() {
    const std::size_t from = at_++;
    run(is_digit);
    if (depth_ == 0) entity_ = text_.substr(from, at_ - from);
  }

  /// Within parentheses it is the kind of what follows.
  void word() {
    const std::string_view text = run(is_word);
    ended_ = ended_ || text == "END-ISO-10303-21";
    std::size_t after = at_;
    while (after < text_.size() && is_blank(text_[after])) ++after;
    if (depth_ > 0 && (after == text_.size() || text_[after] != '('))
      fail(CadFault::kSyntax, where() + ": " + shown(text) + " is not a value");
  }

  std::string where() const {
    return (entity_.empty() ? "" : std::string(entity_) + ", ") + "line " + std::to_string(line_);
  }

  std::string_view text_, entity_;
  std::size_t at_ = 0;
  int line_ = 1, depth_ = 0;
  bool ended_ = false;
};

/// Cards of 80 columns: values in the first 72, or 64 of the section P; then the section and its number.
class IgesText {
 public:
  explicit IgesText(std::string_view text) : text_(text) {}

  void check() {
    bool ended = false;
    for (int line = 1; !text_.empty(); ++line) {
      const std::string_view card = text_.substr(0, text_.find('\n'));
      text_.remove_prefix(std::min(text_.size(), card.size() + 1));
      if (std::all_of(card.begin(), card.end(), is_blank)) continue;
      const char section = card.size() > kSection ? card[kSection] : ' ';
      if (!ended && std::string_view("SGDPTBC").find(section) == std::string_view::npos)
        fail(CadFault::kSyntax, "line " + std::to_string(line) +
                                    " is no line of IGES: column 73 names no section; the file is damaged or cut off");
      ended = ended || section == 'T';
      if (section == 'G') global_ += card.substr(0, kSection);
      if (section == 'P') parameters(card, line);
    }
    if (!ended) fail(CadFault::kSyntax, "it is cut off, or no IGES file: its last section (T) is missing");
  }

 private:
  void parameters(std::string_view card, int line) {
    if (!known_) marks();
    std::string_view entity = card.substr(kValues, kSection - kValues);
    entity.remove_prefix(std::min(entity.size(), entity.find_first_not_of(' ')));
    if (entity != entity_) {
      entity_ = entity;
      value_.clear();
      rest_ = 0;
      done_ = false;
    }
    for (const char c : card.substr(0, kValues)) {
      if (rest_ > 0)
        --rest_;
      else if (!done_)
        take(c, line);
    }
  }

  /// What follows the last value is a remark.
  void take(char c, int line) {
    const bool digits = !value_.empty() && std::all_of(value_.begin(), value_.end(), is_digit);
    if (c == between_ || c == last_) {
      if (!value_.empty()) require_number("D" + entity_ + ", line " + std::to_string(line), value_);
      value_.clear();
      done_ = c == last_;
    } else if (c == 'H' && digits) {
      rest_ = std::strtoull(value_.c_str(), nullptr, 10);  // a text of so many characters
      value_.clear();
    } else if (!is_blank(c)) {
      value_ += c;
    }
  }

  /// The section G begins with what stands between values, and after the last.
  void marks() {
    known_ = true;
    std::string_view text = global_;
    const auto given = [&](char& to) {
      if (text.size() > 2 && text.substr(0, 2) == "1H") {
        to = text[2];
        text.remove_prefix(3);
      }
    };
    given(between_);
    if (!text.empty()) text.remove_prefix(1);
    given(last_);
  }

  static constexpr std::size_t kValues = 64, kSection = 72;
  std::string_view text_;
  std::string global_, value_, entity_;
  std::size_t rest_ = 0;
  char between_ = ',', last_ = ';';
  bool known_ = false, done_ = false;
};

}  // namespace

void check_step_text(const std::string& bytes) { StepText(bytes).check(); }
void check_iges_text(const std::string& bytes) { IgesText(bytes).check(); }

}  // namespace findspace::cad
