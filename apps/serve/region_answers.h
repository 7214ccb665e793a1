// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A region that many positions are asked about, one after another: whether one belongs, the nearest one that does, and
// what a position that is dragged snaps to. What an answer needs is made when it is first asked for. Guarantee: exact.
// Cost: a position is looked up in a table; the nearest is linear in the cells. Threads: one at a time. Keywords: point
// location, nearest neighbour, snapping.
#pragma once

#include <optional>

#include "plane/query/locate.h"
#include "plane/query/nearest.h"

namespace findspace::app {

class RegionAnswers {
 public:
  /// `step`: a grid step in the scene's unit. `outer`: where the region is known between bounds.
  RegionAnswers(plane::Region region, std::optional<plane::Region> outer, const exact::Real& step)
      : region_(std::move(region)), outer_(std::move(outer)), step_(step) {}
  RegionAnswers(const RegionAnswers&) = delete;
  RegionAnswers& operator=(const RegionAnswers&) = delete;

  const plane::Region& region() const { return region_; }
  const std::optional<plane::Region>& outer() const { return outer_; }
  /// Its cells numbered from left to right.
  const plane::Region& in_order() const;

  /// Positions in grid steps.
  bool has(const exact::RealPoint& p) const;
  /// Of the closure; distance 0 within it. Nothing where the region is empty.
  struct Near {
    exact::RealPoint at;
    exact::Real distance;
    bool attained = false;
  };
  std::optional<Near> nearest(const exact::RealPoint& p) const;
  /// A corner of the region that is no farther than `within`, or else a point of its boundary; one that belongs.
  std::optional<exact::RealPoint> snapped(const exact::RealPoint& p, const exact::Real& within) const;
  /// A position that belongs, an isolated one where there is one. Nothing where the region is empty.
  std::optional<exact::RealPoint> sample() const;

 private:
  const plane::Region& closure() const;
  const plane::Region& corners() const;

  plane::Region region_;
  std::optional<plane::Region> outer_;
  exact::Real step_;
  mutable std::optional<plane::Region> ordered_, closure_, boundary_, corners_;
  mutable std::optional<plane::Locator> in_region_, in_closure_;
};

}  // namespace findspace::app
