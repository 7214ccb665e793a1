// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The region found by looking at what is near only is that of the whole formula: a container, obstacles by name and as
// collections, near and far, with clearances, in conjunctions and inside other conditions, at rest and in motion.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "../unit/plane_topology_sets.h"
#include "formula/language/parse.h"
#include "formula/planar/feasible_near.h"
#include "plane/walk/unite.h"

namespace findspace::formula {
namespace formula_near {

using plane::Region;

using plane::operator+, plane::operator-;

Region frame(std::int64_t x, std::int64_t y) {
  return plane::box(x, y, x + 40, y + 40) - plane::interior(plane::box(x + 8, y + 8, x + 32, y + 32)) +
         plane::box(x + 16, y + 16, x + 20, y + 20);
}

Region part(std::int64_t kind, std::int64_t x, std::int64_t y, std::int64_t size) {
  switch (kind) {
    case 0:
      return frame(x, y);
    case 1:
      return plane::disc(x, y, size);
    case 2:
      return plane::point(x, y);
    default:
      return plane::box(x, y, x + size, y + 12);
  }
}

struct Scene {
  World world;
  std::string formula;
};

Scene random_scene(std::mt19937& random) {
  const auto pick = [&](int n) { return static_cast<std::int64_t>(random() % static_cast<unsigned>(n)); };
  Scene s{{}, "inside(B, room)"};
  s.world.step = exact::Real(1);
  s.world.moving = {"B"};
  s.world.shapes.emplace("B", plane::box(-3, -2, 2, 4));
  s.world.shapes.emplace("room", plane::box(0, 0, 60, 50));
  for (int k = 0; k < 6; ++k) {
    std::vector<Region> parts;
    const std::int64_t count = pick(2) == 0 ? 1 : 8;
    for (std::int64_t c = 0; c < count; ++c) {
      const std::int64_t x = pick(200) - 50, y = pick(200) - 50;
      parts.push_back(part(pick(4), x, y, 1 + pick(20)));
    }
    std::vector<const Region*> all;
    for (const Region& p : parts) all.push_back(&p);
    s.world.shapes.emplace(fmt::format("o{}", k), plane::unite(all));
    const std::int64_t level = pick(4);
    switch (pick(k == 0 ? 4 : 5)) {
      case 0:
        s.formula += fmt::format(" and clear(B, o{}, {})", k, level);
        break;
      case 1:
        s.formula += fmt::format(" and disjoint(B, o{})", k);
        break;
      case 2:
        s.formula += fmt::format(" and (gamma1(B, o{0}) > 3 or gamma1(B, o{0}) < {1})", k, level);
        break;
      case 3:
        s.formula += fmt::format(" and not gamma1(B, o{}) <= {}", k, level);
        break;
      default:
        s.formula += fmt::format(" and clear(B, o{}+o0, {})", k, level);
    }
  }
  return s;
}

/// B moves, and one obstacle of its own.
void set_in_motion(Scene& s, std::mt19937& random) {
  const auto pick = [&](int n) { return exact::Real(static_cast<int>(random() % static_cast<unsigned>(n))); };
  s.world.shapes.emplace("m", plane::box(70, 10, 90, 30));
  s.world.motion.start = 0;
  s.world.motion.end = 2;
  s.world.motion.of["B"] = {{0, 1, 2}, {{0, 0}, {pick(20), pick(20)}, {pick(30), pick(10)}}, {0, 0, 0}};
  s.world.motion.of["m"] = {{0, 2}, {{0, 0}, {pick(60) - 40, pick(60) - 30}}, {0, 0}};
  s.formula += random() % 2 == 0 ? " and gamma1(B, m) >= 2" : " and sup gamma1(m, B) > 25 and inf gamma1(B, o0) != 1";
}

void expect_same(unsigned seed, int scenes, bool motion, int least_possible) {
  std::mt19937 random(seed);
  int some = 0;
  for (int k = 0; k < scenes; ++k) {
    Scene s = random_scene(random);
    if (motion) set_in_motion(s, random);
    Context context;
    for (const auto& [name, shape] : s.world.shapes) context.shapes.push_back(name);
    context.moving = s.world.moving;
    context.motion = motion;
    const Formula formula = parse_formula(s.formula, context);
    const Solver solver(std::move(s.world));
    const Region whole = solver.feasible(formula), near = feasible_near(solver, formula);
    EXPECT_TRUE(plane::same_set(whole, near)) << s.formula;
    some += !plane::is_empty(whole);
  }
  EXPECT_GT(some, least_possible);
}

TEST(FeasibleNear, IsTheFeasibleRegion) { expect_same(11, 60, false, 15); }

TEST(FeasibleNear, IsTheFeasibleRegionOverAMotion) { expect_same(12, 40, true, 8); }

}  // namespace formula_near
}  // namespace findspace::formula
