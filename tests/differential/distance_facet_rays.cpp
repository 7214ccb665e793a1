// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Clearances of solids from the facets of their convolution (space/convolution/facet_rays.h) against those from their
// convex parts (ray_signs.h): the same sign everywhere on every line, in general position and along walls and edges, in
// exact fits.
#include <gtest/gtest.h>

#include "differential/space_voxels.h"
#include "distance/rays/ray_signs.h"
#include "space/convolution/facet_rays.h"

namespace findspace::distance {
namespace distance_facet_rays {

using exact::Real;
using space::Cells;
using space::LinearMap;
using space::PairRays;
using space::RayGrid;
using space::RayRow;

struct Counts {
  int events = 0, differences = 0;
};

/// gamma1 at `level`, and eta1 at minus `level`.
void compare(const Cells& a, const LinearMap& a_map, const Cells& b, const LinearMap& b_map, const Real& level,
             const RayGrid& grid, Counts& counts) {
  const space::Triangles a_surface = surface(a, a_map), b_surface = surface(b, b_map);
  const space::Body a_body = space::body_of(a, a_map), b_body = space::body_of(b, b_map);
  for (const bool inside : {false, true}) {
    const auto by_parts =
        ray_sign_map(inside ? Which::kEta1 : Which::kGamma1, inside ? -level : level, b_body, a_body, grid);
    const auto by_facets = space::clearance_rays(a_surface, b_surface, level, grid,
                                                 inside ? PairRays::Side::kComplement : PairRays::Side::kSolid);
    for (int j = 0; j < grid.nv; ++j) {
      const RayRow rows[2] = {by_parts->row(j), by_facets->row(j)};
      counts.events += static_cast<int>(rows[0].events.size());
      const RayRow same =
          space::combined(rows, [](std::span<const std::int8_t> s) { return std::int8_t(s[0] != s[1]); });
      for (const std::int8_t before : same.before) counts.differences += before;
      counts.differences += static_cast<int>(same.events.size());
    }
  }
}

const LinearMap kSkew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, kTilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};

TEST(FacetRays, BracketsOnALattice) {
  Counts counts;
  const Cells u = space::extruded({"#.#", "###"}, 2), cube = space::extruded({"#"}, 1),
              room = space::around(space::extruded({"##", "#."}, 2), 1);
  for (const Real& level : {Real(5), Real(10), Real::ratio(7, 2)}) {
    for (int axis = 0; axis < 3; ++axis) {
      const RayGrid walls{axis, 1, -20, -20, 5, 5, 14, 14}, between{axis, 3, -61, -59, 13, 17, 15, 12};
      for (const RayGrid& grid : {walls, between}) {
        compare(u, space::stretch(10), cube, space::stretch(10), level, grid, counts);  // the cube just fits in
        compare(room, space::stretch(10), cube, space::stretch(4), level, grid, counts);
      }
    }
  }
  EXPECT_EQ(counts.differences, 0);
  EXPECT_GT(counts.events, 2000);
}

TEST(FacetRays, RandomSolidsInGeneralPosition) {
  std::mt19937 random(8);
  Counts counts;
  for (int k = 0; k < 8; ++k) {
    const Cells a = space::random_cells(random, 5, 3), b = space::random_cells(random, 3, 2);
    compare(a, kSkew, b, kTilt, Real(9 + 12 * k), {k % 3, 1, -100, -120, 47, 43, 10, 10}, counts);
    compare(space::around(a, 1), kSkew, b, kTilt, Real(2 + k), {k % 3, 1, -100, -120, 47, 43, 10, 10}, counts);
  }
  EXPECT_EQ(counts.differences, 0);
  EXPECT_GT(counts.events, 1000);
}

}  // namespace distance_facet_rays
}  // namespace findspace::distance
