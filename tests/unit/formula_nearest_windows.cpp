// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest position from windows: the first window is as large as the conditions show that it has to be, and what a
// window holds is the answer only where nothing outside of it is nearer.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formula/language/parse.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/regions.h"
#include "plane/base/stage_observer.h"
#include "plane/complex/overlay.h"
#include "plane_topology_sets.h"

namespace findspace::formula {
namespace formula_nearest_windows {

using exact::Real;
using exact::RealPoint;
using plane::Region;

/// Counts the windows that are looked at.
class Windows : public plane::StageObserver {
 public:
  int count = 0;
  void cells(std::string_view stage, const std::string& title, const plane::CellComplex&) override {
    count += stage == "region" && title == "positions at which the formula holds";
  }
  void drawing(std::string_view, const std::string&, const plane::StageDrawing&) override {}
};

struct Question {
  Question(std::map<std::string, Region> shapes, const std::string& text) {
    World world;
    for (auto& [name, shape] : shapes) world.shapes.emplace(name, std::move(shape));
    world.moving = {"B"};
    world.step = 1;
    Context context;
    for (const auto& [name, shape] : world.shapes) context.shapes.push_back(name);
    context.moving = {"B"};
    formula.emplace(parse_formula(text, context));
    solver.emplace(std::move(world));
  }

  std::optional<Formula> formula;
  std::optional<Solver> solver;
};

RealPoint at(int x, int y) { return {Real(x), Real(y)}; }

Region box(int x0, int y0, int x1, int y1) { return plane::box(x0, y0, x1, y1); }

/// 102 below the free half plane above A, where D stands in the way of the nearest contact.
Question deep_below() {
  return {{{"A", box(0, 0, 1000, 1000)}, {"B", box(-1, -1, 1, 1)}, {"D", box(495, 1000, 505, 1010)}},
          "gap(B, A) >= 1 and gap(B, D) >= 1"};
}

TEST(NearestWindows, TheFirstOneReachesBeyondWhatTheConditionsLack) {
  const Question q = deep_below();
  Windows seen;
  const plane::ObserveStages observe(&seen);
  const auto found = q.solver->nearest_feasible(*q.formula, at(499, 900)).or_throw();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->at.at(0), Real(493));
  EXPECT_EQ(found->at.at(1), Real(1002));
  EXPECT_EQ(found->distance * found->distance, Real(6 * 6 + 102 * 102));
  EXPECT_TRUE(found->attained);
  EXPECT_EQ(seen.count, 1);
}

TEST(NearestWindows, TheyGrowWhereNothingIsKnown) {
  const Question q = deep_below();
  Windows seen;
  const plane::ObserveStages observe(&seen);
  const auto found = nearest_in_windows(q.solver->prepared(), *q.formula, at(499, 900), Real());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->nearest.at.x, Real(493));
  EXPECT_EQ(found->nearest.at.y, Real(1002));
  EXPECT_EQ(seen.count, 6);  // half sides of 6, 12, ..., 192
}

TEST(NearestWindows, WhatIsNearerOutsideOfAWindowIsFound) {
  // A hole in the corner of the first window, 149 * sqrt(2) away, and one to the right of it, 180 away.
  const Region corner = box(148, 148, 152, 152), right = box(179, -2, 183, 2), whole = box(-1000, -1000, 1000, 1000);
  const std::array<const Region*, 3> drilled{&whole, &corner, &right};
  const Question q({{"A", plane::subtract(drilled)}, {"B", box(-1, -1, 1, 1)}}, "gap(B, A) >= 0");
  Windows seen;
  const plane::ObserveStages observe(&seen);
  const auto found = nearest_in_windows(q.solver->prepared(), *q.formula, at(0, 0), Real(102));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->nearest.distance, Real(180));
  EXPECT_TRUE(found->attained);
  EXPECT_EQ(seen.count, 2);
}

/// 400 teeth, 10 wide and 10 apart, of which a window sees some.
TEST(NearestWindows, OfALargeShapeNoMoreIsTakenThanWhatIsNear) {
  std::vector<plane::GridPoint> comb{{0, 0}, {8000, 0}};
  for (int x = 8000; x > 0; x -= 20) {
    const int top = 500 + x % 7;
    comb.insert(comb.end(), {{x, top}, {x - 10, top}, {x - 10, 10}, {x - 20, 10}});
  }
  const Question q({{"A", plane::polygon(comb)}, {"B", box(-1, -1, 1, 1)}}, "gap(B, A) >= 2");
  for (const RealPoint& p : {at(4005, 470), at(4013, 300), at(3998, 5), at(4015, 12)}) {
    const auto found = nearest_in_windows(q.solver->prepared(), *q.formula, p, Real());
    const Region whole = feasible(q.solver->prepared(), *q.formula);
    const auto expected = plane::nearest_in_closure(whole, plane::closure(whole), p);
    ASSERT_TRUE(found && expected);
    EXPECT_EQ(found->nearest.distance, expected->nearest.distance);
    EXPECT_EQ(found->nearest.at.x, expected->nearest.at.x);
    EXPECT_EQ(found->nearest.at.y, expected->nearest.at.y);
  }
}

}  // namespace formula_nearest_windows
}  // namespace findspace::formula
