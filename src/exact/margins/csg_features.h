// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Margins of the features of solids that balls are cut out of (csg_features.h), of the sizes or of a radius. Guarantee:
// of each it is said what it does, as in space_distance.h. Keywords: tolerance.
#pragma once

#include "exact/margins/space_distance.h"

namespace findspace::margin {

/// Surfaces that meet at a smaller angle have no features. At greater ones a place is off by 2^6 times kDistanceNoise
/// at most, half of which a place is seldom off. Bounds: with kPlaceBreaks less than kFoundError.
inline constexpr double kFlatMeet = 0x1p-6;
/// A place of a feature breaks or keeps the rule of another surface for sure by this: 2^2 times kDistanceNoise. Bounds:
/// of places between the least distance counts, and such a place is not named.
inline constexpr double kPlaceBreaks = 0x1p-44;

}  // namespace findspace::margin
