// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/boundary_features.h"

#include <algorithm>
#include <cmath>

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using exact::SupportingCurve;
using plane::CellComplex;
using plane::Index;
using plane::Mark;

double near_value(const Real& r) {
  auto i = r.interval();
  return i.lo + (i.hi - i.lo) / 2;
}

bool BoundaryFeature::has_direction(double dx, double dy, double slack) const {
  // By the turns from the ends. The foot itself is rounded, which moves it far along an arc where this is vertical.
  const auto turn = [&](double x, double y) { return half * ((x - cx) * dy - (y - cy) * dx); };
  const double most = slack > 0 ? slack * plain_length(dx, dy) : 0;
  return turn(x0, y0) <= most && turn(x1, y1) >= -most;
}

bool BoundaryFeature::faces(double x, double y, double slack) const {
  if (is_vertex()) return true;
  if (arc) return has_direction(x - cx, y - cy, slack);
  const double dx = x1 - x0, dy = y1 - y0, t = (x - x0) * dx + (y - y0) * dy, size = dx * dx + dy * dy;
  if (t >= 0 && t <= size) return true;
  return slack > 0 && std::max(-t, t - size) <= slack * std::sqrt(size);
}

double BoundaryFeature::arc_distance(double x, double y) const {
  return has_direction(x - cx, y - cy) ? std::abs(plain_length(x - cx, y - cy) - r)
                                       : std::min(plain_length(x - x0, y - y0), plain_length(x - x1, y - y1));
}

double BoundaryFeature::farthest(double x, double y) const {
  double d = plain_length(x - x0, y - y0);
  if (is_vertex()) return d;
  if (arc && has_direction(cx - x, cy - y)) return plain_length(x - cx, y - cy) + r;
  return std::max(d, plain_length(x - x1, y - y1));
}

BoundaryFeature vertex_feature(const CellComplex& c, Index v) {
  const exact::Point& p = c.point(v);
  BoundaryFeature s;
  s.cell = {0, v};
  s.x0 = s.x1 = p.x;
  s.y0 = s.y1 = p.y;
  return s;
}

BoundaryFeature edge_feature(const CellComplex& c, Index e) {
  const exact::Point &p = c.point(c.edges[e].v0), &q = c.point(c.edges[e].v1);
  BoundaryFeature s;
  s.cell = {1, e};
  s.x0 = p.x;
  s.y0 = p.y;
  s.x1 = q.x;
  s.y1 = q.y;
  s.half = c.edges[e].half;
  s.arc = s.half != 0;
  const SupportingCurve& k = c.supporting_curve(e);
  if (s.arc) {
    s.cx = k.x().value;
    s.cy = k.y().value;
    s.r = k.z().value;
  }
  return s;
}

std::vector<BoundaryFeature> features(const CellComplex& c, const std::function<bool(Mark)>& wanted) {
  std::vector<BoundaryFeature> out;
  for (Index v = 0; v < c.vertices.size(); ++v)
    if (wanted(c.vertices[v].mark)) out.push_back(vertex_feature(c, v));
  for (Index e = 0; e < c.edges.size(); ++e)
    if (wanted(c.edges[e].mark)) out.push_back(edge_feature(c, e));
  return out;
}

namespace {

/// `outside` of a circle, or where the form of a line is positive.
LevelCurve curve_beside(const SupportingCurve& k, bool outside, const Real& level) {
  if (k.circle) return LevelCurve::ring(k.center_x(), k.center_y(), k.w(), outside ? level : -level);
  Real n = sqrt(Real(exact::int128(k.a) * k.a + exact::int128(k.b) * k.b)) * level;
  return LevelCurve::line(k.a, k.b, k.offset(), outside ? n : -n);
}

}  // namespace

LevelCurve near_level_curve(const CellComplex& c, const BoundaryFeature& s, double x, double y, int sign) {
  Real level(sign);
  if (s.is_vertex()) {
    RealPoint at = c.geometry.exact(c.vertices[s.cell.index].point);
    return LevelCurve::ring(at.x, at.y, Real(), level);
  }
  const SupportingCurve& k = c.supporting_curve(s.cell.index);
  const bool outside =
      k.circle ? plain_length(x - s.cx, y - s.cy) > s.r : k.x().value * (x - s.x0) + k.y().value * (y - s.y0) > 0;
  return curve_beside(k, outside, level);
}

LevelCurve level_curve_beside(const CellComplex& c, Index edge, bool left) {
  const SupportingCurve& k = c.supporting_curve(edge);
  // An upper half, and a line whose form grows upwards (or to the left, if it is vertical), have the outside on the
  // left.
  const bool outside_on_left = k.circle ? c.edges[edge].half > 0 : k.b > 0 || (k.b == 0 && k.a < 0);
  return curve_beside(k, outside_on_left == left, Real(1));
}

LevelCurve far_level_curve(const CellComplex& c, const BoundaryFeature& s) {
  if (s.is_vertex()) return near_level_curve(c, s, 0, 0, 1);
  const SupportingCurve& k = c.supporting_curve(s.cell.index);
  return LevelCurve::ring(k.center_x(), k.center_y(), -k.w(), 1);
}

LevelCurve fixed_level_curve(const CellComplex& c, const BoundaryFeature& s) {
  if (s.is_vertex()) {
    RealPoint at = c.geometry.exact(c.vertices[s.cell.index].point);
    return LevelCurve::ring(at.x, at.y, Real(), Real());
  }
  const SupportingCurve& k = c.supporting_curve(s.cell.index);
  if (k.circle) return LevelCurve::ring(k.center_x(), k.center_y(), k.w(), Real());
  return LevelCurve::line(k.a, k.b, k.offset(), Real());
}

}  // namespace findspace::distance
