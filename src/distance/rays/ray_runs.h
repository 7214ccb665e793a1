// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign map at any level of a distance along the very direction that the lines run in, read off the signs at level 0
// on each line (translation_value.h says how a value follows from them): a place where the sign can change is an end on
// the line moved by the level. So it holds for shapes of every kind of which the plain distance has a sign map: round
// ones, surfaces, differences. Guarantee: as the sign map at level 0: exact where that is; where a search tells it,
// - or + only where all that its places of 0 may be leave the same sign. Cost: the square of the ends on a line.
// Keywords: directional penetration depth, run-length morphology.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <mutex>

#include "plane/query/section.h"
#include "space/rays/ray_map.h"

namespace findspace::distance {

struct RunQuery {
  bool farthest = false;  // gamma2, eta2, delta2; else gamma1, eta1, delta1
  bool both_ways = false;
  bool forward = true;  // one way: by growing place
};

class RayRuns : public space::RaySource, private space::RayRoots {
 public:
  using Rows = std::function<exact::Tried<space::RayRow>(int)>;
  /// `zero`: of gamma1, eta1 or delta1 at level 0, and whether a search tells it; the level in parts of a grid step.
  RayRuns(Rows zero, bool searched, const RunQuery& query, const exact::Real& level, const space::RayGrid& grid);

  const space::RayGrid& grid() const override { return grid_; }
  exact::Tried<space::RayRow> try_row(int j) const override;
  bool searched() const override { return searched_; }

 private:
  plane::Section section(const space::RayRow& row, int i) const;
  int sign(const plane::Section& line, const exact::Real& at) const;
  /// Of event `number` of line (i, j).
  space::RayPosition position(const exact::Real& at, int number, int i, int j) const;
  exact::Real root(int patch, int which, int i, int j) const override;

  Rows zero_;
  bool searched_;
  RunQuery query_;
  exact::Real level_;
  space::RayGrid grid_;
  mutable std::mutex guard_;
  mutable std::map<std::array<int, 3>, exact::Real> places_;  // those that are not small fractions, by their names
};

}  // namespace findspace::distance
