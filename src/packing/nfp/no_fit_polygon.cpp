// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/no_fit_polygon.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "plane/complex/primitives.h"
#include "plane/sum/minkowski.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kMostEdges = 65535;  // that a depth field numbers
constexpr int kSides = 32;                 // of the polygon about the disc of a gap
constexpr int kSearchDigits = 7;           // of the search's grid, at most

plane::Region region(const SearchShape& shape) {
  std::vector<plane::Contour> contours;
  for (const auto& ring : shape.rings) {
    plane::Contour& contour = contours.emplace_back();
    for (const auto& [x, y] : ring) contour.push_back({.start = {x, y}});
  }
  return plane::region_of_rings(contours);
}

/// A polygon of the grid that holds the disc; its corners are rounded away from the centre.
SearchShape about_disc(double radius, double step) {
  SearchShape result;
  result.step = step;
  auto& ring = result.rings.emplace_back();
  const double out = radius / step / std::cos(std::numbers::pi / kSides);
  const auto away = [](double c) { return std::int64_t(c < 0 ? std::floor(c) : std::ceil(c)); };
  for (int k = 0; k < kSides; ++k) {
    const double angle = (2 * k + 1) * std::numbers::pi / kSides;
    ring.emplace_back(away(out * std::cos(angle)), away(out * std::sin(angle)));
  }
  return result;
}

class Boundary {
 public:
  Boundary(const plane::SignMap& map, double step) : map_(map), step_(step) {
    for (plane::Index e = 0; e < map.edges.size(); ++e) add_edge(e);
    for (const plane::Vertex& v : map.vertices)
      if (v.out == plane::kNone && v.mark == 0) add({at(v.point), at(v.point), true});
  }
  NoFitPolygon take() { return std::move(result_); }

 private:
  Vec at(plane::Index point) const {
    const exact::Point& p = map_.geometry.points[point];
    if (p.kind == exact::Point::Kind::kGrid) return {double(p.gx) * step_, double(p.gy) * step_};
    return {p.x * step_, p.y * step_};
  }
  void add_edge(plane::Index e) {
    if (map_.edges[e].mark != 0) return;
    const bool left = map_.faces[map_.face(2 * e)].mark < 0, right = map_.faces[map_.face(2 * e + 1)].mark < 0;
    if (!left && !right) return;
    Vec from = at(map_.vertices[map_.edges[e].v0].point), to = at(map_.vertices[map_.edges[e].v1].point);
    if (!left) std::swap(from, to);
    add({from, to, left && right});
  }
  void add(const NoFitEdge& edge) {
    result_.edges.push_back(edge);
    for (const Vec p : {edge.from, edge.to}) {
      result_.low = {std::min(result_.low.x, p.x), std::min(result_.low.y, p.y)};
      result_.high = {std::max(result_.high.x, p.x), std::max(result_.high.y, p.y)};
    }
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();
  const plane::SignMap& map_;
  double step_;
  NoFitPolygon result_{{}, {kFar, kFar}, {-kFar, -kFar}};
};

}  // namespace

SearchShape search_shape(const Polygon& shape, int digits) {
  SearchShape result;
  const int128 drop = power_of_ten(std::max(0, digits - kSearchDigits));
  result.step = 1 / double(power_of_ten(std::min(digits, kSearchDigits)));
  const auto rounded = [&](int128 c) { return std::int64_t((c + (c < 0 ? -drop : drop) / 2) / drop); };
  for (const Ring& ring : shape.rings) {
    auto& out = result.rings.emplace_back();
    for (const LatticePoint& p : ring) {
      const std::pair<std::int64_t, std::int64_t> q{rounded(p.x), rounded(p.y)};
      if (out.empty() || out.back() != q) out.push_back(q);
    }
    while (out.size() > 1 && out.back() == out.front()) out.pop_back();
  }
  return result;
}

NoFitPolygon no_fit_polygon(const SearchShape& a, const SearchShape& b, double gap) {
  const plane::Region grown = gap > 0 ? plane::minkowski_sum(region(a), region(about_disc(gap, a.step))) : region(a);
  NoFitPolygon result = Boundary(plane::contact_map(grown, region(b)), a.step).take();
  if (result.edges.size() > kMostEdges)
    throw Error(ErrorCode::kUnsupported, "two parts have too many corners to be packed together");
  return result;
}

}  // namespace findspace::packing
