// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/measure_cells.h"

#include "exact/margins/plane.h"
#include "plane/query/measure_cells_places.h"

namespace findspace::plane {
namespace {

const Twofold kTwoPi{6.283185307179586, 2.4492935982947064e-16};  // no sign: the second half of 2 pi

Twofold determinant(const Twofold& ax, const Twofold& ay, const Twofold& bx, const Twofold& by) {
  return ax * by - ay * bx;
}

}  // namespace

CellMeasures::CellMeasures(const CellComplex& c) : c_(c) {
  x_.reserve(c.vertices.size());
  y_.reserve(c.vertices.size());
  VertexPlaces places(c.geometry);
  for (Index v = 0; v < c.vertices.size(); ++v) {
    const auto [x, y] = places.at(c.vertices[v].point);
    x_.push_back(x);
    y_.push_back(y);
  }
  circle_of_supporting_curve_.assign(c.geometry.supporting_curves.size(), kNone);
  for (Index e = 0; e < c.edges.size(); ++e) {
    Index& place = circle_of_supporting_curve_[c.edges[e].supporting_curve];
    if (!c.is_arc(e) || place != kNone) continue;
    place = Index(circles_.size());
    const exact::SupportingCurve& k = c.supporting_curve(e);
    circles_.push_back({Twofold(k.center_x()), Twofold(k.center_y()), Twofold(k.w())});
  }
}

CellMeasures::Spread CellMeasures::spread(Index arc) const {
  const Edge& e = c_.edges[arc];
  Index from = e.half < 0 ? e.v0 : e.v1, to = e.half < 0 ? e.v1 : e.v0;  // the lower half runs counter-clockwise
  const auto [ax, ay] = directed_edge(arc, from);
  const auto [bx, by] = directed_edge(arc, to);
  return {determinant(ax, ay, bx, by), ax * bx + ay * by};
}

std::array<Twofold, 2> CellMeasures::directed_edge(Index arc, Index vertex) const {
  const Circle& k = circle(arc);
  if (k.radius.hi > margin::kSmallRadius * (std::abs(k.x.hi) + std::abs(k.y.hi)))
    return {x_[vertex] - k.x, y_[vertex] - k.y};
  const exact::RealPoint p = c_.geometry.exact(c_.vertices[vertex].point);
  return {Twofold(p.x - c_.supporting_curve(arc).center_x()), Twofold(p.y - c_.supporting_curve(arc).center_y())};
}

Twofold CellMeasures::angle(Index arc) const {
  Spread s = spread(arc);
  Twofold angle = atan2(s.cross, s.dot);
  // A half circle whose cross product came out a little below zero.
  return s.dot.hi < 0 && angle.hi < 0 ? angle + kTwoPi : angle;
}

Twofold CellMeasures::length(Index edge) const {
  if (c_.is_arc(edge)) return circle(edge).radius * angle(edge);
  const Edge& e = c_.edges[edge];
  Twofold dx = x_[e.v1] - x_[e.v0], dy = y_[e.v1] - y_[e.v0];
  return sqrt(dx * dx + dy * dy);
}

Twofold CellMeasures::swept_area(Index half_edge, const Twofold& ox, const Twofold& oy) const {
  const Index arc = half_edge / 2;
  Index from = c_.origin(half_edge), to = c_.target(half_edge);
  Twofold twice = determinant(x_[from] - ox, y_[from] - oy, x_[to] - ox, y_[to] - oy);
  if (c_.is_arc(arc)) {
    // The circular segment between chord and arc, to the right of the chord where the arc turns left.
    const Twofold& r = circle(arc).radius;
    Twofold segment = r * r * angle(arc) - spread(arc).cross;
    twice += c_.heading(half_edge).forward ? segment : -segment;
  }
  return twice * Twofold(0.5);
}

std::vector<Twofold> CellMeasures::face_areas() const {
  std::vector<Twofold> areas(c_.faces.size());
  for (Index h = 0; h < c_.half_edges.size(); ++h) {
    const Face& f = c_.faces[c_.face(h)];
    if (f.outer == kNone) continue;
    Index origin = c_.origin(f.outer);  // sums are taken about a point of the face: nothing large cancels
    areas[c_.face(h)] += swept_area(h, x_[origin], y_[origin]);
  }
  return areas;
}

}  // namespace findspace::plane
