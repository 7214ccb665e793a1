// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What lines tell of a region whose intervals have no end: they are cut at the box, and neighbours meet. What is made
// of several rows of signs.
#include <gtest/gtest.h>

#include <cmath>

#include "space/rays/ray_extreme.h"
#include "space/rays/ray_summary.h"
#include "space/rays/row_merge.h"

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

void expect_same(const RayRow& a, const RayRow& b) {
  EXPECT_EQ(a.before, b.before);
  EXPECT_EQ(a.first, b.first);
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t k = 0; k < a.events.size(); ++k) {
    EXPECT_EQ(compare_positions(a.events[k].at, b.events[k].at), 0);
    EXPECT_EQ(a.events[k].here, b.events[k].here);
    EXPECT_EQ(a.events[k].after, b.events[k].after);
  }
}

/// Three rows of three lines with events at the same places, lines without events, and signs that differ from where
/// they were left on the line before.
std::vector<RayRow> three_rows() {
  return {{{1, 1, -1}, {0, 2, 2, 3}, {event(0, 0, -1), event(3, 0, 1), event(1, 1, 1)}},
          {{1, -1, 1}, {0, 2, 2, 4}, {event(3, -1, -1), event(5, 0, 1), event(1, 0, -1), event(2, -1, 1)}},
          {{-1, 1, 1}, {0, 1, 3, 3}, {event(0, 0, 1), event(4, 0, 1), event(6, -1, 1)}}};
}

TEST(RowMerge, ExtremesAreThoseOfTheSigns) {
  using Signs = std::span<const std::int8_t>;
  const std::vector<RayRow> rows = three_rows();
  expect_same(extreme(rows, true), combined(rows, [](Signs s) { return *std::min_element(s.begin(), s.end()); }));
  expect_same(extreme(rows, false), combined(rows, [](Signs s) { return *std::max_element(s.begin(), s.end()); }));
}

TEST(RowMerge, SumsAreThoseOfTheSigns) {
  const plane::SignSum sum{1, {{{-1, 0, 1}}, {{2, 0, 0}}, {{-3, 1, -1}}}};
  const std::vector<RayRow> rows = three_rows();
  expect_same(summed(rows, sum), combined(rows, [&](std::span<const std::int8_t> s) {
                return std::int8_t(sum.first + sum.of(0, s[0]) + sum.of(1, s[1]) + sum.of(2, s[2]) > 0 ? -1 : 1);
              }));
}

}  // namespace space_ray_summary
}  // namespace findspace::space
