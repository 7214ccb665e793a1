// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of sets with arcs, or with corners off the grid, from the curves that are left without equal ones and without
// those in cells certainly inside, against the arrangement of the whole convolution: cell by cell.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "differential/whole_sum.h"
#include "plane/offset/level.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace plane_pruned_sum {

using exact::Real;

Region star(std::mt19937& rng, int n, double size) {
  std::vector<GridPoint> points;
  for (int k = 0; k < n; ++k) {
    const double r = (k % 2 ? 0.4 + 0.01 * double(rng() % 10) : 0.9 + 0.01 * double(rng() % 10)) * size;
    points.push_back(
        {std::llround(r * std::cos(6.283185307179586 * k / n)), std::llround(r * std::sin(6.283185307179586 * k / n))});
  }
  return ring(points);
}

/// {d <= level} of the set.
Region grown(const Region& set, std::int64_t level) {
  return remark(distance_map(set, Real(level)), [](Mark m) { return Mark(m <= 0); });
}

Region teeth(int n) {
  std::vector<GridPoint> points{{0, 0}, {400 * n, 0}};
  for (int k = n; k-- > 0;) points.insert(points.end(), {{400 * k + 300, 600}, {400 * k + 210, 200}});
  return ring(points);
}

void compare(const Region& a, const Region& b, const std::string& what) {
  expect_same(contact_map(a, b), -1, whole_sum(a, in, b), what);
  expect_same(containment_map(a, b), 1, whole_sum(a, out, b), what + ", contained");
}

TEST(PrunedSum, RoundedStars) {
  for (unsigned seed = 0; seed < 2; ++seed) {
    std::mt19937 rng(seed);
    const Region a = grown(star(rng, 80, 100'000), seed % 2 ? 100 : 20'000);
    compare(a, star(rng, 80, seed % 2 ? 100'000 : 60'000), "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(PrunedSum, SumsThatRepeatTheirEdges) {
  const Region twice = minkowski_sum(teeth(4), teeth(3)), more = minkowski_sum(twice, teeth(5));
  compare(more, twice, "sums of teeth");
  compare(twice, more, "the larger one moves");
}

}  // namespace plane_pruned_sum
}  // namespace findspace::plane
