// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Overlap of solids on rays against CGAL's Minkowski sum of Nef polyhedra: random positions, and the volume.
#pragma once

#include <gtest/gtest.h>

#include "differential/space_nef_sum.h"
#include "space/rays/ray_summary.h"

namespace findspace::space::nef_oracle {

/// On 24 x 24 lines.
inline void compare(const Triangles& a, const Triangles& b, int places) {
  const Agreement found = agreement(difference(a, b), a, b, 24, places);
  EXPECT_EQ(found.differing, 0);
  EXPECT_GT(found.inside, places / 20);
  EXPECT_LT(found.inside, places);
}

/// The volume on n x n lines along z, to 1e-4 of it; no wall of the sum is parallel to them.
inline void compare_volume(const Triangles& a, const Triangles& b, int n) {
  const RayBody body(a), other(b);
  const Point low = body.low - other.high, high = body.high - other.low;
  const RayGrid grid = ray_grid(low, high, 2, n);
  RaySummarizer summarizer(grid, low, high);
  each_row(PairRays(a, b, grid), [&](int j, RayRow&& row) { summarizer.add(j, row); });
  const double exact = volume(difference(a, b));
  EXPECT_NEAR(summarizer.finish().volume, exact, 1e-4 * exact);
}

}  // namespace findspace::space::nef_oracle
