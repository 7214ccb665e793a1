// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/ellipse_arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace findspace::io {
namespace {

using exact::Real;
using std::numbers::pi;

Real number(double v) { return Real::from_double(v); }

/// Angle from u to v, in (-pi, pi].
double angle(double ux, double uy, double vx, double vy) { return std::atan2(ux * vy - uy * vx, ux * vx + uy * vy); }

}  // namespace

EllipseArc ellipse_arc(const SvgArc& a) {
  const double c = std::cos(a.degrees * (pi / 180)), s = std::sin(a.degrees * (pi / 180));
  const double dx = (a.x0 - a.x1) / 2, dy = (a.y0 - a.y1) / 2;
  double x = (c * dx + s * dy) / a.rx, y = (c * dy - s * dx) / a.ry;  // half the chord, on the unit circle
  const double grown = std::max(1.0, std::hypot(x, y));
  const double rx = a.rx * grown, ry = a.ry * grown;
  x /= grown;
  y /= grown;
  const double square = x * x + y * y;
  const double beside = (a.large == a.sweep ? -1 : 1) * std::sqrt(std::max(0.0, 1 - square) / square);
  const double ox = beside * y, oy = -beside * x;  // the centre, from the middle of the chord
  const double first = std::atan2(y - oy, x - ox);
  double sweep = angle(x - ox, y - oy, -x - ox, -y - oy);
  if (a.sweep && sweep <= 0) sweep += 2 * pi;
  if (!a.sweep && sweep >= 0) sweep -= 2 * pi;
  const double cx = c * rx * ox - s * ry * oy + (a.x0 + a.x1) / 2, cy = s * rx * ox + c * ry * oy + (a.y0 + a.y1) / 2;
  return {
      {{number(cx), number(cy)}, {number(c * rx), number(s * rx)}, {number(-s * ry), number(c * ry)}}, first, sweep};
}

EllipseArc bulge_ellipse(double x0, double y0, double bulge, double x1, double y1) {
  const double side = (1 - bulge * bulge) / (4 * bulge);
  const double cx = (x0 + x1) / 2 - (y1 - y0) * side, cy = (y0 + y1) / 2 + (x1 - x0) * side;
  return {{{number(cx), number(cy)}, {number(x0 - cx), number(y0 - cy)}, {number(cy - y0), number(x0 - cx)}},
          0,
          4 * std::atan(bulge)};
}

plane::CurvePoint ellipse_point(const EllipseArc& arc, double turn) {
  const plane::EllipseFrame& f = arc.frame;
  const Real c = number(std::cos(arc.first + turn)), s = number(std::sin(arc.first + turn));
  return {f.center.x + f.u.x * c + f.v.x * s, f.center.y + f.u.y * c + f.v.y * s};
}

EllipseArc whole_ellipse(const Real& x, const Real& y, const Real& rx, const Real& ry) {
  return {{{x, y}, {rx, Real(0)}, {Real(0), ry}}, 0, 2 * pi};
}

}  // namespace findspace::io
