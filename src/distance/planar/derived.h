// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// T-distances made of others (distances.md 3.4, 3.5): cut off below (d1, h, diameter: max(floor, f)), rotated round and
// cut off (penetration, d*: max(0, -f)), the greater of two (Hausdorff), seen from the other shape (f(-p)), and between
// shapes that are somewhere else (f(p + by)). Guarantee: exact where the operands are; zero sets of positive area (d1 =
// 0, h = 0, d* = 0) are kept. Cost: that of the operands, one overlay for the greater of two.
#pragma once

#include "distance/planar_features/t_distance.h"

namespace findspace::distance {

/// max(floor, f), or max(floor, -f) if `negated`. Where f is undefined: undefined, or `floor` if `negated`.
TDistancePointer cut_off(TDistancePointer f, exact::Real floor, bool negated = false);
/// max(f, g).
TDistancePointer greater(TDistancePointer f, TDistancePointer g);
/// p -> f(-p).
TDistancePointer reflected(TDistancePointer f);
/// p -> f(p + by), searched in the coordinates of f.
TDistancePointer displaced(TDistancePointer f, exact::RealPoint by);

}  // namespace findspace::distance
