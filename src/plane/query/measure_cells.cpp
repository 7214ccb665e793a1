// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/measure_cells.h"

#include "exact/margins/plane.h"
#include "plane/base/parallel.h"
#include "plane/query/measure_cells_places.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kManyCells = 1 << 13;    // from here on in several threads
constexpr std::size_t kSweptAtOnce = 1 << 16;  // their areas are kept before they are summed up in order
const Twofold kTwoPi{6.283185307179586, 2.4492935982947064e-16};  // no sign: the second half of 2 pi

Twofold determinant(const Twofold& ax, const Twofold& ay, const Twofold& bx, const Twofold& by) {
  return ax * by - ay * bx;
}

/// Of a coordinate on the grid, which is far below what 64 bits hold.
Twofold twofold(std::int64_t whole) {
  const auto high = static_cast<double>(whole);
  return {high, static_cast<double>(whole - static_cast<std::int64_t>(high))};
}

}  // namespace

CellMeasures::CellMeasures(const CellComplex& c) : c_(c), x_(c.vertices.size()), y_(c.vertices.size()) {
  in_ranges(c.vertices.size(), kManyCells, [&](const IndexRange& vertices) {
    VertexPlaces places(c.geometry);
    for (std::size_t v = vertices.first; v < vertices.end; ++v) {
      const auto [x, y] = places.at(c.vertices[v].point);
      x_[v] = x;
      y_[v] = y;
    }
  });
  add_circles();
}

void CellMeasures::add_circles() {
  const CellComplex& c = c_;
  const exact::Real *last = nullptr, *last_kept = nullptr;  // circles of one offset share their radius
  Twofold radius;
  circle_of_supporting_curve_.assign(c.geometry.supporting_curves.size(), kNone);
  for (Index e = 0; e < c.edges.size(); ++e) {
    Index& place = circle_of_supporting_curve_[c.edges[e].supporting_curve];
    if (!c.is_arc(e) || place != kNone) continue;
    const exact::SupportingCurve& k = c.supporting_curve(e);
    if (&k.w() != last) radius = Twofold(k.w());
    last = &k.w();
    if (!k.grid) {
      place = Index(circles_.size());
      circles_.push_back({Twofold(k.center_x()), Twofold(k.center_y()), radius});
      continue;
    }
    if (last_kept != last) radii_.push_back(radius);
    last_kept = last;
    place = Index(radii_.size()) - 1;
  }
}

CellMeasures::Circle CellMeasures::circle(Index arc) const {
  const exact::SupportingCurve& k = c_.supporting_curve(arc);
  const Index place = circle_of_supporting_curve_[c_.edges[arc].supporting_curve];
  return k.grid ? Circle{twofold(k.a), twofold(k.b), radii_[place]} : circles_[place];
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
  const auto counts = [&](Index face) { return c_.faces[face].outer != kNone && c_.faces[face].mark != 0; };
  std::vector<Twofold> areas(c_.faces.size());
  std::vector<Index> half_edges;
  std::vector<Twofold> swept;
  const auto sum_up = [&] {
    swept.resize(half_edges.size());
    in_ranges(half_edges.size(), kManyCells, [&](const IndexRange& some) {
      for (std::size_t k = some.first; k < some.end; ++k) {
        // About a point of the face: nothing large cancels.
        const Index h = half_edges[k], origin = c_.origin(c_.faces[c_.face(h)].outer);
        swept[k] = swept_area(h, x_[origin], y_[origin]);
      }
    });
    for (std::size_t k = 0; k < swept.size(); ++k) areas[c_.face(half_edges[k])] += swept[k];
    half_edges.clear();
  };
  for (Index h = 0; h < c_.half_edges.size(); ++h) {
    if (counts(c_.face(h))) half_edges.push_back(h);
    if (half_edges.size() == kSweptAtOnce) sum_up();
  }
  sum_up();
  return areas;
}

}  // namespace findspace::plane
