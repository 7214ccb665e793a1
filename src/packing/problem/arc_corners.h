// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// An arc as a chain of sides in doubles: tangents of it, or chords. Sides end at the multiples of 3.75 degrees, so the
// chain touches the circle where neighbours of a square or hexagonal lattice of discs touch. A tangent passes the
// circle by at most a two-thousandth of the radius. Guarantee: that of doubles; it steers and filters. Cost: a sine a
// corner. Keywords: tessellation, circumscribed polygon.
#pragma once

#include <vector>

#include "packing/problem/vec.h"

namespace findspace::packing {

struct Arc {
  Vec centre;
  double radius = 0;
  Vec from, to;
  bool ccw = true;
};

/// The corners between the ends.
std::vector<Vec> corners_of(const Arc& arc, bool tangents);

}  // namespace findspace::packing
