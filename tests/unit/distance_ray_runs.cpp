// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Levels along the lines: a place that is no fraction has the same name whenever its row is made.
#include <gtest/gtest.h>

#include "distance/rays/ray_runs.h"

namespace findspace::distance {
namespace distance_ray_runs {

using exact::Real;

class Roots : public space::RayRoots {
 public:
  Real root(int, int, int, int) const override { return sqrt(Real(2)); }
};

TEST(RayRuns, PlacesAreNamedByTheirLines) {
  const Roots roots;
  const auto zero = [&](int) -> exact::Tried<space::RayRow> {  // in below sqrt 2
    space::RayRow row{{-1}, {0, 1}, {{}}};
    row.events[0].at.value = std::sqrt(2.0);
    row.events[0].at.roots = &roots;
    row.events[0].here = 0;
    row.events[0].after = 1;
    return row;
  };
  const RayRuns runs(zero, false, {}, Real(1), space::RayGrid{2, 1, 0, 0, 1, 1, 1, 2});
  const space::RayRow first = runs.row(0), other = runs.row(1), again = runs.row(0);
  ASSERT_FALSE(first.events.empty());
  ASSERT_EQ(first.events.size(), again.events.size());
  for (std::size_t k = 0; k < first.events.size(); ++k) {
    EXPECT_TRUE(space::same_root(first.events[k].at, again.events[k].at));
    EXPECT_FALSE(space::same_root(first.events[k].at, other.events[k].at));
    EXPECT_EQ(first.events[k].at.to_real(), other.events[k].at.to_real());
  }
}

}  // namespace distance_ray_runs
}  // namespace findspace::distance
