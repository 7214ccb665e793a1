// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How weights of pairs of parts change from pass to pass: those of overlaps grow, by more the deeper they are; all
// decay towards 1. Source: Gardeyn & Wauters 2024. Keywords: guided local search.
#pragma once

#include <algorithm>

namespace findspace::packing {

inline constexpr double kLeastGrowth = 1.2, kMostGrowth = 2.0, kDecay = 0.95;

/// What the weight is multiplied with, so that it has grown after it decayed; `depth` as a share of the deepest.
inline double grown_weight(double depth) { return (kLeastGrowth + (kMostGrowth - kLeastGrowth) * depth) / kDecay; }
inline double decayed_weight(double weight) { return std::max(1.0, weight * kDecay); }

}  // namespace findspace::packing
