// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/piece_builder.h"

namespace findspace::plane {

using exact::int128;
using exact::SupportingCurve;

Index PieceBuilder::line(const GridPoint& p, const GridPoint& q) {
  std::int64_t a = q.y - p.y, b = p.x - q.x;
  exact::make_primitive(a, b);
  return geometry.add_line(a, b, int128(a) * p.x + int128(b) * p.y);
}

void PieceBuilder::segment(Index supporting_curve, Index from, Index to, bool right) {
  pieces.push_back({.supporting_curve = supporting_curve, .p0 = right ? from : to, .p1 = right ? to : from});
  forward.push_back(right);
}

void PieceBuilder::segment(const GridPoint& p, const GridPoint& q) {
  Index from = geometry.add_grid_point(p.x, p.y), to = geometry.add_grid_point(q.x, q.y);
  segment(line(p, q), from, to, p < q);
}

Index extreme_point(exact::Geometry& geometry, Index circle, int side) {
  const SupportingCurve k = geometry.supporting_curves[circle];
  exact::Real x = side > 0 ? k.center_x() + k.w() : k.center_x() - k.w();
  return geometry.add_real_point(x, k.center_y());
}

void PieceBuilder::arc(Index circle, Index from, Index to, bool ccw) {
  cut_arc(geometry, circle, from, to, ccw, [&](Index at, Index next, std::int8_t half, bool right) {
    pieces.push_back({.supporting_curve = circle, .p0 = right ? at : next, .p1 = right ? next : at, .half = half});
    forward.push_back(right);
  });
}

void PieceBuilder::edge(const ContourEdge& e, const GridPoint& to) {
  if (!e.arc) return segment(e.start, to);
  Index from = geometry.add_grid_point(e.start.x, e.start.y);
  Index end = e.start == to ? from : geometry.add_grid_point(to.x, to.y);
  arc(geometry.add(SupportingCurve::circle_at(e.arc->cx, e.arc->cy, e.arc->r)), from, end, e.ccw);
}

void PieceBuilder::circle(Index circle) {
  Index start = extreme(circle, -1);
  arc(circle, start, start, true);
}

}  // namespace findspace::plane
