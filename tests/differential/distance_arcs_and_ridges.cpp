// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// mu both ways and hausdorff where an arc decides, against the sign maps: a little below the value the map is + at the
// position, a little above it is -. The maps search for no place; they grow one shape and look where the other stays in
// it. A is made of unit cells, with reflex corners, slits and holes; B is round or has rounded corners. Positions are
// anywhere, or put an arc's far side near a place where the ridge of the distance to A between two edges bends because
// one of them ends: there the arc crosses the ridge of the two lines as well, beside the true place and at a lower
// value.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "distance/planar/at_position.h"
#include "plane/build/path_region.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"
#include "unit/distance_shapes.h"

namespace findspace::distance {
namespace distance_arcs_and_ridges {

using exact::Real;
using exact::RealPoint;
using plane::Region;

constexpr int kUnit = 64;                 // grid steps a cell
constexpr double kMargin = 1e-9 * kUnit;  // of a level; farther than this the value must not be off
constexpr std::array kSides{Which::kMu, Which::kMuBack, Which::kHausdorff};

Region box(int x0, int y0, int x1, int y1) { return testing::box(x0 * kUnit, y0 * kUnit, x1 * kUnit, y1 * kUnit); }
Region cell(int x, int y) { return box(x, y, x + 1, y + 1); }

class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Region cells(int side, int percent) {
    std::vector<Region> boxes{cell(number(0, side - 1), number(0, side - 1))};
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y)
        if (number(0, 99) < percent) boxes.push_back(cell(x, y));
    std::vector<const Region*> all;
    for (const Region& b : boxes) all.push_back(&b);
    return plane::unite(all);
  }
  /// Cells grown by half a cell, or a disc about the origin.
  Region rounded(int radius) {
    const Region disc = plane::region_of_disc(0, 0, radius);
    return number(0, 1) ? disc : plane::minkowski_sum(cells(2, 40), disc);
  }
  RealPoint anywhere() {
    return {Real::ratio(number(-100, 500) * kUnit, 100), Real::ratio(number(-100, 500) * kUnit, 100)};
  }
  /// A block without its lower right corner; the reflex corner is at (x, y).
  Region notched(int x, int y) {
    const std::vector<Region> boxes{box(0, y, 6, 6), box(0, 0, x, y)};
    const std::vector<const Region*> both{&boxes[0], &boxes[1]};
    return plane::unite(both);
  }
  /// Of a disc about the origin, such that its far side is near the place where the notch's ridge bends.
  RealPoint near_the_bend(int x, int y, int radius) {
    const double angle = number(-70, -20) * std::numbers::pi / 180;
    const int reach = std::min(6 - x, y);
    const auto place = [&](double bend, double d) {
      return Real::from_double(bend * kUnit - d * radius + number(-60, 60) * 1e-4 * kUnit);
    };
    return {place(x + reach, std::cos(angle)), place(y - reach, std::sin(angle))};
  }

 private:
  std::mt19937 random_;
};

/// The value lies within the margin of the level at which the position's sign changes.
void expect_between(const AtPosition& pair, Which which, const RealPoint& p) {
  const auto m = pair.measure(which, p);
  ASSERT_TRUE(m);
  const auto family = pair.pair().distance(which);
  const auto sign = [&](double by) { return testing::sign_at(family->sign_map(m->value + Real::from_double(by)), p); };
  EXPECT_EQ(sign(-kMargin), 1) << "too large: " << m->value.to_double() / kUnit;
  EXPECT_EQ(sign(kMargin), -1) << "too small: " << m->value.to_double() / kUnit;
}

void expect_all_between(const AtPosition& pair, const RealPoint& p) {
  for (const Which which : kSides) {
    SCOPED_TRACE(::testing::Message() << "which " << int(which));
    expect_between(pair, which, p);
  }
}

TEST(ArcsAndRidges, ValuesLieWhereTheMapsChange) {
  Scenes random(31);
  for (int round = 0; round < 30; ++round) {
    const Region b = random.rounded(random.number(1, 3) * kUnit / 2);
    const AtPosition pair(std::make_shared<ShapePair>(b, random.cells(5, 60)));
    for (int i = 0; i < 2; ++i) {
      SCOPED_TRACE(::testing::Message() << "round " << round << ", position " << i);
      expect_all_between(pair, random.anywhere());
    }
  }
}

TEST(ArcsAndRidges, BesideABend) {
  Scenes random(32);
  for (int round = 0; round < 60; ++round) {
    const int radius = random.number(1, 3) * kUnit / 2, x = random.number(3, 5), y = random.number(1, 3);
    const Region disc = plane::region_of_disc(0, 0, radius);
    const AtPosition pair(std::make_shared<ShapePair>(disc, random.notched(x, y)));
    SCOPED_TRACE(::testing::Message() << "round " << round);
    expect_all_between(pair, random.near_the_bend(x, y, radius));
  }
}

/// The search goes on from where it was coarse: a search that is fine from the beginning finds no place that is
/// farther.
TEST(ArcsAndRidges, NoPlaceIsFartherThanTheFarthest) {
  const std::array<RealPoint, 3> chain{testing::at(24, 25), testing::at(30, 15), testing::at(10, 16)};
  const Region disc = plane::region_of_disc(0, 0, 12), path = plane::region_of_path(chain);
  const FarthestFromSet search(disc, path);
  const AtPosition pair(std::make_shared<ShapePair>(disc, path));
  for (int x = -4; x < 40; x += 3)
    for (int y = 3; y < 40; y += 4) {
      const auto value = pair.measure(Which::kMu, testing::at(x, y))->value.to_double();
      const auto max_mins = search.max_mins(x, y, 1e-9, 0, {0x1p-44});
      ASSERT_FALSE(max_mins.empty());
      EXPECT_NEAR(value, max_mins[0].value, 1e-11) << x << ", " << y;
    }
}

}  // namespace distance_arcs_and_ridges
}  // namespace findspace::distance
