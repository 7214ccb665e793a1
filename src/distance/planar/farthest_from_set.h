// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The point of a set B + p that is farthest from a closed set A: the directed Hausdorff distance h(B+p, A) = max over b
// of d(b, A), over the whole of B (its vertices, edges and inside), not over samples. Method: boxes over B, the one
// with the largest bound first. A box carries the parts of A's boundary that can be nearest in it; its bound is the
// least over those of their greatest distance in the box (at a corner, distances to convex parts being convex). In a
// box with few parts the candidates are: B's vertices; on B's edges the places between two parts of A, by intervals
// with the same bound; inside B the places equally far from three parts. The best place is then computed exactly from
// the level curves that meet there; last, a finer search for what is more. Guarantee: numbers to about 1e-14 of the
// coordinates, the final value exact in the place found, and no place has more by 2^-43 of the scale. A value at a
// place that no formula gives, as where an arc of B crosses a parabola between two parts of A, is enclosed that
// tightly. Cost: about (n + m) log(n + m) for shapes that are apart or similar. Source: branch and bound; Alt,
// Behrends, Blömer 1995 for where the maximum can lie. Keywords: directed Hausdorff distance, lower envelope, branch
// and bound.
#pragma once

#include <limits>
#include <vector>

#include "distance/planar/farthest_place.h"
#include "distance/planar_features/voronoi_cells.h"
#include "plane/query/locate.h"

namespace findspace::distance {

/// A place of B + p where d(., A) has (about) a local maximum.
struct MaxMinPlace {
  double value = 0, x = 0, y = 0;  // the place itself, in A's coordinates
  plane::Cell cell{};              // of B; dimension 2 for a place inside B
  bool unnamed = false;            // no formula may give it: parts of A meet there on an arc, or too many do
};

/// How far a search goes.
struct MaxMinEffort {
  double short_part;  // of the scale: a part of an edge this short is a place
  long most_ranges = std::numeric_limits<long>::max();
};

inline constexpr std::size_t kMostMaxMins = 10;  // places, and parts of A at one place

class FarthestFromSet {
 public:
  /// Keeps references; both closed, B bounded.
  FarthestFromSet(const plane::Region& b, const plane::Region& a);

  /// Max-min places of value at least greatest - tolerance and more than `least_value`, the greatest first, one for
  /// each place, as far as the effort goes.
  std::vector<MaxMinPlace> max_mins(double px, double py, double tolerance, double least_value,
                                    const MaxMinEffort& effort) const;
  /// The distance to A in the place of the max_min: exact, or in the place as the search has it.
  FarthestPlace exact_place(const MaxMinPlace& max_min, const exact::RealPoint& p) const;
  /// The farthest place if its value is more than `least_value`.
  std::optional<FarthestPlace> greatest(const exact::RealPoint& p, double least_value) const;
  /// Level curves (in p) that decide the max-min value, as far as they can be given.
  void add_level_curves(const MaxMinPlace& max_min, const exact::RealPoint& p, double tolerance,
                        std::vector<NearLevelCurve>& out) const;

  /// The size of the numbers at p; rounding is relative to it.
  double scale(double px, double py) const;

 private:
  /// Of parts of A that are equally far from a place, perhaps on an edge of B.
  struct Meeting {
    exact::Real level;
    exact::RealPoint at;
    std::vector<plane::Index> parts;
  };
  static std::vector<MaxMinPlace> distinct(const std::vector<MaxMinPlace>& all, double scale);
  bool is_distance(const Event& e) const;
  std::vector<Meeting> meetings(const MaxMinPlace& max_min, const exact::RealPoint& p) const;
  bool is_in_b(const MaxMinPlace& max_min, const exact::RealPoint& own) const;
  bool is_exact(const Meeting& m) const;
  std::vector<plane::Index> near_features(double x, double y, double tolerance) const;

  const plane::Region &b_, &a_;
  std::vector<BoundaryFeature> a_features_, b_features_;
  VoronoiCells a_reach_;
  double scale_ = 1;
};

}  // namespace findspace::distance
