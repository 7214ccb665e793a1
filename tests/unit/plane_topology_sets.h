// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Small exact sets from which the tests of topology, summary and location are put together with set operations.
#pragma once

#include <vector>

#include "law/plane_same_set.h"
#include "plane/complex/overlay.h"
#include "plane/complex/piece_builder.h"
#include "plane/complex/winding.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

namespace findspace::plane {

/// All curves of the builder belong to the set, and the faces with a positive winding number.
inline Region closed_set(const PieceBuilder& b, const std::vector<Index>& isolated = {}) {
  Arrangement a = arrange(b.geometry, b.pieces, isolated);
  Marks marks;
  for (std::int32_t w : face_windings(a, b.forward, 0)) marks.faces.push_back(w > 0);
  marks.edges.assign(a.edge_count(), 1);
  marks.vertices.assign(a.vertex_count(), 1);
  return extract(std::move(a), marks);
}

/// Counter-clockwise corners.
inline Region polygon(const std::vector<GridPoint>& p) {
  PieceBuilder b;
  for (std::size_t i = 0; i < p.size(); ++i) b.segment(p[i], p[(i + 1) % p.size()]);
  return closed_set(b);
}

inline Region box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

inline Region disc(std::int64_t x, std::int64_t y, const exact::Real& r) {
  PieceBuilder b;
  b.circle(b.geometry.add(exact::SupportingCurve::circle_at(x, y, r)));
  return closed_set(b);
}

inline Region segment(const GridPoint& p, const GridPoint& q) {
  PieceBuilder b;
  b.segment(p, q);
  return closed_set(b);
}

inline Region point(std::int64_t x, std::int64_t y) {
  PieceBuilder b;
  return closed_set(b, {b.geometry.add_grid_point(x, y)});
}

inline Region operator+(const Region& a, const Region& b) { return unite(std::vector<const Region*>{&a, &b}); }
inline Region operator-(const Region& a, const Region& b) { return subtract(std::vector<const Region*>{&a, &b}); }
inline Region operator&(const Region& a, const Region& b) { return intersect(std::vector<const Region*>{&a, &b}); }

}  // namespace findspace::plane
