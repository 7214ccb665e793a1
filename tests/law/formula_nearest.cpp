// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest feasible position, found without a map where contacts decide and from windows among many obstacles, is as
// far as the nearest point of the closure of the whole region, and attained where that is.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "../unit/distance_shapes.h"
#include "formula/language/parse.h"
#include "formula/planar/solve.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

using namespace findspace::formula;
using findspace::exact::Real;
using findspace::exact::RealPoint;
using findspace::plane::Region;
namespace plane = findspace::plane;

namespace formula_nearest {

Region triangle(std::mt19937& random, int size) {
  const auto at = [&] { return std::uniform_int_distribution(-size, size)(random); };
  for (;;) {
    const int x1 = at(), y1 = at(), x2 = at(), y2 = at();
    if (x1 * y2 - y1 * x2 > size) return findspace::testing::polygon({{0, 0}, {x1, y1}, {x2, y2}});
  }
}

Region random_shape(std::mt19937& random, int size) {
  if (random() % 3 > 0) return triangle(random, size);
  return plane::minkowski_sum(triangle(random, size), plane::region_of_disc(0, 0, Real(size / 3 + 1)));
}

TEST(NearestFeasible, IsThatOfTheWholeRegion) {
  std::mt19937 random(11);
  const std::array<const char*, 17> formulas{"gamma1(B, A) >= 2.5",
                                             "gamma1(B, A) <= 2.5",
                                             "gamma1(B, A) <= -1",
                                             "gamma1(B, A) > 0",
                                             "gamma1(B, A) < 0",
                                             "gamma1(B, A) > 3 and gamma1(B, D) >= 1",
                                             "gamma1(B, A) = 1.5",
                                             "eta1(B, C) < -2 and gamma1(B, A) > 1",
                                             "eta1(B, C) <= -3",
                                             "delta1(B, D) <= 1",
                                             "gamma1(B, A) >= 0",
                                             "gamma1(B, A) <= 0",
                                             "gamma1(B, A) = 0",
                                             "eta1(B, C) <= 0 and gamma1(B, A) >= 0",
                                             "eta1(B, C) <= 0",
                                             "delta1(B, D) <= 0",
                                             "gamma1(B, A) >= 0 and gamma1(B, D) >= 0 and eta1(B, C) <= 0"};
  int without_map = 0;
  for (int round = 0; round < 170; ++round) {
    World world;
    world.shapes.emplace("A", random_shape(random, 12));
    world.shapes.emplace("B", random_shape(random, 9));
    world.shapes.emplace("C", findspace::testing::box(-25, -20, 30, 25));
    world.shapes.emplace("D", random_shape(random, 3));
    world.moving = {"B"};
    world.step = 1;
    Context context;
    context.shapes = {"A", "B", "C", "D"};
    context.moving = {"B"};
    const Solver solver(world);
    const Formula formula = parse_formula(formulas[std::size_t(round) % formulas.size()], context);
    const RealPoint p{Real(std::int64_t(random() % 61) - 30), Real(std::int64_t(random() % 61) - 30)};
    const auto found = solver.nearest_feasible(formula, p).or_throw();
    const Region region = solver.feasible(formula);
    ASSERT_EQ(found.has_value(), !plane::is_empty(region)) << round;
    if (!found) continue;
    const Region closed = plane::closure(region);
    const bool here = mark_of(closed, locate(closed, p)) > 0;
    const auto expected = plane::nearest(
        closed, [](plane::Mark m) { return m > 0; }, p);
    EXPECT_NEAR(found->distance.to_double(), here ? 0 : expected->distance.to_double(), 1e-12) << round;
    const RealPoint at{found->at.at(0), found->at.at(1)};
    EXPECT_GT(mark_of(closed, locate(closed, at)), 0) << round;
    EXPECT_EQ(found->attained, mark_of(region, locate(region, at)) > 0) << round;
    without_map += !here;
  }
  EXPECT_GT(without_map, 60);
}

/// Among many obstacles the windows that grow about the position are small beside the whole. The obstacles are one
/// shape, or a shape each.
TEST(NearestFeasible, IsThatOfTheWholeRegionAmongManyObstacles) {
  std::mt19937 random(12);
  const std::array<const char*, 5> formulas{"gamma1(B, A) >= 1.5", "gamma1(B, A) > 1 and gamma1(B, D) > 0",
                                            "eta1(B, C) <= 0 and gamma1(B, A) >= 0", "gamma1(B, A) = 1",
                                            "gamma1(B, A) >= 2 or gamma1(B, D) <= 0"};
  int far = 0;
  for (int round = 0; round < 25; ++round) {
    std::vector<Region> cells;
    for (int x = 0; x < 16; ++x)
      for (int y = 0; y < 16; ++y) {
        const int x0 = 12 * x + int(random() % 4), y0 = 12 * y + int(random() % 4);
        if (random() % 8 > 0)
          cells.push_back(findspace::testing::box(x0, y0, x0 + 7 + int(random() % 4), y0 + 7 + int(random() % 4)));
      }
    std::vector<const Region*> all;
    for (const Region& c : cells) all.push_back(&c);
    World world;
    world.shapes.emplace("A", plane::unite(all));
    world.shapes.emplace("B", random_shape(random, 3));
    world.shapes.emplace("C", findspace::testing::box(-40, -40, 240, 240));
    world.shapes.emplace("D", random_shape(random, 20));
    world.moving = {"B"};
    world.step = 1;
    Context context;
    context.shapes = {"A", "B", "C", "D"};
    context.moving = {"B"};
    const Solver solver(world);
    const Formula formula = parse_formula(formulas[std::size_t(round) % formulas.size()], context);
    const RealPoint p{Real(std::int64_t(random() % 190)), Real(std::int64_t(random() % 190))};
    const auto found = solver.nearest_feasible(formula, p).or_throw();
    const Region region = solver.feasible(formula), closed = plane::closure(region);
    ASSERT_TRUE(found) << round;
    const bool here = mark_of(closed, locate(closed, p)) > 0;
    const auto expected = plane::nearest(
        closed, [](plane::Mark m) { return m > 0; }, p);
    EXPECT_NEAR(found->distance.to_double(), here ? 0 : expected->distance.to_double(), 1e-12) << round;
    const RealPoint at{found->at.at(0), found->at.at(1)};
    EXPECT_GT(mark_of(closed, locate(closed, at)), 0) << round;
    EXPECT_EQ(found->attained, mark_of(region, locate(region, at)) > 0) << round;
    far += !here;
  }
  EXPECT_GT(far, 10);
}

}  // namespace formula_nearest
