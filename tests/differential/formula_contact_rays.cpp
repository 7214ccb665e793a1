// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Depths, distances from fitting and farthest fits on lines by values from positions of contact (contact_rays.h)
// against those from convex parts: no place is certainly on different sides, and few are not certain.
#include <gtest/gtest.h>

#include "differential/space_voxels.h"
#include "distance/rays/ray_signs.h"
#include "formula/solid/contact_rays.h"

namespace findspace::formula {
namespace formula_contact_rays {

using distance::Which;
using exact::Real;
using space::Cells;
using space::LinearMap;

struct Both {
  Both(const Cells& cells, const LinearMap& map)
      : solid{space::surface(cells, map), {}, {}}, body(space::body_of(cells, map)) {}
  space::RaySolid solid;
  space::Body body;
};

struct Counts {
  int known = 0, unknown = 0, inside = 0, different = 0;
};

void compare(Which which, const Real& level, const Both& b, const Both& a, const space::RayGrid& grid, Counts& counts) {
  const auto parts = distance::ray_sign_map(which, level, b.body, a.body, grid);
  const auto contacts = contact_rays(which, b.solid, a.solid, level, grid);
  for (int j = 0; j < grid.nv; ++j) {
    const space::RayRow rows[2] = {parts->row(j), contacts->row(j)};
    for (int i = 0; i < grid.nu; ++i) {
      for (int z = -600; z < 900; z += 7) {
        const int s = space::sign_at(rows[0], i, Real(z)), t = space::sign_at(rows[1], i, Real(z));
        (s != 0 && t != 0 ? counts.known : counts.unknown) += 1;
        counts.different += s * t < 0;
        counts.inside += t < 0;
      }
    }
  }
}

TEST(ContactRays, AgreeWithParts) {
  const LinearMap skew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, small{{{30, 3, -8}, {7, 20, 9}, {-5, 2, 27}}};
  const Both a(space::extruded({"#.#", "###"}, 2), skew), l(space::extruded({"##", "#."}, 1), small),
      room(space::around(space::extruded({"##", "#."}, 2), 1), skew);
  Counts counts;
  for (int axis = 0; axis < 3; ++axis) {
    const space::RayGrid grid{axis, 1, -90, -110, 71, 57, 4, 4};
    compare(Which::kGamma1, Real(-9), l, a, grid, counts);
    compare(Which::kEta1, Real(15), l, room, grid, counts);
    compare(Which::kEta2, Real(220), l, room, grid, counts);
  }
  EXPECT_EQ(counts.different, 0);
  EXPECT_GT(counts.inside, 500);
  EXPECT_GT(counts.known, 1000 * counts.unknown);
}

}  // namespace formula_contact_rays
}  // namespace findspace::formula
