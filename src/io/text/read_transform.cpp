// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_transform.h"

#include <cmath>
#include <numbers>

#include "exact/planar/angle.h"
#include "findspace/error.h"

namespace findspace::io {

using exact::Real;

Direction direction(const Real& degrees) {
  auto quarters = (degrees / Real(90)).integer();
  if (!quarters) {
    double angle = exact::rounded_degrees(degrees) * (std::numbers::pi / 180);
    return {Real::from_double(std::cos(angle)), Real::from_double(std::sin(angle))};
  }
  switch (static_cast<int>((*quarters % 4 + 4) % 4)) {
    case 0:
      return {1, 0};
    case 1:
      return {0, 1};
    case 2:
      return {-1, 0};
    default:
      return {0, -1};
  }
}

Affine Affine::translation(const Real& x, const Real& y) {
  Affine map;
  map.e = x;
  map.f = y;
  return map;
}

Affine Affine::scaling(const Real& x, const Real& y) {
  Affine map;
  map.a = x;
  map.d = y;
  map.mirrors = x.sign() * y.sign() < 0;
  map.scale = compare(abs(x), abs(y)) == 0 ? std::optional(abs(x)) : std::nullopt;
  return map;
}

Affine Affine::rotation(const Real& degrees) {
  Direction to = direction(degrees);
  Affine map;
  map.a = map.d = to.cosine;
  map.b = to.sine;
  map.c = -to.sine;
  return map;
}

Affine Affine::matrix(Real a, Real b, Real c, Real d, Real e, Real f) {
  Affine map{std::move(a), std::move(b), std::move(c), std::move(d), std::move(e), std::move(f), std::nullopt, false};
  map.mirrors = (map.a * map.d - map.b * map.c).sign() < 0;
  Real p = map.a * map.a + map.b * map.b, q = map.c * map.c + map.d * map.d;
  if (compare(p, q) == 0 && (map.a * map.c + map.b * map.d).sign() == 0) map.scale = sqrt(p);
  return map;
}

EllipseArc Affine::of(const EllipseArc& arc) const {
  auto rotated = [&](const plane::CurvePoint& v) { return plane::CurvePoint{a * v.x + c * v.y, b * v.x + d * v.y}; };
  return {{of(arc.frame.center), rotated(arc.frame.u), rotated(arc.frame.v)}, arc.first, arc.sweep};
}

Affine operator*(const Affine& o, const Affine& i) {
  Affine map{o.a * i.a + o.c * i.b,       o.b * i.a + o.d * i.b,       o.a * i.c + o.c * i.d, o.b * i.c + o.d * i.d,
             o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f, std::nullopt,          o.mirrors != i.mirrors};
  if (o.scale && i.scale) map.scale = *o.scale * *i.scale;
  return map;
}

void Placed::move_to(const Real& x, const Real& y) {
  outline_.move_to(map_.x_of(x, y), map_.y_of(x, y));
  start_ = {x, y};
  reach(x, y);
}

void Placed::line_to(const Real& x, const Real& y) {
  outline_.line_to(map_.x_of(x, y), map_.y_of(x, y));
  reach(x, y);
}

void Placed::arc_to(const Real& radius, bool large, bool sweep, const Real& x, const Real& y) {
  if (!map_.scale) {
    if (at_.x == x && at_.y == y) return;
    const double r = radius.to_double();
    return ellipse_to(
        ellipse_arc({at_.x.to_double(), at_.y.to_double(), r, r, 0, large, sweep, x.to_double(), y.to_double()}), x, y);
  }
  outline_.arc_to(radius * *map_.scale, large, sweep != map_.mirrors, map_.x_of(x, y), map_.y_of(x, y));
  reach(x, y);
}

void Placed::curve_to(std::span<const plane::CurvePoint> points, std::span<const Real> weights) {
  std::vector<plane::CurvePoint> placed;
  for (const plane::CurvePoint& p : points) placed.push_back(map_.of(p));
  outline_.curve_to(placed, weights);
  at_ = points.back();
}

void Placed::ellipse_to(const EllipseArc& arc, const Real& x, const Real& y) {
  outline_.ellipse_to(map_.of(arc), map_.x_of(x, y), map_.y_of(x, y));
  reach(x, y);
}

void Placed::close() {
  outline_.close();
  at_ = start_;
}

void Placed::bulge_to(const Real& bulge, const Real& x, const Real& y) {
  if (bulge.sign() != 0 && !map_.scale) {
    if (at_.x == x && at_.y == y) return;
    return ellipse_to(
        bulge_ellipse(at_.x.to_double(), at_.y.to_double(), bulge.to_double(), x.to_double(), y.to_double()), x, y);
  }
  outline_.bulge_to(map_.mirrors ? -bulge : bulge, map_.x_of(x, y), map_.y_of(x, y));
  reach(x, y);
}

void Placed::spline_to(plane::Spline spline) {
  at_ = plane::spline_end(spline, true);
  for (plane::CurvePoint& p : spline.points) p = map_.of(p);
  outline_.spline_to(std::move(spline));
}

void Placed::spline(plane::Spline spline, bool closed) {
  plane::check_spline(spline);
  const plane::CurvePoint first = plane::spline_end(spline, false);
  move_to(first.x, first.y);
  spline_to(std::move(spline));
  if (closed) return close();
  finish();
}

void Placed::circle(const Real& x, const Real& y, const Real& radius) {
  if (!map_.scale) return ellipse(whole_ellipse(x, y, radius, radius));
  outline_.circle(map_.x_of(x, y), map_.y_of(x, y), radius * *map_.scale);
}

void Placed::ellipse(const EllipseArc& whole) { outline_.ellipse(map_.of(whole)); }

}  // namespace findspace::io
