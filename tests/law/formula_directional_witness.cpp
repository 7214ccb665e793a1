// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The witness of a distance along a direction: the two points lie that distance apart in that direction, on the
// features that are named, whichever shape moves and however the roles are written.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "../unit/distance_shapes.h"
#include "formula/language/parse.h"
#include "formula/planar/solve.h"
#include "plane/sum/minkowski.h"

using namespace findspace::formula;
using findspace::exact::Real;
using findspace::exact::RealPoint;
using findspace::plane::Region;
namespace plane = findspace::plane;

namespace formula_directional_witness {

Region shape(std::mt19937& random, int size) {
  const auto at = [&] { return std::uniform_int_distribution(size / 2, size)(random); };
  const Region ring = findspace::testing::polygon({{-at(), -at()}, {at(), -at()}, {at(), at()}, {-at(), at()}});
  return random() % 2 > 0 ? ring : plane::minkowski_sum(ring, plane::region_of_disc(0, 0, Real(size / 3 + 1)));
}

/// Whether the point lies on the feature, with its shape moved by p.
void expect_on(const FeatureAt& f, const findspace::distance::Coordinates& at, const RealPoint& p,
               const std::string& what) {
  const double x = (at[0] - p.x).to_double(), y = (at[1] - p.y).to_double();
  const auto place = [&](std::size_t i) { return std::array{f.points[i][0].to_double(), f.points[i][1].to_double()}; };
  const auto [ax, ay] = place(0);
  if (f.kind == FeatureAt::Kind::kEdge) {
    const auto [bx, by] = place(1);
    const double length = std::hypot(bx - ax, by - ay);
    EXPECT_NEAR(((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / length, 0, 1e-9) << what;
    const double along = ((bx - ax) * (x - ax) + (by - ay) * (y - ay)) / length;
    EXPECT_TRUE(along > -1e-9 && along < length + 1e-9) << what;
  } else {
    EXPECT_NEAR(std::hypot(x - ax, y - ay), f.radius.to_double(), 1e-9) << what;
  }
}

TEST(DirectionalWitness, LiesThatFarApartInThatDirection) {
  std::mt19937 random(5);
  const std::array<const char*, 7> formulas{
      "gamma1(B, A, along=(2, 1)) >= 0",   "gamma1(A, B, along=(-1, 3)) >= 0", "gamma1(B, A, toward=(1, 2)) >= 0",
      "eta1(B, C, along=(3, 1)) <= 0",     "eta1(B, C, toward=(-1, 1)) <= 0",  "delta1(C, B, along=(1, -1)) <= 0",
      "gamma1(B, A, toward=(-3, 1)) >= 0",
  };
  const std::array<std::array<double, 2>, 7> directions{{{2, 1}, {-1, 3}, {1, 2}, {3, 1}, {-1, 1}, {1, -1}, {-3, 1}}};
  int met = 0;
  for (std::size_t round = 0; round < 105; ++round) {
    World world;
    world.shapes.emplace("A", shape(random, 14));
    world.shapes.emplace("B", shape(random, 6));
    world.shapes.emplace("C", shape(random, 50));
    world.moving = {"B"};
    world.step = 1;
    Context context;
    context.shapes = {"A", "B", "C"};
    context.moving = {"B"};
    const std::size_t k = round % formulas.size();
    const RealPoint p{Real(std::int64_t(random() % 61) - 30), Real(std::int64_t(random() % 61) - 30)};
    const auto check = Solver(world).check(parse_formula(formulas[k], context), p);
    const DistanceAt& d = check.atoms.at(0).distance;
    if (d.features.empty()) continue;
    ++met;
    const auto& points = d.answer->witness;
    ASSERT_EQ(d.features.size(), 2u);
    ASSERT_EQ(points.size(), 2u);
    const std::string what = std::string(formulas[k]) + " " + std::to_string(round);
    const double dx = (points[1].at[0] - points[0].at[0]).to_double();
    const double dy = (points[1].at[1] - points[0].at[1]).to_double();
    const double length = std::hypot(directions[k][0], directions[k][1]);
    EXPECT_NEAR(std::hypot(dx, dy), std::abs(*d.value()), 1e-9) << what;
    EXPECT_NEAR((dx * directions[k][1] - dy * directions[k][0]) / length, 0, 1e-9) << what;
    for (std::size_t i = 0; i < 2; ++i)
      expect_on(d.features[i], points[i].at, d.features[i].shape == "B" ? p : RealPoint{Real(), Real()}, what);
  }
  EXPECT_GT(met, 50);
}

}  // namespace formula_directional_witness
