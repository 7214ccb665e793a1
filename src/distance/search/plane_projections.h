// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The projections of p on planes, on the lines in which two of them meet, and the points in which three do: candidates
// for the place nearest to p of a closed set that is bounded by the planes. Guarantee: projections in doubles with a
// bound, exact on demand; planes whose angle is below 2^-30 count as parallel. Cost: n^3 of a dozen nanoseconds for n
// planes. Keywords: vertex enumeration.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "space/polytope/real_vector.h"

namespace findspace::distance {

class PlaneProjections {
 public:
  /// Keeps references. `size` of the coordinates.
  PlaneProjections(const std::vector<space::HalfSpace>& planes, const space::RealVector& p, double size);

  struct Projection {
    std::array<int, 3> planes{-1, -1, -1};
    space::Vector at;  // relative to p
    double error = 0;  // of a coordinate
    double key = 0;    // the distance
  };
  /// Those whose distance from `middle` (relative to p) is at most `reach` in each coordinate, or may be. Points in
  /// which only planes meet that pass through a known place, if these are given, are left out.
  std::vector<Projection> all(const space::Vector& middle, const space::Vector& reach, bool corners_only,
                              const std::vector<bool>& through = {}) const;
  /// The points in which planes that follow each other meet.
  std::vector<Projection> some_corners(const space::Vector& middle, const space::Vector& reach) const;
  /// Of each plane whether it passes through the place.
  std::vector<bool> through(const space::RealVector& place) const;
  space::RealVector exact(const Projection& projection) const;

 private:
  struct Seen {
    space::Vector unit;
    double gap;
  };
  class Collector;

  const space::RealVector& p_;
  const std::vector<space::HalfSpace>& planes_;
  std::vector<Seen> seen_;
  double size_;
};

}  // namespace findspace::distance
