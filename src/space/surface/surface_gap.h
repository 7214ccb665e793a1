// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Two closed sets given by their surfaces (surface_set.h), B moved to a position p: whether their interiors meet,
// whether B lies in A, and the least distance of their surfaces. Neither is cut into convex parts. The least distance
// is taken between a corner and a face, or two edges: pairs of boxes are searched nearest first in doubles, and all
// features that are as near as doubles can tell are compared exactly. Overlap by real_overlap.h. Guarantee:
// exact. Cost: O(log n) pairs of boxes where few features are nearest, and building the trees. Source: closest
// points as in Ericson, Real-Time Collision Detection, 2004, 5.1. Keywords: minimum distance, clearance, BVH, branch
// and bound.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "space/surface/real_overlap.h"
#include "space/surface/surface_set.h"

namespace findspace::space {

/// The nearest two places of two surfaces.
struct SurfaceGap {
  RealVector way;      // from the place of B + p (the centre of a ball) to that of A
  exact::Real radius;  // of the balls among the two
  exact::Real value;   // |way| - radius
};

class SurfaceGaps {
 public:
  SurfaceGaps(std::shared_ptr<const SurfaceSet> a, std::shared_ptr<const SurfaceSet> b);

  /// A corner of one and a face of the other, or two edges; of a ball its centre.
  struct Pair {
    enum class Kind { kCornerOfB, kCornerOfA, kEdges, kBallOfB, kBallOfA, kBalls };
    Kind kind;
    int sheet_a = 0, sheet_b = 0;  // or the ball
    int a = 0, b = 0;              // point, face or edge of its sheet
    double nearly = 0;             // their distance
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };
  /// All pairs that can be nearest.
  struct Near {
    std::vector<Pair> pairs;
    double value = exact::kInfinity, error = 0;
  };
  Near near(const RealVector& p) const { return near(space::rounded(p)); }
  Near near(const Vector& p) const;
  /// The least distance of the surfaces, for a ball of its centre less the radius. Where the interiors do not meet, and
  /// where B lies in A, it is the distance.
  SurfaceGap gap(const RealVector& p, const Near& near) const;

  enum class Relation { kApart, kInside, kOther };
  /// Apart: the interiors do not meet. Inside: B + p lies in A, of which one sheet is the frontier.
  Relation relation(const RealVector& p) const;

 private:
  RealVector way(const Pair& pair, const RealVector& p) const;
  exact::Real radius(const Pair& pair) const;
  /// Of a sheet of A, or of what is outside it, and one of B.
  const RealOverlap& overlap(std::size_t i, std::size_t j, bool complement) const;
  /// Whether the interiors of B's sheet and of A's, or what is outside that, meet.
  bool sheets_meet(std::size_t i, std::size_t j, bool complement, const RealVector& p) const;
  Relation with_balls(const RealVector& p) const;

  std::shared_ptr<const SurfaceSet> a_, b_;
  double longest_ = 0;  // edge
  mutable std::mutex guard_;
  mutable std::vector<std::array<std::unique_ptr<const RealOverlap>, 2>> overlaps_;
};

/// From x to the nearest place of the surface.
RealVector way_to(const SurfaceSet::Sheet& sheet, const RealVector& x);
/// The squared distance of x from the face, in doubles.
double squared_distance(const SurfaceSet::Sheet& sheet, int face, const Vector& x);
/// Its place nearest to x, in doubles.
Vector nearest_place(const SurfaceSet::Sheet& sheet, int face, const Vector& x);

}  // namespace findspace::space
