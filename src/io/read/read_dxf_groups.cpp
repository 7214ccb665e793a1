// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/read/read_dxf_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "findspace/error.h"
#include "formula/language/lexer.h"

namespace findspace::io {
namespace {

std::string_view without_blanks(std::string_view text) {
  std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

constexpr std::string_view kEscape = "\\U+";  // and four hexadecimal digits: a character

void add_utf8(std::string& out, unsigned code) {
  const auto tail = [](unsigned bits) { return static_cast<char>(0x80 | (bits & 0x3f)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | code >> 6);
    out += tail(code);
  } else {
    out += static_cast<char>(0xe0 | code >> 12);
    out += tail(code >> 6);
    out += tail(code);
  }
}

std::string without_escapes(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::string_view digits = text.substr(0, kEscape.size()) == kEscape ? text.substr(kEscape.size(), 4) : "";
    unsigned code = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() == 4 && error == std::errc() && end == digits.data() + 4 && code >= 0x80) {
      add_utf8(out, code);
      text.remove_prefix(kEscape.size() + 4);
    } else {
      out += text[0];
      text.remove_prefix(1);
    }
  }
  return out;
}

/// Of a name in the code page of its writer: the usual one, 1252.
std::string of_code_page(std::string_view text) {
  constexpr unsigned kFirst = 0x80;
  constexpr std::array<std::uint16_t, 32> kBeyondLatin1{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                        0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                                        0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                        0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
  std::string out;
  for (const char c : text) {
    const unsigned byte = static_cast<unsigned char>(c);
    add_utf8(out, byte >= kFirst && byte < kFirst + kBeyondLatin1.size() ? kBeyondLatin1[byte - kFirst] : byte);
  }
  return out;
}

class DxfParser {
 public:
  DxfParser(std::string_view text, const std::string& name) : text_(text) { document_.name = name; }

  DxfDocument parse() {
    constexpr std::string_view kBinary("AutoCAD Binary DXF\r\n\x1a\0", 22);
    binary_ = text_.starts_with(kBinary);
    if (binary_) at_ = kBinary.size();
    advance();
    while (!is(0, "EOF")) {
      if (!is(0, "SECTION")) fail("a SECTION is expected");
      advance();
      std::string_view section = now_.value;
      advance();
      if (section == "HEADER")
        header();
      else if (section == "TABLES")
        tables();
      else if (section == "BLOCKS")
        blocks();
      else if (section == "ENTITIES")
        entities(document_.entities, "ENDSEC");
      while (!is(0, "ENDSEC")) advance();
      advance();
    }
    return std::move(document_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorCode::kSyntax, message, fmt::format("{}:{}", document_.name, line_));
  }

  bool is(int code, std::string_view value) const { return now_.code == code && now_.value == value; }

  [[noreturn]] void cut_off() const {
    throw Error(ErrorCode::kFile, "the DXF file ends before its EOF: it is cut off",
                fmt::format("{}:{}", document_.name, line_));
  }

  std::string_view next_line() {
    if (at_ >= text_.size()) cut_off();
    std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    return without_blanks(line);
  }

  std::string_view bytes(std::size_t count) {
    if (text_.size() - at_ < count) cut_off();
    const std::string_view found = text_.substr(at_, count);
    at_ += count;
    return found;
  }

  template <class T>
  T value() {
    T out;  // files are little endian, as the machines that this is built for
    std::memcpy(&out, bytes(sizeof(T)).data(), sizeof(T));
    return out;
  }

  /// The value that the code says, as text.
  std::string binary_value(int code) {
    const auto in = [&](int low, int high) { return low <= code && code <= high; };
    if (in(10, 59) || in(110, 149) || in(210, 239) || in(460, 469) || in(1010, 1059))
      return fmt::format("{}", value<double>());
    if (in(60, 79) || in(170, 179) || in(270, 289) || in(370, 389) || in(400, 409) || in(1060, 1070))
      return fmt::format("{}", value<std::int16_t>());
    if (in(90, 99) || in(420, 429) || in(440, 459) || code == 1071) return fmt::format("{}", value<std::int32_t>());
    if (in(160, 169)) return fmt::format("{}", value<std::int64_t>());
    if (in(290, 299)) return fmt::format("{}", int(value<std::uint8_t>()));
    if (in(310, 319) || code == 1004) return std::string(bytes(value<std::uint8_t>()).size(), '.');
    const std::size_t end = text_.find('\0', at_);
    if (end == std::string_view::npos) cut_off();
    std::string out(text_.substr(at_, end - at_));
    at_ = end + 1;
    return out;
  }

  void advance_binary() {
    do {
      ++line_;
      const int code = value<std::uint16_t>();
      document_.texts.push_back(binary_value(code));
      now_ = {code, without_blanks(document_.texts.back()), line_};
    } while (now_.code == 999);
  }

  /// To the next group; names become UTF-8, and escapes in them are read.
  void advance() {
    if (binary_)
      advance_binary();
    else
      advance_text();
    if (now_.code != 0 && now_.code != 2 && now_.code != 8) return;
    if (!formula::is_utf8(now_.value)) now_.value = document_.texts.emplace_back(of_code_page(now_.value));
    if (now_.value.find(kEscape) != std::string_view::npos)
      now_.value = document_.texts.emplace_back(without_escapes(now_.value));
  }

  void advance_text() {
    do {
      std::string_view code = next_line();
      int number = 0;
      auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), number);
      if (error != std::errc() || end != code.data() + code.size())
        fail("this is not ASCII DXF: a group code is expected");
      std::string_view value = next_line();
      now_ = {number, value, line_};
    } while (now_.code == 999);  // comments
  }

  void header() {
    while (!is(0, "ENDSEC")) {
      bool units = is(9, "$INSUNITS");
      advance();
      if (!units || now_.code != 70) continue;
      int value = 0;
      const char* end = now_.value.data() + now_.value.size();
      if (const auto read = std::from_chars(now_.value.data(), end, value); read.ec != std::errc{} || read.ptr != end)
        fail(fmt::format("'{}' is not a code of $INSUNITS", now_.value));
      document_.units = value;
    }
  }

  /// The entity that begins here, with all its groups.
  DxfEntity entity() {
    if (now_.code != 0) fail("an entity is expected");
    DxfEntity entity{now_.value, line_, {}, {}};
    for (advance(); now_.code != 0; advance()) entity.groups.push_back(now_);
    if (entity.type != "POLYLINE") return entity;
    while (is(0, "VERTEX")) entity.vertices.push_back(this->entity());
    if (!is(0, "SEQEND")) fail("a POLYLINE without SEQEND");
    this->entity();
    return entity;
  }

  void entities(std::vector<DxfEntity>& all, std::string_view end) {
    while (!is(0, end)) {
      if (is(0, "ENDSEC") || is(0, "EOF")) fail(fmt::format("{} is expected", end));
      all.push_back(entity());
    }
  }

  /// Layers that are off, which their colour says by its sign, or frozen.
  void tables() {
    constexpr int kFrozen = 1;
    while (!is(0, "ENDSEC")) {
      if (!is(0, "LAYER")) {
        advance();
        continue;
      }
      const DxfEntity layer = entity();
      const DxfGroup* name = layer.find(2);
      if (!name) continue;
      const bool off = document_.number(layer, 62, 1).sign() < 0;
      const bool frozen = (document_.flags(layer, 70) & kFrozen) != 0;
      if (off || frozen) document_.hidden_layers.emplace(name->value);
      if (frozen) document_.frozen_layers.emplace(name->value);
    }
  }

  void blocks() {
    while (is(0, "BLOCK")) {
      DxfBlock block;
      block.head = entity();
      entities(block.entities, "ENDBLK");
      entity();
      if (const DxfGroup* name = block.head.find(2)) document_.blocks[std::string(name->value)] = std::move(block);
    }
  }

  std::string_view text_;
  DxfDocument document_;
  std::size_t at_ = 0;
  int line_ = 0;
  bool binary_ = false;
  DxfGroup now_;
};

}  // namespace

bool DxfNameOrder::operator()(std::string_view a, std::string_view b) const {
  const auto capital = [](char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [&](char c, char d) { return capital(c) < capital(d); });
}

bool same_dxf_name(std::string_view a, std::string_view b) { return !DxfNameOrder{}(a, b) && !DxfNameOrder{}(b, a); }

const DxfGroup* DxfEntity::find(int code) const {
  for (const DxfGroup& group : groups) {
    if (group.code == code) return &group;
  }
  return nullptr;
}

std::string_view DxfEntity::layer() const {
  const DxfGroup* group = find(8);
  return group ? group->value : "0";
}

exact::Real DxfDocument::number(const DxfGroup& group) const {
  try {
    return exact::Real::parse_decimal(group.value);
  } catch (const Error&) {
    throw Error(ErrorCode::kSyntax, fmt::format("'{}' is not a number", group.value),
                fmt::format("{}:{}", name, group.line));
  }
}

exact::Real DxfDocument::number(const DxfEntity& entity, int code, const exact::Real& missing) const {
  const DxfGroup* group = entity.find(code);
  return group ? number(*group) : missing;
}

exact::Real DxfDocument::number(const DxfEntity& entity, int code) const {
  if (const DxfGroup* group = entity.find(code)) return number(*group);
  throw Error(ErrorCode::kSyntax, fmt::format("group {} is missing", code), place(entity));
}

int DxfDocument::flags(const DxfEntity& entity, int code) const {
  auto value = number(entity, code, 0).integer();
  if (!value || *value < 0 || *value > 1 << 20)
    throw Error(ErrorCode::kBadValue, fmt::format("group {} is not a set of flags", code), place(entity));
  return static_cast<int>(*value);
}

std::string DxfDocument::place(const DxfEntity& entity) const {
  return fmt::format("{} ({}:{})", entity.type, name, entity.line);
}

DxfDocument read_dxf_document(std::string_view text, const std::string& name) { return DxfParser(text, name).parse(); }

}  // namespace findspace::io
