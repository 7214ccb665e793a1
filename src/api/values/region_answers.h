// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A region that many positions are asked about, one after another: whether one belongs, the nearest one that does, and
// what a position that is dragged snaps to. What an answer needs is made when it is first asked for. Guarantee: exact.
// Cost: a position is looked up in a table; the nearest is linear in the cells. Threads: safe. Keywords: point
// location, nearest neighbour, snapping.
#pragma once

#include <mutex>
#include <optional>

#include "plane/query/locate.h"
#include "plane/query/nearest.h"

namespace findspace::api {

class RegionAnswers {
 public:
  /// Keeps a reference. `step`: a grid step in the scene's unit.
  RegionAnswers(const plane::Region& region, const exact::Real& step) : region_(region), step_(step) {}
  RegionAnswers(const RegionAnswers&) = delete;
  RegionAnswers& operator=(const RegionAnswers&) = delete;

  /// Positions in grid steps.
  bool has(const exact::RealPoint& p) const;
  /// Of the closure, one of the region where it has one as near; distance 0 within it. Nothing where the region is
  /// empty.
  struct Near {
    exact::RealPoint at;
    exact::Real distance;
    bool attained = false;
  };
  std::optional<Near> nearest(const exact::RealPoint& p) const;
  /// A corner of the region that is no farther than `within`, or else a point of its boundary; one that belongs.
  std::optional<exact::RealPoint> snapped(const exact::RealPoint& p, const exact::Real& within) const;

 private:
  const plane::Region& closure() const;
  /// Of a part of the closure what belongs to the region.
  plane::Region own_part(plane::Region of) const;
  /// Those that belong to the region.
  const plane::Region& boundary() const;
  const plane::Region& corners() const;

  const plane::Region& region_;
  exact::Real step_;
  mutable std::once_flag closed_{}, bounded_{}, cornered_{}, located_{};
  mutable std::optional<plane::Region> closure_{}, boundary_{}, corners_{};
  mutable std::optional<plane::Locator> in_region_{};
};

/// A position of a region, an isolated one where there is one. Nothing where the region is empty. Cost: linear.
std::optional<exact::RealPoint> position_in(const plane::Region& region);

}  // namespace findspace::api
