// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "exact/planar/angle.h"

namespace findspace::exact {
namespace exact_angle {

Real decimal(const char* text) { return Real::parse_decimal(text); }

const ExactAngle kThirty{sqrt(Real(3)) / Real(2), Real::ratio(1, 2)};
const ExactAngle kSixty = kThirty + kThirty;

TEST(Angle, RationalDegreesAreRecognised) {
  const ExactAngle eighth{sqrt(Real::ratio(1, 2)), sqrt(Real::ratio(1, 2))};
  const ExactAngle sixteenth{sqrt(Real(2) + sqrt(Real(2))) / Real(2), sqrt(Real(2) - sqrt(Real(2))) / Real(2)};
  EXPECT_EQ(compare(Angle{kThirty, {}}, Angle::of_degrees(30)), 0);
  EXPECT_EQ(compare(Angle{kSixty, {}}, Angle::of_degrees(780)), 0);
  EXPECT_EQ(compare(Angle{-eighth, {}}, Angle::of_degrees(-45)), 0);
  EXPECT_EQ(compare(Angle{sixteenth, {}}, Angle::of_degrees(decimal("22.5"))), 0);
  EXPECT_EQ(compare(Angle{{0, -1}, {}}, Angle::of_degrees(270)), 0);
  EXPECT_EQ(compare(Angle{kThirty, Real(15)}, Angle{eighth, {}}), 0);
}

TEST(Angle, OrderIsExactHoweverClose) {
  const Angle sixty{kSixty, {}};
  EXPECT_EQ(compare(Angle::of_degrees(decimal("59.99999999999999999999")), sixty), -1);
  EXPECT_EQ(compare(Angle::of_degrees(decimal("60.00000000000000000001")), sixty), 1);
  const Angle odd{{Real::ratio(3, 5), Real::ratio(4, 5)}, {}};  // no rational number of degrees
  EXPECT_NE(compare(odd, Angle::of_degrees(decimal("53.13010235415598"))), 0);
  EXPECT_EQ(compare(odd + Real(10), odd + Real(370)), 0);
  EXPECT_EQ(compare(odd + decimal("1e-20"), odd), 1);
}

TEST(Angle, ManyDegreesAreTheirRemainder) {
  const char* contact = "16.260204708312";  // the next digits do not matter: the others differ by 1e-8 and more
  EXPECT_EQ(compare(Angle::of_degrees(decimal("999999736.2602047205")), Angle::of_degrees(decimal(contact))), 1);
  EXPECT_EQ(compare(Angle::of_degrees(decimal("-1000000063.7397952795")), Angle::of_degrees(decimal(contact))), 1);
  EXPECT_EQ(compare(Angle::of_degrees(decimal("99999999999999736")), Angle::of_degrees(16)), 0);
  EXPECT_NEAR(Angle::of_degrees(decimal("99999999999999736.25")).degrees(), 16.25, 1e-12);
  EXPECT_NEAR((Angle{kThirty, {}} + decimal("36e30")).degrees(), 30, 1e-12);
}

TEST(Angle, PlacesNearZero) {
  EXPECT_LT(Angle::of_degrees(decimal("1e-30")).degrees(), 1);
  EXPECT_GT(Angle::of_degrees(decimal("-1e-30")).degrees(), 359);
  EXPECT_EQ(compare(Angle::of_degrees(360), Angle{}), 0);
  EXPECT_EQ(compare(Angle::of_degrees(decimal("-1e-30")), Angle{}), 1);
}

TEST(Angle, SolvesForRotations) {
  EXPECT_EQ(rotations_where(0, 0, 0).size(), 0u);
  EXPECT_EQ(rotations_where(3, 4, 6).size(), 0u);
  const auto touching = rotations_where(3, 4, 5);
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].cos, Real::ratio(3, 5));
  for (const ExactAngle& t : rotations_where(2, -1, 1)) EXPECT_EQ(Real(2) * t.cos - t.sin, Real(1));
  EXPECT_EQ(rotations_where(2, -1, 1).size(), 2u);
}

TEST(Angle, BetweenIsStrictlyBetween) {
  for (const auto& [from, to] : {std::pair{10, 20}, {350, 10}, {20, 10}, {0, 180}, {90, 90}}) {
    const ExactAngle p = ExactAngle::near(from, 30), q = ExactAngle::near(to, 30), m = between(p, q);
    EXPECT_EQ(m.cos * m.cos + m.sin * m.sin, Real(1));
    const double way = (m + -p).degrees(), whole = (q + -p).degrees();
    EXPECT_GT(way, 0);
    if (from != to) {
      EXPECT_LT(way, whole);
    }
  }
}

/// A turn by about 2^-bits, in radians.
ExactAngle tiny(int bits) {
  const Real t = Real::ratio(1, int128(1) << (bits + 1)), below = Real(1) + t * t;
  return {(Real(1) - t * t) / below, (t + t) / below};
}

TEST(Angle, BetweenWhereDoublesTellNoWay) {
  for (const int bits : {40, 52, 60, 100}) {
    const ExactAngle p = ExactAngle::near(33, 20), q = p + tiny(bits), m = between(p, q);
    EXPECT_EQ((m + -p).sin.sign(), 1);
    EXPECT_EQ((q + -m).sin.sign(), 1);
    EXPECT_NEAR((between(q, p) + -p).degrees(), 180, 30) << bits;  // the rest of the circle
  }
}

TEST(Angle, TheWayToTheNextIsNotTheWholeCircle) {
  for (const double place : {0.0, 33.0, 180.0, 359.0}) {
    for (const int bits : {20, 52, 60, 100}) {
      const ExactAngle start = ExactAngle::near(place, 20);
      for (const ExactAngle& t : {start, start + tiny(bits), start + -tiny(bits)}) {
        const Angle p{t, {}}, q{t + tiny(bits), {}}, r{q.rotation, Real(90)};
        EXPECT_LT(way(p, q), 1e-4);
        EXPECT_GT(way(q, p), 359.9);
        EXPECT_NEAR(way(p, r), 90, 1e-4);
        EXPECT_NEAR(way(r, p), 270, 1e-4);
        EXPECT_EQ(way(q, q), 0);
      }
    }
  }
}

}  // namespace exact_angle
}  // namespace findspace::exact
