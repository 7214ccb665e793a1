// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/summary_sample.h"

#include <cmath>

#include "plane/query/summary_outline.h"

namespace findspace::plane {
namespace {

using exact::Real;
using exact::RealPoint;

Real half_of(const Real& a) { return a / Real(2); }

/// Exact y of a non-vertical edge at x, which is in its range.
Real y_at(const CellComplex& c, Index edge, const Real& x) {
  const exact::SupportingCurve& k = c.supporting_curve(edge);
  if (!k.circle) return (k.offset() - Real(k.a) * x) / Real(k.b);
  Real dx = x - k.center_x(), root = sqrt(k.w() * k.w() - dx * dx);
  return c.edges[edge].half > 0 ? k.center_y() + root : k.center_y() - root;
}

bool is_vertical(const CellComplex& c, Index edge) { return !c.is_arc(edge) && c.supporting_curve(edge).b == 0; }

/// The multiple of `unit` nearest to x, as an integer.
Real on_lattice(double x, double unit) { return Real(exact::int128(std::round(x / unit))) * Real(exact::int128(unit)); }

}  // namespace

Sampler::Sampler(const Region& s, const CellMeasures& measures)
    : s_(s), measures_(measures), start_(s.faces.size() + 1, 0) {
  for (Index h = 0; h < s.half_edges.size(); ++h) ++start_[s.face(h) + 1];
  for (std::size_t f = 0; f < s.faces.size(); ++f) start_[f + 1] += start_[f];
  half_edges_.resize(s.half_edges.size());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (Index h = 0; h < s.half_edges.size(); ++h) half_edges_[next[s.face(h)]++] = h;
}

bool Sampler::is_inside(const RealPoint& p, Index face) {
  constexpr int kFew = 3;
  if (!locator_ && ++located_ > kFew) locator_.emplace(s_);
  return (locator_ ? locator_->locate(p) : locate(s_, p)) == Cell{2, face};
}

RealPoint Sampler::inside_face(Index face) {
  std::span<const Index> half_edges(half_edges_.data() + start_[face], start_[face + 1] - start_[face]);
  if (half_edges.empty() && s_.faces[face].isolated.empty()) return {};
  FaceOutline outline(s_, measures_, face, half_edges);
  FaceOutline::Spot spot = outline.clearest();
  if (spot.clearance > 0) {
    // A grid point with as few digits as the clearance around it allows.
    double unit = spot.clearance < 8 ? 1 : std::pow(10, std::floor(std::log10(spot.clearance / 8)));
    RealPoint p{on_lattice(spot.x, unit), on_lattice(spot.y, unit)};
    if (is_inside(p, face)) return p;
    p = {Real::from_double(spot.x), Real::from_double(spot.y)};
    if (is_inside(p, face)) return p;
  }
  return exact_inside_face(face);
}

/// Halfway between the middle of an edge of the face and the next of its edges on that side.
RealPoint Sampler::exact_inside_face(Index face) {
  Index base = start_[face];
  while (is_vertical(s_, half_edges_[base] / 2)) ++base;  // a bounded face has other edges, and this one has curves
  const Index h = half_edges_[base];
  const bool up = !(h & 1u);
  const Real x = middle_of_edge(h / 2).x, y = y_at(s_, h / 2, x);
  std::optional<Real> other;
  for (Index i = start_[face]; i < start_[face + 1]; ++i) {
    const Index k = half_edges_[i];
    const Edge& e = s_.edges[k / 2];
    if (k == h || bool(k & 1u) != up || is_vertical(s_, k / 2)) continue;  // it must have the face on the other side
    if (s_.geometry.exact_x(s_.vertices[e.v0].point) > x || s_.geometry.exact_x(s_.vertices[e.v1].point) < x) continue;
    Real z = y_at(s_, k / 2, x);
    if (up ? z <= y : z >= y) continue;
    if (!other || (up ? z < *other : z > *other)) other = z;
  }
  RealPoint p{x, other ? half_of(y + *other) : up ? y + Real(1) : y - Real(1)};
  while (!is_inside(p, face))
    p.y = half_of(y + p.y);  // a whisker or an isolated point may stand at x, away from the edge
  return p;
}

RealPoint Sampler::middle_of_edge(Index edge) const {
  const Edge& e = s_.edges[edge];
  RealPoint p = s_.geometry.exact(s_.vertices[e.v0].point), q = s_.geometry.exact(s_.vertices[e.v1].point);
  Real x = half_of(p.x + q.x);
  if (is_vertical(s_, edge)) return {x, half_of(p.y + q.y)};
  return {x, s_.is_arc(edge) ? y_at(s_, edge, x) : half_of(p.y + q.y)};
}

}  // namespace findspace::plane
