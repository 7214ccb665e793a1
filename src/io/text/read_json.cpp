// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The reader of JSON: RFC 8259, with the comments of C++. Numbers are not computed, so the only limit to them is that
// of doubles, as other programs have it. Cost: one look at each byte.
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <unordered_set>

#include "findspace/error.h"
#include "io/text/json_tree.h"

namespace findspace::io {
namespace {

constexpr std::size_t kMaxDepth = 200;
constexpr std::string_view kNotJson = "this is not JSON: ";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// What is wrong, after "this is not JSON: ".
constexpr const char *kNoValue = "there is no value", *kAfterEnd = "text stands after the end",
                     *kWantsValue =
                         "a value is expected: a number, a text in double quotes, a list, an object, true, "
                         "false or null",
                     *kWantsName = "a name in double quotes is expected",
                     *kWantsColon = "':' is expected after the name", *kWantsCommaOrBrace = "',' or '}' is expected",
                     *kWantsCommaOrBracket = "',' or ']' is expected", *kOpenComment = "a comment without its end",
                     *kTooBig = "the number is beyond 1e308",
                     *kWantsFraction = "digits are expected after the decimal point",
                     *kWantsExponent = "digits are expected after the exponent's letter";
/// The same within a text.
constexpr const char *kWantsHex = "four hexadecimal digits are expected after '\\u'",
                     *kHalfPair = "half of a surrogate pair", *kNoEscape = "no such escape in a text",
                     *kOpenText = "a text without its closing '\"'",
                     *kNotUtf8 = "a control character or no UTF-8 in a text";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

unsigned byte(std::string_view text, std::size_t k) {
  return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
}

/// Bytes of the character that begins the text, if it has several; 0 where they are not put together well.
std::size_t size_of_sign(std::string_view text) {
  const unsigned lead = byte(text, 0);
  const std::size_t size = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(text, k) & 0xc0) != 0x80) return 0;
  }
  return size;
}

/// Whether these bytes are the shortest for what they say, and that is a character.
bool is_utf8(std::string_view sign) {
  const unsigned lead = byte(sign, 0), next = byte(sign, 1);
  const bool longer_than_needed = (lead == 0xe0 && next < 0xa0) || (lead == 0xf0 && next < 0x90);
  const bool no_character = (lead == 0xed && next > 0x9f) || (lead == 0xf4 && next > 0x8f);
  return !longer_than_needed && !no_character;
}

void put_utf8(std::string& out, unsigned code) {
  const auto tail = [&](int shift) { out += static_cast<char>(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xe0 | (code >> 12));
    tail(6);
    tail(0);
  } else {
    out += static_cast<char>(0xf0 | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// Of whole digits.
bool is_beyond_doubles(std::string_view digits) {
  constexpr std::size_t kSurelyNot = 300;
  double value = 0;
  for (std::size_t k = 0; digits.size() > kSurelyNot && k < digits.size(); ++k) {
    if (value >= std::numeric_limits<double>::max() / 10) return true;
    value = value * 10 + (digits[k] - '0');
  }
  return false;
}

/// The greatest exponent of a number with these digits, as the last of those behind the point are worth less.
std::size_t greatest_exponent(std::string_view whole, std::string_view fraction) {
  constexpr std::size_t kMostOfDouble = 17;
  const std::size_t zeros = whole == "0" ? std::min(fraction.find_first_not_of('0'), fraction.size()) : 0;
  const std::size_t before = whole == "0" ? 0 : std::min(whole.size(), kMostOfDouble);
  return std::numeric_limits<double>::max_exponent10 + std::min(fraction.size(), zeros + kMostOfDouble - before);
}

/// Reads the text once, from its beginning to its end. Values wait until the end of what holds them.
class TreeReader {
 public:
  TreeReader(std::string_view text, const std::string& name, plane::WorkBudget& work)
      : name_(name), work_(work), at_(text.data()), end_(at_ + text.size()), line_start_(at_) {
    if (text.starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
  }

  JsonTree run() {
    skip();
    if (peek() == '\0') refuse(kNoValue, at_);
    value();
    skip();
    if (peek() != '\0') refuse(kAfterEnd, at_);
    if (at_ != end_) fail(std::string(kNotJson) + kAfterEnd, at_);
    tree_.set_root(waiting_.back());
    return std::move(tree_);
  }

 private:
  using Kind = JsonValue::Kind;
  using Keys = std::span<const std::string_view>;

  struct Open {
    int line, column;
    std::size_t values, keys;                                      // the first of its own among those that wait
    std::unique_ptr<std::unordered_set<std::string_view>> seen{};  // its keys, where they are many
  };

  // The text. A NUL byte is like its end until something is wrong.

  char peek() const { return at_ == end_ ? '\0' : *at_; }
  bool take(char c) {
    if (peek() != c) return false;
    if (c != '\0') ++at_;
    return true;
  }

  /// Blanks and comments; mostly there are none, or there is one blank.
  void skip() {
    if (at_ != end_ && *at_ == ' ') ++at_;
    if (at_ == end_ || is_blank_or_slash(*at_)) skip_all();
  }

  static bool is_blank_or_slash(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '/'; }

  void skip_all() {
    for (;; ++at_) {
      const char c = peek();
      if (c == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      } else if (c == '/') {
        skip_comment();
      } else if (c != ' ' && c != '\t' && c != '\r') {
        return;
      }
    }
  }

  /// Up to its last byte.
  void skip_comment() {
    ++at_;
    if (take('/')) {
      while (peek() != '\0' && *at_ != '\n') ++at_;
      --at_;
      return;
    }
    if (!take('*')) refuse(kOpenComment, at_);
    for (;; ++at_) {
      if (peek() == '\0') refuse(kOpenComment, at_);
      if (*at_ == '\n') {
        ++line_;
        line_start_ = at_ + 1;
      }
      if (*at_ == '*' && at_ + 1 != end_ && at_[1] == '/') break;
    }
    ++at_;
  }

  int column(const char* at) const { return static_cast<int>(at - line_start_) + 1; }

  /// At a place in this line.
  [[noreturn]] void fail(const std::string& message, const char* at) const {
    throw Error(ErrorCode::kSyntax, message, name_ + ":" + std::to_string(line_) + ":" + std::to_string(column(at)));
  }

  [[noreturn]] void refuse(const char* fault, const char* at, bool in_text = false) const {
    const std::string_view rest(at, static_cast<std::size_t>(end_ - at)), sign = rest.substr(0, size_of_sign(rest));
    std::string message(kNotJson);
    if (!sign.empty() && !in_text) {
      message += "stray character '" + std::string(sign) + (sign == "−" ? "'; the minus is '-'" : "'");
    } else {
      const bool nul = at != end_ && *at == '\0';
      message += at == end_ ? "the end comes too early; " : "";
      message += nul ? "a NUL byte" : fault;
    }
    fail(message, at);
  }

  // Tokens.

  void word(std::string_view word) {
    for (const char c : word)
      if (!take(c)) refuse(kWantsValue, at_);
  }

  std::string_view digits() {
    const char* const start = at_;
    const char* at = start;
    while (at != end_ && is_digit(*at)) ++at;
    at_ = at;
    return {start, static_cast<std::size_t>(at - start)};
  }

  std::string_view number() {
    const char* const start = at_;
    take('-');
    std::string_view fraction;
    const std::string_view whole = take('0') ? "0" : digits();
    if (whole.empty()) refuse(kWantsValue, at_);
    if (is_beyond_doubles(whole)) refuse(kTooBig, start);
    if (take('.') && (fraction = digits()).empty()) refuse(kWantsFraction, at_);
    if (take('e') || take('E')) check_exponent(start, whole, fraction);
    return {start, static_cast<std::size_t>(at_ - start)};
  }

  void check_exponent(const char* start, std::string_view whole, std::string_view fraction) {
    const bool negative = take('-');
    if (!negative) take('+');
    const std::string_view exponent = digits();
    if (exponent.empty()) refuse(kWantsExponent, at_);
    if (negative) return;
    const std::size_t most = greatest_exponent(whole, fraction);
    std::size_t value = 0;
    for (const char digit : exponent) {
      value = value * 10 + static_cast<std::size_t>(digit - '0');
      if (value > most) refuse(kTooBig, start);
    }
  }

  /// The text in quotes that begins here; it stands until the next one is read.
  std::string_view quoted() {
    const char* const start = ++at_;
    const char* at = start;
    while (at != end_ && *at != '"' && *at != '\\' && static_cast<unsigned char>(*at) - 0x20u < 0x60u) ++at;
    at_ = at;
    const std::string_view plain(start, static_cast<std::size_t>(at - start));
    if (take('"')) return plain;
    buffer_ = plain;
    while (!take('"')) put_sign();
    return buffer_;
  }

  /// One character of a text.
  void put_sign() {
    const char c = peek();
    if (c == '\\') return put_escaped();
    if (c == '\0') refuse(kOpenText, at_, true);
    if (static_cast<unsigned char>(c) < 0x20) refuse(kNoEscape, at_, true);
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    const std::size_t size = static_cast<unsigned char>(c) < 0x80 ? 1 : size_of_sign(rest);
    if (size == 0 || !is_utf8(rest.substr(0, size))) refuse(kNotUtf8, at_, true);
    buffer_ += rest.substr(0, size);
    at_ += size;
  }

  void put_escaped() {
    static constexpr std::string_view kLetters = "\"/\\bfnrt", kMeant = "\"/\\\b\f\n\r\t";
    const char* const start = at_++;
    const std::size_t k = peek() == '\0' ? kLetters.npos : kLetters.find(*at_);
    if (k != kLetters.npos) {
      ++at_;
      buffer_ += kMeant[k];
      return;
    }
    if (!take('u')) refuse(kNoEscape, start, true);
    unsigned code = hexadecimal(start);
    if (code >= 0xd800 && code < 0xdc00) {
      const unsigned low = take('\\') && take('u') ? hexadecimal(start) : 0;
      if (low < 0xdc00 || low > 0xdfff) refuse(kHalfPair, start, true);
      code = ((code - 0xd800) << 10 | (low - 0xdc00)) + 0x10000;
    }
    put_utf8(buffer_, code);
  }

  unsigned hexadecimal(const char* escape) {
    static constexpr std::string_view kDigits = "0123456789abcdefABCDEF";
    unsigned code = 0;
    for (int i = 0; i < 4; ++i) {
      const std::size_t k = peek() == '\0' ? kDigits.npos : kDigits.find(*at_);
      if (k == kDigits.npos) refuse(kWantsHex, escape, true);
      code = code * 16 + static_cast<unsigned>(k < 16 ? k : k - 6);
      ++at_;
    }
    return code;
  }

  // Values.

  void value() {
    const char* const start = at_;
    switch (peek()) {
      case 'n':
        word("null");
        return add(start, JsonValue());
      case 't':
        word("true");
        return add(start, truth(true));
      case 'f':
        word("false");
        return add(start, truth(false));
      case '"':
        return add(start, tree_.text(Kind::kString, quoted()));
      case '{':
        return object();
      case '[':
        return list();
      default:
        return add(start, tree_.text(Kind::kNumber, number()));
    }
  }

  static JsonValue truth(bool truth) {
    JsonValue value(Kind::kBoolean);
    value.boolean = truth;
    return value;
  }

  void list() {
    open();
    skip();
    if (!take(']')) {
      for (;;) {
        value();
        skip();
        if (take(']')) break;
        if (!take(',')) refuse(kWantsCommaOrBracket, at_);
        skip();
      }
    }
    close(tree_.list(std::span<const JsonValue>(waiting_).subspan(open_.back().values)));
  }

  void object() {
    open();
    skip();
    if (!take('}')) {
      for (;;) {
        key();
        skip();
        if (!take(':')) refuse(kWantsColon, at_);
        skip();
        value();
        skip();
        if (take('}')) break;
        if (!take(',')) refuse(kWantsCommaOrBrace, at_);
        skip();
      }
    }
    const Keys keys = keys_of_last();
    keys_.resize(open_.back().keys);
    close(tree_.object(keys, std::span<const JsonValue>(waiting_).subspan(open_.back().values)));
  }

  void key() {
    const char* const start = at_;
    if (peek() != '"') refuse(kWantsName, at_);
    const std::string_view key = quoted();
    const Keys& before = keys_at_depth_[open_.size()];
    const std::size_t k = keys_.size() - open_.back().keys;
    keys_.push_back(k < before.size() && before[k] == key ? before[k] : tree_.kept(key));
    if (stands_twice()) fail("the key '" + std::string(key) + "' stands twice in one object", start);
  }

  /// Whether the last key is among those before it. Most objects have few keys.
  bool stands_twice() {
    constexpr std::size_t kFew = 8;
    Open& open = open_.back();
    const auto first = keys_.begin() + std::ptrdiff_t(open.keys), last = keys_.end() - 1;
    if (keys_.size() - open.keys <= kFew) return std::find(first, last, *last) != last;
    if (open.seen == nullptr) open.seen = std::make_unique<std::unordered_set<std::string_view>>(first, last);
    return !open.seen->insert(*last).second;
  }

  /// Of the object that ends. They are those of the one before it at its depth, where it has the same.
  Keys keys_of_last() {
    const Keys own = Keys(keys_).subspan(open_.back().keys);
    Keys& before = keys_at_depth_[open_.size()];
    const auto same = [](std::string_view a, std::string_view b) {
      return a.data() == b.data() && a.size() == b.size();
    };
    if (!std::equal(own.begin(), own.end(), before.begin(), before.end(), same)) before = tree_.kept(own);
    return before;
  }

  void charge() { work_.charge(kJsonValue, "a JSON text of so many values"); }

  void add(const char* start, JsonValue value) {
    charge();
    value.line = line_;
    value.column = column(start);
    waiting_.push_back(value);
  }

  void open() {
    if (open_.size() >= kMaxDepth) fail("more than 200 levels of nesting", at_);
    charge();
    open_.push_back({line_, column(at_), waiting_.size(), keys_.size()});
    ++at_;
  }

  /// What holds those that waited for its end takes their place.
  void close(JsonValue value) {
    value.line = open_.back().line;
    value.column = open_.back().column;
    waiting_.resize(open_.back().values);
    waiting_.push_back(value);
    open_.pop_back();
  }

  const std::string& name_;
  plane::WorkBudget& work_;
  const char *at_, *end_;
  const char* line_start_;
  int line_ = 1;
  std::string buffer_;  // the text that is read, where it is not as written
  JsonTree tree_;
  std::vector<JsonValue> waiting_;
  std::vector<std::string_view> keys_;
  std::vector<Open> open_;
  std::array<Keys, kMaxDepth + 1> keys_at_depth_;
};

}  // namespace

namespace {

/// Of texts of two or four bytes a character: they begin with a mark, or their first characters have bytes of 0.
bool is_wide(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") || text.substr(0, 4).find('\0') < 4;
}

}  // namespace

JsonTree parse_json(std::string_view text, const std::string& name, plane::WorkBudget& work) {
  if (is_wide(text)) throw Error(ErrorCode::kSyntax, "this is not JSON in UTF-8 but looks like UTF-16 or UTF-32", name);
  try {
    return TreeReader(text, name, work).run();
  } catch (const Error& e) {
    throw e.place().empty() ? e.within(name) : e;
  }
}

}  // namespace findspace::io
