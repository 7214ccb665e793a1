// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The best place of intervals on lines, against every place of a fine sampling; ends, ties and single places. A region
// on lines by the levels of one distance.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "formula/language/evaluate.h"
#include "formula/language/parse.h"
#include "formula/solid/optimize_rays.h"
#include "formula/solid/solve_rays.h"
#include "unit/solid_shapes.h"

namespace findspace::formula {
namespace formula_optimize_rays {

using Place = std::array<double, 3>;
using space::RayInterval;

double distance(const Place& p, const Place& q) {
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

TEST(OptimizeRays, NothingOnNoLines) {
  EXPECT_FALSE(best_on_lines({}, false, [](const Place&) { return 0.0; }));
}

TEST(OptimizeRays, EndsAreOpenOrClosed) {
  const auto height = [](const Place& p) { return p[2]; };
  const RayInterval half_open{{1, 2, 0}, 2, 3, 5, false, true};
  const auto least = best_on_lines({half_open}, false, height), greatest = best_on_lines({half_open}, true, height);
  EXPECT_DOUBLE_EQ(least->value, 3);
  EXPECT_FALSE(least->attained);
  EXPECT_DOUBLE_EQ(greatest->value, 5);
  EXPECT_TRUE(greatest->attained);
  EXPECT_EQ(greatest->at, (Place{1, 2, 5}));
}

TEST(OptimizeRays, ASinglePlaceCounts) {
  const RayInterval line{{0, 0, 0}, 2, 2, 9, true, true}, place{{0, 1, 0}, 2, 1, 1, true, true};
  const auto least = best_on_lines({line, place}, false, [](const Place& p) { return distance(p, {}); });
  EXPECT_DOUBLE_EQ(least->value, std::sqrt(2.0));
  EXPECT_EQ(least->at, (Place{0, 1, 1}));
}

TEST(OptimizeRays, SaysOnWhichSideAPlaceIsCertain) {
  using distance::Sense;
  const RayBest found{4, 3, {1, 2, 3}, true};
  const auto least = [&](Side on_lines, Side cells) {
    return best_over_region(found, Sense::kMinimum, {on_lines, cells, exact::Real(1)}, 0.5);
  };
  const distance::OptimalValue inner = least(Side::kExact, Side::kNone);
  EXPECT_EQ(inner.answer->side, Side::kInner);
  EXPECT_EQ(inner.answer->way, distance::Way::kLines);
  EXPECT_EQ(*inner.value(), exact::Real(2));
  EXPECT_FALSE(inner.bound());  // between the lines there may be better ones
  EXPECT_TRUE(inner.attained);
  EXPECT_EQ(inner.answer->at,
            (distance::Coordinates{exact::Real::ratio(1, 2), exact::Real(1), exact::Real::ratio(3, 2)}));
  const distance::OptimalValue outer = least(Side::kExact, Side::kOuter);
  EXPECT_EQ(outer.answer->side, Side::kNone);
  EXPECT_NEAR(outer.bound()->to_double(), 1, 1e-12);
  EXPECT_FALSE(outer.attained);
  EXPECT_EQ(least(Side::kOuter, Side::kNone).answer->side, Side::kNone);
  const RayBest lowest{-INFINITY, -INFINITY, {}, true};
  EXPECT_TRUE(best_over_region(lowest, Sense::kMinimum, {Side::kExact, Side::kNone, exact::Real(1)}, 1).unbounded);
}

/// The distance to the nearest of some points, which has many local optima.
TEST(OptimizeRays, AgreesWithSampling) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 8);
  for (int round = 0; round < 10; ++round) {
    std::vector<Place> points(6);
    for (Place& p : points) p = {at(random), at(random), at(random)};
    const auto value = [&](const Place& p) {
      double least = 100;
      for (const Place& q : points) least = std::min(least, distance(p, q));
      return least;
    };
    std::vector<RayInterval> lines;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 100; ++k) {
        RayInterval r;
        r.axis = axis;
        r.at[(axis + 1) % 3] = k % 10;
        r.at[(axis + 2) % 3] = k / 10;
        const double a = at(random), b = at(random);
        r.from = std::min(a, b);
        r.to = std::max(a, b);
        lines.push_back(r);
      }
    }
    double least = 100, greatest = 0;
    for (const RayInterval& r : lines) {
      for (int k = 0; k <= 200; ++k) {
        Place p = r.at;
        p[r.axis] = r.from + (r.to - r.from) * k / 200;
        least = std::min(least, value(p));
        greatest = std::max(greatest, value(p));
      }
    }
    const auto low = best_on_lines(lines, false, value), high = best_on_lines(lines, true, value);
    EXPECT_LE(low->value, least + 2e-5);
    EXPECT_GE(low->value, least - 0.05);
    EXPECT_LE(low->bound, low->value);
    EXPECT_NEAR(low->bound, low->value, 2e-5);
    EXPECT_GE(high->value, greatest - 2e-5);
    EXPECT_LE(high->value, greatest + 0.05);
    EXPECT_GE(high->bound, high->value);
    EXPECT_NEAR(high->bound, high->value, 2e-5);
  }
}

Formula in_space(const std::string& text) {
  return parse_formula(text, {.shapes = {"A", "B"},
                              .moving = {"B"},
                              .extra = {},
                              .independent = false,
                              .motion = false,
                              .unit = Unit::kMillimetre,
                              .dimension = 3});
}

/// The formula in every place of a line has the truth of the signs at its levels, one level at a time.
TEST(RayRegion, LevelsOfOneDistanceAreTheFormula) {
  RayWorld world;
  world.shapes.emplace("A", RayShape(space::hull({{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}})));
  world.shapes.emplace("B", RayShape(space::hull({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}})));
  world.moving = {"B"};
  world.step = exact::Real(1);
  const space::RayGrid grid{2, 1, -12, -12, 3, 3, 8, 8};
  for (const char* text : {"0 <= gap(B, A) < 2 or gap(B, A) = 4 or gap(B, A) > 6", "gap(B, A) > 1 and gap(B, A) > 3",
                           "gap(B, A) < 1 or gap(B, A) <= 2 or gap(B, A) >= 1"}) {
    const Formula formula = in_space(text);
    const RegionOnLines region = ray_region(world, formula, grid);
    EXPECT_EQ(region.side, Side::kExact);
    std::vector<RegionOnLines> closed, open;
    std::vector<Formula> kept;
    kept.reserve(2 * formula.sign_maps().size());
    for (const SignMap& m : formula.sign_maps()) {
      closed.push_back(ray_region(world, kept.emplace_back(compare(m.distance, Relation::kLessEqual, m.level)), grid));
      open.push_back(ray_region(world, kept.emplace_back(compare(m.distance, Relation::kLess, m.level)), grid));
    }
    for (int j = 0; j < grid.nv; ++j) {
      const space::RayRow row = region.rays->row(j);
      std::vector<space::RayRow> within, inside;
      for (std::size_t k = 0; k < closed.size(); ++k) {
        within.push_back(closed[k].rays->row(j));
        inside.push_back(open[k].rays->row(j));
      }
      for (int place = 0; place < 81 * grid.nu; ++place) {
        const int i = place % grid.nu;
        const exact::Real z = exact::Real::ratio(place / grid.nu - 40, 2);
        std::vector<std::int8_t> signs;
        for (std::size_t k = 0; k < closed.size(); ++k) {
          const bool in = space::sign_at(inside[k], i, z) < 0, not_out = space::sign_at(within[k], i, z) < 0;
          signs.push_back(static_cast<std::int8_t>(in ? -1 : not_out ? 0 : 1));
        }
        EXPECT_EQ(space::sign_at(row, i, z) < 0, evaluate(formula, signs)) << text;
      }
    }
  }
}

}  // namespace formula_optimize_rays
}  // namespace findspace::formula
