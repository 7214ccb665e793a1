// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign of a sum of T-distances minus a level at every position of a window: distances compared with each other,
//     S = { p : w1 f1(p) + ... + wn fn(p) <= level },   "gap(B, A) <= gap(B, C)" with the weights 1 and -1.
// Method: boxes that are halved both ways. In a box the sum is one of a few combinations of smooth forms
// (smooth_form.h). One combination whose level curve is a line with a direction in integers or a circle gives the exact
// sign: lines with lines, two points (the bisector, Apollonius' circle), circles about one centre. Else the tangent
// planes with their bounds give half planes on which the sign is certain; between them it stays open, in a strip
// narrower than `width`. Guarantee: low <= true sign <= high everywhere; the same where bisectors are such lines or
// circles, but for boxes no wider than `width` where such pieces meet. Outside the window low = -1, high = +1.
// Cost: a range and an overlay a box, boxes in proportion to the length of the curve. Keywords: bisector, Voronoi
// diagram, hyperbola, enclosure, marching squares.
#pragma once

#include "distance/planar_least/distance_sum.h"

namespace findspace::distance {

/// `window`: in whole grid steps; `width`: of strips, in grid steps.
/// low <= the sign <= high.
struct SumSigns {
  plane::SignMap low, high;
};
SumSigns sum_map(const DistanceSum& f, const exact::Real& level, const plane::PieceBox& window, double width);

}  // namespace findspace::distance
