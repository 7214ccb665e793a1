// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <atomic>
#include <utility>

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

/// Eight events, and sets of which some begin, end or lie between them.
TEST(RotationMap, MarksWithinASetAreThoseOfAllAngles) {
  std::vector<exact::ExactAngle> events;
  for (int k = 0; k < 8; ++k) events.push_back(exact::ExactAngle::near(45 * k + 10, 30));
  const auto place = [&](const exact::ExactAngle& t) { return int(t.degrees() * 1000); };
  const auto at = [](double degrees) { return Angle{exact::ExactAngle::near(degrees, 30), Real()}; };
  const RotationMap all = RotationMap::uniform(1);
  std::vector<RotationMap> sets{all, RotationMap::uniform(0)};
  for (const auto& [from, to] : {std::pair(20.0, 30.0), {5.0, 56.0}, {10.0, 10.5}, {100.0, 300.0}, {330.0, 350.0}}) {
    sets.push_back({{at(from), at(to)}, {1, 0}, {1, 0}, 0});
    sets.push_back({{at(from), at(to)}, {1, 0}, {0, 1}, 0});
    sets.push_back({{at(from)}, {1}, {0}, 0});
  }
  std::atomic<int> looks{0};
  const auto look = [&]() -> AngleMark {
    return [&](std::size_t, const exact::ExactAngle& t) {
      ++looks;
      return Mark(place(t) / 7 % 3 - 1);
    };
  };
  const RotationMap whole = marks_within(all, events, look);
  EXPECT_EQ(looks, 16);
  for (const RotationMap& set : sets) {
    looks = 0;
    const RotationMap part = marks_within(set, events, look);
    EXPECT_LE(looks, 16);
    const std::array<const RotationMap*, 3> maps{&set, &whole, &part};
    const RotationMap wrong = overlay(maps, [](std::span<const Mark> m) { return Mark(m[0] != 0 && m[1] != m[2]); });
    EXPECT_TRUE(intervals(wrong).empty());
  }
  EXPECT_EQ(looks, 1);
}

}  // namespace plane_rotation_map
}  // namespace findspace::plane
