// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The point of a set's edges and vertices that is nearest to a position, and that of a region. Guarantee: the distance
// is that of an exact point of the cell found, computed exactly and rounded once; cells whose distances agree to about
// 1e-12 relative may be exchanged. Cost: linear in the cells, a few of them exactly. Keywords: closest point, distance
// query.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "plane/complex/broad_phase.h"
#include "plane/complex/cell_complex.h"
#include "plane/query/locate.h"

namespace findspace::plane {

struct Nearest {
  exact::Real distance;  // in grid steps
  exact::RealPoint at;
  Cell cell;  // a vertex or an edge
};

/// Among edges and vertices whose mark is wanted; nothing if there are none.
std::optional<Nearest> nearest(const CellComplex& complex, const std::function<bool(Mark)>& wanted,
                               const exact::RealPoint& from);

/// The same, prepared for many places. Keeps a reference to the complex. Cost: O(n log n) to build, 30 bytes a cell; a
/// place looks at the cells about as near as the nearest. Threads: safe.
class NearestSearch {
 public:
  NearestSearch(const CellComplex& complex, const std::function<bool(Mark)>& wanted);
  std::optional<Nearest> nearest(const exact::RealPoint& from) const;

 private:
  struct Item {
    PieceBox box;
    Cell cell;
  };
  struct Node {
    PieceBox box;
    Index first = 0, end = 0;  // of its cells
    Index child = kNone;       // the first of two; kNone: a leaf
  };
  void build(std::span<Item> items);

  const CellComplex& c_;
  double greatest_;  // of the coordinates
  std::vector<Cell> cells_;
  std::vector<Node> nodes_;
};

/// The point of a region's closure that is nearest to a position, and whether the region has it.
struct NearestInClosure {
  Nearest nearest;  // without a cell at distance 0
  bool attained = false;
};

/// One of the region itself where it has one that is as near (distances that are no closed forms are compared as
/// doubles). `closed` is the closure of the region; nothing if that is empty.
std::optional<NearestInClosure> nearest_in_closure(const Region& region, const Region& closed,
                                                   const exact::RealPoint& from);

/// Whether the closed arc has a point at its centre plus a positive multiple of (dx, dy); true for (0, 0). Doubles
/// decide where they are certain, and where a direction is no fraction; else it is exact.
bool has_direction(const CellComplex& complex, Index arc, const exact::Real& dx, const exact::Real& dy);

}  // namespace findspace::plane
