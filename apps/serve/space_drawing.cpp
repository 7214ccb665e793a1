// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/space_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "findspace/text.h"
#include "io/mesh/space_surface.h"
#include "space/box/box_operations.h"
#include "space/box/box_topology.h"

namespace findspace::app {
namespace {

std::string corner_json(const SpacePlace& p) {
  return fmt::format("[{}, {}, {}]", json_number(p[0]), json_number(p[1]), json_number(p[2]));
}

std::string corners_list(const std::vector<SpacePlace>& places) { return json_list(places, corner_json); }

/// What the closure of its interior leaves of a set.
space::BoxComplex without_volume(const space::BoxComplex& set) {
  const space::BoxComplex solid = space::regularized(set);
  const std::array<const space::BoxComplex*, 2> both{&set, &solid};
  return space::overlay(both, [](std::span<const space::Mark> m) { return space::Mark(m[0] != 0 && m[1] == 0); })
      .simplified();
}

/// The corners of a flat box that is cut off at the window: of a sheet in order around it.
std::vector<SpacePlace> corners_of(const space::IntervalBox& box, const exact::Real& step, const SpaceWindow& window) {
  SpacePlace from{}, to{};
  std::vector<std::size_t> wide;
  for (std::size_t k = 0; k < 3; ++k) {
    from[k] = box[k].from ? (*box[k].from * step).to_double() : window.low[k];
    to[k] = box[k].to ? (*box[k].to * step).to_double() : window.high[k];
    if (!(box[k].from && box[k].to && *box[k].from == *box[k].to)) wide.push_back(k);
  }
  std::vector<SpacePlace> out{from};
  if (wide.empty()) return out;
  const auto add = [&](std::initializer_list<std::size_t> far) {
    SpacePlace p = from;
    for (const std::size_t k : far) p[k] = to[k];
    out.push_back(p);
  };
  add({wide[0]});
  if (wide.size() == 1) return out;
  add({wide[0], wide[1]});
  add({wide[1]});
  return out;
}

}  // namespace

void SpaceWindow::include(const io::Surface& surface) {
  for (const auto& v : surface.vertices) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = any ? std::min(low[k], v[k]) : v[k];
      high[k] = any ? std::max(high[k], v[k]) : v[k];
    }
    any = true;
  }
}

SpaceWindow SpaceWindow::wider() const {
  SpaceWindow out = *this;
  double size = 1;
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, high[k] - low[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    out.low[k] -= size;
    out.high[k] += size;
  }
  return out;
}

std::string SpaceDrawing::json() const {
  const std::string faces =
      json_list(solid.faces, [](const std::vector<int>& face) { return fmt::format("[{}]", fmt::join(face, ",")); });
  return fmt::format(R"({{"vertices": {}, "faces": {}, "sheets": {}, "curves": {}, "points": {}}})",
                     corners_list(solid.vertices), faces, json_list(sheets, corners_list),
                     json_list(curves, corners_list), corners_list(points));
}

SpaceDrawing drawing_of_boxes(const space::BoxComplex& set, const exact::Real& step, const SpaceWindow& window) {
  SpaceDrawing out;
  out.solid = io::box_surface(set, step);
  for (const space::IntervalBox& box : without_volume(set).boxes()) {
    std::vector<SpacePlace> corners = corners_of(box, step, window);
    if (corners.size() == 1)
      out.points.push_back(corners[0]);
    else
      (corners.size() == 2 ? out.curves : out.sheets).push_back(std::move(corners));
  }
  return out;
}

SpaceDrawing drawing_of_convex(const space::ConvexSet& set, const exact::Real& step) {
  SpaceDrawing out;
  if (!set.inside && !set.frontier && !set.outside) return out;
  const int dimension = set.region.dimension();
  io::Surface all = io::convex_surface(set, step);
  if (dimension == 3) {
    out.solid = std::move(all);
    return out;
  }
  if (!set.frontier) return out;
  std::vector<SpacePlace> corners(all.vertices.begin(), all.vertices.end());
  if (dimension == 2) {
    std::vector<SpacePlace> sheet;
    for (const int v : set.region.circuit(set.region.facets().at(0))) sheet.push_back(corners[std::size_t(v)]);
    out.sheets.push_back(std::move(sheet));
  } else if (dimension == 1) {
    out.curves.push_back(std::move(corners));
  } else {
    out.points = std::move(corners);
  }
  return out;
}

SpaceDrawing drawing_of_line(const std::vector<plane::LineInterval>& intervals, const SpacePlace& through,
                             const SpacePlace& direction, const SpaceWindow& window) {
  SpaceDrawing out;
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k)
    reach = std::max({reach, std::abs(window.high[k] - through[k]), std::abs(window.low[k] - through[k])});
  const auto at = [&](const std::optional<exact::Real>& t, double end) {
    const double gone = (t ? t->to_double() : end) / length;
    return SpacePlace{through[0] + gone * direction[0], through[1] + gone * direction[1],
                      through[2] + gone * direction[2]};
  };
  for (const plane::LineInterval& i : intervals) {
    if (i.from && i.to && *i.from == *i.to)
      out.points.push_back(at(i.from, 0));
    else
      out.curves.push_back({at(i.from, -reach), at(i.to, reach)});
  }
  return out;
}

}  // namespace findspace::app
