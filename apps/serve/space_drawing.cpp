// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/space_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "findspace/text.h"

namespace findspace::app {
namespace {

std::string corner_json(const Position3& p) {
  return fmt::format("[{}, {}, {}]", json_number(p[0]), json_number(p[1]), json_number(p[2]));
}

std::string corners_list(const std::vector<Position3>& places) { return json_list(places, corner_json); }

}  // namespace

void SpaceWindow::include(const Surface& surface) {
  for (const Position3& v : surface.vertices) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = any ? std::min(box.low[k], v[k]) : v[k];
      box.high[k] = any ? std::max(box.high[k], v[k]) : v[k];
    }
    any = true;
  }
}

SpaceWindow SpaceWindow::wider() const {
  SpaceWindow out = *this;
  double size = 1;
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, box.high[k] - box.low[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    out.box.low[k] -= size;
    out.box.high[k] += size;
  }
  return out;
}

std::string SpaceDrawing::json() const {
  const std::string faces =
      json_list(solid.faces, [](const std::vector<int>& face) { return fmt::format("[{}]", fmt::join(face, ",")); });
  return fmt::format(R"({{"vertices": {}, "faces": {}, "sheets": {}, "curves": {}, "points": {}}})",
                     corners_list(solid.vertices), faces, json_list(thin.sheets, corners_list),
                     json_list(thin.curves, corners_list), corners_list(thin.points));
}

SpaceDrawing drawing_of(const SpaceRegion& region, const SpaceWindow& window) {
  if (region.empty()) return {};
  SpaceDrawing out{region.surface(), region.thin(window.box)};
  if (out.solid.faces.empty()) out.solid = {};
  return out;
}

SpaceDrawing drawing_of_line(const std::vector<Interval>& intervals, const Scene::Free& line,
                             const SpaceWindow& window) {
  Position3 through{}, direction{};
  for (std::size_t k = 0; k < 3; ++k) {
    through[k] = line.through[k].value();
    direction[k] = line.direction[k].value();
  }
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k)
    reach = std::max({reach, std::abs(window.box.high[k] - through[k]), std::abs(window.box.low[k] - through[k])});
  const auto at = [&](const std::optional<double>& t, double end) {
    const double gone = t.value_or(end) / length;
    return Position3{through[0] + gone * direction[0], through[1] + gone * direction[1],
                     through[2] + gone * direction[2]};
  };
  SpaceDrawing out;
  for (const Interval& i : intervals) {
    if (i.from && i.to && *i.from == *i.to && i.from_belongs && i.to_belongs)
      out.thin.points.push_back(at(i.from, 0));
    else
      out.thin.curves.push_back({at(i.from, -reach), at(i.to, reach)});
  }
  return out;
}

}  // namespace findspace::app
