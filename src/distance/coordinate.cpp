// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/coordinate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "distance/sites.h"
#include "plane/arrangement.h"
#include "plane/overlay.h"
#include "plane/piece_builder.h"
#include "plane/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Index;
using plane::Region;

namespace {

/// Coordinates that can be extreme: of all vertices, and of the highest or lowest point of every arc that has it inside.
std::vector<Real> coordinates(const Region& closed, Axis axis) {
  std::vector<Real> out;
  for (const auto& v : closed.vertices)
    if (v.mark > 0) out.push_back(axis == Axis::kX ? closed.geometry.exact_x(v.point) : closed.geometry.exact_y(v.point));
  if (axis == Axis::kX) return out;  // arcs are cut at their leftmost and rightmost points
  for (const auto& e : closed.edges) {
    if (e.mark <= 0 || e.half == 0) continue;
    Index from = closed.vertices[e.v0].point, to = closed.vertices[e.v1].point;
    if (closed.geometry.right_of_center(from, e.carrier) >= 0 || closed.geometry.right_of_center(to, e.carrier) <= 0) continue;
    const exact::Carrier& k = closed.geometry.carriers[e.carrier];
    out.push_back(e.half > 0 ? k.center_y() + k.w : k.center_y() - k.w);
  }
  return out;
}

/// A segment of the line `coordinate = level` that crosses the whole set.
Region line_across(const Region& s, Axis axis, const Real& level) {
  double low = 0, high = 0;
  for (const auto& v : s.vertices) {
    const exact::Point& p = s.geometry.points[v.point];
    low = std::min({low, p.x, p.y}), high = std::max({high, p.x, p.y});
  }
  for (Index e = 0; e < s.edges.size(); ++e)
    if (s.is_arc(e)) low = std::min(low, low - 2 * s.carrier(e).z.value), high = std::max(high, high + 2 * s.carrier(e).z.value);
  Real from = Real::from_double(std::floor(low - 2)), to = Real::from_double(std::ceil(high + 2));
  plane::PieceBuilder b;
  bool x = axis == Axis::kX;
  Index line = b.geometry.add(exact::Carrier::line(x, !x, level));
  Index p = x ? b.geometry.add_real_point(level, from) : b.geometry.add_real_point(from, level);
  Index q = x ? b.geometry.add_real_point(level, to) : b.geometry.add_real_point(to, level);
  b.segment(line, p, q, true);
  plane::Arrangement a = plane::arrange(std::move(b.geometry), std::move(b.pieces));
  plane::Marks m;
  m.faces.assign(a.face_count, 0), m.edges.assign(a.edge_count(), 1), m.vertices.assign(a.vertex_count(), 1);
  return plane::extract(a, m);
}

}  // namespace

Extremum coordinate_extremum(const Region& s, Axis axis, Sense sense) {
  Extremum e;
  if (plane::is_empty(s)) return e;
  if (s.faces[0].mark > 0) {
    e.unbounded = true;
    return e;
  }
  Region closed = plane::closure(s);
  std::optional<Real> best;
  for (const Real& c : coordinates(closed, axis))
    if (!best || (sense == Sense::kMinimum ? c < *best : c > *best)) best = c;
  e.exists = e.proven = true;
  e.level = *best;
  Region line = line_across(closed, axis, e.level);
  std::array<const Region*, 2> both{&s, &line};
  e.at = plane::intersect(both);
  e.attained = !plane::is_empty(e.at);
  both[0] = &closed;
  if (!e.attained) e.at = plane::intersect(both);
  return e;
}

}  // namespace findspace::distance
