// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "findspace/error.h"

namespace findspace::io {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f";
constexpr std::array<std::string_view, 14> kGeometries{
    "POINT",        "MULTIPOINT",   "LINESTRING",         "MULTILINESTRING", "POLYGON",
    "MULTIPOLYGON", "SRID",         "CIRCULARSTRING",     "COMPOUNDCURVE",   "CURVEPOLYGON",
    "MULTICURVE",   "MULTISURFACE", "GEOMETRYCOLLECTION", "TRIANGLE"};
constexpr std::array<std::string_view, 5> kJsonKeys{"coordinates", "geometry", "geometries", "features", "exact"};

/// Without a byte order mark and the blanks at its beginning.
std::string_view trimmed(std::string_view text) {
  text = without_byte_order_mark(text);
  return text.substr(std::min(text.find_first_not_of(kBlanks), text.size()));
}

std::string_view first_word(std::string_view text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return text.substr(0, static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), letter) - text.begin()));
}

bool same(std::string_view a, std::string_view b) {
  const auto upper = [](char c) { return std::toupper(static_cast<unsigned char>(c)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return upper(x) == upper(y); });
}

bool is_wkt(std::string_view text) {
  text = trimmed(text);
  return text.empty() || std::any_of(kGeometries.begin(), kGeometries.end(),
                                     [&](std::string_view name) { return same(name, first_word(text)); });
}

/// Group 0 or a comment comes first, and a section somewhere.
bool is_dxf(std::string_view text) {
  if (text.starts_with("AutoCAD Binary DXF")) return true;
  text = trimmed(text);
  const std::string_view group = text.substr(0, text.find_first_of(kBlanks));
  return (group == "0" || group == "999") && text.find("SECTION") != std::string_view::npos;
}

/// An object that has one of the keys of GeoJSON, or exact cells.
bool is_shape_json(std::string_view text) {
  return trimmed(text).starts_with('{') && std::any_of(kJsonKeys.begin(), kJsonKeys.end(), [&](std::string_view key) {
           return text.find(fmt::format("\"{}\"", key)) != std::string_view::npos;
         });
}

bool is_svg(std::string_view text) {
  return trimmed(text).starts_with('<') &&
         (text.find("<svg") != std::string_view::npos || text.find(":svg") != std::string_view::npos);
}

/// Some line states a vertex: "v" and a number.
bool is_obj(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    const std::string_view line = trimmed(text.substr(at, std::min<std::size_t>(text.find('\n', at) - at, 80)));
    if (line.size() < 3 || line[0] != 'v' || (line[1] != ' ' && line[1] != '\t')) continue;
    const std::string_view number = trimmed(line.substr(1));
    return !number.empty() && std::string_view("+-.0123456789").find(number[0]) != std::string_view::npos;
  }
  return false;
}

/// The first word of the first line that is not a comment.
std::string_view headline_word(std::string_view text) {
  text = trimmed(text);
  while (text.starts_with('#')) text = trimmed(text.substr(std::min(text.find('\n'), text.size())));
  return text.substr(0, text.find_first_of(kBlanks));
}

constexpr std::size_t kStlHead = 84, kStlTriangle = 50;  // bytes of a binary file

/// Its count, which stands at the end of the head.
std::size_t stl_triangles(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[kStlHead - 4 + i]); };
  return byte(0) | byte(1) << 8U | byte(2) << 16U | std::size_t{byte(3)} << 24U;
}

/// Binary files have their length by their count of triangles.
bool is_stl(std::string_view text) {
  if (text.size() >= kStlHead && text.size() == kStlHead + kStlTriangle * stl_triangles(text)) return true;
  return trimmed(text).starts_with("solid") && text.find("facet") != std::string_view::npos;
}

/// The first line of a grid of heights counts its columns.
bool is_asc(std::string_view text) { return same(headline_word(text), "ncols"); }

bool is_step(std::string_view text) { return trimmed(text).starts_with("ISO-10303-21"); }

/// The letter of the start section ends the first card.
bool is_iges(std::string_view text) { return text.size() > 80 && text[72] == 'S'; }

struct FileKind {
  std::string_view ending, name;
  bool space;
  bool (*is)(std::string_view text);
};

constexpr std::array<FileKind, 16> kKinds{{
    {".svg", "an SVG drawing", false, is_svg},
    {".dxf", "a DXF drawing", false, is_dxf},
    {".wkt", "well-known text of a geometry", false, is_wkt},
    {".geojson", "GeoJSON", false, is_shape_json},
    {".json", "GeoJSON or a result with exact cells", false, is_shape_json},
    {".stl", "a whole STL mesh", true, is_stl},
    {".obj", "an OBJ mesh", true, is_obj},
    {".off", "an OFF mesh", true, [](std::string_view t) { return headline_word(t).ends_with("OFF"); }},
    {".ply", "a PLY mesh", true, [](std::string_view t) { return headline_word(t) == "ply"; }},
    {".3mf", "a 3MF package", true,
     [](std::string_view) { return true; }},  // its reader shows nothing of what is no ZIP
    {".glb", "a binary glTF file", true, [](std::string_view t) { return t.starts_with("glTF"); }},
    {".asc", "an ASCII grid of heights", true, is_asc},
    {".step", "a STEP file", true, is_step},
    {".stp", "a STEP file", true, is_step},
    {".iges", "an IGES file", true, is_iges},
    {".igs", "an IGES file", true, is_iges},
}};

const FileKind* kind_of(std::string_view ending) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(), [&](const FileKind& k) { return k.ending == ending; });
  return found == kKinds.end() ? nullptr : &*found;
}

/// A kind of file by its first bytes, and what to do about it. None of the file's words is shown.
struct OtherKind {
  std::string_view begin, what;
};
constexpr std::array<OtherKind, 8> kOtherFiles{{{"\x1f\x8b", "gzip has compressed it: unpack it first"},
                                                {"PK\x03\x04", "it is a ZIP archive: unpack it first"},
                                                {"AC10", "it is a DWG drawing: save it as DXF"},
                                                {"%PDF", "it is a PDF file: export SVG or DXF"},
                                                {"\x89PNG", "it is a picture of pixels"},
                                                {"\xff\xd8\xff", "it is a picture of pixels"},
                                                {"GIF8", "it is a picture of pixels"},
                                                {"<!DOCTYPE html", "it is a page of the web"}}};

/// ": what it is instead", where that is known.
std::string what_instead(const FileKind& kind, std::string_view text) {
  if (text.empty()) return ": it is empty";
  for (const OtherKind& other : kOtherFiles)
    if (text.starts_with(other.begin)) return fmt::format(": {}", other.what);
  if (same(trimmed(text).substr(0, 5), "<html")) return ": it is a page of the web";
  const bool stl = kind.ending == ".stl" && text.size() >= kStlHead && !trimmed(text).starts_with("solid");
  if (!stl) return "";
  return ": its length does not fit its count of triangles, so it is cut off or no mesh";
}

/// Of JSON that is not a shape: what a shape would have. Nothing of the file is shown: it may be anyone's.
std::string lacks(const FileKind& kind, std::string_view text) {
  if (kind.is != is_shape_json || !trimmed(text).starts_with('{')) return "";
  if (text.find("\"type\"") == std::string_view::npos) return ": it has no \"type\"";
  return ": it has a \"type\", but no \"coordinates\", \"geometry\", \"geometries\" or \"features\"";
}

}  // namespace

void require_kind(std::string_view text, std::string_view ending, const std::string& name) {
  const FileKind* kind = kind_of(ending);
  if (kind == nullptr || kind->is(text)) return;
  const std::string instead = what_instead(*kind, text);
  throw Error(
      ErrorCode::kFile,
      fmt::format("this is not {}, by how it begins{}", kind->name, instead.empty() ? lacks(*kind, text) : instead),
      name);
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

bool is_space_ending(std::string_view ending) {
  const FileKind* kind = kind_of(ending);
  return kind != nullptr && kind->space;
}

bool is_plane_ending(std::string_view ending) {
  const FileKind* kind = kind_of(ending);
  return kind != nullptr && !kind->space;
}

std::vector<std::string_view> file_endings(bool space) {
  std::vector<std::string_view> out;
  for (const FileKind& kind : kKinds)
    if (kind.space == space) out.push_back(kind.ending);
  return out;
}

std::string lower_ending(const std::string& ending) {
  std::string out = ending;
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return out;
}

}  // namespace findspace::io
