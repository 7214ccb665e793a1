// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/extent.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"

namespace findspace::plane {
namespace {

PieceBox place_box(double x, double y, double tolerance) {
  const double dx = tolerance + std::abs(x) * margin::kRoundings8, dy = tolerance + std::abs(y) * margin::kRoundings8;
  return {x - dx, y - dy, x + dx, y + dy};
}

PieceBox place_box(const exact::Point& p) { return place_box(p.x, p.y, p.error); }

void grow(std::optional<PieceBox>& box, double x, double y, double tolerance) {
  const PieceBox place = place_box(x, y, tolerance);
  box = box ? joined(*box, place) : place;
}

/// Ends are vertices; what an arc adds is its highest or lowest point.
void grow_by_arc(std::optional<PieceBox>& box, const CellComplex& c, const Edge& arc) {
  const exact::SupportingCurve& k = c.geometry.supporting_curves[arc.supporting_curve];
  const double x = std::clamp(k.x().value, box->x0, box->x1);
  grow(box, x, k.y().value + arc.half * k.z().value,
       k.y().error + k.z().error + std::abs(k.z().value) * margin::kRoundings8);
}

}  // namespace

std::optional<PieceBox> extent(const CellComplex& c) {
  std::optional<PieceBox> box;
  for (const Vertex& v : c.vertices) {
    const exact::Point& p = c.geometry.points[v.point];
    grow(box, p.x, p.y, p.error);
  }
  for (const Edge& e : c.edges)
    if (e.half != 0) grow_by_arc(box, c, e);
  return box;
}

bool is_within(const CellComplex& c, double most) {
  return std::all_of(c.vertices.begin(), c.vertices.end(), [&](const Vertex& v) {
    const exact::Point& p = c.geometry.points[v.point];
    return std::abs(p.x) - p.error <= most && std::abs(p.y) - p.error <= most;
  });
}

PieceBox extent(std::span<const Contour> rings) {
  std::optional<PieceBox> box;
  for (const Contour& ring : rings)
    for (const ContourEdge& e : ring) {
      grow(box, double(e.start.x), double(e.start.y), 0);
      if (!e.arc) continue;
      const exact::Interval x = e.arc->cx.interval(), y = e.arc->cy.interval(), r = e.arc->r.interval();
      grow(box, x.lo, y.lo, r.hi);
      grow(box, x.hi, y.hi, r.hi);
    }
  return *box;
}

PieceBox edge_box(const CellComplex& c, Index edge) {
  const Edge& e = c.edges[edge];
  std::optional<PieceBox> box = joined(place_box(c.point(e.v0)), place_box(c.point(e.v1)));
  if (e.half != 0) grow_by_arc(box, c, e);
  return *box;
}

PieceBox moved(const PieceBox& box, const exact::RealPoint& by) {
  std::optional<PieceBox> out;
  const exact::Interval x = by.x.interval(), y = by.y.interval();
  grow(out, box.x0 + x.lo, box.y0 + y.lo, 0);
  grow(out, box.x1 + x.hi, box.y1 + y.hi, 0);
  return *out;
}

}  // namespace findspace::plane
