// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The region of the plane and what is best in it: exact, or between bounds, and which way found it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "findspace/error.h"
#include "formula/language/parse.h"
#include "formula/language/parse_goal.h"
#include "formula/planar/regions.h"
#include "formula/planar/solve_region.h"
#include "plane/query/locate.h"
#include "plane_topology_sets.h"

namespace findspace::formula {
namespace formula_solve_region {

using distance::Sense;
using distance::Side;
using distance::Way;
using exact::Real;

/// A point B that moves, a small disc A and a large one C on either side of it, and a disc like A.
/// Another one, F, is far away on the same line.
class SolveRegion : public testing::Test {
 protected:
  static constexpr std::int64_t kFar = std::int64_t{1} << 36;
  static World world() {
    World out;
    out.shapes.emplace("A", plane::disc(600, 0, 100));
    out.shapes.emplace("C", plane::disc(-600, 0, 300));
    out.shapes.emplace("D", plane::disc(-600, 0, 100));
    out.shapes.emplace("W", plane::box(-2000, -2000, 2000, 2000));
    out.shapes.emplace("F", plane::box(kFar, -5, 2 * kFar, 5));
    out.shapes.emplace("B", plane::point(0, 0));
    out.moving = {"B"};
    out.step = Real(1);
    return out;
  }
  static Context context() {
    Context out;
    out.shapes = {"A", "B", "C", "D", "F", "W"};
    out.moving = {"B"};
    return out;
  }
  Formula where(const char* text) const { return parse_formula(text, context()); }
  Optimum best(const char* objective, const char* formula, Sense sense = Sense::kMinimum,
               std::optional<PlanarLine> line = {}) const {
    SolvedRegion region = solve_region(solver, where(formula));
    const Objective wanted = parse_objective(objective, context());
    if (line) line = reaching(*line, region, wanted, solver);
    if (line) region = on_line(region, *line);
    return optimize(solver, region, {wanted, sense, line});
  }

  Solver solver{world()};
};

constexpr const char* kAlongAHyperbola = "inside(B, W) and gap(B, A) <= gap(B, C)";
constexpr const char* kAlongALine = "inside(B, W) and gap(B, A) <= gap(B, D)";

TEST_F(SolveRegion, SaysWhetherItIsExact) {
  EXPECT_FALSE(solve_region(solver, where("gap(B, A) >= 5")).outer);
  EXPECT_FALSE(solve_region(solver, where(kAlongALine)).outer);
  EXPECT_TRUE(solve_region(solver, where(kAlongAHyperbola)).outer);
  EXPECT_TRUE(solve_region(solver, where("gap(B, A, rotating=(0, 0)) >= 5")).outer);
}

/// As by laying all sign maps over each other and asking the formula in every cell.
TEST_F(SolveRegion, LevelsOfOneDistanceMakeTheSameRegion) {
  for (const char* text :
       {"-50 <= gap(B, A) < 20 or gap(B, A) = 40 or gap(B, A) > 100 and gap(B, A) != 300",
        "gap(B, A) >= 0 and gap(B, A) >= 20", "gap(B, A) = -100 or gap(B, A) <= -200 or gap(B, A) > 5",
        "gap(B, A, along=(1, 0)) <= 30 or 50 < gap(B, A, along=(1, 0)) <= 60",
        "gap(B, A+C) <= 100 or gap(B, A+C) = 150", "gap(B, A) < 1 or gap(B, A) >= 1 or gap(B, A) > 2"}) {
    const Formula formula = where(text);
    const std::optional<plane::Region> levels = region_by_levels(solver.prepared(), formula);
    ASSERT_TRUE(levels) << text;
    const plane::Region all = region_of(formula, sign_maps(solver.prepared(), formula));
    EXPECT_EQ(levels->vertices.size(), all.vertices.size()) << text;
    EXPECT_EQ(levels->edges.size(), all.edges.size()) << text;
    EXPECT_EQ(levels->faces.size(), all.faces.size()) << text;
    EXPECT_TRUE(plane::same_set(*levels, all)) << text;
  }
  EXPECT_FALSE(region_by_levels(solver.prepared(), where("gap(B, A) >= 5 and gap(B, C) >= 5")));
}

/// Levels of one distance among others, and beside a container.
TEST_F(SolveRegion, ManyLevelsAmongOthersMakeTheSameRegion) {
  std::string bands = "gap(B, A) < 1";
  for (int k = 1; k < 40; ++k) bands += fmt::format(" or {} <= gap(B, A) < {}", 20 * k, 20 * k + 10);
  const auto by_cells = [&](const Formula& formula) {
    return region_of(formula, sign_maps(solver.prepared(), formula));
  };
  for (const std::string& text :
       {"gap(B, C) >= 50 and (" + bands + ")", "gap(B, C) < 50 or " + bands, "inside(B, W) and (" + bands + ")",
        "inside(B, W) and gap(B, C) > 3 and (" + bands + ")",
        std::string("inside(B, W) and (gap(B, A) < 30 or gap(B, A) > 40)")}) {
    const Formula formula = where(text.c_str());
    EXPECT_TRUE(plane::same_set(solve_region(solver, formula).region, by_cells(formula))) << text;
    EXPECT_TRUE(plane::same_set(feasible(solver.prepared(), formula), by_cells(formula))) << text;
  }
}

TEST_F(SolveRegion, IsRefusedToThoseWhoNeedItExact) {
  EXPECT_TRUE(exact_region(solver, where(kAlongALine)));
  for (const char* text : {kAlongAHyperbola, "gap(B, A, rotating=(0, 0)) >= 5"}) {
    const auto tried = exact_region(solver, where(text));
    ASSERT_FALSE(tried) << text;
    EXPECT_EQ(tried.refusal().error.code(), ErrorCode::kUnsupported);
  }
}

TEST_F(SolveRegion, TheBestOfAnExactRegionIsExact) {
  const Optimum x = best("x", kAlongALine);
  EXPECT_EQ(*x.value(), Real());
  EXPECT_TRUE(x.proven());
  EXPECT_EQ(x.answer->side, Side::kExact);
  EXPECT_EQ(x.answer->way, Way::kMap);
}

TEST_F(SolveRegion, TheBestBetweenBoundsIsTakenByACertainPosition) {
  // |p - C| - |p - A| >= 200: a branch of a hyperbola, whose vertex is (100, 0).
  const Optimum x = best("x", kAlongAHyperbola);
  ASSERT_TRUE(x.value() && x.bound());
  EXPECT_FALSE(x.proven());
  EXPECT_EQ(x.answer->side, Side::kInner);
  EXPECT_EQ(x.answer->way, Way::kSearch);
  EXPECT_GE(*x.value(), Real(100));
  EXPECT_LE(*x.bound(), Real(100));
  EXPECT_LE(x.value()->to_double() - x.bound()->to_double(), 8);  // of 4000
  const Optimum most = best("x", kAlongAHyperbola, Sense::kMaximum);
  EXPECT_TRUE(most.proven());  // both sets reach the wall
  EXPECT_EQ(*most.value(), Real(2000));
}

TEST_F(SolveRegion, ALineGoesOnBeyondItsEnds) {
  const PlanarLine axis{{0, 0}, {1, 0}};
  EXPECT_TRUE(best("x", "gap(B, A) >= 5", Sense::kMaximum, axis).unbounded);
  const Optimum least = best("x", kAlongALine, Sense::kMinimum, axis);
  EXPECT_EQ(*least.value(), Real());
  const Optimum bounded = best("x", kAlongAHyperbola, Sense::kMaximum, axis);
  EXPECT_EQ(*bounded.value(), Real(2000));
}

TEST_F(SolveRegion, ALineReachesAllThatIsFarAway) {
  for (const std::int64_t step : {std::int64_t{1}, std::int64_t{1} << 39}) {
    const PlanarLine axis{{0, 0}, {step, 0}};
    EXPECT_EQ(*best("x", "gap(B, F) <= 0", Sense::kMinimum, axis).value(), Real(kFar));
    EXPECT_EQ(*best("x", "gap(B, F) <= 0", Sense::kMaximum, axis).value(), Real(2 * kFar));
    EXPECT_EQ(*best("gap(B, F)", "gap(B, A) >= 5", Sense::kMinimum, axis).value(), Real(-5));
    EXPECT_EQ(*best("distance to [100000000000, 7]", "gap(B, A) >= 5", Sense::kMinimum, axis).value(), Real(7));
    EXPECT_EQ(*best("x", "gap(B, A) = 1e13", Sense::kMaximum, axis).value(), Real(10000000000700));
    EXPECT_TRUE(best("x", "gap(B, F) > 0", Sense::kMaximum, axis).unbounded);
  }
}

TEST_F(SolveRegion, AValueThatTheWholeLineHasIsTaken) {
  const PlanarLine axis{{0, 0}, {1, 0}};
  for (const char* same : {"y", "depth(B, C)"}) {
    const Optimum least = best(same, "gap(B, A) >= 5", Sense::kMinimum, axis);
    ASSERT_TRUE(least.value()) << same;
    EXPECT_EQ(*least.value(), Real());
    EXPECT_TRUE(least.proven() && least.attained && !least.unbounded);
    EXPECT_GT(mark_of(least.at, plane::locate(least.at, {Real(100000), Real()})), 0);
  }
  EXPECT_TRUE(best("x", "gap(B, A) >= 5", Sense::kMinimum, axis).unbounded);
}

TEST_F(SolveRegion, SumsAlongALineThatGoesOn) {
  const PlanarLine axis{{0, 0}, {1, 0}};
  EXPECT_THROW(best("gap(B, A) - 2 * gap(B, C)", "gap(B, A) >= 5", Sense::kMinimum, axis), Error);
  EXPECT_THROW(best("gap(B, A) + gap(B, C)", "gap(B, A) >= 5", Sense::kMaximum, axis), Error);
  // Far away the values tend to a limit, and bounds cannot tell where the least one is.
  const PlanarLine above{{0, 50}, {1, 0}};
  EXPECT_THROW(best("gap(B, C) - gap(B, A)", "gap(B, A) >= 5", Sense::kMinimum, above), Error);
  EXPECT_NEAR(best("gap(B, C) - gap(B, A)", "inside(B, W)", Sense::kMinimum, above).value()->to_double(), -1400, 2);
  // At (495, 0): 5 from A, 795 from C.
  EXPECT_NEAR(best("2 * gap(B, A) + gap(B, C)", "gap(B, A) >= 5", Sense::kMinimum, axis).value()->to_double(), 805,
              1e-2);
  // At (2000, 0): 1300 from A, 2300 from C.
  EXPECT_NEAR(best("gap(B, A) - 2 * gap(B, C)", "inside(B, W)", Sense::kMinimum, axis).value()->to_double(), -3300,
              1e-2);
}

TEST_F(SolveRegion, ExactValuesAreAskedOfExactObjectives) {
  const plane::Region all = plane::box(-10, -10, 10, 10);
  EXPECT_THROW(exact_optimum(solver, all, {parse_objective("gap(B, A, rotating=(0, 0))", context())}), Error);
  EXPECT_EQ(*exact_optimum(solver, all, {parse_objective("gap(B, A)", context())}).value(), Real(490));
}

}  // namespace formula_solve_region
}  // namespace findspace::formula
