// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search behind OpenUnion::nearest_in_complement(): boxes of space about p, the nearest first. A box that one set
// covers is left out. In a box that few sets meet the nearest point is a projection (projection_search.h), where the
// sides of the box are planes as well. A box that is neither is divided. Guarantee: as of projection_search.h; where
// the question may look at no more cells (search_work.h), a bound. Cost: the boxes near p that no set covers alone; one
// search of projections where that ends soon, which it does for most unions of a few sets. Source: branch and bound
// (subdivide.h). Keywords: octree, distance to the complement.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "plane/base/search_work.h"
#include "space/body/projection_search.h"

namespace findspace::space {

class ComplementSearch {
 public:
  /// `within`: boxes that hold the complement; none: it may be anywhere.
  ComplementSearch(const OpenUnion& cover, const RealVector& p, std::span<const Extent> within = {});
  /// Says of bounded boxes that they are covered, also where no set covers one alone.
  void leave_out(std::function<bool(const Extent&)> covered) { covered_ = std::move(covered); }
  /// The complement point nearest to p; nothing where everything is covered.
  NearestOutside run();

 private:
  struct Cell {
    Extent box;
    std::vector<std::size_t> sets;  // those that may meet it
    double distance = 0;
    bool whole = false;
    int fruitless = 0;  // divisions that left its sets as many
    bool operator<(const Cell& other) const { return distance > other.distance; }  // the nearest is on top
  };
  enum class Meeting { kApart, kMeets, kCovers };

  void look(Cell cell);
  /// A cell is searched for projections where it has at most as many sets; so many looks are worth it. Both grow where
  /// division does not help, as at a corner of many sets.
  static long most_sets(const Cell& cell) { return kSets << std::min(cell.fruitless / 3, 40); }
  static long most_looks(const Cell& cell) {
    return cell.whole ? kFirstLooks : kLooks << std::min(cell.fruitless / 3, 40);
  }
  Meeting meeting(std::size_t set, const Extent& box);
  /// Whether one of the sets that reach farthest around the box covers it.
  bool likely_covered(const Cell& cell);
  /// Leaves out the sets that do not meet the box; true where one covers it.
  bool sift(Cell& cell);
  void divide(const Cell& cell);
  /// The part of the cell in the box, if that may hold a nearer place.
  void add(const Cell& cell, const Extent& box);
  /// Whether so many sets may hold p that boxes are better than projections from the start.
  bool crowded() const;
  /// Counts the look at the cell for the question. It is a step, and so are so many sets, or a quarter as many whose
  /// planes are looked at; several cost as much as a cell of other searches.
  void count(const Cell& cell);

  static constexpr long kSets = 24;
  static constexpr long kLooks = 20;
  static constexpr long kCrowd = 64;
  static constexpr long kLikely = 32;
  static constexpr long kSifted = 512;
  static constexpr long kFirstLooks = 2000;  // where few sets are at p
  static constexpr long kSetsOfStep = 128, kStepsOfCell = 8;

  const OpenUnion& cover_;
  RealVector p_;
  Vector near_;
  std::span<const Extent> within_;
  std::function<bool(const Extent&)> covered_;
  const plane::SearchQuestion question_;
  long met_ = 0;      // sets whose planes were looked at and are not yet counted
  long steps_ = 0;    // that do not make a cell yet
  double reach_ = 1;  // what is bounded lies within it of p, along each axis
  plane::Subdivision<Cell> queue_;
  std::optional<RealVector> found_;
  double bound_ = exact::kInfinity;
};

}  // namespace findspace::space
