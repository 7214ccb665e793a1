// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/exact_pairs.h"

#include <algorithm>
#include <cmath>

#include "distance/planar_features/boundary_features.h"
#include "exact/margins/planar_distance.h"
#include "plane/query/nearest.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Cell;
using plane::Index;
using plane::Region;

namespace {

/// A vertex, or the centre and radius of an arc.
struct Centre {
  RealPoint at;
  Real radius;
};

Centre centre(const Region& r, Cell cell, const RealPoint& by) {
  if (cell.dimension == 0) {
    RealPoint at = r.geometry.exact(r.vertices[cell.index].point);
    return {{at.x + by.x, at.y + by.y}, Real()};
  }
  const exact::SupportingCurve& k = r.supporting_curve(cell.index);
  return {{k.center_x() + by.x, k.center_y() + by.y}, k.w()};
}

bool is_line(const Region& r, Cell cell) { return cell.dimension == 1 && !r.is_arc(cell.index); }

RealPoint towards(const Centre& from, const Real& dx, const Real& dy, const Real& d, const Real& length) {
  if (d.sign() == 0) return {from.at.x + length, from.at.y};
  return {from.at.x + dx * length / d, from.at.y + dy * length / d};
}

/// Projection of the perpendicular from the centre (radius 0 or less than the distance) on an edge moved by `by`, if it
/// lies there.
std::optional<FeaturePair> line_pair(const Region& lines, Index edge, const RealPoint& by, const Centre& c) {
  const exact::SupportingCurve& k = lines.supporting_curve(edge);
  Real a(k.a), b(k.b), x = c.at.x - by.x, y = c.at.y - by.y;
  auto along = [&](Index v) {
    RealPoint end = lines.geometry.exact(lines.vertices[v].point);
    return (b * (x - end.x) - a * (y - end.y)).sign();
  };
  if (along(lines.edges[edge].v0) * along(lines.edges[edge].v1) > 0) return std::nullopt;
  Real n2 = a * a + b * b, h = a * x + b * y - k.offset();
  Real d = abs(h) / sqrt(n2);
  RealPoint projection{c.at.x - a * h / n2, c.at.y - b * h / n2};
  FeaturePair out{d - c.radius, projection, c.at, {}, {}};
  if (c.radius.sign() != 0) out.second = towards(c, projection.x - c.at.x, projection.y - c.at.y, d, c.radius);
  return out;
}

/// The nearest points of two circles that lie apart, or one inside the other; or the farthest points.
enum class Between { kApart, kInside, kFar };

FeaturePair centre_pair(const Centre& f, const Centre& g, Between how) {
  Real dx = g.at.x - f.at.x, dy = g.at.y - f.at.y, d = sqrt(dx * dx + dy * dy);
  if (how == Between::kFar)
    return {d + f.radius + g.radius, towards(f, dx, dy, d, -f.radius), towards(g, dx, dy, d, g.radius), {}, {}};
  if (how == Between::kApart)
    return {d - f.radius - g.radius, towards(f, dx, dy, d, f.radius), towards(g, dx, dy, d, -g.radius), {}, {}};
  int turn = compare(f.radius, g.radius);
  Real s(turn);
  return {
      abs(f.radius - g.radius) - d, towards(f, dx, dy, d, s * f.radius), towards(g, dx, dy, d, s * g.radius), {}, {}};
}

/// A point of the circle of an arc that is moved by `by` lies on the arc.
bool is_on_arc(const Region& r, Cell arc, const RealPoint& by, const RealPoint& at) {
  const plane::Edge& e = r.edges[arc.index];
  const auto x_of = [&](Index v) { return r.geometry.exact(r.vertices[v].point).x + by.x; };
  return (at.y - r.supporting_curve(arc.index).center_y() - by.y).sign() * e.half >= 0 && at.x >= x_of(e.v0) &&
         at.x <= x_of(e.v1);
}

/// A vertex, or an arc with a point in the direction from `from` to `to`, two places that move with it.
bool faces(const Region& r, Cell cell, const RealPoint& from, const RealPoint& to) {
  return cell.dimension == 0 || plane::has_direction(r, cell.index, to.x - from.x, to.y - from.y);
}

}  // namespace

std::optional<FeaturePair> exact_pair(const Region& a, const Region& b, const RealPoint& p, const Candidate& k,
                                      bool far) {
  const RealPoint origin{Real(), Real()};
  FeaturePair out;
  if (is_line(a, k.first)) {
    const Centre c = centre(b, k.second, p);
    auto found = line_pair(a, k.first.index, origin, c);
    if (!found || !faces(b, k.second, c.at, found->first)) return std::nullopt;
    out = std::move(*found);
  } else if (is_line(b, k.second)) {
    const Centre c = centre(a, k.first, origin);
    auto found = line_pair(b, k.second.index, p, c);
    if (!found || !faces(a, k.first, c.at, found->first)) return std::nullopt;
    out = std::move(*found);
    std::swap(out.first, out.second);
  } else {
    Centre f = centre(a, k.first, origin), g = centre(b, k.second, p);
    double d = std::hypot(near_value(f.at.x) - near_value(g.at.x), near_value(f.at.y) - near_value(g.at.y));
    bool inside = d < std::max(near_value(f.radius), near_value(g.radius));
    out = centre_pair(f, g, far ? Between::kFar : inside ? Between::kInside : Between::kApart);
    const bool arc_and_point = k.first.dimension == 0 || k.second.dimension == 0;
    // A point beside a circle has the same foot on either side, and numbers need not tell on which it is.
    if (!far && arc_and_point) out.distance = abs(out.distance);
    if (!far && !(faces(a, k.first, f.at, arc_and_point ? g.at : out.first) &&
                  faces(b, k.second, g.at, arc_and_point ? f.at : out.second)))
      return std::nullopt;
    // Where the centres may be one, numbers do not tell the way from one to the other.
    const bool arcs = k.first.dimension == 1 && k.second.dimension == 1;
    if (far && arcs &&
        d <= margin::kNearCentres * (std::abs(near_value(f.at.x)) + std::abs(near_value(f.at.y)) +
                                     near_value(f.radius) + near_value(g.radius))) {
      const bool one = compare(f.at.x, g.at.x) == 0 && compare(f.at.y, g.at.y) == 0;
      if (one || !is_on_arc(a, k.first, origin, out.first) || !is_on_arc(b, k.second, p, out.second))
        return std::nullopt;
    }
  }
  out.first_cell = k.first;
  out.second_cell = k.second;
  return out;
}

std::optional<FeaturePair> exact_pair(const Region& a, Cell cell, const RealPoint& at) {
  const RealPoint origin{Real(), Real()};
  const Centre place{at, Real()};
  std::optional<FeaturePair> out;
  if (is_line(a, cell)) {
    out = line_pair(a, cell.index, origin, place);
  } else {
    Centre c = centre(a, cell, origin);
    out = centre_pair(c, place, Between::kApart);
    out->distance = abs(out->distance);
    if (!faces(a, cell, c.at, at)) return std::nullopt;
  }
  if (out) out->first_cell = cell;
  return out;
}

/// The common point of two straight edges that cross.
FeaturePair crossing(const Region& a, const Region& b, Cell s, Cell t, const RealPoint& p) {
  const exact::SupportingCurve &f = a.supporting_curve(s.index), &g = b.supporting_curve(t.index);
  Real c = f.offset(), d = g.offset() + Real(g.a) * p.x + Real(g.b) * p.y;
  Real n(exact::int128(f.a) * g.b - exact::int128(f.b) * g.a);
  RealPoint at{(c * Real(g.b) - d * Real(f.b)) / n, (Real(f.a) * d - Real(g.a) * c) / n};
  return {Real(), at, at, s, t};
}

}  // namespace findspace::distance
