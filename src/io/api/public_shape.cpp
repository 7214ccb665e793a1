// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What public shapes and regions have to do with text: scenes, files, paths, JSON, WKT, SVG.

#include <fmt/format.h>

#include <filesystem>

#include "api/values/region_data.h"
#include "api/values/shape_data.h"
#include "findspace/error.h"
#include "io/scene/scene.h"
#include "io/write/write_cells.h"
#include "io/write/write_json.h"
#include "io/write/write_svg.h"
#include "io/write/write_wkt.h"

namespace findspace {
namespace {

/// A shape as a scene would have it.
Shape scene_shape(std::string_view text, const Grid& grid, const std::string& name) {
  const io::Scene scene = io::read_scene_text(
      fmt::format("{{\"findspace\": 1, \"grid\": {}, \"shapes\": {{\"shape\": {}}}}}", grid.step.text(), text),
      std::filesystem::current_path(), name);
  return api::make_shape(scene.shapes[0], scene.grid, scene.dimension);
}

}  // namespace

Shape Shape::json(std::string_view text, const Grid& grid) { return scene_shape(text, grid, "shape"); }
Shape Shape::path(std::string_view data, const Grid& grid) {
  return scene_shape(fmt::format("{{\"path\": {}}}", io::json_string(data)), grid, "path");
}
Shape Shape::file(const std::string& path, const Grid& grid) {
  return scene_shape(fmt::format("{{\"file\": {}}}", io::json_string(path)), grid, path);
}

std::string Region::json() const {
  return io::region_json(data_->cells, data_->summary(), data_->grid.step(), data_->unit);
}
std::string Region::exact_json() const {
  return fmt::format("{{\"cells\": {}}}", io::cells_json(data_->cells, data_->grid.step(), data_->unit));
}
std::string Region::wkt() const { return io::region_wkt(data_->cells, data_->grid.step()).text; }
std::string Region::svg() const {
  return io::shape_svg(data_->cells, data_->grid.step(), "region", formula::find_unit(data_->unit)).text;
}

}  // namespace findspace
