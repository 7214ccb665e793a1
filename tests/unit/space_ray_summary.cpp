// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What lines tell of a region whose intervals have no end: they are cut at the box, and neighbours meet.
#include <gtest/gtest.h>

#include <cmath>

#include "space/rays/ray_extreme.h"
#include "space/rays/ray_summary.h"

namespace findspace::space {
namespace space_ray_summary {

RayEvent event(std::int64_t at, int here, int after) {
  RayEvent out;
  out.at.exact = {at, 1};
  out.at.value = static_cast<double>(at);
  out.here = static_cast<std::int8_t>(here);
  out.after = static_cast<std::int8_t>(after);
  return out;
}

/// Two lines, half a step to a part: all but ]-1, 1[ of the first, all of the second but for the place 2.
struct Outside {
  RayGrid grid{2, 2, 0, 0, 2, 2, 2, 1};
  Point low{0, 0, -5}, high{2, 1, 5};
  RayRow row{{-1, -1}, {0, 2, 3}, {event(-2, -1, 1), event(2, 0, -1), event(4, 1, -1)}};
};

TEST(RaySummary, IntervalsWithoutEndAreCutAtTheBox) {
  const Outside set;
  const RowIntervals intervals = intervals_of(set.row);
  ASSERT_EQ(intervals.from.size(), 4U);
  EXPECT_TRUE(std::isinf(intervals.from[0]));
  EXPECT_EQ(intervals.to[0], -2);
  EXPECT_EQ(intervals.from[3], 4);
  EXPECT_TRUE(std::isinf(intervals.to[3]));
  RaySummarizer summarizer(set.grid, set.low, set.high);
  summarizer.add(0, set.row);
  const RaySummary summary = summarizer.finish();
  EXPECT_EQ(summary.intervals, 4);
  EXPECT_EQ(summary.points, 0);
  EXPECT_EQ(summary.volume, 4 + 4 + 10);
  EXPECT_EQ(summary.low[2], -5);
  EXPECT_EQ(summary.high[2], 5);
  EXPECT_EQ(summary.components.size(), 1U);
}

TEST(RaySummary, LinesThatLieInTheRegionAreIntervals) {
  const RayGrid grid{0, 1, 0, 0, 1, 1, 1, 1};
  RaySummarizer summarizer(grid, {-3, 0, 0}, {4, 1, 1});
  summarizer.add(0, RayRow{{-1}, {0, 0}, {}});
  const RaySummary summary = summarizer.finish();
  EXPECT_FALSE(summary.empty);
  EXPECT_EQ(summary.volume, 7);
  EXPECT_EQ(summary.low[0], -3);
}

TEST(RayExtreme, OfIntervalsWithoutEndIsInTheBox) {
  const Outside set;
  const auto extreme = [&](const RayAim& aim) {
    RayExtreme out(aim, set.low, set.high);
    out.add(set.grid, 0, set.row);
    return out.found()->value;
  };
  EXPECT_EQ(extreme({2, false, {}}), -5);
  EXPECT_EQ(extreme({2, true, {}}), 5);
  EXPECT_EQ(extreme({-1, false, {0, 0, 9}}), 0);
}

}  // namespace space_ray_summary
}  // namespace findspace::space
