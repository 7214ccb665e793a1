// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The only file that includes the JSON reader (RapidJSON), and only its events: they carry no places, so the start of
// each token is found from the end of the last.
#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <array>
#include <memory>
#include <unordered_set>

#include "findspace/error.h"
#include "io/text/json_tree.h"

namespace findspace::io {
namespace {

constexpr std::size_t kMaxDepth = 200;
constexpr std::string_view kNotJson = "this is not JSON: ", kManyValues = "a JSON text of so many values";

/// Byte offsets to lines and columns, for offsets that only grow.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}
  void place(std::size_t offset, int& line, int& column) {
    const std::size_t end = std::min(offset, text_.size());
    while (at_ < end) {
      const std::size_t found = text_.substr(at_, end - at_).find('\n');
      if (found == std::string_view::npos) break;
      at_ += found + 1;
      ++line_;
      line_start_ = at_;
    }
    at_ = std::max(at_, end);
    line = line_;
    column = static_cast<int>(offset - line_start_) + 1;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0, line_start_ = 0;
  int line_ = 1;
};

/// What is wrong, after "this is not JSON: ".
const char* fault(rapidjson::ParseErrorCode code) {
  switch (code) {
    case rapidjson::kParseErrorDocumentEmpty:
      return "there is no value";
    case rapidjson::kParseErrorDocumentRootNotSingular:
      return "text stands after the end";
    case rapidjson::kParseErrorValueInvalid:
      return "a value is expected: a number, a text in double quotes, a list, an object, true, false or null";
    case rapidjson::kParseErrorObjectMissName:
      return "a name in double quotes is expected";
    case rapidjson::kParseErrorObjectMissColon:
      return "':' is expected after the name";
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
      return "',' or '}' is expected";
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
      return "',' or ']' is expected";
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
      return "four hexadecimal digits are expected after '\\u'";
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
      return "half of a surrogate pair";
    case rapidjson::kParseErrorStringEscapeInvalid:
      return "no such escape in a text";
    case rapidjson::kParseErrorStringMissQuotationMark:
      return "a text without its closing '\"'";
    case rapidjson::kParseErrorStringInvalidEncoding:
      return "a control character or no UTF-8 in a text";
    case rapidjson::kParseErrorNumberTooBig:
      return "the number is beyond 1e308";
    case rapidjson::kParseErrorNumberMissFraction:
      return "digits are expected after the decimal point";
    case rapidjson::kParseErrorNumberMissExponent:
      return "digits are expected after the exponent's letter";
    default:
      return "a comment without its end";
  }
}

/// A text as a stream of bytes, the places of its tokens, and the errors that show them.
class TokenStream {
 public:
  TokenStream(std::string_view text, const std::string& name)
      : text_(text), name_(name), stream_(text.data(), text.size()), lines_(text) {
    if (!text_.starts_with(kByteOrderMark)) return;
    mark_ = kByteOrderMark.size();
    stream_ = rapidjson::MemoryStream(text_.data() + mark_, text_.size() - mark_);
    end_ = mark_;
  }

  rapidjson::MemoryStream& bytes() { return stream_; }
  std::size_t offset() const { return mark_ + stream_.Tell(); }
  bool at_end() const { return offset() == text_.size(); }
  /// Start of the token just read: what follows the token before but blanks, separators and comments.
  std::size_t token_start() const {
    std::size_t i = end_;
    for (;; ++i) {
      switch (i < text_.size() ? text_[i] : '\0') {
        case ' ':
        case '\t':
        case '\r':
        case '\n':
        case ',':
        case ':':
          continue;
        case '/':
          i = comment_end(i);
          continue;
        default:
          return std::min(i, text_.size());
      }
    }
  }

  /// The next token begins after what has been read.
  void end_token() { end_ = offset(); }
  std::string_view read_from(std::size_t start) const { return text_.substr(start, offset() - start); }
  void place(std::size_t start, int& line, int& column) { lines_.place(start, line, column); }

  [[noreturn]] void fail(const std::string& message, std::size_t start) {
    int line = 0, column = 0;
    lines_.place(start, line, column);
    throw Error(ErrorCode::kSyntax, message, name_ + ":" + std::to_string(line) + ":" + std::to_string(column));
  }

  [[noreturn]] void refuse(const rapidjson::ParseResult& result) {
    const std::size_t at = std::min(mark_ + result.Offset(), text_.size());
    const std::string_view sign = sign_at(at);
    const bool in_text = result.Code() >= rapidjson::kParseErrorStringUnicodeEscapeInvalidHex &&
                         result.Code() <= rapidjson::kParseErrorStringInvalidEncoding;
    std::string message(kNotJson);
    if (sign.size() > 1 && !in_text) {
      message += "stray character '" + std::string(sign) + (sign == "−" ? "'; the minus is '-'" : "'");
    } else {
      const bool nul = at < text_.size() && text_[at] == '\0';
      message += at == text_.size() ? "the end comes too early; " : "";
      message += nul ? "a NUL byte" : fault(result.Code());
    }
    fail(message, at);
  }

 private:
  static constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

  /// The character that begins there if it is one of several bytes and well formed, else nothing.
  std::string_view sign_at(std::size_t start) const {
    const auto byte = [&](std::size_t i) { return i < text_.size() ? static_cast<unsigned char>(text_[i]) : 0u; };
    const unsigned lead = byte(start);
    const std::size_t size = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
    for (std::size_t k = 1; k < size; ++k) {
      if ((byte(start + k) & 0xc0) != 0x80) return {};
    }
    return text_.substr(std::min(start, text_.size()), size);
  }

  /// The last byte of the comment that begins at `i`.
  std::size_t comment_end(std::size_t i) const {
    if (text_.substr(i, 2) == "//") return std::min(text_.find('\n', i), text_.size());
    return std::min(text_.find("*/", i + 2), text_.size() - 2) + 1;
  }

  std::string_view text_;
  const std::string& name_;
  rapidjson::MemoryStream stream_;  // the one stream whose place is right at every event
  std::size_t mark_ = 0;            // bytes before the stream
  LineCounter lines_;
  std::size_t end_ = 0;  // of the last token
};

/// How many values a text of JSON has, counted without reading them, until they are more than `most`. Of what is not
/// JSON it says nothing.
class ValueCount {
 public:
  explicit ValueCount(std::string_view text) : text_(text) {}

  std::uint64_t count(std::uint64_t most) {
    for (; at_ < text_.size() && count_ <= most; ++at_) pass(text_[at_]);
    return count_;
  }

 private:
  /// A separator stands before each value but the first of a list, which counts with its bracket if there is one.
  void pass(char c) {
    switch (c) {
      case '"':
        pass_text();
        break;
      case '/':
        pass_comment();
        return;
      case ',':
      case '[':
      case '{':
        ++count_;
        break;
      case ']':
      case '}':
        count_ -= opened_ ? 1 : 0;
        break;
      case ' ':
      case '\t':
      case '\r':
      case '\n':
        return;
      default:
        break;
    }
    opened_ = c == '[' || c == '{';
  }

  void pass_text() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\' ? 1 : 0;
  }

  void pass_comment() {
    const bool line = text_.substr(at_, 2) == "//";
    const std::size_t end = line ? text_.find('\n', at_) : text_.find("*/", at_ + 2);
    at_ = end == std::string_view::npos ? text_.size() : end + (line ? 0 : 1);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint64_t count_ = 1;
  bool opened_ = false;  // the last sign opens a list or an object
};

/// Takes the reader's events; the numbers it computes are not used. Values wait until the end of what holds them.
class TreeBuilder : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, TreeBuilder> {
 public:
  TreeBuilder(std::string_view text, const std::string& name, plane::WorkBudget& work)
      : tokens_(text, name), work_(work) {}

  JsonTree run() {
    using namespace rapidjson;
    Reader reader;
    const ParseResult result = reader.Parse<kParseCommentsFlag | kParseValidateEncodingFlag>(tokens_.bytes(), *this);
    if (result.IsError()) tokens_.refuse(result);
    if (!tokens_.at_end())
      tokens_.fail(std::string(kNotJson) + fault(kParseErrorDocumentRootNotSingular), tokens_.offset());
    tree_.set_root(waiting_.back());
    return std::move(tree_);
  }

  bool Null() { return add(JsonValue()); }
  bool Bool(bool truth) {
    JsonValue value(Kind::kBoolean);
    value.boolean = truth;
    return add(value);
  }
  /// Numbers of every type.
  bool Default() {
    const Place place = begin();
    return add_at(place, tree_.text(Kind::kNumber, tokens_.read_from(start_)));
  }
  bool String(const char* value, rapidjson::SizeType size, bool) {
    return add(tree_.text(Kind::kString, {value, size}));
  }
  bool StartObject() { return open(); }
  bool StartArray() { return open(); }
  bool EndObject(rapidjson::SizeType) {
    const std::span<const std::string_view> keys = keys_of_last();
    keys_.resize(open_.back().keys);
    return close([&](std::span<const JsonValue> values) { return tree_.object(keys, values); });
  }
  bool EndArray(rapidjson::SizeType) {
    return close([&](std::span<const JsonValue> items) { return tree_.list(items); });
  }
  bool Key(const char* value, rapidjson::SizeType size, bool) {
    const std::string_view key(value, size);
    const Keys& before = keys_at_depth_[open_.size()];
    const std::size_t k = keys_.size() - open_.back().keys;
    keys_.push_back(k < before.size() && before[k] == key ? before[k] : tree_.kept(key));
    if (stands_twice())
      tokens_.fail("the key '" + std::string(key) + "' stands twice in one object", tokens_.token_start());
    tokens_.end_token();
    return true;
  }

 private:
  using Kind = JsonValue::Kind;
  using Keys = std::span<const std::string_view>;

  struct Place {
    int line = 0, column = 0;
  };
  struct Open {
    Place place;
    std::size_t values, keys;                                      // the first of its own among those that wait
    std::unique_ptr<std::unordered_set<std::string_view>> seen{};  // its keys, where they are many
  };

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

  Place begin() {
    work_.charge(kJsonValue, kManyValues);
    start_ = tokens_.token_start();
    Place place;
    tokens_.place(start_, place.line, place.column);
    tokens_.end_token();
    return place;
  }

  bool add(const JsonValue& value) { return add_at(begin(), value); }

  bool add_at(const Place& place, JsonValue value) {
    value.line = place.line;
    value.column = place.column;
    waiting_.push_back(value);
    return true;
  }

  bool open() {
    if (open_.size() >= kMaxDepth) tokens_.fail("more than 200 levels of nesting", tokens_.token_start());
    open_.push_back({begin(), waiting_.size(), keys_.size()});
    return true;
  }

  /// `made`: the value of those that waited for its end.
  template <class Made>
  bool close(const Made& made) {
    const Open& last = open_.back();
    const JsonValue value = made(std::span<const JsonValue>(waiting_).subspan(last.values));
    waiting_.resize(last.values);
    add_at(last.place, value);
    open_.pop_back();
    tokens_.end_token();
    return true;
  }

  TokenStream tokens_;
  plane::WorkBudget& work_;
  std::size_t start_ = 0;  // of the last token
  JsonTree tree_;
  std::vector<JsonValue> waiting_;
  std::vector<std::string_view> keys_;
  std::vector<Open> open_;
  std::array<Keys, kMaxDepth + 1> keys_at_depth_;
};

/// Of texts of two or four bytes a character: they begin with a mark, or their first characters have bytes of 0.
bool is_wide(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") || text.substr(0, 4).find('\0') < 4;
}

/// Refuses a text of too many values before a tree of many is made. A value takes two bytes at least.
void charge_many(std::string_view text, plane::WorkBudget& work) {
  const std::uint64_t most = work.left() / kJsonValue;
  if (text.size() / 2 <= most) return;
  const std::uint64_t count = ValueCount(text).count(most);
  if (count > most) work.charge(count * kJsonValue, kManyValues);
}

}  // namespace

JsonTree parse_json(std::string_view text, const std::string& name, plane::WorkBudget& work) {
  if (is_wide(text)) throw Error(ErrorCode::kSyntax, "this is not JSON in UTF-8 but looks like UTF-16 or UTF-32", name);
  try {
    charge_many(text, work);
    return TreeBuilder(text, name, work).run();
  } catch (const Error& e) {
    throw e.place().empty() ? e.within(name) : e;
  }
}

}  // namespace findspace::io
