// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// mu both ways and hausdorff of round shapes, against the sign maps at the value itself: where the value is exact the
// position has sign 0 there, where it is enclosed its sign is + at the lower end and - at the upper one, or 0. The maps
// search for no place: they grow one shape and look where the other stays in it. Positions are anywhere, and beside
// those at which an arc just protrudes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "distance/planar/at_position.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"
#include "unit/distance_shapes.h"

namespace findspace::distance {
namespace distance_arcs_exact {

using exact::Real;
using exact::RealPoint;
using plane::Region;

constexpr int kUnit = 64;  // grid steps a cell

class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  Region polygon() {
    const int x = number(-4, 4) * kUnit / 2, y = number(-4, 4) * kUnit / 2;
    const auto corner = [&](int low, int high) { return number(low, high) * kUnit / 4; };
    return testing::polygon({{x, y}, {x + corner(4, 12), y + corner(-3, 3)}, {x + corner(1, 9), y + corner(4, 12)}});
  }
  /// One or two triangles, perhaps grown by a disc, perhaps with a round hole.
  Region shape(bool round) {
    Region out = polygon();
    if (number(0, 1) != 0) {
      const Region other = polygon();
      const std::array<const Region*, 2> both{&out, &other};
      out = plane::unite(both);
    }
    if (round && number(0, 2) != 0)
      out = plane::minkowski_sum(out, plane::region_of_disc(0, 0, number(1, 4) * kUnit / 4));
    if (round && number(0, 2) == 0) {
      const Region hole =
          plane::region_of_disc(number(-2, 4) * kUnit / 2, number(-2, 4) * kUnit / 2, number(2, 5) * kUnit / 4);
      const std::array<const Region*, 2> both{&out, &hole};
      out = plane::closure(plane::subtract(both));
    }
    return out;
  }
  Region round_part() {
    const Region disc = plane::region_of_disc(0, 0, number(1, 6) * kUnit / 4);
    return number(0, 2) == 0 ? plane::minkowski_sum(polygon(), disc) : disc;
  }
  RealPoint anywhere() {
    return {Real::ratio(number(-300, 400) * kUnit, 100), Real::ratio(number(-300, 400) * kUnit, 100)};
  }

 private:
  std::mt19937 random_;
};

/// Of the sign map of the distance at the level.
int sign(const AtPosition& pair, Which which, const Real& level, const RealPoint& p) {
  return testing::sign_at(pair.pair().distance(which)->sign_map(level), p);
}

/// Counts the exact and the enclosed values.
struct Seen {
  int exact = 0, enclosed = 0;
};

void expect_true(const AtPosition& pair, Which which, const RealPoint& p, Seen& seen) {
  const auto m = pair.measure(which, p);
  if (!m || m->minus_infinity) return;
  if (m->proven) {
    ++seen.exact;
    EXPECT_EQ(sign(pair, which, m->value, p), 0) << m->value.to_double() / kUnit;
    return;
  }
  ++seen.enclosed;
  const Enclosure e = m->bounds();
  EXPECT_GE(sign(pair, which, *e.lower, p), 0) << "too large: " << e.lower->to_double() / kUnit;
  EXPECT_LE(sign(pair, which, *e.upper, p), 0) << "too small: " << e.upper->to_double() / kUnit;
  EXPECT_LE((*e.upper - *e.lower).to_double(), 1e-9 * kUnit);
}

TEST(ArcsExact, ValuesAreThoseOfTheMaps) {
  Scenes random(41);
  Seen seen;
  for (int round = 0; round < 120; ++round) {
    const Region a = random.shape(round % 2 != 0);
    const AtPosition pair(std::make_shared<ShapePair>(random.round_part(), a));
    const RealPoint p = random.anywhere();
    for (const Which which : {Which::kMu, Which::kMuBack, Which::kHausdorff}) {
      SCOPED_TRACE(::testing::Message() << "round " << round << ", which " << int(which));
      expect_true(pair, which, p, seen);
    }
  }
  EXPECT_GT(seen.exact, 200);
  EXPECT_GT(seen.enclosed, 0);
}

/// A disc that protrudes by 1e-3 to 1e-9 of a unit from a slanted edge.
TEST(ArcsExact, BesideAContact) {
  Scenes random(42);
  Seen seen;
  for (int round = 0; round < 150; ++round) {
    const Region a = random.shape(round % 2 != 0);
    const AtPosition pair(std::make_shared<ShapePair>(random.round_part(), a));
    const RealPoint p = random.anywhere();
    const auto margin = pair.measure(Which::kEta1, p);
    if (!margin || margin->minus_infinity || !margin->nearest) continue;
    const Real by = Real::from_double(std::ldexp(1.0, -random.number(4, 30)));
    const RealPoint q{margin->nearest->x + by * (p.x - margin->nearest->x),
                      margin->nearest->y + by * (p.y - margin->nearest->y)};
    const RealPoint rounded{Real::from_double(q.x.to_double()), Real::from_double(q.y.to_double())};
    SCOPED_TRACE(::testing::Message() << "round " << round);
    expect_true(pair, Which::kMu, rounded, seen);
  }
  EXPECT_GT(seen.exact, 20);
}

}  // namespace distance_arcs_exact
}  // namespace findspace::distance
