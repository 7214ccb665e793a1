// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A line of space in any direction, as the third axis of a right-angled frame of its own, so that what is known of
// lines along z (piece_rays.h) holds for it. Guarantee: exact: the frame's numbers are square roots of fractions.
// Keywords: ray, change of coordinates.
#pragma once

#include <array>

#include "space/polytope/real_vector.h"

namespace findspace::space {

struct ObliqueLine {
  RealVector origin;                // place 0, in grid steps
  std::array<RealVector, 3> frame;  // unit vectors; [2] runs along the line

  /// `direction` is not zero.
  ObliqueLine(RealVector through, const RealVector& direction);
  /// Whether the line may meet the box; only certain where it says no.
  bool may_meet(const Vector& low, const Vector& high, double scale) const;
};

}  // namespace findspace::space
