// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Arc edges from what formats give: radius, bulge or centre.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "plane/contour/contour.h"
#include "plane/contour/contour_meet.h"

namespace findspace::plane {
namespace {

using exact::Real;

int128 squared_distance(GridPoint a, GridPoint b) {
  int128 dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

/// from + (to - from)/2 + perpendicular * factor, the perpendicular being to - from turned left.
ArcCircle circle_beside(GridPoint from, GridPoint to, const Real& factor) {
  const Real half = Real::ratio(1, 2);
  return {Real(from.x + to.x) * half - Real(to.y - from.y) * factor,
          Real(from.y + to.y) * half + Real(to.x - from.x) * factor,
          {}};
}

/// The grid point nearest to the centre if it is equally far from both ends; the exact centre may be off by the few
/// digits of the input. `moved` is set when the two differ.
std::optional<GridPoint> grid_center(const ArcCircle& circle, GridPoint from, GridPoint to, bool* moved) {
  constexpr double kFar = 0x1p60;  // no sign: beyond, products of coordinates would not fit 128 bits
  if (!(std::abs(circle.cx.to_double()) < kFar && std::abs(circle.cy.to_double()) < kFar)) return std::nullopt;
  GridPoint near{std::int64_t(round(circle.cx)), std::int64_t(round(circle.cy))};
  if (near == from || squared_distance(near, from) != squared_distance(near, to)) return std::nullopt;
  bool same = compare(circle.cx, Real(near.x)) == 0 && compare(circle.cy, Real(near.y)) == 0;
  if (moved && !same) *moved = true;
  return near;
}

ContourEdge arc_of(GridPoint from, bool ccw, ArcCircle circle) {
  return {from, std::make_shared<const ArcCircle>(std::move(circle)), ccw};
}

}  // namespace

ContourEdge radius_arc(GridPoint from, GridPoint to, const Real& radius, bool large, bool ccw, bool* grown) {
  Real d2(squared_distance(from, to));
  Real square = radius * radius / d2 - Real::ratio(1, 4), factor, r = radius;
  if (square.sign() < 0) {
    r = sqrt(d2) / Real(2);
    if (grown) *grown = true;
  } else if (square.sign() > 0) {
    factor = ccw != large ? sqrt(square) : -sqrt(square);
  }
  ArcCircle circle = circle_beside(from, to, factor);
  circle.r = r;
  return arc_of(from, ccw, std::move(circle));
}

ContourEdge center_arc(GridPoint from, GridPoint to, GridPoint center, bool ccw) {
  assert(squared_distance(from, center) == squared_distance(to, center));
  (void)to;
  return arc_of(from, ccw, {Real(center.x), Real(center.y), sqrt(Real(squared_distance(from, center)))});
}

ContourEdge bulge_arc(GridPoint from, GridPoint to, const Real& bulge, bool* moved) {
  const bool ccw = bulge.sign() > 0;
  Real b2 = bulge * bulge;
  ArcCircle circle = circle_beside(from, to, (Real(1) - b2) / (Real(4) * bulge));
  if (auto near = grid_center(circle, from, to, moved)) return center_arc(from, to, *near, ccw);
  circle.r = sqrt(Real(squared_distance(from, to))) * (Real(1) + b2) / (Real(4) * (ccw ? bulge : -bulge));
  return arc_of(from, ccw, std::move(circle));
}

ContourEdge three_point_arc(GridPoint from, GridPoint through, GridPoint to, bool* moved) {
  int128 turn = cross(from, through, to);
  if (turn == 0) return {.start = from};
  // Circumcentre relative to `from`: (a^2 b - b^2 a) turned, over twice the cross product.
  Real a2(squared_distance(from, through)), b2(squared_distance(from, to)), twice(2 * turn);
  Real ax(through.x - from.x), ay(through.y - from.y), bx(to.x - from.x), by(to.y - from.y);
  ArcCircle circle{Real(from.x) + (by * a2 - ay * b2) / twice, Real(from.y) + (ax * b2 - bx * a2) / twice, {}};
  if (auto near = grid_center(circle, from, to, moved)) return center_arc(from, to, *near, turn > 0);
  Real dx = circle.cx - Real(from.x), dy = circle.cy - Real(from.y);
  circle.r = sqrt(dx * dx + dy * dy);
  return arc_of(from, turn > 0, std::move(circle));
}

Contour circle_ring(GridPoint center, std::int64_t radius) {
  GridPoint right{center.x + radius, center.y}, left{center.x - radius, center.y};
  return {center_arc(right, left, center, true), center_arc(left, right, center, true)};
}

double sagitta(const ContourEdge& edge, GridPoint to) {
  const ArcCircle& circle = *edge.arc;
  double r = circle.r.to_double();
  double half = std::sqrt(double(squared_distance(edge.start, to))) / 2;
  double apothem = std::sqrt(std::max(0.0, r * r - half * half));
  GridPoint first = edge.ccw ? edge.start : to, last = edge.ccw ? to : edge.start;
  double cx = circle.cx.to_double() - double(first.x), cy = circle.cy.to_double() - double(first.y);
  bool minor = double(last.x - first.x) * cy - double(last.y - first.y) * cx >= 0;
  return minor ? half * half / (r + apothem) : r + apothem;
}

}  // namespace findspace::plane
