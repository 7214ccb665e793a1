// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The stack of maps over angles against the exact set of angles at single positions, which another machinery finds:
// what `inner` claims holds over the whole sector, what `outer` excludes holds nowhere in it, and the maps agree where
// rotating rounds nothing.

#include <gtest/gtest.h>

#include "../unit/distance_shapes.h"
#include "formula/language/parse.h"
#include "formula/planar/solve_rotation.h"
#include "planning/pose/pose_stack.h"

namespace findspace::planning {
namespace planning_pose {

using exact::Angle;
using exact::Real;
using exact::RealPoint;
using plane::RotationMap;

formula::World world() {
  formula::World w;
  w.shapes.emplace("A", testing::polygon({{0, 0}, {900, 0}, {900, 700}, {500, 700}, {500, 300}, {0, 300}}));
  w.shapes.emplace("C", plane::region_of_disc(700, 500, 60));
  w.shapes.emplace("B", testing::polygon({{-20, -30}, {260, -30}, {260, 40}, {30, 40}, {30, 120}, {-20, 120}}));
  w.moving = {"B"};
  w.step = 1;
  return w;
}

formula::Formula formula(const char* text) {
  formula::Context c;
  c.shapes = {"A", "B", "C"};
  c.moving = {"B"};
  return formula::parse_formula(text, c);
}

/// 1: the set has the whole sector; 0: some of it; -1: none.
int cover(const RotationMap& set, const Real& from, const Real& to) {
  bool some = false, all = true;
  const auto see = [&](const Angle& a) { (mark_at(set, a) != 0 ? some : all) = mark_at(set, a) != 0; };
  for (int k = 0; k <= 40; ++k) see(Angle::of_degrees(from + (to - from) * Real::ratio(k, 40)));
  for (const Angle& a : set.at) {
    const double d = a.degrees(), low = from.to_double(), high = to.to_double();
    if ((low <= d && d <= high) || (low <= d + 360 && d + 360 <= high)) see(a);
  }
  return all ? 1 : some ? 0 : -1;
}

void compare_at_positions(const char* text) {
  const formula::Formula f = formula(text);
  const PoseStack stack = pose_stack(world(), f, {0, 0}, {Real(0), Real(15), Real(90), Real(110), Real(290)});
  ASSERT_EQ(stack.slices.size(), 5u);
  ASSERT_EQ(stack.sectors.size(), 5u);
  const formula::Solver solver(world());
  int inner = 0, outer = 0;
  for (int x = 40; x < 900; x += 190) {
    for (int y = 40; y < 700; y += 155) {
      const RealPoint p{x, y};
      const RotationMap set = formula::RotationSolver(solver, {p, Real(), RealPoint{}}).maps(f).feasible(f);
      for (const PoseSlice& s : stack.slices) {
        if (!(s.degrees / Real(90)).integer()) continue;
        EXPECT_EQ(testing::sign_at(s.region, p), mark_at(set, Angle::of_degrees(s.degrees)))
            << text << " at " << x << "," << y;
      }
      for (const PoseSector& s : stack.sectors) {
        const int truth = cover(set, s.from, s.to);
        inner += testing::sign_at(s.inner, p);
        outer += testing::sign_at(s.outer, p) == 0;
        if (testing::sign_at(s.inner, p) != 0) {
          EXPECT_EQ(truth, 1) << text << " at " << x << "," << y;
        }
        if (testing::sign_at(s.outer, p) == 0) {
          EXPECT_EQ(truth, -1) << text << " at " << x << "," << y;
        }
      }
    }
  }
  EXPECT_GT(inner + outer, 0) << "nothing was certified at all";
}

TEST(PoseStack, SectorsAreCertified) {
  compare_at_positions("eta1(B, A) <= 0");
  compare_at_positions("gamma1(B, C) >= 20");
  compare_at_positions("not (gamma1(B, C) > 30 and gamma2(B, A) < 800)");
}

/// Distances in rotation about a point that stands still: each slice between bounds, level 0 exact.
void compare_in_rotation(const char* text, bool exact) {
  const formula::Formula f = formula(text);
  const PoseStack stack = pose_stack(world(), f, {0, 0}, {Real(0), Real(90), Real(180)});
  const formula::Solver solver(world());
  int holds = 0, fails = 0, open = 0;
  for (const PoseSlice& s : stack.slices) {
    ASSERT_EQ(s.outer.has_value(), !exact) << text;
    for (int x = 45; x < 900; x += 95) {
      for (int y = 45; y < 700; y += 85) {
        const RealPoint p{x, y};
        const bool truth = formula::RotationSolver(solver, {p, s.degrees, RealPoint{}}).check(f).holds;
        const bool in = testing::sign_at(s.region, p) != 0, possible = exact ? in : testing::sign_at(*s.outer, p) != 0;
        EXPECT_TRUE((!in || truth) && (!truth || possible))
            << text << " at " << x << "," << y << ", " << s.degrees.text();
        holds += in;
        fails += !possible;
        open += possible && !in;
      }
    }
  }
  EXPECT_GT(holds, 5) << text;
  EXPECT_GT(fails, 5) << text;
  EXPECT_LT(open, holds + fails) << text;
}

TEST(PoseStack, DistancesInRotationAreBounded) {
  compare_in_rotation("gamma1(B, C, turning=(400, 200)) >= 20", false);
  compare_in_rotation("gamma1(B, C, turning=(700, 500)) > -10 and eta1(B, A) <= 0", false);
  compare_in_rotation("eta1(B, A, turning=(500, 100)) <= -4", false);
  compare_in_rotation("eta1(B, A, turning=(500, 100)) <= 0", true);
}

TEST(PoseStack, SectorsAreCertifiedInRotation) {
  compare_at_positions("eta1(B, A, turning=(0, 0)) <= 0");
  compare_at_positions("gamma1(B, C, turning=(300, 100)) >= 0");
}

TEST(PoseStack, RoundingIsReported) {
  const PoseStack stack = pose_stack(world(), formula("gamma1(B, C) >= 0"), {0, 0}, {Real(0), Real(15)});
  EXPECT_EQ(stack.slices[0].rounding.points, 0);
  EXPECT_EQ(stack.slices[1].rounding.points, 6);
  EXPECT_LE(stack.slices[1].rounding.largest, 0.7072);
  EXPECT_EQ(stack.sectors.size(), 1u);  // the way back is more than half a turn
}

TEST(PoseStack, RefusesWhatItCannotHedge) {
  EXPECT_THROW(pose_stack(world(), formula("gamma2(B, A) -> min"), {0, 0}, {Real(0), Real(90)}), Error);
}

}  // namespace planning_pose
}  // namespace findspace::planning
