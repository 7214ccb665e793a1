// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The only file that includes the JSON reader (RapidJSON), and only its events: they carry no places, so the start of
// each token is found from the end of the last.
#include "io/text/json_tree.h"

#include <rapidjson/memorystream.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <unordered_set>

#include "findspace/error.h"

namespace findspace::io {
namespace {

constexpr std::size_t kMaxDepth = 200;
constexpr std::string_view kNotJson = "this is not JSON: ";

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

/// Takes the reader's events; the numbers it computes are not used.
class TreeBuilder : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, TreeBuilder> {
 public:
  TreeBuilder(std::string_view text, const std::string& name, plane::WorkBudget& work)
      : tokens_(text, name), work_(work) {}

  JsonValue run() {
    using namespace rapidjson;
    Reader reader;
    const ParseResult result = reader.Parse<kParseCommentsFlag | kParseValidateEncodingFlag>(tokens_.bytes(), *this);
    if (result.IsError()) tokens_.refuse(result);
    if (!tokens_.at_end())
      tokens_.fail(std::string(kNotJson) + fault(kParseErrorDocumentRootNotSingular), tokens_.offset());
    return std::move(root_);
  }

  bool Null() { return begin(JsonValue::Kind::kNull) != nullptr; }
  bool Bool(bool value) {
    begin(JsonValue::Kind::kBoolean)->boolean = value;
    return true;
  }
  /// Numbers of every type.
  bool Default() {
    begin(JsonValue::Kind::kNumber)->text.assign(tokens_.read_from(start_));
    return true;
  }
  bool String(const char* value, rapidjson::SizeType size, bool) {
    begin(JsonValue::Kind::kString)->text.assign(value, size);
    return true;
  }
  bool StartObject() { return open(JsonValue::Kind::kObject); }
  bool StartArray() { return open(JsonValue::Kind::kArray); }
  bool EndObject(rapidjson::SizeType) { return close(); }
  bool EndArray(rapidjson::SizeType) { return close(); }
  bool Key(const char* value, rapidjson::SizeType size, bool) {
    const std::vector<std::string>& keys = open_.back()->keys;
    open_.back()->keys.emplace_back(value, size);
    if (stands_twice(keys))
      tokens_.fail("the key '" + keys.back() + "' stands twice in one object", tokens_.token_start());
    tokens_.end_token();
    return true;
  }

 private:
  static JsonValue& item_of(JsonValue& list) {
    if (list.items.capacity() == 0) list.items.reserve(2);  // most lists are points
    return list.items.emplace_back();
  }

  /// Whether the last key is among those before it. Most objects have few keys.
  bool stands_twice(const std::vector<std::string>& keys) {
    constexpr std::size_t kFew = 8;
    if (keys.size() <= kFew) return std::find(keys.begin(), keys.end() - 1, keys.back()) != keys.end() - 1;
    std::unordered_set<std::string>& seen = seen_.back();
    if (seen.empty()) seen.insert(keys.begin(), keys.end() - 1);
    return !seen.insert(keys.back()).second;
  }

  JsonValue* begin(JsonValue::Kind kind) {
    work_.charge(kJsonValue, "a JSON text of so many values");
    JsonValue* value = open_.empty() ? &root_ : &item_of(*open_.back());
    value->kind = kind;
    start_ = tokens_.token_start();
    tokens_.place(start_, value->line, value->column);
    tokens_.end_token();
    return value;
  }

  bool open(JsonValue::Kind kind) {
    if (open_.size() >= kMaxDepth) tokens_.fail("more than 200 levels of nesting", tokens_.token_start());
    open_.push_back(begin(kind));  // stays valid: a value gets no sibling while it is open
    seen_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    seen_.pop_back();
    tokens_.end_token();
    return true;
  }

  TokenStream tokens_;
  plane::WorkBudget& work_;
  std::size_t start_ = 0;  // of the last token
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::vector<std::unordered_set<std::string>> seen_;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] == key) return &items[i];
  }
  return nullptr;
}

const char* JsonValue::kind_name() const {
  switch (kind) {
    case Kind::kNull:
      return "null";
    case Kind::kBoolean:
      return "a truth value";
    case Kind::kNumber:
      return "a number";
    case Kind::kString:
      return "a text";
    case Kind::kArray:
      return "a list";
    case Kind::kObject:
      return "an object";
  }
  return "nothing";
}

namespace {

/// Of texts of two or four bytes a character: they begin with a mark, or their first characters have bytes of 0.
bool is_wide(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") || text.substr(0, 4).find('\0') < 4;
}

}  // namespace

JsonValue parse_json(std::string_view text, const std::string& name, plane::WorkBudget& work) {
  if (is_wide(text)) throw Error(ErrorCode::kSyntax, "this is not JSON in UTF-8 but looks like UTF-16 or UTF-32", name);
  try {
    return TreeBuilder(text, name, work).run();
  } catch (const Error& e) {
    throw e.place().empty() ? e.within(name) : e;
  }
}

}  // namespace findspace::io
