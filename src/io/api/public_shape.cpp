// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What public shapes and regions have to do with text: scenes, files, paths, JSON, WKT, SVG.

#include <fmt/format.h>

#include <filesystem>

#include "api/values/region_data.h"
#include "api/values/shape_data.h"
#include "findspace/error.h"
#include "io/draw/draw_region.h"
#include "io/export/write_drawing.h"
#include "io/export/write_wkt.h"
#include "io/scene/scene.h"
#include "io/write/write_cells.h"
#include "io/write/write_constructive.h"
#include "io/write/write_json.h"
#include "io/write/write_summary.h"
#include "io/write/write_svg.h"

namespace findspace {
namespace {

/// A shape as a scene would have it.
Shape scene_shape(std::string_view text, const Grid& grid, const std::string& name) {
  const io::Scene scene = io::read_shape_text(text, api::real_of(grid.step), std::filesystem::current_path(), name);
  return api::make_shape(scene.shapes[0], scene.grid, scene.dimension, {}, plane::kUsualWorkBudget,
                         scene.unit ? std::string(formula::name(*scene.unit)) : "");
}

/// The same of a text that is made here: a place in it tells nobody anything.
Shape made_shape(const char* kind, std::string_view value, const Grid& grid, const std::string& name) {
  try {
    return scene_shape(fmt::format("{{\"{}\": {}}}", kind, io::json_string(value)), grid, name);
  } catch (const Error& e) {
    Error plain(e.code(), e.message(), name);
    for (const auto& p : e.geometry()) plain.at(p[0], p[1]);
    throw plain;
  }
}

}  // namespace

Shape Shape::json(std::string_view text, const Grid& grid) { return scene_shape(text, grid, "shape"); }
Shape Shape::path(std::string_view data, const Grid& grid) { return made_shape("path", data, grid, "path"); }
Shape Shape::file(const std::string& path, const Grid& grid) { return made_shape("file", path, grid, path); }

std::string Region::json(bool exact) const {
  return io::region_json(data_->cells, data_->summary(), data_->grid.step(), data_->unit, nullptr, exact);
}
std::string Region::text(std::string_view title) const {
  return io::summary_text(title, data_->summary(), data_->unit);
}
std::string Region::scene_json(std::string_view name) const {
  return io::constructive_scene(data_->cells, name, data_->grid, data_->unit);
}
std::string Region::exact_json() const {
  return fmt::format("{{\"cells\": {}}}", io::cells_json(data_->cells, data_->grid.step(), data_->unit));
}
std::string Region::wkt() const { return io::region_wkt(data_->cells, data_->grid.step()).text; }
std::string Region::svg() const {
  return io::shape_svg(data_->cells, data_->grid.step(), "region", formula::find_unit(data_->unit)).text;
}

Region::Drawn Region::drawn(std::string_view ending, std::string_view name, DxfVersion dxf) const {
  const exact::Real& step = data_->grid.step();
  const auto unit = formula::find_unit(data_->unit);
  const io::NamedRegion named{std::string(name), &data_->cells};
  const auto plain = [](auto drawn) { return Drawn{std::move(drawn.text), std::move(drawn.lost)}; };
  if (ending == ".svg") return plain(io::shape_svg(data_->cells, step, name, unit));
  if (ending == ".dxf") return plain(io::shapes_dxf({&named, 1}, step, unit, dxf));
  if (ending == ".geojson") return plain(io::shapes_geojson({&named, 1}, step));
  if (ending == ".wkt") return plain(io::region_wkt(data_->cells, step));
  throw Error(ErrorCode::kUnsupported, fmt::format("a region is not written as '{}'", ending));
}

Region::Paths Region::paths(const Bounds& window, bool y_down) const {
  io::Frame frame;
  frame.world = {window.low, window.high};
  frame.left = window.low[0];
  frame.y_down = y_down;
  frame.top = y_down ? window.low[1] : -window.high[1];
  io::RegionDrawing drawn = io::region_drawing(plane::CurveNet(data_->cells, data_->grid.step()), frame);
  return {std::move(drawn.faces),  std::move(drawn.closed), std::move(drawn.open),  std::move(drawn.free),
          std::move(drawn.points), std::move(drawn.full),   std::move(drawn.hollow)};
}

std::string Region::picture(std::string_view title, std::string_view subtitle) const {
  io::Picture picture;
  picture.title = title;
  picture.subtitle = subtitle;
  picture.step = data_->grid.step();
  picture.unit = data_->unit;
  picture.region = &data_->cells;
  picture.summary = &data_->summary();
  picture.of_positions = false;
  return io::picture_svg(picture);
}

}  // namespace findspace
