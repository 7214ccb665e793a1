// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The only file that includes the JSON library, and only its event (SAX) parser: events carry no places, so the
// parser reads through an iterator that counts bytes, and the start of each token is found from the end of the last.
#include "io/json_tree.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "findspace/error.h"

namespace findspace::io {
namespace {

constexpr std::size_t kMaxDepth = 200;

/// Input iterator over the text that leaves behind how far the parser has read.
struct CountingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  const char** reached = nullptr;

  reference operator*() const { return *at; }
  CountingIterator& operator++() {
    ++at;
    *reached = at;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return a.at != b.at; }
};

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

class TreeBuilder {
 public:
  using Json = nlohmann::json;

  TreeBuilder(std::string_view text, const std::string& name, const char* const* reached)
      : text_(text), name_(name), reached_(reached), lines_(text) {}

  JsonValue take() { return std::move(root_); }

  bool null() { return begin(JsonValue::Kind::kNull) != nullptr; }
  bool boolean(bool value) {
    begin(JsonValue::Kind::kBoolean)->boolean = value;
    return true;
  }
  bool number_integer(Json::number_integer_t) { return begin(JsonValue::Kind::kNumber) != nullptr; }
  bool number_unsigned(Json::number_unsigned_t) { return begin(JsonValue::Kind::kNumber) != nullptr; }
  bool number_float(Json::number_float_t, const std::string&) { return begin(JsonValue::Kind::kNumber) != nullptr; }
  bool string(std::string& value) {
    begin(JsonValue::Kind::kString)->text = std::move(value);
    return true;
  }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(JsonValue::Kind::kObject); }
  bool start_array(std::size_t) { return open(JsonValue::Kind::kArray); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& value) {
    std::size_t start = token_start();
    if (!seen_.back().insert(value).second) fail("the key '" + value + "' stands twice in one object", start);
    open_.back()->keys.push_back(value);
    end_ = offset();
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception& error) {
    if (const std::string_view sign = sign_at(std::max<std::size_t>(offset(), 1) - 1); sign.size() > 1) {
      const std::string hint = sign == "−" ? "; the minus is '-'" : "";
      fail("this is not JSON: stray character '" + std::string(sign) + "'" + hint, offset() - 1);
    }
    std::string message = error.what();
    std::size_t cut = message.find("parse error at ");
    cut = cut == std::string::npos ? message.find("] ") : message.find(": ", cut);
    if (cut != std::string::npos) message.erase(0, cut + 2);
    fail("this is not JSON: " + message, std::max<std::size_t>(offset(), 1) - 1);
  }

 private:
  std::size_t offset() const { return static_cast<std::size_t>(*reached_ - text_.data()); }

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
        case '\xEF':
          if (text_.substr(i, 3) != "\xEF\xBB\xBF") return i;
          i += 2;
          continue;
        default:
          return std::min(i, text_.size());
      }
    }
  }

  std::size_t number_end(std::size_t i) const {
    const auto in_number = [](char c) {
      return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
    };
    while (i < text_.size() && in_number(text_[i])) ++i;
    return i;
  }

  /// The last byte of the comment that begins at `i`.
  std::size_t comment_end(std::size_t i) const {
    if (text_.substr(i, 2) == "//") return std::min(text_.find('\n', i), text_.size());
    return std::min(text_.find("*/", i + 2), text_.size() - 2) + 1;
  }

  static JsonValue& item_of(JsonValue& list) {
    if (list.items.capacity() == 0) list.items.reserve(2);  // most lists are points
    return list.items.emplace_back();
  }

  JsonValue* begin(JsonValue::Kind kind) {
    std::size_t start = token_start();
    JsonValue* value = open_.empty() ? &root_ : &item_of(*open_.back());
    value->kind = kind;
    lines_.place(start, value->line, value->column);
    end_ = offset();
    if (kind == JsonValue::Kind::kNumber) {  // the parser has read one byte too many
      end_ = number_end(start);
      value->text = std::string(text_.substr(start, end_ - start));
    }
    return value;
  }

  bool open(JsonValue::Kind kind) {
    if (open_.size() >= kMaxDepth) fail("more than 200 levels of nesting", token_start());
    open_.push_back(begin(kind));  // stays valid: a value gets no sibling while it is open
    seen_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    seen_.pop_back();
    end_ = offset();
    return true;
  }

  [[noreturn]] void fail(const std::string& message, std::size_t start) {
    int line = 0, column = 0;
    lines_.place(start, line, column);
    throw Error(ErrorCode::kSyntax, message, name_ + ":" + std::to_string(line) + ":" + std::to_string(column));
  }

  std::string_view text_;
  const std::string& name_;
  const char* const* reached_;
  LineCounter lines_;
  std::size_t end_ = 0;  // just behind the last token
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

JsonValue parse_json(std::string_view text, const std::string& name) {
  if (is_wide(text)) throw Error(ErrorCode::kSyntax, "this is not JSON in UTF-8 but looks like UTF-16 or UTF-32", name);
  const char* reached = text.data();
  TreeBuilder builder(text, name, &reached);
  CountingIterator first{text.data(), &reached}, last{text.data() + text.size(), &reached};
  nlohmann::json::sax_parse(first, last, &builder, nlohmann::json::input_format_t::json, true, true);
  return builder.take();
}

}  // namespace findspace::io
