// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Levels along the lines: a place that is no fraction has the same name whenever its row is made. Where a search told
// the signs, places of 0 are not known, and values lie between two readings of them.
#include <gtest/gtest.h>

#include "distance/planar/translation_value.h"
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

/// - on [2, 6], 0 within 1 of it, + elsewhere; the position is `at`.
plane::Section uncertain(int at) {
  return {1, {{Real(1 - at), 0, 0}, {Real(2 - at), -1, -1}, {Real(6 - at), -1, 0}, {Real(7 - at), 0, 1}}};
}

TEST(TranslationBounds, HoldTheValuesOfBothReadings) {
  const TranslationBounds inside = translation_bounds(uncertain(3), false, true);
  EXPECT_EQ(inside.lower->value(), Real(-2));
  EXPECT_EQ(inside.upper->value(), Real(-1));
  EXPECT_EQ(inside.sign(Real(-3), false), 1);
  EXPECT_EQ(inside.sign(Real::ratio(-3, 2), false), 0);
  EXPECT_EQ(inside.sign(Real(0), false), -1);
  const TranslationBounds outside = translation_bounds(uncertain(9), false, true);
  EXPECT_EQ(outside.lower->value(), Real(2));
  EXPECT_EQ(outside.upper->value(), Real(3));
  EXPECT_FALSE(translation_bounds(uncertain(9), false, false).lower);  // nothing ahead
  const TranslationBounds far = translation_bounds(uncertain(3), true, false);
  EXPECT_EQ(far.lower->value(), Real(3));
  EXPECT_EQ(far.upper->value(), Real(4));
}

TEST(TranslationBounds, OfAPositionThatIsNotKnown) {
  const plane::Section line{1, {{Real(-1), 0, 0}, {Real(2), 0, 1}}};
  const TranslationBounds near = translation_bounds(line, false, true);
  EXPECT_EQ(near.lower->value(), Real(-1));
  EXPECT_FALSE(near.upper);
  EXPECT_EQ(near.sign(Real(0), false), 0);
  EXPECT_EQ(near.sign(Real(-2), false), 1);
  const TranslationBounds far = translation_bounds(line, true, true);
  EXPECT_FALSE(far.lower);
  EXPECT_EQ(far.sign(Real(1), true), 0);
}

TEST(RayRuns, SignsThatASearchLeavesOpen) {
  const auto zero = [](int) -> exact::Tried<space::RayRow> {
    space::RayRow row{{1}, {0, 4}, {}};
    for (const auto& stop : uncertain(0).stops) {
      space::RayEvent event;
      event.at.exact = {static_cast<int>(stop.t.to_double()), 1};
      event.at.value = stop.t.to_double();
      event.here = static_cast<std::int8_t>(stop.at);
      event.after = static_cast<std::int8_t>(stop.after);
      row.events.push_back(event);
    }
    return row;
  };
  RunQuery query;
  query.both_ways = true;
  const RayRuns deep(zero, true, query, Real(-1), space::RayGrid{2, 1, 0, 0, 1, 1, 1, 1});
  const space::RayRow row = deep.row(0);
  EXPECT_EQ(space::sign_at(row, 0, Real::ratio(7, 2)), -1);  // up to 2: -1.5 to -2.5
  EXPECT_EQ(space::sign_at(row, 0, Real::ratio(5, 2)), 0);   // -0.5 to -1.5
  EXPECT_EQ(space::sign_at(row, 0, Real::ratio(3, 2)), 1);   // at least -0.5
  EXPECT_EQ(space::sign_at(row, 0, Real(9)), 1);
}

}  // namespace distance_ray_runs
}  // namespace findspace::distance
