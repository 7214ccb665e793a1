// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

using exact::Real;
using exact::RealPoint;

double middle(const Real& r) {
  auto i = r.interval();
  return i.lo + (i.hi - i.lo) / 2;
}

struct Candidate {
  double distance;
  Cell cell;
};

/// The projection of the perpendicular is inside the edge, or no farther than `slack` beyond an end of a straight one.
bool projection_inside(const CellComplex& c, Index edge, double x, double y, double slack) {
  const Edge& e = c.edges[edge];
  const exact::Point &p = c.point(e.v0), &q = c.point(e.v1);
  if (e.half == 0) {
    const double dx = q.x - p.x, dy = q.y - p.y, t = (x - p.x) * dx + (y - p.y) * dy, size = dx * dx + dy * dy;
    return std::max(-t, t - size) < slack * std::sqrt(size);
  }
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  // The direction lies between those of the ends. The foot itself is rounded, which moves it far along an arc where
  // this is vertical.
  const double dx = x - k.x().value, dy = y - k.y().value;
  const auto turn = [&](const exact::Point& end) { return (end.x - k.x().value) * dy - (end.y - k.y().value) * dx; };
  return e.half * turn(p) <= 0 && e.half * turn(q) >= 0;
}

/// Whether the box of a straight edge is farther than `reach`, as near as rounding; of an arc never.
bool is_beyond(const CellComplex& c, Index edge, double x, double y, double reach) {
  const Edge& e = c.edges[edge];
  if (e.half != 0) return false;
  const exact::Point &p = c.point(e.v0), &q = c.point(e.v1);
  return x < std::min(p.x, q.x) - reach || x > std::max(p.x, q.x) + reach || y < std::min(p.y, q.y) - reach ||
         y > std::max(p.y, q.y) + reach;
}

/// Of a straight edge no less than that of what of it is nearest.
double edge_distance(const CellComplex& c, Index edge, double x, double y) {
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  if (c.edges[edge].half == 0) {
    const exact::Point &p = c.point(c.edges[edge].v0), &q = c.point(c.edges[edge].v1);
    const double dx = q.x - p.x, dy = q.y - p.y, t = (x - p.x) * dx + (y - p.y) * dy;
    if (t < 0) return std::hypot(x - p.x, y - p.y);
    if (t > dx * dx + dy * dy) return std::hypot(x - q.x, y - q.y);
    return std::abs(k.x().value * (x - p.x) + k.y().value * (y - p.y));
  }
  return std::abs(std::hypot(x - k.x().value, y - k.y().value) - k.z().value);
}

std::optional<Nearest> exact_vertex(const CellComplex& c, Index v, const RealPoint& from) {
  RealPoint at = c.geometry.exact(c.vertices[v].point);
  Real dx = at.x - from.x, dy = at.y - from.y;
  return Nearest{sqrt(dx * dx + dy * dy), at, {0, v}};
}

/// The projection on a straight edge is between its ends, exactly.
bool is_between_ends(const CellComplex& c, Index edge, const RealPoint& from) {
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  const auto along = [&](Index v) {
    const RealPoint end = c.geometry.exact(c.vertices[v].point);
    return (Real(k.b) * (from.x - end.x) - Real(k.a) * (from.y - end.y)).sign();
  };
  return along(c.edges[edge].v0) * along(c.edges[edge].v1) < 0;
}

/// Nothing where the projection is not on the edge.
std::optional<Nearest> exact_edge(const CellComplex& c, Index edge, const RealPoint& from) {
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  if (!k.circle) {
    if (!is_between_ends(c, edge, from)) return std::nullopt;
    Real a(k.a), b(k.b), n2 = a * a + b * b, h = a * from.x + b * from.y - k.offset();
    Real d = h / sqrt(n2);
    return Nearest{d.sign() < 0 ? -d : d, {from.x - a * h / n2, from.y - b * h / n2}, {1, edge}};
  }
  Real dx = from.x - k.center_x(), dy = from.y - k.center_y(), length = sqrt(dx * dx + dy * dy), d = length - k.w();
  RealPoint at = length.sign() == 0 ? c.geometry.exact(c.vertices[c.edges[edge].v0].point)
                                    : RealPoint{k.center_x() + dx * k.w() / length, k.center_y() + dy * k.w() / length};
  return Nearest{d.sign() < 0 ? -d : d, at, {1, edge}};
}

}  // namespace

std::optional<Nearest> nearest(const CellComplex& c, const std::function<bool(Mark)>& wanted, const RealPoint& from) {
  const double x = middle(from.x), y = middle(from.y);
  double scale = std::abs(x) + std::abs(y), greatest = 0, reach = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < c.vertices.size(); ++v)
    greatest = std::max({greatest, std::abs(c.point(v).x), std::abs(c.point(v).y)});
  scale += greatest;
  // Rounding can only exchange candidates that are as near as `reach`, a little beyond the least; their distances are
  // exact, and compared when rounded once.
  std::vector<Candidate> all;
  const auto take = [&](double d, Mark mark, Cell cell) {
    if (d > reach || !wanted(mark)) return;
    all.push_back({d, cell});
    reach = std::min(reach, d + (scale + d) * margin::kNearestCandidate);
  };
  for (Index v = 0; v < c.vertices.size(); ++v) {
    const double dx = c.point(v).x - x, dy = c.point(v).y - y;
    take(std::sqrt(dx * dx + dy * dy), c.vertices[v].mark, {0, v});
  }
  for (Index e = 0; e < c.edges.size(); ++e)
    if (!is_beyond(c, e, x, y, reach) && projection_inside(c, e, x, y, scale * margin::kNearestCandidate))
      take(edge_distance(c, e, x, y), c.edges[e].mark, {1, e});
  std::optional<Nearest> best;
  for (const Candidate& k : all) {
    if (k.distance > reach) continue;
    auto n = k.cell.dimension == 0 ? exact_vertex(c, k.cell.index, from) : exact_edge(c, k.cell.index, from);
    if (n && (!best || n->distance.to_double() < best->distance.to_double())) best = std::move(n);
  }
  return best;
}

}  // namespace findspace::plane
