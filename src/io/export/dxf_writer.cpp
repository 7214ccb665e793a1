// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/export/dxf_writer.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <set>
#include <utility>

namespace findspace::io {
namespace {

/// Handles that others name; all that follow count on from kFirstFree.
constexpr int kBlockRecords = 1, kModelSpace = 2, kPaperSpace = 3, kRoot = 4, kGroups = 5, kFirstFree = 16;
/// The seed of handles is stated before they are given: more than any drawing has.
constexpr std::string_view kSeed = "7FFFFFFF";

int insunits(std::optional<formula::Unit> unit) {
  if (!unit) return 0;
  switch (*unit) {
    case formula::Unit::kMicrometre:
      return 13;
    case formula::Unit::kMillimetre:
      return 4;
    case formula::Unit::kCentimetre:
      return 5;
    case formula::Unit::kMetre:
      return 6;
    case formula::Unit::kInch:
      return 1;
    case formula::Unit::kMil:
      return 9;
  }
  return 0;
}

/// Layers of R12 are short of blanks and signs, those of 2000 of some signs, and of blanks at their ends.
bool may_name(std::string_view name, std::size_t at, DxfVersion version) {
  const char c = name[at];
  if (version == DxfVersion::k2000)
    return static_cast<unsigned char>(c) >= ' ' &&
           std::string_view("<>/\\\":;?*|=,`").find(c) == std::string_view::npos &&
           (c != ' ' || (at > 0 && at + 1 < name.size()));
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '$';
}

/// The number of a character of two or three bytes of UTF-8; 0 of any other.
unsigned code_of(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(text[k])); };
  if (text.size() >= 2 && (byte(0) & 0xe0) == 0xc0) return (byte(0) & 0x1f) << 6 | (byte(1) & 0x3f);
  if (text.size() >= 3 && (byte(0) & 0xf0) == 0xe0)
    return (byte(0) & 0x0f) << 12 | (byte(1) & 0x3f) << 6 | (byte(2) & 0x3f);
  return 0;
}

bool is_inner_byte(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// A name that the version allows. Characters beyond ASCII are escapes of 2000, which has no UTF-8.
std::string allowed_name(std::string_view name, DxfVersion version) {
  std::string out;
  for (std::size_t k = 0; k < name.size(); ++k) {
    if (is_inner_byte(name[k])) continue;
    const bool ascii = static_cast<unsigned char>(name[k]) < 0x80;
    const unsigned code = ascii ? 0 : code_of(name.substr(k));
    if (ascii)
      out += may_name(name, k, version) ? name[k] : '_';
    else
      out += code != 0 && version == DxfVersion::k2000 ? fmt::format("\\U+{:04X}", code) : "_";
  }
  return out.empty() ? "0" : out;
}

std::string in_capitals(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

DxfWriter::DxfWriter(DxfVersion version, std::optional<formula::Unit> unit, std::span<const std::string> layers)
    : version_(version), next_(kFirstFree) {
  name_layers(layers);
  header(unit);
  tables();
  if (in_2000()) blocks();
  begin("ENTITIES");
}

std::string DxfWriter::take() {
  end();
  if (in_2000()) objects();
  group(0, "EOF");
  return std::move(text_);
}

void DxfWriter::polyline(std::string_view layer, std::span<const DrawnCorner> corners, bool closed) {
  if (in_2000()) {
    entity("LWPOLYLINE", layer, "AcDbPolyline");
    group(90, int(corners.size()));
    group(70, closed ? 1 : 0);
  } else {
    entity("POLYLINE", layer, "");
    group(66, 1);
    group(70, closed ? 1 : 0);
    place(0, 0);
  }
  for (const DrawnCorner& c : corners) {
    if (!in_2000()) entity("VERTEX", layer, "");
    place(c.x, c.y);
    if (c.bulge != 0) number(42, c.bulge);
  }
  if (!in_2000()) entity("SEQEND", layer, "");
}

void DxfWriter::circle(std::string_view layer, double x, double y, double radius) {
  entity("CIRCLE", layer, "AcDbCircle");
  place(x, y);
  number(40, radius);
}

void DxfWriter::point(std::string_view layer, double x, double y) {
  entity("POINT", layer, "AcDbPoint");
  place(x, y);
}

void DxfWriter::group(int code, std::string_view value) { text_ += fmt::format("{:>3}\n{}\n", code, value); }
void DxfWriter::group(int code, int value) { group(code, std::to_string(value)); }
void DxfWriter::number(int code, double value) { group(code, fmt::format("{}", value == 0 ? 0.0 : value)); }
void DxfWriter::place(double x, double y) {
  number(10, x);
  number(20, y);
}

void DxfWriter::begin(std::string_view section) {
  group(0, "SECTION");
  group(2, section);
}
void DxfWriter::end() { group(0, "ENDSEC"); }

std::string DxfWriter::handle(int number) const { return fmt::format("{:X}", number); }

/// Layers are told apart by names in capitals.
void DxfWriter::name_layers(std::span<const std::string> layers) {
  std::set<std::string> taken;
  for (const std::string& layer : layers) {
    if (layers_.contains(layer)) continue;
    const std::string name = allowed_name(layer, version_);
    std::string free = name;
    for (int k = 2; !taken.insert(in_capitals(free)).second; ++k) free = fmt::format("{}_{}", name, k);
    layers_.emplace(layer, free);
  }
}

void DxfWriter::header(std::optional<formula::Unit> unit) {
  begin("HEADER");
  group(9, "$ACADVER");
  group(1, in_2000() ? "AC1015" : "AC1009");
  if (in_2000()) {
    group(9, "$HANDSEED");
    group(5, kSeed);
  }
  group(9, "$INSUNITS");
  group(70, insunits(unit));
  end();
}

void DxfWriter::begin_table(std::string_view name, std::size_t entries) {
  group(0, "TABLE");
  group(2, name);
  if (in_2000()) {
    group(5, name == "BLOCK_RECORD" ? handle(kBlockRecords) : next_handle());
    group(330, "0");
    group(100, "AcDbSymbolTable");
  }
  group(70, int(entries));
}

void DxfWriter::table_entry(std::string_view type, std::string_view name, std::string_view kind) {
  group(0, type);
  if (in_2000()) {
    group(type == "DIMSTYLE" ? 105 : 5, next_handle());
    group(100, "AcDbSymbolTableRecord");
    group(100, kind);
  }
  group(2, name);
  group(70, 0);
}

void DxfWriter::tables() {
  begin("TABLES");
  if (in_2000()) tables_of_2000();
  std::vector<std::string> names{"0"};
  for (const auto& [layer, name] : layers_)
    if (name != "0") names.push_back(name);
  begin_table("LAYER", names.size());
  for (const std::string& name : names) {
    table_entry("LAYER", name, "AcDbLayerTableRecord");
    group(62, 7);
    group(6, "CONTINUOUS");
  }
  group(0, "ENDTAB");
  end();
}

/// The tables that must be there, with the entries that must be in them.
void DxfWriter::tables_of_2000() {
  for (const char* empty : {"VPORT", "VIEW", "UCS"}) {
    begin_table(empty, 0);
    group(0, "ENDTAB");
  }
  begin_table("LTYPE", 3);
  for (const char* name : {"ByBlock", "ByLayer", "CONTINUOUS"}) {
    table_entry("LTYPE", name, "AcDbLinetypeTableRecord");
    group(3, "");
    group(72, 65);
    group(73, 0);
    number(40, 0);
  }
  group(0, "ENDTAB");
  begin_table("STYLE", 1);
  table_entry("STYLE", "STANDARD", "AcDbTextStyleTableRecord");
  for (const int code : {40, 41, 50}) number(code, code == 41 ? 1 : 0);
  group(71, 0);
  number(42, 1);
  group(3, "txt");
  group(4, "");
  group(0, "ENDTAB");
  begin_table("APPID", 1);
  table_entry("APPID", "ACAD", "AcDbRegAppTableRecord");
  group(0, "ENDTAB");
  begin_table("DIMSTYLE", 1);
  group(100, "AcDbDimStyleTable");
  table_entry("DIMSTYLE", "STANDARD", "AcDbDimStyleTableRecord");
  group(0, "ENDTAB");
  begin_table("BLOCK_RECORD", 2);
  for (const int space : {kModelSpace, kPaperSpace}) {
    group(0, "BLOCK_RECORD");
    group(5, handle(space));
    group(330, handle(kBlockRecords));
    group(100, "AcDbSymbolTableRecord");
    group(100, "AcDbBlockTableRecord");
    group(2, space == kModelSpace ? "*Model_Space" : "*Paper_Space");
  }
  group(0, "ENDTAB");
}

void DxfWriter::blocks() {
  begin("BLOCKS");
  for (const int space : {kModelSpace, kPaperSpace}) {
    const std::string_view name = space == kModelSpace ? "*Model_Space" : "*Paper_Space";
    for (const char* type : {"BLOCK", "ENDBLK"}) {
      group(0, type);
      group(5, next_handle());
      group(330, handle(space));
      group(100, "AcDbEntity");
      group(8, "0");
      group(100, std::string_view(type) == "BLOCK" ? "AcDbBlockBegin" : "AcDbBlockEnd");
      if (std::string_view(type) == "ENDBLK") continue;
      group(2, name);
      group(70, 0);
      place(0, 0);
      group(3, name);
      group(1, "");
    }
  }
  end();
}

void DxfWriter::objects() {
  begin("OBJECTS");
  for (const int dictionary : {kRoot, kGroups}) {
    group(0, "DICTIONARY");
    group(5, handle(dictionary));
    group(330, handle(dictionary == kRoot ? 0 : kRoot));
    group(100, "AcDbDictionary");
    group(281, 1);
    if (dictionary != kRoot) continue;
    group(3, "ACAD_GROUP");
    group(350, handle(kGroups));
  }
  end();
}

void DxfWriter::entity(std::string_view type, std::string_view layer, std::string_view kind) {
  group(0, type);
  if (in_2000()) {
    group(5, next_handle());
    group(330, handle(kModelSpace));
    group(100, "AcDbEntity");
  }
  group(8, layers_.find(layer)->second);
  if (in_2000()) group(100, kind);
}

}  // namespace findspace::io
