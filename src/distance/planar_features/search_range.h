// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A part of B + p in the search for the place that is farthest from A: a box of the plane, or a part of an edge of B;
// and bounds of distances over it. Guarantee: bounds hold up to rounding (about 1e-14 of the coordinates). Keywords:
// branch and bound.
#pragma once

#include <vector>

#include "distance/planar_features/boundary_features.h"
#include "plane/base/stage_observer.h"

namespace findspace::distance {

struct Spot {
  double x = 0, y = 0;
};

/// With what can matter in it.
struct SearchRange {
  using List = std::vector<plane::Index>;

  double bound = 0;
  int edge = -1;                          // of the features of B, or a box
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // box
  double t0 = 0, t1 = 1;                  // part of the edge
  List a, b;                              // parts of A's boundary; parts of B's (boxes only)
  bool operator<(const SearchRange& other) const { return bound < other.bound; }
  void draw(plane::ObservedCells& seen) const {
    if (edge < 0) seen.add_box({x0, y0, 0}, {x1, y1, 0});
  }
};

/// Ranges of a set whose features are moved by (px, py).
class MovedFeatures {
 public:
  MovedFeatures(const std::vector<BoundaryFeature>& features, double px, double py)
      : features_(features), px_(px), py_(py) {}

  const BoundaryFeature& operator[](std::size_t k) const { return features_[k]; }
  std::size_t size() const { return features_.size(); }
  /// A point of the moved edge.
  Spot on_edge(int edge, double t) const;
  /// At least the length of the part.
  double length(const SearchRange& part) const;
  /// At least the greatest distance of a point of the range from the nearest of its parts of A.
  double bound(const SearchRange& r, const std::vector<BoundaryFeature>& a) const;
  /// The places inside a part of an edge where the distance to one part of A can be greatest.
  std::vector<Spot> max_mins(const SearchRange& part, const BoundaryFeature& a) const;

 private:
  std::vector<Spot> hull(const SearchRange& r) const;
  BoundaryFeature arc_part(const SearchRange& part) const;
  double farthest(const SearchRange& r, const std::vector<Spot>& hull, double x, double y) const;
  double nearest(const SearchRange& r, const std::vector<Spot>& hull, double x, double y) const;
  double most(const BoundaryFeature& s, const SearchRange& r, const std::vector<Spot>& hull) const;

  const std::vector<BoundaryFeature>& features_;
  double px_, py_;
};

}  // namespace findspace::distance
