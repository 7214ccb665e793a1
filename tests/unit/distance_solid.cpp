// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances of solids in closed form (distances.md 3.11): balls, parallel boxes, a ball and a box, slits and exact
// fits.
#include <gtest/gtest.h>

#include <cmath>

#include "distance/solid/box_maps.h"
#include "distance/solid/fitting_places.h"
#include "distance/solid/solid_pair.h"
#include "findspace/error.h"
#include "space/box/box_topology.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_solid {

using exact::Real;
using space::Body;
using space::box_body;
using space::box_set;
using space::place;
using space::RealVector;

Body ball(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t r) {
  Body b;
  b.parts.push_back({std::nullopt, {x, y, z}, Real(r)});
  return b;
}

double value(const PairDistances& pair, Which which, const RealVector& p) {
  const auto v = pair.value(which, p);
  return v ? v->value.to_double() : INFINITY;
}

/// The signed distance of c to the box of half sizes e, which may be negative.
double box_distance(const std::array<double, 3>& c, const std::array<double, 3>& e) {
  double out = 0, most = -INFINITY;
  for (std::size_t k = 0; k < 3; ++k) {
    const double q = std::fabs(c[k]) - e[k];
    out += std::pow(std::max(q, 0.0), 2);
    most = std::max(most, q);
  }
  return std::sqrt(out) + std::min(most, 0.0);
}

TEST(SolidPairs, NothingAttainsAZeroThatIsCutOff) {
  const PairDistances pair = solid_pair(shared(ball(0, 0, 0, 1)), shared(ball(0, 0, 0, 3)));
  for (const auto& [which, p] : {std::pair{Which::kPenetration, place(9, 0, 0)},
                                 {Which::kDstarBack, place(9, 0, 0)},
                                 {Which::kD1, place(3, 0, 0)},
                                 {Which::kH, place(1, 0, 0)}}) {
    const auto v = pair.value(which, p);
    ASSERT_TRUE(v);
    EXPECT_EQ(v->value.sign(), 0);
    EXPECT_TRUE(v->proven);
    EXPECT_FALSE(v->nearest);
    EXPECT_TRUE(v->witness.empty());
  }
  EXPECT_TRUE(pair.value(Which::kD1, place(9, 0, 0))->nearest);
}

TEST(SolidPairs, Balls) {
  const PairDistances pair = solid_pair(shared(ball(0, 0, 0, 1)), shared(ball(0, 0, 0, 3)));
  for (const auto& [p, d] :
       {std::pair{place(2, 3, 6), 7.0}, {place(0, 0, 0), 0.0}, {place(1, 0, 0), 1.0}, {place(0, 4, 0), 4.0}}) {
    EXPECT_DOUBLE_EQ(value(pair, Which::kGamma1, p), d - 4);
    EXPECT_DOUBLE_EQ(value(pair, Which::kGamma2, p), d + 4);
    EXPECT_DOUBLE_EQ(value(pair, Which::kEta1, p), d - 2);
    EXPECT_DOUBLE_EQ(value(pair, Which::kEta2, p), d + 2);
    EXPECT_EQ(value(pair, Which::kDelta1, p), INFINITY);
    EXPECT_DOUBLE_EQ(value(pair, Which::kMu, p), d - 2);
    EXPECT_DOUBLE_EQ(value(pair, Which::kMuBack, p), d + 2);
    EXPECT_DOUBLE_EQ(value(pair, Which::kHausdorff, p), d + 2);
    EXPECT_DOUBLE_EQ(value(pair, Which::kDiameter, p), std::max(6.0, d + 4));
  }
}

TEST(SolidPairs, ParallelBoxes) {
  // Half sizes (1, 1, 1) in (3, 1, 2): an exact fit along y; in doubled coordinates.
  const PairDistances pair =
      solid_pair(shared(box_body({{{{-1, -1, -1}, {1, 1, 1}}}})), shared(box_body({{{{-3, -1, -2}, {3, 1, 2}}}})));
  for (std::int64_t x = -6; x <= 6; x += 2) {
    for (std::int64_t y = -4; y <= 4; ++y) {
      const std::int64_t z = (x * 3 + y) % 5;
      const RealVector p = place(x, y, z);
      const std::array<double, 3> c{double(x), double(y), double(z)};
      ASSERT_NEAR(value(pair, Which::kGamma1, p), box_distance(c, {4, 2, 3}), 1e-12)
          << x << ' ' << y << ' ' << z;  // no sign: test
      ASSERT_NEAR(value(pair, Which::kEta1, p), box_distance(c, {2, 0, 1}), 1e-12)
          << x << ' ' << y << ' ' << z;                                                  // no sign: test
      ASSERT_NEAR(value(pair, Which::kMu, p), box_distance(c, {2, 0, 1}), 1e-12);        // no sign: test
      ASSERT_NEAR(value(pair, Which::kMuBack, p), box_distance(c, {-2, 0, -1}), 1e-12);  // no sign: test
      ASSERT_NEAR(value(pair, Which::kEta2, p),
                  std::hypot(std::fabs(c[0]) + 2, std::fabs(c[1]) + 0, std::fabs(c[2]) + 1), 1e-12);  // no sign: test
    }
  }
}

TEST(SolidPairs, BallInBox) {
  // Box of half size 3, ball of radius 1: E is the box of half size 2; mu is the box's signed distance plus 1.
  const PairDistances pair = solid_pair(shared(ball(0, 0, 0, 1)), shared(box_body({{{{-3, -3, -3}, {3, 3, 3}}}})));
  for (const std::array<std::int64_t, 3>& q :
       {std::array<std::int64_t, 3>{0, 0, 0}, {5, 5, 1}, {4, 1, 1}, {6, 6, 6}, {2, 2, 2}, {3, 0, 1}}) {
    const RealVector p = place(q[0], q[1], q[2]);
    const std::array<double, 3> c{double(q[0]), double(q[1]), double(q[2])};
    EXPECT_NEAR(value(pair, Which::kGamma1, p), box_distance(c, {3, 3, 3}) - 1, 1e-12);  // no sign: test
    EXPECT_NEAR(value(pair, Which::kEta1, p), box_distance(c, {2, 2, 2}), 1e-12);        // no sign: test
    EXPECT_NEAR(value(pair, Which::kMu, p), box_distance(c, {3, 3, 3}) + 1, 1e-12);      // no sign: test
    const double corner = std::hypot(std::fabs(c[0]) + 3, std::fabs(c[1]) + 3, std::fabs(c[2]) + 3);
    EXPECT_NEAR(value(pair, Which::kGamma2, p), corner + 1, 1e-12);  // no sign: test
    EXPECT_NEAR(value(pair, Which::kMuBack, p), corner - 1, 1e-12);  // no sign: test
  }
}

/// Balls of radius 0, as offset leaves them: they overlap with nothing that has no interior, and nothing fits into them
/// but they themselves.
TEST(SolidPairs, Points) {
  const PairDistances two = solid_pair(shared(ball(1, 2, 3, 0)), shared(ball(1, 2, 3, 0)));
  for (const Which which : {Which::kGamma1, Which::kGamma2, Which::kEta1, Which::kDelta1, Which::kMu}) {
    EXPECT_EQ(two.value(which, place(3, 4, 0))->value, Real(5));
    EXPECT_EQ(two.value(which, place(0, 0, 0))->value, Real(0));
  }
  // A union with a point, in which a box fits into the boxes alone.
  Body rooms = box_body({{{{0, 0, 0}, {4, 4, 4}}}, {{{20, 0, 0}, {24, 4, 4}}}});
  rooms.parts.push_back(ball(10, 1, 1, 0).parts[0]);
  const PairDistances box = solid_pair(shared(box_body({{{{0, 0, 0}, {1, 1, 1}}}})), shared(rooms)),
                      point = solid_pair(shared(ball(0, 0, 0, 0)), shared(rooms));
  EXPECT_EQ(box.value(Which::kEta1, place(10, 1, 1))->value, Real(7));
  EXPECT_EQ(box.value(Which::kGamma1, place(5, 1, 1))->value, Real(1));
  EXPECT_EQ(point.value(Which::kGamma1, place(12, 1, 1))->value, Real(2));
}

/// What is connected lies in one connected piece: that says where it fits, and mostly that it does not, without a look
/// at what the pieces leave free.
TEST(SolidPairs, PiecesFitIntoPieces) {
  // Three rooms; the last one is two boxes that meet in a face.
  const Body rooms = box_body(
      {{{{0, 0, 0}, {4, 4, 4}}}, {{{10, 0, 0}, {14, 4, 4}}}, {{{20, 0, 0}, {23, 4, 4}}}, {{{23, 0, 0}, {29, 4, 4}}}});
  const auto places = [&](const Body& b) { return fitting_places(b, rooms); };
  EXPECT_FALSE(fitting_places(rooms, box_body({{{{0, 0, 0}, {30, 4, 4}}}})));  // one piece
  EXPECT_EQ(places(box_body({{{{0, 0, 0}, {1, 1, 1}}}}))->size(), 3U);
  EXPECT_EQ(places(box_body({{{{0, 0, 0}, {5, 1, 1}}}}))->size(), 1U);
  EXPECT_EQ(places(box_body({{{{0, 0, 0}, {10, 1, 1}}}}))->size(), 0U);
  const Body two = box_body({{{{0, 0, 0}, {2, 2, 2}}}, {{{11, 0, 0}, {13, 2, 2}}}}),
             three = box_body({{{{0, 0, 0}, {2, 2, 2}}}, {{{11, 0, 0}, {13, 2, 2}}}, {{{5, 0, 0}, {7, 2, 2}}}});
  EXPECT_EQ(places(two)->size(), 2U);
  EXPECT_EQ(places(three)->size(), 0U);
  const PairDistances pair = solid_pair(shared(two), shared(rooms));
  EXPECT_EQ(pair.value(Which::kEta1, place(-5, 1, 1))->value, Real(5));
  EXPECT_EQ(pair.value(Which::kEta1, place(8, 1, 1))->value, Real(2));
  EXPECT_FALSE(solid_pair(shared(three), shared(rooms)).value(Which::kEta1, place(0, 1, 1)));
}

/// All of space but a point: a box about it protrudes by nothing.
TEST(SolidPairs, ProtrusionFromTheComplementOfAPoint) {
  Body outside = ball(5, 5, 5, 0);
  outside.outside = true;
  const PairDistances pair = solid_pair(shared(box_body({{{{0, 0, 0}, {4, 4, 4}}}})), shared(outside));
  const auto within = pair.value(Which::kMu, place(2, 3, 2));
  ASSERT_TRUE(within);
  EXPECT_EQ(within->value, Real(0));
  EXPECT_EQ(pair.value(Which::kMu, place(7, 2, 2))->value, Real(-2));
}

TEST(SolidPairs, BallCoversBox) {
  // delta1 of a ball about a box: |p| + a to the far corner, less the radius, where it covers.
  const PairDistances pair = solid_pair(shared(ball(0, 0, 0, 9)), shared(box_body({{{{-4, -4, -4}, {4, 4, 4}}}})));
  EXPECT_NEAR(value(pair, Which::kDelta1, place(1, 0, 0)), std::hypot(5, 4, 4) - 9, 1e-12);  // no sign: test
  EXPECT_NEAR(value(pair, Which::kDelta1, place(0, 0, 0)), std::sqrt(48) - 9, 1e-12);        // no sign: test
  // Outside: the projection on one sphere would leave the octant, so the nearest point of the lens lies on four at
  // once.
  const double reach = std::sqrt(81 - 32) - 4;
  EXPECT_NEAR(value(pair, Which::kDelta1, place(20, 0, 0)), 20 - reach, 1e-12);  // no sign: test
  EXPECT_NEAR(value(pair, Which::kDelta2, place(20, 0, 0)), 20 + reach, 1e-12);  // no sign: test
  const PairDistances exact = solid_pair(shared(ball(0, 0, 0, 7)), shared(box_body({{{{-6, -3, -2}, {6, 3, 2}}}})));
  EXPECT_EQ(exact.value(Which::kDelta1, place(0, 0, 0))->value.sign(), 0);
  EXPECT_NEAR(value(exact, Which::kDelta1, place(3, 4, 12)), 13, 1e-12);  // no sign: test
}

TEST(SolidPairs, DepthInAUnionOfBalls) {
  // Positions: two balls of radius 5 with centres 6 apart; from the middle the nearest free position is on the circle
  // of radius 4.
  Body two = ball(-3, 0, 0, 4);
  two.parts.push_back({std::nullopt, {3, 0, 0}, Real(4)});
  const PairDistances pair = solid_pair(shared(ball(0, 0, 0, 1)), shared(std::move(two)));
  EXPECT_NEAR(value(pair, Which::kGamma1, place(0, 0, 0)), -4, 1e-12);              // no sign: test
  EXPECT_NEAR(value(pair, Which::kGamma1, place(0, 3, 0)), -1, 1e-12);              // no sign: test
  EXPECT_NEAR(value(pair, Which::kGamma1, place(-3, 0, 0)), -5, 1e-12);             // no sign: test
  EXPECT_NEAR(value(pair, Which::kGamma1, place(1, 0, 0)), -std::sqrt(17), 1e-12);  // no sign: test
  EXPECT_NEAR(value(pair, Which::kGamma1, place(6, 0, 0)), -2, 1e-12);              // no sign: test
  EXPECT_EQ(pair.value(Which::kGamma1, place(0, 0, 4))->value.sign(), 0);
}

TEST(SolidPairs, ChannelOfExactWidth) {
  const std::vector<space::Corners> channel{
      {{{0, 0, 0}, {1, 6, 4}}}, {{{2, 0, 0}, {3, 6, 4}}}, {{{0, 0, -1}, {3, 6, 0}}}};
  const PairDistances pair = solid_pair(shared(box_body({{{{0, 0, 0}, {1, 2, 2}}}})), shared(box_body(channel)));
  EXPECT_EQ(pair.value(Which::kGamma1, place(1, 2, 1))->value.sign(), 0);
  EXPECT_EQ(pair.value(Which::kGamma1, place(1, 2, 0))->value.sign(), 0);
  EXPECT_DOUBLE_EQ(value(pair, Which::kGamma1, place(3, 4, 4, 2)), -0.5);
  EXPECT_DOUBLE_EQ(value(pair, Which::kGamma1, place(1, 2, 6)), 2);
}

TEST(SolidPairs, RoomsWithSheetsLinesAndPoints) {
  const std::vector<space::Corners> rooms{
      {{{0, 0, 0}, {4, 4, 4}}}, {{{4, 1, 1}, {7, 3, 2}}}, {{{-3, 1, 1}, {0, 2, 2}}}, {{{10, 0, 0}, {11, 1, 1}}}};
  const PairDistances pair = solid_pair(shared(box_body({{{{0, 0, 0}, {1, 1, 1}}}})), shared(box_body(rooms)));
  EXPECT_DOUBLE_EQ(value(pair, Which::kEta1, place(-20, 13, 14, 10)), 0.5);
  EXPECT_EQ(pair.value(Which::kEta1, place(10, 0, 0))->value.sign(), 0);
  EXPECT_EQ(pair.value(Which::kEta1, place(-5, 2, 2, 2))->value.sign(), 0);
  EXPECT_DOUBLE_EQ(value(pair, Which::kEta1, place(9, 0, 0)), 1);
  EXPECT_DOUBLE_EQ(value(pair, Which::kEta1, place(1, 1, 1)), -1);
  EXPECT_DOUBLE_EQ(value(pair, Which::kEta2, place(0, 0, 0)), 10);  // the single point is the farthest
}

TEST(SolidPairs, DirectedHausdorffInsideAHole) {
  // A square tube of inner width 4 and a bar that fills it: the axis is 2 away from the wall, at no vertex of the bar.
  const std::vector<space::Corners> tube{{{{-4, -4, 0}, {-2, 4, 20}}},
                                         {{{2, -4, 0}, {4, 4, 20}}},
                                         {{{-2, -4, 0}, {2, -2, 20}}},
                                         {{{-2, 2, 0}, {2, 4, 20}}}};
  const PairDistances pair = solid_pair(shared(box_body({{{{-3, -3, 5}, {3, 3, 9}}}})), shared(box_body(tube)));
  EXPECT_NEAR(value(pair, Which::kMu, place(0, 0, 0)), 2, 1e-11);  // no sign: test
  EXPECT_NEAR(value(pair, Which::kMu, place(0, 0, 14)), std::sqrt(13),
              1e-11);  // no sign: test (on the axis, 3 above the tube)
}

TEST(BoxMaps, AgreesOnSlitsAndUnboundedShapes) {
  const BoxMaps channel(box_set({{{{0, 0, 0}, {1, 2, 2}}}}),
                        box_set({{{{0, 0, 0}, {1, 6, 4}}}, {{{2, 0, 0}, {3, 6, 4}}}, {{{0, 0, -1}, {3, 6, 0}}}}));
  EXPECT_EQ(channel.distances().value(Which::kGamma1, place(1, 2, 1))->value.sign(), 0);
  EXPECT_DOUBLE_EQ(channel.distances().value(Which::kGamma1, place(3, 4, 4, 2))->value.to_double(), -0.5);
  // Everything outside a room of 4: gamma1 is minus eta1 of the room, and minus infinity for what does not fit in.
  const space::BoxComplex walls = closure(complement(box_set({{{{0, 0, 0}, {4, 4, 4}}}})));
  const BoxMaps fits(box_set({{{{0, 0, 0}, {1, 1, 1}}}}), walls), large(box_set({{{{0, 0, 0}, {5, 1, 1}}}}), walls);
  EXPECT_DOUBLE_EQ(fits.distances().value(Which::kGamma1, place(1, 1, 1))->value.to_double(), 1);
  EXPECT_DOUBLE_EQ(fits.distances().value(Which::kGamma1, place(-2, 1, 1))->value.to_double(), -2);
  EXPECT_TRUE(large.distances().value(Which::kGamma1, place(1, 1, 1))->minus_infinity);
}

TEST(BoxMaps, LeastValuesAndLevelsOfBoxes) {
  const BoxMaps pair(box_set({{{{0, 0, 0}, {1, 1, 1}}}}), box_set({{{{0, 0, 0}, {5, 3, 9}}}}));
  const auto least = pair.least(Which::kEta1).or_throw();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->value, Real(-1));  // E is 4 x 2 x 8
  EXPECT_EQ(least->at.mark(place(1, 1, 7)), 1);
  EXPECT_EQ(least->at.mark(place(3, 1, 1)), 1);
  EXPECT_EQ(least->at.mark(place(4, 1, 1)), 0);
  const space::BoxComplex map = *pair.sign_map(Which::kEta1, Real::ratio(-1, 2));
  EXPECT_EQ(map.mark(place(1, 1, 1)), -1);
  EXPECT_EQ(map.mark(place(1, 2, 2, 2)), 0);
  EXPECT_EQ(map.mark(place(0, 1, 1)), 1);
  EXPECT_FALSE(pair.sign_map(Which::kGamma1, Real(1)));
}

/// The sum has 4000 coordinates on each of two axes.
TEST(BoxMaps, RefusesWhatIsTooFine) {
  const auto squares = [](int count, int apart, int side) {
    std::vector<space::IntervalBox> boxes;
    for (int k = 0; k < count; ++k) {
      const space::Interval i{Real(apart * k), Real(apart * k + side), true, true};
      boxes.push_back({{i, i, {Real(0), Real(1), true, true}}});
    }
    return space::BoxComplex::of_boxes(boxes);
  };
  const BoxMaps pair(squares(20, 7, 3), squares(100, 1000, 500));
  EXPECT_FALSE(pair.sign_map(Which::kGamma1, Real()));
  EXPECT_FALSE(pair.distances().try_value(Which::kGamma1, place(0, 0, 0)));
  EXPECT_FALSE(pair.distances().try_value(Which::kGamma2, place(0, 0, 0)));
  EXPECT_FALSE(pair.least(Which::kGamma1));
  EXPECT_FALSE(pair.directional_map(Which::kGamma1, Real(1), 0, 0));
  EXPECT_FALSE(pair.directional_least(Which::kGamma1, 0, 0));
}

/// Rooms joined by a door that is too low: separate boxes of positions, which levels shrink one by one.
TEST(BoxMaps, LevelsOfSeparateBoxes) {
  const auto cube = box_set({{{{0, 0, 0}, {1, 1, 1}}}});
  const auto rooms = box_set({{{{0, 0, 0}, {4, 4, 4}}}, {{{4, 1, 1}, {6, 3, 2}}}, {{{6, 0, 0}, {12, 6, 3}}}});
  const BoxMaps pair(cube, rooms);
  const space::BoxComplex map = *pair.sign_map(Which::kEta1, Real(-1));
  // The rooms' positions are [0, 3]^3 and [6, 11] x [0, 5] x [0, 2].
  EXPECT_EQ(map.mark(place(3, 3, 3, 2)), -1);
  EXPECT_EQ(map.mark(place(1, 1, 1)), 0);
  EXPECT_EQ(map.mark(place(8, 3, 1)), 0);
  EXPECT_EQ(map.mark(place(16, 6, 3, 2)), 1);
  EXPECT_EQ(map.mark(place(5, 1, 1)), 1);
  const auto least = pair.least(Which::kEta1).or_throw();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->value, Real::ratio(-3, 2));
  EXPECT_EQ(least->at.mark(place(3, 3, 3, 2)), 1);
  EXPECT_EQ(least->at.mark(place(8, 3, 1)), 0);
  // Where a slit parts them they are separate, too; where they are one L they are not boxes.
  const BoxMaps slit(cube, box_set({{{{0, 0, 0}, {2, 4, 4}}}, {{{3, 0, 0}, {7, 4, 4}}}}));
  EXPECT_EQ(slit.sign_map(Which::kGamma1, Real(-1))->mark(place(2, 2, 2)), 1);
  EXPECT_EQ(slit.sign_map(Which::kGamma1, Real(-1))->mark(place(1, 3, 3, 2)), -1);
  const BoxMaps bent(cube, box_set({{{{0, 0, 0}, {6, 3, 3}}}, {{{0, 0, 0}, {3, 6, 3}}}}));
  EXPECT_FALSE(bent.sign_map(Which::kEta1, Real(-1)));
  EXPECT_FALSE(bent.least(Which::kEta1).or_throw());
}

}  // namespace distance_solid
}  // namespace findspace::distance
