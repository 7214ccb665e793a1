// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/coordinate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "distance/planar_features/boundary_features.h"
#include "exact/margins/planar_distance.h"
#include "exact/planar/geometry_signs.h"
#include "plane/complex/arrangement.h"
#include "plane/complex/overlay.h"
#include "plane/complex/piece_builder.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Index;
using plane::Region;

namespace {

Real value_at(const LinearForm& f, const RealPoint& p) { return Real(f.a) * p.x + Real(f.b) * p.y; }

/// The farthest points of an arc's circle in the direction of the form and against it, where they lie inside the arc.
void add_arc_values(const Region& s, Index e, const LinearForm& form, std::vector<Real>& out) {
  if (form.b == 0) return;  // arcs are cut at their leftmost and rightmost points
  const exact::SupportingCurve& k = s.supporting_curve(e);
  const Index from = s.vertices[s.edges[e].v0].point, to = s.vertices[s.edges[e].v1].point;
  const bool above = s.edges[e].half > 0;
  const Real along =
      k.w() * Real(form.b) / exact::sqrt(Real(exact::int128(form.a) * form.a + exact::int128(form.b) * form.b));
  const Real over = along * Real::ratio(form.a, form.b);
  // The point (over, along) from the centre lies above it where along > 0; the opposite one is the other extreme.
  const bool same = (along.sign() > 0) == above;
  const Real x = same ? k.center_x() + over : k.center_x() - over,
             y = same ? k.center_y() + along : k.center_y() - along;
  if (x > s.geometry.exact_x(from) && x < s.geometry.exact_x(to)) out.push_back(value_at(form, {x, y}));
}

/// A value with what bounds its distance from the exact one.
struct Rough {
  double value, error;
};

Rough rough(const LinearForm& f, const exact::Point& p) {
  const double a = double(f.a), b = double(f.b);
  return {a * p.x + b * p.y,
          (std::abs(a) + std::abs(b)) * p.error * 2 + (std::abs(a * p.x) + std::abs(b * p.y)) * margin::kFormNoise};
}

/// Values that can be extreme: those of vertices that doubles cannot rule out, and of arcs.
std::vector<Real> values(const Region& closed, const LinearForm& form, Sense sense) {
  const double sign = sense == Sense::kMinimum ? 1 : -1;
  double bound = std::numeric_limits<double>::infinity();
  for (const auto& v : closed.vertices) {
    const Rough r = rough(form, closed.geometry.points[v.point]);
    if (v.mark > 0) bound = std::min(bound, sign * r.value + r.error);
  }
  std::vector<Real> out;
  for (const auto& v : closed.vertices) {
    const Rough r = rough(form, closed.geometry.points[v.point]);
    if (v.mark > 0 && sign * r.value - r.error <= bound) out.push_back(value_at(form, closed.geometry.exact(v.point)));
  }
  for (Index e = 0; e < closed.edges.size(); ++e)
    if (closed.edges[e].mark > 0 && closed.is_arc(e)) add_arc_values(closed, e, form, out);
  return out;
}

/// A segment of the line `form = value` that crosses the whole set.
Region line_across(const Region& s, const LinearForm& form, const Real& value) {
  double size = 2;
  for (const auto& v : s.vertices) {
    const exact::Point& p = s.geometry.points[v.point];
    size = std::max({size, std::abs(p.x) + 2, std::abs(p.y) + 2});
  }
  for (Index e = 0; e < s.edges.size(); ++e)
    if (s.is_arc(e)) size = std::max(size, size + 2 * s.supporting_curve(e).z().value);
  // The coordinate along the line is the larger one of its direction (-b, a); the set lies within `size` of the origin.
  const Real reach = Real::from_double(std::ceil(size));
  const bool steep = std::abs(form.a) > std::abs(form.b);
  auto point = [&](const Real& t) -> RealPoint {
    return steep ? RealPoint{(value - Real(form.b) * t) / Real(form.a), t}
                 : RealPoint{t, (value - Real(form.a) * t) / Real(form.b)};
  };
  plane::PieceBuilder b;
  const RealPoint from = point(-reach), to = point(reach);
  Index line = b.geometry.add(exact::SupportingCurve::line(form.a, form.b, value));
  Index p = b.geometry.add_real_point(from.x, from.y), q = b.geometry.add_real_point(to.x, to.y);
  b.segment(line, p, q, compare_xy(b.geometry, p, q) < 0);
  plane::Arrangement a = plane::arrange(std::move(b.geometry), std::move(b.pieces));
  plane::Marks m;
  m.faces.assign(a.face_count, 0);
  m.edges.assign(a.edge_count(), 1);
  m.vertices.assign(a.vertex_count(), 1);
  return plane::extract(std::move(a), m);
}

}  // namespace

Region on_line(const Region& s, const LinearForm& form, const Real& value) {
  Region line = line_across(s, form, value);
  std::array<const Region*, 2> both{&s, &line};
  return plane::intersect(both);
}

Extremum linear_extremum(const Region& s, const LinearForm& form, Sense sense) {
  Extremum e = no_optimum<Region>(sense, !plane::is_empty(s) && s.faces[0].mark > 0);
  if (plane::is_empty(s) || e.unbounded) return e;
  Region closed = plane::closure(s);
  std::optional<Real> best;
  for (const Real& c : values(closed, form, sense))
    if (!best || (sense == Sense::kMinimum ? c < *best : c > *best)) best = c;
  e.set_exact(*best, Way::kMap);
  e.at = on_line(s, form, *best);
  e.attained = !plane::is_empty(e.at);
  if (!e.attained) e.at = on_line(closed, form, *best);
  return e;
}

}  // namespace findspace::distance
