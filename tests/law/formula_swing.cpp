// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Instants of a shape that only rotates, exact, against the certified bounds of shapes that move in any way: every
// instant that the bounds decide is the same, for legs in both directions, rests and several rotates; and the instants
// of a turn run backwards are the same backwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "../unit/plane_topology_sets.h"
#include "formula/language/parse.h"
#include "formula/planar/solve.h"

namespace findspace::formula {
namespace formula_swing {

using exact::Real;
using exact::RealPoint;
using plane::Section;

World random_world(std::mt19937& random) {
  const auto pick = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  World w;
  w.step = Real(1);
  w.moving = {"B"};
  w.shapes.emplace("B", plane::box(-pick(0, 4), -pick(1, 3), pick(6, 14), pick(1, 3)));
  w.shapes.emplace("A", plane::disc(pick(-12, 12), pick(8, 14), pick(1, 5)));
  w.shapes.emplace("C", plane::box(-pick(12, 20), -pick(8, 16), pick(12, 20), pick(8, 16)));
  w.motion.start = 0;
  w.motion.end = 4;
  const Real stay(pick(-2, 2));
  Trajectory& way = w.motion.of["B"];
  way.times = {0, 1, 3};
  way.path.assign(3, RealPoint{stay, stay});
  way.angles = {pick(-100, 100), pick(-100, 100), pick(-500, 500)};
  return w;
}

Formula random_formula(std::mt19937& random) {
  constexpr std::array<const char*, 5> kForms{"gamma1(B, A) >= 1", "eta1(B, C) <= 0 and gamma1(B, A) > 0",
                                              "gamma2(B, A) < 20", "gamma1(B, A) <= 2 or not eta1(B, C) <= -1",
                                              "mu(A, B) <= 12"};
  Context context;
  context.shapes = {"A", "B", "C"};
  context.moving = {"B"};
  context.motion = true;
  return parse_formula(kForms[random() % kForms.size()], context);
}

plane::Mark mark_at(const Section& s, const Real& t) {
  plane::Mark mark = s.before;
  for (const Section::Stop& stop : s.stops) {
    if (t == stop.t) return stop.at;
    if (t < stop.t) break;
    mark = stop.after;
  }
  return mark;
}

TEST(Swing, LiesBetweenTheBounds) {
  std::mt19937 random(3);
  int decided = 0, changes = 0;
  for (int k = 0; k < 12; ++k) {
    const Solver solver(random_world(random));
    const Formula formula = random_formula(random);
    const std::optional<Section> swing = solver.swing(formula, {});
    ASSERT_TRUE(swing);
    for (std::size_t i = 0; i + 1 < swing->stops.size(); ++i) ASSERT_LT(swing->stops[i].t, swing->stops[i + 1].t);
    const InstantBounds bounds = solver.instant_bounds(formula, {});
    plane::Mark last = 0;
    for (int i = 0; i <= 400; ++i) {
      const Real t = Real::ratio(i, 100);
      const plane::Mark low = mark_at(bounds.inner, t), high = mark_at(bounds.outer, t), here = mark_at(*swing, t);
      EXPECT_TRUE(low <= here && here <= high) << "scene " << k << " at " << t.text();
      decided += low == high;
      changes += here != last;
      last = here;
    }
  }
  EXPECT_GT(decided, 12 * 350);
  EXPECT_GT(changes, 20);
}

TEST(Swing, BackwardsIsTheSameBackwards) {
  std::mt19937 random(4);
  for (int k = 0; k < 10; ++k) {
    World w = random_world(random), back = w;
    Trajectory& way = back.motion.of["B"];
    way.times = {1, 3, 4};
    std::reverse(way.angles.begin(), way.angles.end());
    const Formula formula = random_formula(random);
    const auto forth = Solver(std::move(w)).swing(formula, {}), reversed = Solver(std::move(back)).swing(formula, {});
    for (int i = 0; i <= 400; ++i)
      EXPECT_EQ(mark_at(*forth, Real::ratio(i, 100)), mark_at(*reversed, Real(4) - Real::ratio(i, 100)))
          << k << " at " << i;
  }
}

/// Both turn about one point: as one of them does alone, by the difference.
TEST(Swing, BothTurnAboutOnePoint) {
  std::mt19937 random(6);
  for (int k = 0; k < 8; ++k) {
    World both = random_world(random);
    Trajectory& way = both.motion.of["B"];
    Trajectory& other = both.motion.of["A"];
    other = way;
    for (Real& a : other.angles) a = Real(int(random() % 400) - 200);
    World one = both;
    one.motion.of.erase("A");
    Trajectory& alone = one.motion.of["B"];
    alone.path.assign(3, RealPoint{});
    for (std::size_t i = 0; i < 3; ++i) alone.angles[i] = way.angles[i] - other.angles[i];
    Context context;
    context.shapes = {"A", "B", "C"};
    context.moving = {"B"};
    context.motion = true;
    const Formula formula = parse_formula("gamma1(B, A) >= 1 or mu(A, B) <= 12", context);
    const auto of_both = Solver(std::move(both)).swing(formula, {}), of_one = Solver(std::move(one)).swing(formula, {});
    ASSERT_TRUE(of_both && of_one);
    for (int i = 0; i <= 400; ++i)
      EXPECT_EQ(mark_at(*of_both, Real::ratio(i, 100)), mark_at(*of_one, Real::ratio(i, 100))) << k << " at " << i;
  }
}

TEST(Swing, TurningTogetherIsStandingStill) {
  std::mt19937 random(7);
  for (int k = 0; k < 6; ++k) {
    World together = random_world(random);
    together.motion.of["A"] = together.motion.of["B"];
    World still = together;
    still.motion = {};
    Context context;
    context.shapes = {"A", "B", "C"};
    context.moving = {"B"};
    const Solver at_rest(std::move(still));
    context.motion = true;
    const Solver turning(std::move(together));
    for (const char* name : {"gamma1", "eta1", "gamma2", "mu", "hausdorff", "penetration"}) {
      Distance d = parse_formula(std::string(name) + "(B, A) = 0", context).atoms()[0].distance;
      d.prefix = Extremum::kNone;
      const DistanceAt value = at_rest.distance_at(d, {});
      d.prefix = Extremum::kSup;
      const DistanceAt turned = turning.distance_at(d, {});
      ASSERT_EQ(value.value(), turned.value()) << name;
      if (!value.value()) continue;
      EXPECT_TRUE(turning.holds(Formula(compare(d, Relation::kEqual, value.answer->value)), {})) << name;
    }
  }
}

TEST(Swing, ALapIsNoStandingStill) {
  World w;
  w.step = Real(1);
  w.moving = {"B"};
  w.shapes.emplace("B", plane::box(-3, -1, 3, 1));
  w.shapes.emplace("A", plane::box(-3, -3, 3, 3));
  w.motion.start = 0;
  w.motion.end = 1;
  w.motion.of["B"] = {{0, 1}, {RealPoint{}, RealPoint{}}, {0, 360}};
  Context context;
  context.shapes = {"A", "B"};
  context.moving = {"B"};
  context.motion = true;
  const Formula fits = parse_formula("sup eta1(B, A) <= 0", context),
                meets = parse_formula("inf gamma1(B, A) < 0", context);
  for (const int laps : {1, 1'000'000}) {
    w.motion.of["B"].angles[1] = Real(360) * Real(laps);
    EXPECT_FALSE(Solver(w).holds(fits, {})) << laps;
    EXPECT_TRUE(Solver(w).holds(meets, {})) << laps;
  }
}

TEST(Swing, IsNothingWhereSomethingElseMoves) {
  std::mt19937 random(5);
  World away = random_world(random), both = away;
  away.motion.of["B"].path[1].x = Real(7);
  both.motion.of["A"] = both.motion.of["B"];
  both.motion.of["A"].path.assign(3, RealPoint{});  // about another point
  const Formula formula = random_formula(random);
  EXPECT_FALSE(Solver(std::move(away)).swing(formula, {}));
  EXPECT_FALSE(Solver(std::move(both)).swing(formula, {}));
}

}  // namespace formula_swing
}  // namespace findspace::formula
