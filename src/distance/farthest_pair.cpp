// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/farthest_pair.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "distance/sites.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Region;

namespace {

/// Vertices on the convex hull of all vertices (or within rounding of it), and all arcs.
std::vector<Site> outer_sites(const Region& r) {
  std::vector<Site> vertices, arcs, hull;
  for (const Site& s : sites(r, [](plane::Mark m) { return m > 0; })) {
    if (s.is_vertex()) vertices.push_back(s);
    else if (s.arc) arcs.push_back(s);
  }
  std::sort(vertices.begin(), vertices.end(), [](const Site& p, const Site& q) { return p.x0 != q.x0 ? p.x0 < q.x0 : p.y0 < q.y0; });
  auto inner = [](const Site& p, const Site& q, const Site& next) {
    double ax = q.x0 - p.x0, ay = q.y0 - p.y0, bx = next.x0 - p.x0, by = next.y0 - p.y0;
    return ax * by - ay * bx < -0x1p-40 * (std::abs(ax * by) + std::abs(ay * bx));
  };
  for (int pass = 0; pass < 2; ++pass) {
    std::size_t first = hull.size();
    for (const Site& s : vertices) {
      while (hull.size() >= first + 2 && inner(hull[hull.size() - 2], hull.back(), s)) hull.pop_back();
      hull.push_back(s);
    }
    std::reverse(vertices.begin(), vertices.end());
  }
  hull.insert(hull.end(), arcs.begin(), arcs.end());
  return hull;
}

/// The greatest distance of the two, where it is taken inside arcs or in vertices; less than 0 where an end does better.
double greatest(const Site& s, const Site& t, double px, double py) {
  double sx = s.arc ? s.cx : s.x0, sy = s.arc ? s.cy : s.y0, tx = (t.arc ? t.cx : t.x0) + px, ty = (t.arc ? t.cy : t.y0) + py;
  if (s.arc && !s.has_direction(sx - tx, sy - ty)) return -1;
  if (t.arc && !t.has_direction(tx - sx, ty - sy)) return -1;
  return std::hypot(sx - tx, sy - ty) + s.r + t.r;
}

/// From the centre of a site outwards along d, for its radius.
RealPoint pushed(const Region& r, const Site& s, const Front& centre, const Real& dx, const Real& dy, const Real& d) {
  if (!s.arc) return {centre.a, centre.b};
  if (d.sign() == 0) return r.geometry.exact(r.vertices[r.edges[s.cell.index].v0].point);
  return {centre.a - centre.c * dx / d, centre.b - centre.c * dy / d};
}

}  // namespace

FarthestPair farthest_pair(const Region& a, const Region& b, const RealPoint& p) {
  std::vector<Site> as = outer_sites(a), bs = outer_sites(b);
  double px = near_value(p.x), py = near_value(p.y), most = 0;
  for (const Site& s : as)
    for (const Site& t : bs) most = std::max(most, greatest(s, t, px, py));
  std::optional<FarthestPair> best;
  for (const Site& s : as)
    for (const Site& t : bs) {
      if (greatest(s, t, px, py) < most * (1 - 0x1p-42)) continue;
      Front f = far_front(a, s), g = far_front(b, t).moved({-p.x, -p.y});
      Real dx = f.a - g.a, dy = f.b - g.b, d = sqrt(dx * dx + dy * dy), value = d - f.c - g.c;
      if (best && value.to_double() <= best->distance.to_double()) continue;
      RealPoint second = pushed(b, t, g, -dx, -dy, d);
      if (t.arc && d.sign() == 0) second = {second.x + p.x, second.y + p.y};
      best = FarthestPair{value, pushed(a, s, f, dx, dy, d), second, s.cell, t.cell};
    }
  return *best;
}

}  // namespace findspace::distance
