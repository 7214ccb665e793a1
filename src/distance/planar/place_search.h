// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search behind farthest_place.h. In numbers: places on B's boundary and inside that can be the farthest, with the
// parts of A that are nearest there (place_search.cpp); then the exact place and value of each (farthest_place.cpp).
// Guarantee: as farthest_place.h. Keywords: branch and bound.
#pragma once

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <vector>

#include "distance/planar/farthest_place.h"

namespace findspace::distance {

inline constexpr std::size_t kMostParts = 10;  // of A at one place: their meetings are all tried
/// A search ends after this many boxes, parts of edges and squares, and says what is still open.
inline constexpr long kLeastSteps = 100000, kStepsPerFeature = 100;

/// B + p and A, as numbers.
class PlacedSets {
 public:
  PlacedSets(const FeatureTree& b, const FeatureTree& a, const exact::RealPoint& p);

  bool in_a(Spot at, const FeatureTree::Near& near) const;
  bool in_b(Spot at, const FeatureTree::Near& near) const;
  FeatureTree::Near nearest_of_b(Spot at) const { return b.nearest(at.x - px, at.y - py); }
  double to_feature(Spot at, plane::Index feature) const { return a.features()[feature].distance(at.x, at.y); }
  /// The greatest distance of a place in the box to a part of A.
  double most(const FeatureBox& box, plane::Index feature) const;
  /// A box of B's boundary in its place.
  FeatureBox placed(plane::Index node) const;
  /// The vertices and edges of A with a place no farther than `reach` that is the nearest of its line or vertex.
  std::vector<BoundaryFeature> parts_near(Spot at, double reach) const;

  const FeatureTree &a, &b;
  const exact::RealPoint& p;
  double px, py, scale, slack;
};

/// A place with its distance to A (0 inside A) and the part of A's boundary that is nearest. Where that part is too
/// close to matter, the value is its distance and `inside` false, wherever the place lies.
struct Seen {
  Spot at;
  double value = 0;
  FeatureTree::Near near{};
  bool inside = false;
};

struct Found {
  Seen seen;
  plane::Cell cell;
  double error = 0;      // of the value
  bool halving = false;  // the middle of a part of an edge, where parts of A need not meet
};

/// What a search found: places that can be the farthest, and what it did not look into.
struct FoundPlaces {
  std::vector<Found> places;
  double best = 0;
  plane::Cell first{};  // some vertex of B
  double open = 0;      // no place is farther than this or than those found
};

class PlaceSearch {
 public:
  PlaceSearch(const PlacedSets& sets, const MaxMinBoxes& boxes, double least_value);

  FoundPlaces run();

 private:
  /// One that may hold a place of at most `bound`; the nearest feature of the square that it is a quarter of.
  struct Square {
    double bound;
    MaxMinBoxes::Part part;
    plane::Index guess;
    FeatureBox box;
    bool operator<(const Square& o) const { return bound < o.bound; }
    void draw(plane::ObservedCells& seen) const { seen.add_box({box.x0, box.y0, 0}, {box.x1, box.y1, 0}); }
  };
  Seen see(Spot at, plane::Index guess) const;
  void record(const Found& found);
  plane::Index start();
  void walk_boundary();
  void visit_edge(const BoundaryFeature& edge, plane::Index guess);
  double split(const Seen& s, const Seen& t) const;
  void search_inside();
  FeatureBox box_of(const MaxMinBoxes::Part& part) const;
  std::optional<plane::Index> look_inside(const Square& e);
  /// Counts a step; true once all are taken.
  bool spent() { return left_ <= 0 || --left_ <= 0; }
  /// Farther than the best place by less than numbers tell: such corners and places of edges are all compared exactly.
  bool may_be_farthest(double value) const { return value > best_ - slack_; }
  /// Whether nothing that has no place farther than this is looked into: it is not `wanted`, or all steps are taken.
  bool settled(double bound, bool wanted) {
    if (!wanted) return true;
    if (!spent()) return false;
    leave_open(bound);
    return true;
  }
  /// Something is not looked into that has no place farther than this.
  void leave_open(double bound) { out_.open = std::max(out_.open, bound); }

  const PlacedSets& sets_;
  const MaxMinBoxes& boxes_;
  double scale_, slack_, best_;
  long left_;
  std::unordered_set<plane::Index> corners_;  // of B, that are found
  std::vector<Found> halvings_;
  FoundPlaces out_;
};

}  // namespace findspace::distance
