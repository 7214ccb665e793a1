// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/read/read_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "findspace/error.h"
#include "io/text/file_kind.h"
#include "io/text/outline_shapes.h"
#include "io/text/read_cells.h"

namespace findspace::io {
namespace {

/// A result with its exact cells, or GeoJSON.
plane::ShapePtr read_json(std::string_view text, const std::string& name, const FileChoice& choice,
                          ReadContext& context) {
  const JsonTree tree = parse_json(text, name, context.work);
  const JsonValue& root = tree.root();
  const JsonValue* exact = root.is(JsonValue::Kind::kObject) ? root.find("exact") : nullptr;
  if (exact == nullptr) return read_geojson(text, name, choice, context);
  refuse_choice(choice.id.has_value(), "id", "exact cells", name);
  refuse_choice(choice.layer.has_value(), "layer", "exact cells", name);
  refuse_choice(choice.index.has_value(), "index", "exact cells", name);
  const bool stated = exact->find("unit") != nullptr;
  if (stated) refuse_choice(choice.unit.has_value(), "unit", "exact cells, which state theirs", name);
  const exact::Real scale = stated ? exact::Real(1) : file_scale(std::nullopt, name, choice, context);
  return read_cells(SceneReader(name, context), *exact, {}, scale);
}

using Reader = plane::ShapePtr (*)(std::string_view, const std::string&, const FileChoice&, ReadContext&);
struct Format {
  std::string_view ending;
  Reader read;
};
constexpr std::array<Format, 5> kFormats{
    {{".svg", read_svg}, {".dxf", read_dxf}, {".wkt", read_wkt}, {".geojson", read_geojson}, {".json", read_json}}};

}  // namespace

plane::ShapePtr read_shape_file(const std::filesystem::path& path, const FileChoice& choice, ReadContext& context,
                                int dimension) {
  std::string name = path.string();
  const std::string ending = lower_ending(path.extension().string());
  const auto format =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return f.ending == ending; });
  if (format == kFormats.end()) {
    const std::string in_plane = fmt::format("2D shapes come from {}", fmt::join(file_endings(false), " "));
    const std::string in_space = fmt::format("3D shapes come from {}", fmt::join(file_endings(true), " "));
    const std::string kinds = dimension == 2   ? in_plane
                              : dimension == 3 ? in_space
                                               : fmt::format("{}, and {}", in_plane, in_space);
    throw Error(ErrorCode::kFile, fmt::format("a file of unknown kind '{}'; {}", ending, kinds), name);
  }
  refuse_choice(choice.floor.has_value(), "floor", "a file without heights", name);
  const std::string text = context.take_file(path);
  require_kind(text, ending, name);
  return format->read(text, name, choice, context);
}

exact::Real file_scale(const std::optional<exact::Real>& millimetres, const std::string& name, const FileChoice& choice,
                       ReadContext& context) {
  if (choice.unit || millimetres) {
    if (!context.unit) {
      throw Error(ErrorCode::kBadValue, "the shape's file has a unit, so the scene needs \"unit\" too", name);
    }
    if (choice.unit) return formula::factor(*choice.unit, *context.unit);
    return *millimetres * formula::factor(Unit::kMillimetre, *context.unit);
  }
  if (context.unit)
    context.notes.push_back(fmt::format("{} states no unit: read as {}", name, formula::name(*context.unit)));
  return 1;
}

plane::ShapePtr chosen(std::vector<plane::ShapePtr> parts, const std::string& name, const FileChoice& choice) {
  if (parts.empty()) throw Error(ErrorCode::kGeometry, "there is no shape in it", name);
  if (!choice.index) return united(std::move(parts), name, true);
  if (*choice.index < parts.size()) return parts[*choice.index];
  throw Error(ErrorCode::kBadValue,
              fmt::format("\"index\" {} is too large: it has {} shape{}, counted from 0", *choice.index, parts.size(),
                          parts.size() == 1 ? "" : "s"),
              name);
}

bool nests(const FileChoice& choice, const ReadContext& context) {
  if (context.drawing.parts == PartRule::kOutlines) return true;  // an index counts these
  const bool one = context.drawing.parts ? context.drawing.parts == PartRule::kOne : context.quantities;
  return one && !choice.index;
}

void refuse_choice(bool given, const char* key, const char* format, const std::string& name) {
  if (given) throw Error(ErrorCode::kBadValue, fmt::format("\"{}\" has no meaning for {}", key, format), name);
}

TextPlaces::TextPlaces(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  Line line;
  for (std::size_t at = 0; at <= text.size(); at += kBlock) {
    lines_.push_back(line);
    pass(line, at, std::min(at + kBlock, text.size()));
  }
}

void TextPlaces::pass(Line& line, std::size_t from, std::size_t to) const {
  for (std::size_t at = from; at < to; ++at) {
    if (text_[at] != '\n') continue;
    ++line.number;
    line.start = at + 1;
  }
}

std::string TextPlaces::at(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const std::size_t block = offset / kBlock;
  Line line = lines_[block];
  pass(line, block * kBlock, offset);
  return fmt::format("{}:{}:{}", name_, line.number, offset - line.start + 1);
}

}  // namespace findspace::io
