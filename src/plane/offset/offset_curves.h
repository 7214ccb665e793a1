// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The curves at distance r from a set of grid polygons that can be boundary of D = {p : less than r away from the set}:
// every edge displaced to the outside, and an arc about every convex corner, each with D on its left. At a reflex
// corner the two displaced edges cross; what lies beyond the crossing is in D and left out, where both edges are long
// enough for that. Curves that certainly lie in D are left out too. Guarantee: exact; every point of the boundary of D
// lies on a curve. Cost: linear, and the search for covered curves where that pays. Source:
// docs/decisions/0012-offsets-by-outer-walks.md. Keywords: parallel curve, offset, buffer.
#pragma once

#include <vector>

#include "exact/planar/geometry_signs.h"
#include "plane/complex/arrangement.h"
#include "plane/offset/offset_edges.h"

namespace findspace::plane {

/// What a piece was made from and where it leads.
struct OffsetOrigin {
  bool right;         // it is travelled from p0 to p1
  bool arc;           // about `corner`; else the edge that leaves `corner`, displaced
  std::int8_t rises;  // +1 on its whole way, or it is level; -1: it falls; 0: an arc over its highest or lowest point
  Index corner;
  Index next = kNone;  // the piece that starts where this one ends
};

struct OffsetCurves {
  exact::Geometry geometry;
  std::vector<Piece> pieces;  // x-monotone, in the order of the boundary
  std::vector<OffsetOrigin> origins;

  Index start(Index i) const { return origins[i].right ? pieces[i].p0 : pieces[i].p1; }
  Index end(Index i) const { return origins[i].right ? pieces[i].p1 : pieces[i].p0; }
  /// Of travel.
  exact::Heading heading(Index i) const {
    const Piece& p = pieces[i];
    return {p.supporting_curve,
            p.half != 0 || (geometry.supporting_curves[p.supporting_curve].b > 0) == origins[i].right};
  }
};

/// `geometry`: of the corners, none of them straight.
OffsetCurves offset_curves(std::span<const GridCorner> corners, const exact::Geometry& geometry,
                           const exact::Real& radius, OffsetEdges& edges);

}  // namespace findspace::plane
