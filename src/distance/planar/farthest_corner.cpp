// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/farthest_corner.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/planar_distance.h"
#include "plane/base/real_vector.h"
#include "plane/query/nearest.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Index;
using plane::Mark;
using plane::Region;
using plane::operator+;

namespace {

bool has_arcs(const Region& r) {
  return std::any_of(r.edges.begin(), r.edges.end(), [](const plane::Edge& e) { return e.half != 0; });
}

/// Of one ring that certainly turns left at every vertex; false where numbers cannot tell.
bool clearly_convex(const Region& a) {
  if (a.faces.size() != 2 || a.faces[0].mark > 0 || a.edges.size() != a.vertices.size() || has_arcs(a)) return false;
  double x = 0, y = 0, scale = 1;
  for (const plane::Vertex& v : a.vertices) {
    const exact::Point& p = a.point(&v - a.vertices.data());
    x += p.x / double(a.vertices.size());
    y += p.y / double(a.vertices.size());
    scale = std::max({scale, std::abs(p.x), std::abs(p.y)});
  }
  // All vertices but the ends of an edge lie on the same side of it as the middle.
  return std::all_of(a.edges.begin(), a.edges.end(), [&](const plane::Edge& e) {
    const exact::Point &p = a.point(e.v0), &q = a.point(e.v1);
    const double dx = q.x - p.x, dy = q.y - p.y, length = std::hypot(dx, dy);
    const auto height = [&](double px, double py) { return (dx * (py - p.y) - dy * (px - p.x)) / length; };
    const double side = height(x, y);
    for (Index v = 0; v < a.vertices.size(); ++v) {
      const exact::Point& o = a.point(v);
      if (v != e.v0 && v != e.v1 && height(o.x, o.y) * side <= std::abs(side) * scale * margin::kSameNumber)
        return false;
    }
    return true;
  });
}

bool of_set(Mark m) { return m > 0; }

}  // namespace

FarthestPlace farthest_corner(const Region& b, const Region& a, const RealPoint& p, double reach) {
  plane::Locator in_a(a);
  std::optional<FarthestPlace> best;
  for (Index v = 0; v < b.vertices.size(); ++v) {
    if (!of_set(b.vertices[v].mark)) continue;
    const RealPoint at = b.geometry.exact(b.vertices[v].point) + p;
    const Real d = of_set(in_a.mark(at)) ? Real() : plane::nearest(a, of_set, at)->distance;
    if (!best || d > best->value) best = FarthestPlace{d, at, {0, v}};
  }
  const bool point = b.vertices.size() == 1 && b.edges.empty();
  if (!point && (has_arcs(b) || !clearly_convex(a))) best->open = reach;
  return *best;
}

}  // namespace findspace::distance
