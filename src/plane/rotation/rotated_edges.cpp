// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotated_edges.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {

using exact::ExactAngle;
using exact::Real;

double rough(const Real& r) {
  const exact::Interval i = r.interval();
  return i.lo + (i.hi - i.lo) / 2;
}

RotatedNet::RotatedNet(const CellComplex& complex, RealVector about, bool (*wanted)(Mark))
    : complex_(complex), about_(std::move(about)) {
  edges_.reserve(complex.edges.size());
  for (Index e = 0; e < complex.edges.size(); ++e)
    if (wanted(complex.edges[e].mark)) edges_.push_back(e);
  for (Index v = 0; v < vertex_count(); ++v) {
    if (complex.point(v).kind == exact::Point::Kind::kGrid) continue;
    if (place_.empty()) place_.resize(vertex_count());
    place_[v] = Index(off_grid_.size());
    off_grid_.push_back(complex.geometry.exact(complex.vertices[v].point) - about_);
  }
}

RealVector RotatedNet::vertex(Index v) const {
  const exact::Point& p = complex_.point(v);
  if (p.kind != exact::Point::Kind::kGrid) return off_grid_[place_[v]];
  return {Real(p.gx) - about_.x, Real(p.gy) - about_.y};
}

RotatedEdge RotatedNet::edge(Index e) const {
  const Edge& edge = complex_.edges[e];
  RotatedEdge out;
  out.cell = e;
  // A lower half runs counter-clockwise from left to right, an upper one from right to left.
  out.v0 = edge.half > 0 ? edge.v1 : edge.v0;
  out.v1 = edge.half > 0 ? edge.v0 : edge.v1;
  out.p = vertex(out.v0);
  out.q = vertex(out.v1);
  if (edge.half == 0) return out;
  const exact::SupportingCurve& k = complex_.supporting_curve(e);
  out.arc = true;
  out.center = RealVector{k.center_x(), k.center_y()} - about_;
  out.radius = k.w();
  return out;
}

RoughBox box_of(const RotatedEdge& e) {
  const auto px = e.p.x.interval(), py = e.p.y.interval(), qx = e.q.x.interval(), qy = e.q.y.interval();
  RoughBox b{std::min(px.lo, qx.lo), std::min(py.lo, qy.lo), std::max(px.hi, qx.hi), std::max(py.hi, qy.hi)};
  if (!e.arc) return b;
  const auto cx = e.center.x.interval(), cy = e.center.y.interval(), r = e.radius.interval();
  // The arc lies to the right of its chord, within half a circle: the box of the circle where an extreme may lie on it.
  const double dx = qx.hi - px.lo, dy = qy.hi - py.lo,
               tolerance = (std::abs(dx) + std::abs(dy) + r.hi) * margin::kUprightChord;
  if (dx > -tolerance) b.y0 = std::min(b.y0, cy.lo - r.hi);
  if (dx < tolerance) b.y1 = std::max(b.y1, cy.hi + r.hi);
  if (dy > -tolerance) b.x1 = std::max(b.x1, cx.hi + r.hi);
  if (dy < tolerance) b.x0 = std::min(b.x0, cx.lo - r.hi);
  return b;
}

int place_on(const RotatedEdge& e, const RealVector& point) {
  if (e.arc) return -cross(e.q - e.p, point - e.p).sign();
  const RealVector d = e.q - e.p;
  const int from = dot(d, point - e.p).sign();
  return from <= 0 ? from : dot(d, e.q - point).sign();
}

bool lies_on(const RotatedEdge& e, const RealVector& point) {
  if (e.arc) {
    const RealVector d = point - e.center;
    return compare(dot(d, d), e.radius * e.radius) == 0 && place_on(e, point) > 0;
  }
  return cross(e.q - e.p, point - e.p).sign() == 0 && place_on(e, point) > 0;
}

namespace {

using Points = std::vector<RealVector>;

Points cross_lines(const RotatedEdge& e, const RotatedEdge& f) {
  const RealVector d = e.q - e.p, g = f.q - f.p;
  const Real s0 = cross(d, f.p - e.p), s1 = cross(d, f.q - e.p);
  if (s0.sign() * s1.sign() >= 0) return {};  // ends that touch are vertices
  const Real u0 = cross(g, e.p - f.p), u1 = cross(g, e.q - f.p);
  if (u0.sign() * u1.sign() >= 0) return {};
  return {f.p + s0 / (s0 - s1) * g};
}

/// The points of the segment's line on the circle.
Points line_and_circle(const RotatedEdge& line, const RotatedEdge& circle) {
  const RealVector d = line.q - line.p;
  const Real square = dot(d, d), height = cross(d, circle.center - line.p);
  const Real rest = circle.radius * circle.radius * square - height * height;
  if (rest.sign() < 0) return {};
  const RealVector projection = line.p + dot(d, circle.center - line.p) / square * d;
  if (rest.sign() == 0) return {projection};
  const RealVector half = sqrt(rest) / square * d;
  return {projection - half, projection + half};
}

Points cross_circles(const RotatedEdge& e, const RotatedEdge& f) {
  const RealVector d = f.center - e.center;
  const Real square = dot(d, d);
  if (square.sign() == 0) return {};
  const Real r2 = e.radius * e.radius, along = (square + r2 - f.radius * f.radius) / Real(2);  // times the distance
  const Real rest = r2 * square - along * along;
  if (rest.sign() < 0) return {};
  const RealVector projection = e.center + along / square * d;
  if (rest.sign() == 0) return {projection};
  const RealVector half = sqrt(rest) / square * left_normal(d);
  return {projection - half, projection + half};
}

}  // namespace

Points meetings(const RotatedEdge& e, const RotatedEdge& f) {
  if (!e.arc && !f.arc) return cross_lines(e, f);
  Points all = !e.arc ? line_and_circle(e, f) : !f.arc ? line_and_circle(f, e) : cross_circles(e, f);
  std::erase_if(all, [&](const RealVector& p) { return place_on(e, p) <= 0 || place_on(f, p) <= 0; });
  return all;
}

int compare_along(const RotatedEdge& e, const RealVector& s, const RealVector& t) {
  if (!e.arc) return -dot(e.q - e.p, t - s).sign();
  return -cross(s - e.center, t - e.center).sign();
}

namespace {

/// A point of the arc's circle with a direction of few digits near the middle of the way from s to t.
RealVector near_middle(const RotatedEdge& e, const RealVector& s, const RealVector& t) {
  const double cx = rough(e.center.x), cy = rough(e.center.y);
  double a = std::atan2(rough(s.y) - cy, rough(s.x) - cx), b = std::atan2(rough(t.y) - cy, rough(t.x) - cx);
  if (b <= a) b += 2 * M_PI;
  const double width = (b - a) * 180 / M_PI, middle = (a + b) * 90 / M_PI;
  const int bits = std::clamp(6 - std::ilogb(width / 180), 6, 40);
  return e.center + e.radius * ExactAngle::near(middle, bits)({1, 0});
}

}  // namespace

RealVector point_between(const RotatedEdge& e, const RealVector& s, const RealVector& t) {
  if (!e.arc) {
    // Parameters of few digits first: they keep the point in the field of the ends.
    const RealVector d = e.q - e.p;
    const double square = rough(dot(d, d)), a = rough(dot(d, s - e.p)) / square, b = rough(dot(d, t - e.p)) / square;
    const RealVector p = e.p + Real::from_double(std::ldexp(std::round(std::ldexp((a + b) / 2, 30)), -30)) * d;
    if (compare_along(e, s, p) < 0 && compare_along(e, p, t) < 0) return p;
    return Real::ratio(1, 2) * (s + t);
  }
  const RealVector p = near_middle(e, s, t);
  if (place_on(e, p) > 0 && compare_along(e, s, p) < 0 && compare_along(e, p, t) < 0) return p;
  const RealVector chord = t - s, normal = right_normal(chord);
  return e.center + e.radius / sqrt(dot(normal, normal)) * normal;
}

}  // namespace findspace::plane
