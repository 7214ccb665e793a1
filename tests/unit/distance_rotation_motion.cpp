// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "distance/rotation/rotation_motion.h"
#include "distance_shapes.h"
#include "plane/query/topology.h"

namespace findspace::distance {
namespace distance_rotation_motion {

using namespace findspace::testing;
using exact::Real;
using plane::Region;

/// Turning about the origin on the spot.
std::vector<RotatingPose> turning(int from, int to) { return {{{}, Real(from), Real()}, {{}, Real(to), Real()}}; }

/// All instants looked at are whole turns, where the bar fits; between them a dent in the disc is in its way.
TEST(RotatingMotion, ABoundAboveZeroOfTheGreatestEta1IsNone) {
  const Region disc = plane::region_of_disc(0, 0, 100000),
               dent = polygon({{54000, 72000}, {66160, 87880}, {65840, 88120}}), bar = box(-99999, -440, 99999, 440);
  const std::array<const Region*, 2> both{&disc, &dent};
  const RotatingMotion f(bar, plane::closure(plane::subtract(both)), Which::kEta1, turning(0, 360 << 14));
  const auto v = f.extremum({}, Sense::kMaximum);
  ASSERT_TRUE(v);
  EXPECT_EQ(v->high, INFINITY);
}

}  // namespace distance_rotation_motion
}  // namespace findspace::distance
