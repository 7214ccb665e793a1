// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Extreme values of convex functions of the position on a stretch of a line, {p + s u : from <= s <= to}: the greatest
// of their minimum (whether a union of convex sets holds all of the stretch, and how safely), and the least. No step
// changes a function by more than its length. Guarantee: doubles; the true value lies between the two bounds, which
// have one sign and a ratio of at most 2, or are within 2^-40 of the size of each other (or what kMostPieces pieces
// gave). Method: between two places a convex function is below its chord, so the minimum is below the highest meeting
// of two chords; stretches are divided there. Cost: some ten places, each a value of every function near the minimum.
// Keywords: line integral convolution, concave maximisation, golden section.
#pragma once

#include <span>

#include "distance/rays/value_rays.h"
#include "distance/search/solid_max_min.h"

namespace findspace::distance {

struct PathStretch {
  space::Vector unit;
  double from = 0, to = 0;
};

/// max over the stretch of min over the functions. At least one function. `size`: of coordinates and functions.
Between greatest_of_least(std::span<const ConvexDistance> functions, const space::Vector& p, const PathStretch& way,
                          double size);
/// min over the stretch.
Between least_on(const ConvexDistance& function, const space::Vector& p, const PathStretch& way, double size);
/// min over the stretch and the functions.
Between least_on(std::span<const ConvexDistance> functions, const space::Vector& p, const PathStretch& way,
                 double size);

}  // namespace findspace::distance
