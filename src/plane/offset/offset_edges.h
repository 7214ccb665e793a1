// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The edges of a set of grid polygons, asked what is near: D = {p : less than r away from the set} is the union of
// the set's interior and, for every edge, of the points less than r away from it; a point outside the set is in D
// exactly where an edge is that near. Guarantee: `holds` is exact; what `covers_*` finds lies in D for certain, and it
// may miss some (conservative double arithmetic, no sign is decided). Cost: a descent in a tree of boxes each, with the
// edges near by. Keywords: distance query, offset, pruning.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "exact/planar/near_segment.h"
#include "plane/complex/sequence_boxes.h"
#include "plane/grid/grid_faces.h"

namespace findspace::plane {

/// The corners of all faces in one list, with `next` and `before` as places in it. Many faces are ordered along a curve
/// that fills the plane, so that what is near in the plane mostly is near in the list.
GridCorners all_corners(GridFaces faces);

class OffsetEdges {
 public:
  /// Keeps references; looks at the corners when asked.
  OffsetEdges(std::span<const GridCorner> corners, const exact::Real& radius);

  Index before(Index corner) const { return corners_[corner].before; }

  /// Is an edge other than `own` less than r away from the point?
  bool holds(const exact::Geometry& g, Index point, std::span<const Index> own);

  /// Edge k displaced to the right by r lies in D.
  bool covers_displaced(Index k);
  /// The arc of radius r about convex corner k, between the normals of its edges, lies in D.
  bool covers_arc(Index k);
  /// Gives back what only `covers_*` reads.
  void end_covering();

 private:
  struct Vector {
    double x, y;
    friend Vector operator+(Vector p, Vector q) { return {p.x + q.x, p.y + q.y}; }
    friend Vector operator-(Vector p, Vector q) { return {p.x - q.x, p.y - q.y}; }
    friend Vector operator*(double f, Vector p) { return {f * p.x, f * p.y}; }
    friend double dot(Vector p, Vector q) { return p.x * q.x + p.y * q.y; }
  };
  struct Edge {
    Vector from, way, normal;  // to its end; the unit normal to its right
    double per_square;         // 1 over the square of its length
  };
  /// A part of a curve, in the triangle (or on the segment) of three points.
  struct Part {
    Vector from, top, to;
  };

  bool near(const Edge& e, Vector p) const;
  bool near(const Edge& e, const Part& p) const { return near(e, p.from) && near(e, p.to) && near(e, p.top); }
  Vector middle(const Part& p, const Vector* center) const;
  Part part(Vector from, Vector to, const Vector* center) const;
  bool covered(const Part& p, const Vector* center, std::span<const Index> by) const;
  bool covered(const Part& p, const Vector* center, std::span<const Index> by, int halvings) const;
  bool covered(const Part& p, const Vector* center, Index k);
  Index end_of_short_ring(Index k) const;
  bool in_short_ring(Index k) const {
    return near_first_ <= k && k < near_end_ ? near_end_ - near_first_ > 1 : end_of_short_ring(k) > k + 1;
  }
  /// Finds those that the curves made of a corner and its edge may be near to, or those of a short ring.
  void find_near(Index k);
  void prepare();
  void prepare_boxes();

  std::span<const GridCorner> corners_;
  const exact::Real& radius_;
  double r_;
  double certain_ = 0;  // a little less than r
  std::vector<Edge> edges_;
  std::vector<Index> near_, nearest_;    // to the curves of some corners, and to one of these
  Index near_first_ = 0, near_end_ = 0;  // these corners
  std::optional<SequenceBoxes> boxes_;
  int asked_ = 0;  // before there were boxes
};

}  // namespace findspace::plane
