// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The best-first order of a branch and bound for a greatest value: cells by what nothing in them exceeds, until no cell
// is worth dividing. Internal to the searches over tetrahedra (solid_max_min.h, surface_protrusion.h), which say what
// they guarantee. Cost: log n a cell. Keywords: branch and bound, best-first search.
#pragma once

#include <algorithm>
#include <queue>

#include "distance/search/boundary_cells.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

/// Cells have a `corner` and a `bound`, and are ordered by it. `slack` and `share`: as solid_max_min().
template <class Cell>
class MaxMinQueue {
 public:
  MaxMinQueue(double slack, double share) : slack_(slack), share_(share) { best_.value = std::min(0.0, slack); }

  const SolidMaxMin& best() const { return best_; }
  double slack() const { return slack_; }

  void offer(const space::Vector& x, double value) {
    if (value > best_.value) {
      best_.value = value;
      best_.place = x;
    }
  }
  bool worth(double bound) const {
    const double surplus = best_.value - slack_;
    return bound > best_.value * (1 + margin::kMaxMinNear) && bound > slack_ &&
           !(surplus > (bound - slack_) * (1 - share_));
  }
  void push(Cell cell) { cells_.push(std::move(cell)); }

  /// `split` offers and pushes what it makes of a cell; it is asked for so many.
  template <class Split>
  SolidMaxMin run(Split&& split, int most = kMostCells) {
    for (int count = 0; !cells_.empty(); ++count) {
      const Cell top = cells_.top();
      if (!worth(top.bound)) break;
      if (count == most) {
        best_.complete = false;
        best_.bound = top.bound;
        return best_;
      }
      cells_.pop();
      observe(seen_, top.corner);
      split(top);
    }
    best_.bound = std::max(best_.value * (1 + margin::kMaxMinNear), slack_);
    return best_;
  }

 private:
  double slack_, share_;
  std::priority_queue<Cell> cells_;
  plane::ObservedCells seen_{"tetrahedra of the farthest place of a solid from a set"};
  SolidMaxMin best_;
};

}  // namespace findspace::distance
