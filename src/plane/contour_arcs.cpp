// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Arc edges from what formats give: radius, bulge or centre.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "plane/contour.h"
#include "plane/contour_meet.h"

namespace findspace::plane {
namespace {

using exact::Real;

int128 squared_distance(GridPoint a, GridPoint b) {
  int128 dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

/// from + (to - from)/2 + perpendicular * factor, the perpendicular being to - from turned left.
void set_center(ContourEdge& edge, GridPoint to, const Real& factor) {
  const Real half = Real::ratio(1, 2);
  edge.cx = Real(edge.start.x + to.x) * half - Real(to.y - edge.start.y) * factor;
  edge.cy = Real(edge.start.y + to.y) * half + Real(to.x - edge.start.x) * factor;
}

/// The grid point nearest to the centre if it is equally far from both ends; the exact centre may be off by the few
/// digits of the input. `moved` is set when the two differ.
std::optional<GridPoint> grid_center(const ContourEdge& edge, GridPoint to, bool* moved) {
  constexpr double kFar = 0x1p60;  // beyond, products of coordinates would not fit 128 bits
  if (!(std::abs(edge.cx.to_double()) < kFar && std::abs(edge.cy.to_double()) < kFar)) return std::nullopt;
  GridPoint near{std::int64_t(round(edge.cx)), std::int64_t(round(edge.cy))};
  if (near == edge.start || squared_distance(near, edge.start) != squared_distance(near, to)) return std::nullopt;
  bool same = compare(edge.cx, Real(near.x)) == 0 && compare(edge.cy, Real(near.y)) == 0;
  if (moved && !same) *moved = true;
  return near;
}

}  // namespace

ContourEdge radius_arc(GridPoint from, GridPoint to, const Real& radius, bool large, bool ccw, bool* grown) {
  ContourEdge edge{from, true, ccw, {}, {}, radius};
  Real d2(squared_distance(from, to));
  Real square = radius * radius / d2 - Real::ratio(1, 4);
  if (square.sign() <= 0) {
    if (square.sign() < 0) {
      edge.r = sqrt(d2) / Real(2);
      if (grown) *grown = true;
    }
    set_center(edge, to, Real(0));
    return edge;
  }
  Real factor = sqrt(square);
  set_center(edge, to, ccw != large ? factor : -factor);
  return edge;
}

ContourEdge center_arc(GridPoint from, GridPoint to, GridPoint center, bool ccw) {
  assert(squared_distance(from, center) == squared_distance(to, center));
  (void)to;
  return {from, true, ccw, Real(center.x), Real(center.y), sqrt(Real(squared_distance(from, center)))};
}

ContourEdge bulge_arc(GridPoint from, GridPoint to, const Real& bulge, bool* moved) {
  ContourEdge edge{from, true, bulge.sign() > 0, {}, {}, {}};
  Real b2 = bulge * bulge;
  set_center(edge, to, (Real(1) - b2) / (Real(4) * bulge));
  if (auto near = grid_center(edge, to, moved)) return center_arc(from, to, *near, edge.ccw);
  Real size = edge.ccw ? bulge : -bulge;
  edge.r = sqrt(Real(squared_distance(from, to))) * (Real(1) + b2) / (Real(4) * size);
  return edge;
}

ContourEdge three_point_arc(GridPoint from, GridPoint through, GridPoint to, bool* moved) {
  int128 turn = cross(from, through, to);
  ContourEdge edge{from, turn != 0, turn >= 0, {}, {}, {}};
  if (turn == 0) return edge;
  // Circumcentre relative to `from`: (a^2 b - b^2 a) turned, over twice the cross product.
  Real a2(squared_distance(from, through)), b2(squared_distance(from, to)), twice(2 * turn);
  Real ax(through.x - from.x), ay(through.y - from.y), bx(to.x - from.x), by(to.y - from.y);
  edge.cx = Real(from.x) + (by * a2 - ay * b2) / twice;
  edge.cy = Real(from.y) + (ax * b2 - bx * a2) / twice;
  if (auto near = grid_center(edge, to, moved)) return center_arc(from, to, *near, edge.ccw);
  Real dx = edge.cx - Real(from.x), dy = edge.cy - Real(from.y);
  edge.r = sqrt(dx * dx + dy * dy);
  return edge;
}

Contour circle_ring(GridPoint center, std::int64_t radius) {
  GridPoint right{center.x + radius, center.y}, left{center.x - radius, center.y};
  return {center_arc(right, left, center, true), center_arc(left, right, center, true)};
}

double sagitta(const ContourEdge& arc, GridPoint to) {
  double r = arc.r.to_double();
  double half = std::sqrt(double(squared_distance(arc.start, to))) / 2;
  double apothem = std::sqrt(std::max(0.0, r * r - half * half));
  GridPoint first = arc.ccw ? arc.start : to, last = arc.ccw ? to : arc.start;
  double cx = arc.cx.to_double() - double(first.x), cy = arc.cy.to_double() - double(first.y);
  bool minor = double(last.x - first.x) * cy - double(last.y - first.y) * cx >= 0;
  return minor ? half * half / (r + apothem) : r + apothem;
}

}  // namespace findspace::plane
