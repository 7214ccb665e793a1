// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing in space: depths and lines, proofs by Phi and by surfaces, linear programs, and searches that must find what
// is known.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <atomic>

#include "packing/solid_moves/solid_finish.h"
#include "packing/solid_moves/solid_linear_moves.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_proof/verify_solids.h"
#include "packing/solid_search/solid_arrangement.h"
#include "packing/solid_search/solid_first_layout.h"
#include "packing/solid_search/solid_search.h"
#include "packing_solid_parts.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace packing_solids {

space::Body body_of(std::vector<space::BodyPart> parts) {
  space::Body body;
  body.parts = std::move(parts);
  return body;
}

SolidPart part_of(const char* name, int demand, space::Body body) {
  SolidPart part{.name = name, .demand = demand, .forms = {}};
  part.forms.emplace_back().body = std::move(body);
  return part;
}

/// Of two boxes: 3 wide, 3 high, 1 thick.
SolidPart angle(int demand) {
  return part_of("angle", demand, body_of({block({0, 0, 0}, {3, 1, 1}), block({0, 0, 1}, {1, 1, 3})}));
}

SolidPart corner(const char* name, int demand, int size) {
  const std::vector<space::Point> points{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
  return part_of(name, demand, body_of({space::part_of(points, {})}));
}

SolidProblem problem_of(int width, int depth, std::vector<SolidPart> parts) {
  SolidProblem problem;
  problem.width = width;
  problem.depth = depth;
  problem.parts = std::move(parts);
  return problem;
}

SolidLayout layout_of(int height, std::vector<std::array<Fraction, 3>> places) {
  SolidLayout layout;
  layout.height = height;
  for (const auto& at : places) layout.items.push_back({0, int(layout.items.size()) + 1, 0, at});
  return layout;
}

SolidLayout found(const SolidProblem& problem, std::uint64_t seed, double work) {
  const std::atomic<bool> stop = false;
  SolidSearchOptions options;
  options.seed = seed;
  options.work = work;
  return *search_solids(problem, options, {}, stop);
}

TEST(SolidTable, DepthOfTwoCubes) {
  const SolidProblem problem = problem_of(9, 9, {box("cube", 2, 2, 2, 2)});
  const SolidTable table(problem);
  const auto [pair, sign] = table.link(0, 0);
  EXPECT_EQ(sign, 1);
  EXPECT_DOUBLE_EQ(pair.depth({0.5, 0.25, 1.5}, 0), 0.5);
  EXPECT_EQ(pair.depth({2, 0, 0}, 0), 0);
  EXPECT_EQ(pair.depth({2.5, 0, 0}, 0), 0);
}

TEST(SolidTable, SwappedPairIsReflected) {
  const SolidProblem problem = problem_of(9, 9, {box("slab", 1, 4, 3, 1), corner("corner", 1, 3)});
  const SolidTable table(problem);
  const auto first = table.link(0, 1), second = table.link(1, 0);
  EXPECT_EQ(&first.pair, &second.pair);
  const Vector u{1.5, 1, 0.25};  // the corner in the slab
  EXPECT_GT(first.pair.depth(first.sign * u, 0), 0);
  EXPECT_DOUBLE_EQ(first.pair.depth(first.sign * u, 0), second.pair.depth(second.sign * (Vector{} - u), 0));
}

TEST(SolidTable, LineThroughAnOverlap) {
  const SolidProblem problem = problem_of(9, 9, {box("cube", 2, 2, 2, 2), corner("corner", 1, 2)});
  const SolidTable table(problem);
  const ConvexOverlap& cubes = table.link(0, 0).pair.overlaps[0];
  const space::LineStretch along = cubes.stretch({-5, 1, 0}, {1, 0, 0}, 0);
  EXPECT_DOUBLE_EQ(along.from, 3);
  EXPECT_DOUBLE_EQ(along.to, 7);
  const space::LineStretch down = cubes.stretch({1, 0, 6}, {0, 0, -1}, 0);
  EXPECT_DOUBLE_EQ(down.from, 4);
  EXPECT_DOUBLE_EQ(down.to, 8);
  const space::LineStretch beside = cubes.stretch({-5, 2, 0}, {1, 0, 0}, 0);
  EXPECT_FALSE(beside.from < beside.to);
  const space::LineStretch touching = cubes.stretch({-5, 2 - 1e-12, 0}, {1, 0, 0}, 1e-9);
  EXPECT_FALSE(touching.from < touching.to);
}

TEST(SolidVerify, ContactIsNoOverlap) {
  const SolidProblem problem = problem_of(4, 2, {box("cube", 2, 2, 2, 2)});
  EXPECT_TRUE(verify(problem, layout_of(2, {{0, 0, 0}, {2, 0, 0}})).is_feasible());
  EXPECT_EQ(verify(problem, layout_of(2, {{0, 0, 0}, {2, 0, 0}})).density, 1);
  const Fraction least = Fraction(2) - Fraction(1, 1000000000);
  const SolidVerdict verdict = verify(problem, layout_of(2, {{0, 0, 0}, {least, 0, 0}}));
  ASSERT_EQ(verdict.faults.size(), 1U);
  EXPECT_EQ(verdict.faults[0].kind, SolidFault::Kind::kOverlap);
  EXPECT_NEAR(verdict.faults[0].depth, 1e-9, 1e-15);
}

TEST(SolidVerify, WallsCopiesAndGaps) {
  SolidProblem problem = problem_of(5, 2, {box("cube", 2, 2, 2, 2)});
  EXPECT_EQ(verify(problem, layout_of(2, {{0, 0, 0}})).faults[0].kind, SolidFault::Kind::kCount);
  EXPECT_EQ(verify(problem, layout_of(1, {{0, 0, 0}, {2, 0, 0}})).faults[0].kind, SolidFault::Kind::kOutside);
  problem.gap = 1;
  EXPECT_TRUE(verify(problem, layout_of(2, {{0, 0, 0}, {3, 0, 0}})).is_feasible());
  const SolidVerdict near = verify(problem, layout_of(2, {{0, 0, 0}, {Fraction(299, 100), 0, 0}}));
  ASSERT_EQ(near.faults.size(), 1U);
  EXPECT_EQ(near.faults[0].kind, SolidFault::Kind::kGap);
}

/// Where convex parts were rounded the surface decides.
TEST(SolidVerify, BySurfacesAsByPhi) {
  SolidProblem exact = problem_of(9, 9, {angle(2)}), rounded = exact;
  const std::vector<space::Point> outline{{0, 0, 0}, {3, 0, 0}, {3, 0, 1}, {1, 0, 1}, {1, 0, 3}, {0, 0, 3},
                                          {0, 1, 0}, {3, 1, 0}, {3, 1, 1}, {1, 1, 1}, {1, 1, 3}, {0, 1, 3}};
  space::RaySolid solid;
  solid.surface.points = outline;
  solid.surface.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto face = solid.surface.faces[k];
    solid.surface.faces.push_back({face[2] + 6, face[1] + 6, face[0] + 6});
  }
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    solid.surface.faces.push_back({next, k, k + 6});
    solid.surface.faces.push_back({next, k + 6, next + 6});
  }
  rounded.parts[0].forms[0].surface = {solid};
  rounded.parts[0].forms[0].body.rounded = 1;
  int overlaps = 0;
  for (int x = -6; x <= 6; ++x)
    for (int z = -6; z <= 6; ++z) {
      const SolidLayout layout =
          layout_of(9, {{3, 3, 3}, {Fraction(3) + Fraction(x, 2), 3, Fraction(3) + Fraction(z, 2)}});
      const bool feasible = verify(exact, layout).is_feasible();
      EXPECT_EQ(verify(rounded, layout).is_feasible(), feasible) << x << " " << z;
      overlaps += feasible ? 0 : 1;
    }
  EXPECT_GT(overlaps, 20);
  EXPECT_LT(overlaps, 140);
}

TEST(SolidBound, IsTheTallestOrTheVolume) {
  EXPECT_EQ(lower_bound(problem_of(4, 4, {box("tower", 1, 1, 1, 7), box("cube", 2, 2, 2, 2)})), Fraction(7));
  EXPECT_EQ(lower_bound(problem_of(2, 2, {box("cube", 3, 2, 2, 2)})), Fraction(6));
  EXPECT_EQ(lower_bound(problem_of(4, 3, {angle(7)})), Fraction(3));
  EXPECT_EQ(lower_bound(problem_of(7, 1, {corner("corner", 9, 1)})), Fraction(1));
  EXPECT_EQ(lower_bound(problem_of(1, 1, {corner("corner", 19, 1)})), Fraction(3166666666, 1000000000));
  // Doubles of so many billionths are 32 apart.
  EXPECT_EQ(lower_bound(problem_of(1, 1, {corner("corner", 1000000001, 1)})), Fraction(166666666833333333, 1000000000));
}

TEST(SolidBound, HalfTheGapBelongsToASolid) {
  const double pi = std::acos(-1.0);
  SolidProblem problem = problem_of(2, 2, {box("cube", 5, 2, 2, 2)});
  problem.gap = 1;
  const double side = 2 + std::cbrt(4 * pi / 3) / 2;
  EXPECT_NEAR(lower_bound(problem).to_double(), 5 * side * side * side / 9 - 1, 1e-8);  // 14 is the least
  problem.edge = Fraction(1, 4);
  problem.width = problem.depth = Fraction(5, 2);
  EXPECT_NEAR(lower_bound(problem).to_double(), 5 * side * side * side / 9 - 1 + 0.5, 1e-8);
  problem.edge = 0;
  problem.containers = {{"crate", 9, {}, 5, 5, 5}};  // holds eight
  problem.parts[0].demand = 8;
  EXPECT_EQ(lower_bound(problem), Fraction(1));
  problem.containers = {{"crate", 9, {}, 5, 5, Fraction(19, 4)}};
  problem.parts[0].demand = 10;
  EXPECT_EQ(lower_bound(problem), Fraction(2));  // by the volumes alone one would do
}

TEST(SolidBound, CountsContainers) {
  SolidProblem problem = problem_of(4, 4, {box("cube", 5, 2, 2, 2)});
  problem.containers = {{"crate", 9, {}, 5, 3, 3}, {"carton", 1, {}, 2, 2, 2}};
  EXPECT_EQ(lower_bound(problem), Fraction(1));
  problem.parts[0].demand = 6;
  EXPECT_EQ(lower_bound(problem), Fraction(2));
  problem.containers[0] = {"crate", 9, {}, Fraction(5, 2), 3, 2};  // a cube fills more than half of it
  EXPECT_EQ(lower_bound(problem), Fraction(6));
}

TEST(SolidMoves, LetBoxesDown) {
  const SolidProblem problem = problem_of(2, 2, {box("cube", 3, 2, 2, 2)});
  const SolidTable table(problem);
  std::vector<SolidPose> poses{{0, {0, 0, 0.3}}, {0, {0, 0, 2.5}}, {0, {0, 0, 4.9}}};
  EXPECT_NEAR(SolidLinearMoves(table, SolidColumn(problem, table, {})).shorten(poses, 7), 6, 1e-6);
  const std::optional<SolidLayout> layout = finished(problem, table, SolidColumn(problem, table, {}), poses, 6);
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->height, Fraction(6));
}

TEST(SolidMoves, EndAnOverlap) {
  const SolidProblem problem = problem_of(4, 2, {box("cube", 2, 2, 2, 2)});
  const SolidTable table(problem);
  std::vector<SolidPose> poses{{0, {0, 0, 0}}, {0, {1.9, 0, 0.2}}};
  double height = 2.2;
  EXPECT_TRUE(SolidLinearMoves(table, SolidColumn(problem, table, {})).separate(poses, height, 2.2));
  EXPECT_NEAR(poses[1].at.x, 2, 1e-6);
}

TEST(SolidFirstLayout, OverlapsNowhere) {
  const SolidProblem problem = problem_of(7, 6, {box("slab", 4, 4, 3, 1), corner("corner", 5, 4), angle(4)});
  const SolidTable table(problem);
  const SolidColumn column(problem, table, {});
  LayoutInDoubles<SolidPose> layout = first_layout(problem, table, column, 1).layout;
  EXPECT_EQ(layout.poses.size(), problem.items());
  EXPECT_EQ(SolidArrangement(table, column, layout.poses, layout.length).loss(), 0);
  EXPECT_TRUE(finished(problem, table, column, layout.poses, layout.length).has_value());
}

TEST(SolidArrangement, BestPlaceOnALineIsAnEnd) {
  const SolidProblem problem = problem_of(10, 2, {box("cube", 3, 2, 2, 2)});
  const SolidTable table(problem);
  const SolidColumn column(problem, table, {});
  SolidArrangement arrangement(table, column, {{0, {0, 0, 0}}, {0, {4, 0, 0}}, {0, {3, 0, 0}}}, 2);
  const auto left = arrangement.best_on_line(2, arrangement.pose(2), {1, 0, 0}, 1e9, false);
  EXPECT_EQ(left.cost, 0);
  EXPECT_NEAR(left.t, -1, 1e-7);  // between the others
  const auto right = arrangement.best_on_line(2, arrangement.pose(2), {1, 0, 0}, 1e9, true);
  EXPECT_NEAR(right.t, 5, 1e-7);
}

TEST(SolidSearch, FillsACube) {
  const SolidLayout layout = found(problem_of(4, 4, {box("cube", 8, 2, 2, 2)}), 1, 40e6);
  EXPECT_EQ(layout.height, Fraction(4));
}

/// Six bars of 1 x 2 x 2 around three unit cubes: Conway's box of 3 x 3 x 3.
TEST(SolidSearch, SolvesConwaysPuzzle) {
  SolidProblem problem =
      problem_of(3, 3, {box("a", 2, 1, 2, 2), box("b", 2, 2, 1, 2), box("c", 2, 2, 2, 1), box("cube", 3, 1, 1, 1)});
  const SolidLayout layout = found(problem, 1, 200e6);
  EXPECT_EQ(layout.height, Fraction(3));
  EXPECT_TRUE(verify(problem, layout).is_feasible());
}

TEST(AxisRotations, AreTwentyFour) {
  const std::vector<SolidRotation> all = axis_rotations(false);
  EXPECT_EQ(all.size(), 24U);
  EXPECT_EQ(std::count(all.begin(), all.end(), as_given()), 1);
  for (const SolidRotation& r : all) {
    const auto e = [&](int i, int j) { return r[std::size_t(i)][std::size_t(j)].to_double(); };
    const double determinant = e(0, 0) * (e(1, 1) * e(2, 2) - e(1, 2) * e(2, 1)) -
                               e(0, 1) * (e(1, 0) * e(2, 2) - e(1, 2) * e(2, 0)) +
                               e(0, 2) * (e(1, 0) * e(2, 1) - e(1, 1) * e(2, 0));
    EXPECT_EQ(determinant, 1);
    EXPECT_EQ(std::count(all.begin(), all.end(), r), 1);
  }
  const std::vector<SolidRotation> upright = axis_rotations(true);
  EXPECT_EQ(upright.size(), 4U);
  for (const SolidRotation& r : upright) EXPECT_EQ(r[2], (std::array<Fraction, 3>{0, 0, 1}));
}

TEST(SolidTable, FormsThatLookTheSameAreOne) {
  const SolidProblem problem = problem_of(9, 9,
                                          {with_turns(box("cube", 1, 2, 2, 2)), with_turns(box("slab", 1, 2, 2, 1)),
                                           with_turns(box("brick", 1, 1, 2, 3)), with_turns(corner("corner", 1, 2))});
  const SolidTable table(problem);
  EXPECT_EQ(table.variants_of(0).size(), 1U);
  EXPECT_EQ(table.variants_of(1).size(), 3U);
  EXPECT_EQ(table.variants_of(2).size(), 6U);
  EXPECT_EQ(table.variants_of(3).size(), 8U);
  // A form that is left out stands where the one that looks the same does.
  for (std::size_t form = 0; form < 24; ++form) {
    const SolidPlaced item{1, 1, form, {4, 4, 4}};
    const SolidPose pose = table.pose_of(item);
    const SolidBox box = box_of(problem, problem.parts[1].forms[form]);
    EXPECT_EQ(pose.at.z + table.variants()[pose.variant].low.z, 4 + box.low[2].to_double());
    EXPECT_EQ(pose.at.x + table.variants()[pose.variant].high.x, 4 + box.high[0].to_double());
  }
}

/// Both boards lie down.
TEST(SolidSearch, TurnsParts) {
  const SolidProblem problem = problem_of(5, 3, {with_turns(box("board", 2, 1, 3, 5))});
  EXPECT_EQ(lower_bound(problem), Fraction(2));
  const SolidLayout layout = found(problem, 1, 40e6);
  EXPECT_EQ(layout.height, Fraction(2));
  EXPECT_TRUE(verify(problem, layout).is_feasible());
}

/// A part that fits the floor in some forms only, and one that is higher than the others make the container.
TEST(SolidSearch, LeavesFormsThatAreTooHigh) {
  const SolidProblem problem =
      problem_of(4, 3, {with_turns(box("rod", 3, 1, 1, 4)), with_turns(angle(2)), box("cube", 2, 2, 1, 2)});
  const SolidLayout layout = found(problem, 3, 10e6);
  EXPECT_TRUE(verify(problem, layout).is_feasible());
  EXPECT_LE(layout.height, Fraction(3));
}

TEST(SolidSearch, SameResultForAnyNumberOfThreads) {
  const SolidProblem problem = problem_of(7, 6, {box("slab", 4, 4, 3, 1), corner("corner", 5, 4), angle(4)});
  std::vector<SolidLayout> layouts;
  for (const unsigned threads : {1U, 2U, 3U}) {
    const plane::ThreadLimit limit(threads);
    layouts.push_back(found(problem, 5, 4e6));
  }
  for (const SolidLayout& layout : layouts) {
    EXPECT_EQ(layout.height, layouts[0].height);
    for (std::size_t i = 0; i < layout.items.size(); ++i) EXPECT_EQ(layout.items[i].at, layouts[0].items[i].at);
  }
}

TEST(SolidSearch, KeepsAGap) {
  SolidProblem problem = problem_of(5, 2, {box("cube", 4, 2, 2, 2)});
  problem.gap = 1;
  const SolidLayout layout = found(problem, 1, 10e6);
  EXPECT_TRUE(verify(problem, layout).is_feasible());
  EXPECT_NEAR(layout.height.to_double(), 5, 1e-6);
}

TEST(SolidSearch, StopsAtOnce) {
  const SolidProblem problem = problem_of(7, 6, {box("slab", 4, 4, 3, 1), corner("corner", 5, 4)});
  const std::atomic<bool> stop = true;
  const auto layout = search_solids(problem, {}, {}, stop);
  ASSERT_TRUE(layout.has_value());
  EXPECT_TRUE(verify(problem, *layout).is_feasible());
}

TEST(SolidProblem, RefusesWhatDoesNotStandOnTheFloor) {
  EXPECT_THROW(check(problem_of(3, 9, {box("slab", 1, 4, 3, 1)}), "here"), Error);
  EXPECT_THROW(check(problem_of(0, 9, {}), "here"), Error);
  EXPECT_NO_THROW(check(problem_of(4, 3, {box("slab", 1, 4, 3, 1)}), "here"));
}

}  // namespace packing_solids
}  // namespace findspace::packing
