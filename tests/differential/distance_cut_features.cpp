// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The features of a solid that balls are cut out of tell what a search finds, at points and on stretches of lines.
#include <gtest/gtest.h>

#include "distance/csg/csg_features.h"
#include "distance/csg/csg_part.h"
#include "unit/cut_cases.h"

namespace findspace::distance {
namespace distance_cut_features {

using exact::Real;

constexpr double kSize = 100;

ShapePtr plate(std::int64_t radius, std::int64_t thick) {
  std::vector<ShapePtr> all{box({0, 0, -thick}, {60, 60, thick})};
  for (std::int64_t i = 0; i < 3; ++i) {
    for (std::int64_t j = 0; j < 3; ++j) all.push_back(space::ball({10 + 20 * i, 10 + 20 * j, 1}, radius));
  }
  return space::node(plane::Shape::Kind::kDifference, std::move(all));
}

std::vector<ShapePtr> solids() {
  std::vector<ShapePtr> out{plate(9, 5), plate(9, 12), plate(12, 5)};  // pierced; with voids; holes that meet
  for (const Case& c : cases()) out.push_back(c.shape);
  return out;
}

/// Those that have features.
template <class Look>
int each_part(const ShapePtr& shape, const Look& look) {
  int count = 0;
  const space::CsgSolid solid = space::csg_solid(*shape);
  for (const space::CsgPart& part : solid.parts) {
    const auto features = CsgFeatures::of(part, kSize);
    if (!features) continue;
    ++count;
    look(*features, csg_part_search(part, kSize));
  }
  return count;
}

double searched(const CsgPartSearch& part, const Vector& x) {
  return part.places.nearest_to(distance_to_point(x), {}).value;
}

TEST(CsgFeatures, TellTheDistanceThatASearchFinds) {
  std::mt19937 random(3);
  int told = 0, asked = 0, near = 0, parts = 0;
  for (const ShapePtr& shape : solids()) {
    parts += each_part(shape, [&](const CsgFeatures& features, const CsgPartSearch& part) {
      for (int k = 0; k < 60; ++k) {
        const Vector x = any(random, 40);
        const auto found = features.nearest({x, {1, 0, 0}, 0, 0}, {});
        ++asked;
        if (!found) continue;
        ++told;
        near += found->high > 0 && found->high < 10;
        EXPECT_NEAR(found->high, searched(part, x), 1e-9);
        EXPECT_LE(found->low, found->high);
        EXPECT_NEAR(space::length(found->place - x), found->high, 1e-12);
      }
    });
  }
  EXPECT_GT(told, asked * 9 / 10);
  EXPECT_GT(near, 40);
  EXPECT_GE(parts, 8);
}

TEST(CsgFeatures, TellTheCentreOfAHole) {
  const int parts = each_part(plate(9, 12), [](const CsgFeatures& features, const CsgPartSearch&) {
    const auto found = features.nearest({{10, 10, 1}, {1, 0, 0}, 0, 0}, {});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->high, 9, 1e-12);
  });
  EXPECT_EQ(parts, 1);
}

TEST(CsgFeatures, TellWhetherAStretchIsBeyondALevel) {
  std::mt19937 random(4);
  constexpr double kLevel = 3, kLong = 12;
  int beyond = 0, within = 0;
  for (const ShapePtr& shape : solids()) {
    each_part(shape, [&](const CsgFeatures& features, const CsgPartSearch& part) {
      for (int k = 0; k < 20; ++k) {
        const Vector start = any(random, 30), way = any(random, 1), unit = space::scaled(1 / space::length(way), way);
        const auto found = features.nearest({start, unit, 0, kLong}, {kLevel, 0, 1e-9});
        if (!found) continue;
        if (found->high < kLevel) {
          ++within;
          EXPECT_LT(part.places.beyond(found->place), 1e-9);
          const double t = std::clamp(space::dot(found->place - start, unit), 0.0, kLong);
          EXPECT_NEAR(space::length(found->place - space::plus(start, space::scaled(t, unit))), found->high, 1e-12);
        }
        if (!(found->low > kLevel)) continue;
        ++beyond;
        for (int i = 0; i <= 4; ++i) {
          const Vector x = space::plus(start, space::scaled(kLong * i / 4, unit));
          EXPECT_GE(searched(part, x), found->low - 1e-9);
        }
      }
    });
  }
  EXPECT_GT(beyond, 20);
  EXPECT_GT(within, 20);
}

TEST(CsgFeatures, AreNoneOfSurfacesThatNearlyTouch) {
  using Kind = plane::Shape::Kind;
  const auto all_have = [](const ShapePtr& shape) {
    const space::CsgSolid solid = space::csg_solid(*shape);
    return std::all_of(solid.parts.begin(), solid.parts.end(),
                       [](const space::CsgPart& part) { return CsgFeatures::of(part, 1e6) != nullptr; });
  };
  const ShapePtr block = box({-500000, -500000, -500000}, {500000, 500000, 500000});
  const auto less_ball = [&](std::int64_t radius) {
    return space::node(Kind::kDifference, {block, space::ball({0, 0, 0}, radius)});
  };
  EXPECT_TRUE(all_have(less_ball(500000)));  // it touches
  EXPECT_FALSE(all_have(less_ball(500001)));
  EXPECT_TRUE(all_have(less_ball(510000)));
}

}  // namespace distance_cut_features
}  // namespace findspace::distance
