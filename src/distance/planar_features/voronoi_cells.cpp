// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/voronoi_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/margins/planar_distance.h"

namespace findspace::distance {

using plane::Index;

/// Two half planes, the first at the first end, with that end on its border.
std::vector<VoronoiCells::HalfPlane> VoronoiCells::of_edge(const BoundaryFeature& s) {
  const auto through = [](double nx, double ny, double x, double y) {
    const double size = std::hypot(nx, ny);
    return HalfPlane{nx / size, ny / size, (nx * x + ny * y) / size};
  };
  if (!s.arc) {
    const double dx = s.x1 - s.x0, dy = s.y1 - s.y0;
    return {through(dx, dy, s.x0, s.y0), through(-dx, -dy, s.x1, s.y1)};
  }
  // An upper half is run through clockwise from its left end, a lower one counter-clockwise.
  const double turn = s.half > 0 ? -1 : 1;
  const auto side = [&](double x, double y, double sense) {
    return through(-sense * (y - s.cy), sense * (x - s.cx), s.cx, s.cy);
  };
  return {side(s.x0, s.y0, turn), side(s.x1, s.y1, -turn)};
}

/// Some direction lies on the inner side of all borders: their normals lie within less than a half turn.
bool VoronoiCells::has_inside(const std::vector<HalfPlane>& cone) {
  if (cone.size() < 2) return true;
  std::vector<double> angles;
  for (const HalfPlane& h : cone) angles.push_back(std::atan2(h.ny, h.nx));
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k) gap = std::max(gap, angles[k] - angles[k - 1]);
  return gap > std::numbers::pi + margin::kFlatVertex;
}

VoronoiCells::VoronoiCells(const plane::CellComplex& set, std::span<const BoundaryFeature> features)
    : reach_(features.size()) {
  std::vector<Index> of_vertex(set.vertices.size(), plane::kNone);
  for (Index k = 0; k < features.size(); ++k)
    if (features[k].is_vertex()) of_vertex[features[k].cell.index] = k;
  for (Index k = 0; k < features.size(); ++k) {
    if (features[k].is_vertex()) continue;
    reach_[k].bounds = of_edge(features[k]);
    const plane::Edge& e = set.edges[features[k].cell.index];
    const std::array<Index, 2> ends{e.v0, e.v1};
    for (std::size_t end = 0; end < 2; ++end) {
      const HalfPlane& h = reach_[k].bounds[end];
      if (of_vertex[ends[end]] != plane::kNone) reach_[of_vertex[ends[end]]].bounds.push_back({-h.nx, -h.ny, -h.c});
    }
  }
  for (Index k = 0; k < features.size(); ++k)
    if (features[k].is_vertex()) reach_[k].empty = !has_inside(reach_[k].bounds);
}

bool VoronoiCells::out_of_reach(Index feature, double x, double y, double radius) const {
  const Reach& r = reach_[feature];
  return r.empty || std::any_of(r.bounds.begin(), r.bounds.end(),
                                [&](const HalfPlane& h) { return h.nx * x + h.ny * y < h.c - radius; });
}

}  // namespace findspace::distance
