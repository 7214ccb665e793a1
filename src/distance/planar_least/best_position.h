// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least or greatest value over a set S of positions of a function that is known through its range over discs alone:
// distances in rotation, which jump, and those of shapes that rotate in time (extremum.h serves the distances that have
// exact sign maps). S itself may be known between two sets. Method: branch and bound over boxes of positions; a box
// keeps the part of S in it, exactly; the disc about it bounds the function from one side, its value at a position of
// the part from the other. Guarantee: certified, to the rounding of the ranges: a position of S has `level`, none is
// better than `bound`, and every best one lies `within` that distance of one of `at`. Never `proven` but where the
// value is infinite. Cost: up to `most_boxes` boxes, each two ranges and one overlay with what is left of S. Keywords:
// argmin, branch and bound, Lipschitz optimisation.
#pragma once

#include <functional>

#include "distance/planar_least/extremum.h"
#include "plane/complex/extent.h"

namespace findspace::distance {

/// Of values; low may be -infinity, high +infinity (undefined).
struct ValueRange {
  double low, high;

  double middle() const { return low + (high - low) / 2; }
  double off() const { return (high - low) / 2; }
};

/// The values at all positions that are not farther than `radius` from p.
using DiscRange = std::function<ValueRange(const exact::RealPoint& p, double radius)>;

/// Positions that certainly and that possibly belong to S; the same where S is exact.
struct PositionBounds {
  const plane::Region& certain;
  const plane::Region& possible;
};

/// f is constant outside the window, or no better there than inside if `worse_outside`. `enough`: how far level and
/// bound may stay apart.
struct SearchWindow {
  plane::PieceBox box;
  bool worse_outside = false;
  double enough = 0;
  std::size_t most_boxes = 600;
  bool corners = false;  // values cost little: those at corners of S in a box are asked for as well
};

/// Level and bound are in the units of f.
Extremum best_position(const DiscRange& f, const PositionBounds& s, Sense sense, const SearchWindow& window);

}  // namespace findspace::distance
