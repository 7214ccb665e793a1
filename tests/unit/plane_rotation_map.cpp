// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "plane/rotation/rotation_map.h"

namespace findspace::plane {
namespace plane_rotation_map {

using exact::Angle;
using exact::Real;

TEST(RotationInterval, DegreesOfIntervalsThatDoublesDoNotTellFromNoneOrAll) {
  for (const char* place : {"0", "33", "359.99999999999999999"}) {
    const Angle p = Angle::of_degrees(Real::parse_decimal(place)), q = p + Real::parse_decimal("1e-20");
    const RotationInterval least{p, q}, most{q, p}, single{p, p, true, true}, round{p, p, true, false, true};
    for (const RotationInterval& i : {least, most, single, round}) {
      const auto [from, to] = i.degrees();
      EXPECT_GE(from, 0);
      EXPECT_LT(from, 360);
      EXPECT_GE(to, from);
      EXPECT_LE(to, from + 360);
    }
    const auto width = [](const RotationInterval& i) { return i.degrees()[1] - i.degrees()[0]; };
    EXPECT_LT(width(least), 1e-9) << place;
    EXPECT_GT(width(most), 360 - 1e-9) << place;
    EXPECT_EQ(width(single), 0);
    EXPECT_EQ(round.degrees()[1], round.degrees()[0] + 360);
  }
}

}  // namespace plane_rotation_map
}  // namespace findspace::plane
