// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search for the greatest distance of a point of a solid to the nearest of some sets, max over x in the solid of
// min over the sets of d(x): one branch and bound over tetrahedra that fill the solid. What bounds a cell is said by
// the sets (MaxMinTarget): convex sets that are all known, or a surface of which few triangles are near. Distances to
// convex sets are convex, so over a cell any weighted mean of them is bounded by its values at the corners; the best
// weights are a linear program, whose other side is a point of the cell to try. On ridges between flat walls both agree
// at once. A cell that a round solid fills in part is bounded by a plane that touches the solid, too: as no distance
// grows faster than a step, what a corner is beyond the plane may be taken off its distances. Internal to the searches
// that ask for it. Guarantee: doubles, as SolidMaxMin. Keywords: directed Hausdorff distance, largest empty ball,
// branch and bound, linear program.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "distance/search/boundary_cells.h"
#include "distance/search/lp_bound.h"
#include "distance/search/round_solid.h"
#include "exact/number/interval.h"

namespace findspace::distance {

struct MaxMinCell : TetrahedralCell {
  std::vector<int> sets;              // that bound it, by numbers of the target
  std::vector<Column> distances;      // from these, at its corners
  const RoundSolid* round = nullptr;  // only what lies in it counts
  double bound = 0;
  std::optional<Column> beyond{};  // how far its corners are beyond a plane that the solid is on one side of
  /// What a target knows of the cell, which its halves begin with: the sets, if not null, of which one is the nearest
  /// at each place, about a place within `near_reach`; and whether all of it is outside the body, and all within the
  /// solid.
  std::shared_ptr<const std::vector<int>> near{};
  double near_reach = 0;
  bool outside = false, inner = false;
  bool operator<(const MaxMinCell& other) const { return bound < other.bound; }
};

/// The best point found, and what would be better. `slack` and `share`: as solid_max_min(). `noise`: what a value may
/// be off, beside its share.
class MaxMinBest {
 public:
  MaxMinBest(double start, double slack, double share, double noise) : slack_(slack), share_(share), noise_(noise) {
    found_.value = start;
  }
  const SolidMaxMin& found() const { return found_; }
  double slack() const { return slack_; }
  double noise() const { return noise_; }
  /// What is more by less is not looked for.
  double near() const;
  void offer(const space::Vector& x, double value);
  bool worth(double bound) const;

 private:
  double slack_, share_, noise_;
  SolidMaxMin found_;
};

class MaxMinTarget {
 public:
  virtual ~MaxMinTarget() = default;
  /// That the first cells in a ball have.
  virtual std::vector<int> sets(const space::Vector& /*middle*/, double /*radius*/) const { return {}; }
  /// A place of the solid, and at most what its distance is; nothing is said where cells offer their corners.
  virtual double offer_in(const space::Vector& /*x*/, MaxMinBest& /*best*/) const { return exact::kInfinity; }
  /// Many of them: of places that are equally far the first one counts.
  virtual void offer_all(std::span<const space::Vector> places, MaxMinBest& best) const;
  /// Of a cell that has the sets of the one it is a half of (or none): offers places of it, lowers its bound, and keeps
  /// those of its sets, and others, that bound it best, with their distances; may know a better plane. False: nothing
  /// of it counts.
  virtual bool look(MaxMinCell& cell, const space::Vector& middle, MaxMinBest& best) const = 0;
  /// A place of the cell at which the distances in it may be greatest. More distances that bound the cell there are
  /// used at once, so many times.
  virtual void offer(const space::Vector& x, MaxMinCell& cell, MaxMinBest& best) const = 0;
  virtual double distance(int set, const space::Vector& x) const = 0;
  /// How far the corners are beyond a plane that the solid is on one side of.
  virtual std::optional<Column> beyond(const MaxMinCell& cell, const space::Vector& middle) const;
  /// A cell is divided across the edge along which the distances bend most, if that is longer than this share of the
  /// longest one; else across the longest.
  virtual double shortest_share() const { return 0; }
  virtual int rounds() const { return 1; }
  /// Whether so much was done that the search is to end.
  virtual bool spent() const { return false; }
};

/// With at most so many cells.
SolidMaxMin tetrahedral_max_min(const Solids& solids, const MaxMinTarget& target, const MaxMinBest& start, long most);

}  // namespace findspace::distance
