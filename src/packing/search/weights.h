// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Weights of pairs of parts, and how they change from pass to pass: those of overlaps grow, by more the deeper they
// are; all decay towards the least one, which is larger for larger parts. Source: Gardeyn & Wauters 2024. Keywords:
// guided local search.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace findspace::packing {

inline constexpr double kLeastGrowth = 1.2, kMostGrowth = 2.0, kDecay = 0.95;

/// What the weight is multiplied with, so that it has grown after it decayed; `depth` as a share of the deepest.
inline double grown_weight(double depth) { return (kLeastGrowth + (kMostGrowth - kLeastGrowth) * depth) / kDecay; }
inline double decayed_weight(double weight, double least) { return std::max(least, weight * kDecay); }

/// The least weight of a pair is the product of its two numbers here: roots of the lengths of parts, 1 in the mean.
/// A large part that overlaps is harder to place anew than a small one.
inline std::vector<double> root_sizes(std::vector<double> lengths) {
  for (double& length : lengths) length = std::sqrt(length);
  const double mean =
      std::accumulate(lengths.begin(), lengths.end(), 0.0) / double(std::max<std::size_t>(lengths.size(), 1));
  for (double& length : lengths) length = mean > 0 ? length / mean : 1;
  return lengths;
}

}  // namespace findspace::packing
