// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <findspace/error.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "distance/rotation/motion_maps.h"
#include "distance/rotation/rated_gap.h"
#include "distance/rotation/rotated_pair.h"
#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/rotation_least.h"
#include "distance/rotation/rotation_motion.h"
#include "distance/rotation/rotational_by_position.h"
#include "distance/rotation/squared_bound.h"
#include "distance_shapes.h"
#include "plane/base/parallel.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

namespace findspace::distance {
namespace distance_rotation_motion {

using namespace findspace::testing;
using exact::Real;
using plane::Region;

/// Turning about the origin on the spot.
std::vector<RotatingPose> turning(int from, int to) { return {{{}, Real(from), Real()}, {{}, Real(to), Real()}}; }

/// All instants looked at are whole turns, where the bar fits; between them a dent in the disc is in its way.
TEST(RotatingMotion, ABoundAboveZeroOfTheGreatestEta1IsNone) {
  const Region disc = plane::region_of_disc(0, 0, 100000),
               dent = polygon({{54000, 72000}, {66160, 87880}, {65840, 88120}}), bar = box(-99999, -440, 99999, 440);
  const std::array<const Region*, 2> both{&disc, &dent};
  const RotatingMotion f(bar, plane::closure(plane::subtract(both)), Which::kEta1, turning(0, 360 << 14));
  const auto v = f.extremum({}, Sense::kMaximum);
  ASSERT_TRUE(v);
  EXPECT_EQ(v->high, INFINITY);
}

/// The square of half side 2 in a square room whose half side is `half`, in walls of 20.
Region room(std::int64_t half) {
  constexpr std::int64_t kWall = 20'000'000;
  return polygon({{-kWall, -kWall}, {kWall, -kWall}, {kWall, kWall}, {-kWall, kWall}},
                 {{{-half, -half}, {-half, half}, {half, half}, {half, -half}}});
}
const Region kSquare = box(-2'000'000, -2'000'000, 2'000'000, 2'000'000);

/// No instant that is looked at is that of angle 0, the only one at which the square is free: elsewhere it has to leave
/// the walls altogether.
TEST(RotatingMotion, ASquareFitsItsRoomAtOneInstant) {
  const RotatingMotion gap(kSquare, room(2'000'000), Which::kGamma1, turning(-7, 10));
  const auto most = gap.extremum({}, Sense::kMaximum);
  ASSERT_TRUE(most);
  EXPECT_GE(most->high, 0);
  EXPECT_LE(most->low, 0);
  const RotatingMotion depth(kSquare, room(2'000'000), Which::kPenetration, turning(-7, 10));
  EXPECT_EQ(depth.extremum({}, Sense::kMinimum)->low, 0);
  const auto maps = [](Which which, Sense sense) {
    return motion_maps(kSquare, room(2'000'000), which, turning(-7, 10), sense, Real());
  };
  EXPECT_GE(sign_at(maps(Which::kGamma1, Sense::kMaximum).high, at(0, 0)), 0);
  EXPECT_LE(sign_at(maps(Which::kPenetration, Sense::kMinimum).low, at(0, 0)), 0);
}

/// At 52 degrees a corner passes the wall at 3 steps, and the search that is content with 10,000 stops. At 90 degrees
/// two opposite corners are a step longer than the room: there the shape has to leave the walls altogether.
TEST(RotatingMotion, TheLeastGapMayLieFarBelowWhatIsLookedAt) {
  constexpr double kEnough = 10'000, kDepth = 20e6;
  const Region walls = room(2'800'000),
               tight = polygon({{2'800'001, 0}, {-1'723'850, 2'206'428}, {-2'800'000, 0}, {-342'020, -939'693}});
  const RotatingMotion gap(tight, walls, Which::kGamma1, turning(22, 102)),
      depth(tight, walls, Which::kPenetration, turning(22, 102));
  const auto least = gap.extremum({}, Sense::kMinimum, kEnough), most = depth.extremum({}, Sense::kMaximum, kEnough);
  ASSERT_TRUE(least && most);
  EXPECT_LE(gap.instant({}, 0, Real::ratio(17, 20))->high, -kDepth);
  EXPECT_GE(least->high, 0);  // it is not found
  EXPECT_LE(least->low, -kDepth);
  EXPECT_GE(most->high, kDepth);
}

/// Both turn alike, so the square fits the room exactly; rounded it need not.
TEST(RotatingMotion, AnExactFitOfShapesThatTurnAlike) {
  const RotatingMotion gap(kSquare, room(2'000'000), Which::kGamma1, {{{}, Real(), Real()}, {{}, Real(90), Real(90)}});
  for (const int tenth : {1, 3, 6, 8}) {
    const auto v = gap.instant(at(955'000, 0), 0, Real::ratio(tenth, 10));
    ASSERT_TRUE(v);
    EXPECT_LE(v->low, -955'000);
    EXPECT_GE(v->high, -955'001);
  }
}

/// Both turn alike from angle 0, by up to 60.
const std::vector<RotatingPose> kAlike{{{}, Real(), Real()}, {{}, Real(60), Real(60)}};

/// The bar fits the square exactly, in a row of places from the origin to half a side away; rounded it need not.
TEST(RotatingMotion, RoundingDoesNotDecideWhetherAnExactFitIsOne) {
  const Region bar = box(-1'000'000, -500'000, 1'000'000, 1'000'000),
               square = box(-1'000'000, -1'000'000, 1'000'000, 1'000'000);
  for (const Which which : {Which::kEta1, Which::kEta2, Which::kDelta1, Which::kDelta2}) {
    const bool eta = which == Which::kEta1 || which == Which::kEta2;
    const double truth = which == Which::kEta1 || which == Which::kDelta1 ? 0 : 500'000;
    const RotatingMotion f(eta ? bar : square, eta ? square : bar, which, kAlike);
    const auto holds_truth = [&](const std::optional<ValueRange>& v) {
      ASSERT_TRUE(v) << int(which);
      EXPECT_LE(v->low, truth) << int(which);
      EXPECT_GE(v->high, truth) << int(which);
    };
    for (const int tenth : {1, 3, 5, 7, 9}) holds_truth(f.instant({}, 0, Real::ratio(tenth, 10)));
    holds_truth(f.extremum({}, Sense::kMaximum));
    holds_truth(f.extremum({}, Sense::kMinimum));
  }
}

TEST(RotatingMotion, AFitOfClearanceHasNearBounds) {
  const Region large = box(-3'000'000, -3'000'000, 3'000'000, 3'000'000),
               small = box(-1'900'000, -1'900'000, 1'900'000, 1'900'000);
  const Real half = Real::ratio(1, 2);  // 30 degrees
  const auto v = RotatingMotion(kSquare, large, Which::kEta1, kAlike).instant(at(2'000'000, 0), 0, half);
  ASSERT_TRUE(v);
  EXPECT_NEAR(v->low, 1e6 * (std::sqrt(3.0) - 1), 1e-3);
  EXPECT_NEAR(v->high, 1e6 * (std::sqrt(3.0) - 1), 1e-3);
  const auto most = RotatingMotion(kSquare, large, Which::kEta2, kAlike).instant({}, 0, half);
  ASSERT_TRUE(most);
  EXPECT_NEAR(most->low, 1e6 * std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(most->high, 1e6 * std::sqrt(2.0), 1e-3);
  EXPECT_FALSE(RotatingMotion(kSquare, small, Which::kEta1, kAlike).instant({}, 0, half));
  EXPECT_FALSE(RotatingMotion(kSquare, small, Which::kEta2, kAlike).extremum({}, Sense::kMaximum));
  const auto least = RotatingMotion(kSquare, small, Which::kEta1, kAlike).extremum({}, Sense::kMinimum);
  ASSERT_TRUE(least);  // between the instants that are looked at it might fit
  EXPECT_GT(least->low, 100'000);
  EXPECT_LE(least->low, 1e5 * std::sqrt(2.0));
  EXPECT_EQ(least->high, INFINITY);
}

TEST(RotatingMotion, AGapOfShapesThatDoNotTurnKeepsToItsRate) {
  const RotatingMotion gap(kSquare, room(2'500'000), Which::kGamma1,
                           {{{}, Real(90), Real()}, {at(1'000'000, 0), Real(90), Real()}});
  const auto least = gap.extremum({}, Sense::kMinimum);
  ASSERT_TRUE(least);
  EXPECT_NEAR(least->low, -500'000, 10);
  EXPECT_NEAR(least->high, -500'000, 10);
}

TEST(RotatingMotion, TheDepthOfConvexShapesKeepsToItsRate) {
  // Half sides 2 in a square of half side 20: least deep with its sides along.
  const RotatingMotion gap(kSquare, box(-20'000'000, -20'000'000, 20'000'000, 20'000'000), Which::kGamma1,
                           turning(-7, 10));
  const auto most = gap.extremum({}, Sense::kMaximum);
  ASSERT_TRUE(most);
  EXPECT_NEAR(most->low, -22e6, 1);
  EXPECT_NEAR(most->high, -22e6, 1);
}

/// A disc on an arm of 3 passes a fixed one at 5: nearest, and smoothly so, where the arm points to it.
TEST(RotatingMotion, ASmoothLeastGapHasNearBounds) {
  constexpr std::int64_t kUnit = 1'000'000;
  const Region arm = plane::region_of_disc(Real(3 * kUnit), Real(0), Real(kUnit / 2)),
               fixed = plane::region_of_disc(Real(5 * kUnit), Real(0), Real(kUnit));
  for (const auto& [which, sense, truth] :
       {std::tuple{Which::kGamma1, Sense::kMinimum, 0.5}, std::tuple{Which::kD1, Sense::kMinimum, 0.5},
        std::tuple{Which::kGamma2, Sense::kMinimum, 3.5}}) {
    const auto v = RotatingMotion(arm, fixed, which, turning(-70, 101)).extremum({}, sense);
    ASSERT_TRUE(v);
    EXPECT_NEAR(v->low / kUnit, truth, 1e-9);
    EXPECT_NEAR(v->high / kUnit, truth, 1e-9);
  }
  const auto most = RotatingMotion(arm, fixed, Which::kGamma2, turning(90, 271)).extremum({}, Sense::kMaximum);
  ASSERT_TRUE(most);
  EXPECT_NEAR(most->low / kUnit, 9.5, 1e-9);
  EXPECT_NEAR(most->high / kUnit, 9.5, 1e-9);
}

/// A disc on an arm of 3 protrudes least from a box over its corner, and smoothly so; most over its sides.
TEST(RotatingMotion, AProtrusionFromAConvexShapeHasNearBounds) {
  constexpr std::int64_t kUnit = 1'000'000;
  const Region arm = plane::region_of_disc(Real(3 * kUnit), Real(0), Real(kUnit / 2)),
               fixed = box(-2 * kUnit, -2 * kUnit, 2 * kUnit, 2 * kUnit);
  const auto expect = [](const RotatingMotion& f, Sense sense, double truth) {
    const auto v = f.extremum({}, sense);
    ASSERT_TRUE(v);
    EXPECT_NEAR(v->low / kUnit, truth, 1e-9);
    EXPECT_NEAR(v->high / kUnit, truth, 1e-9);
  };
  const double least = 3.5 - 2 * std::sqrt(2.0);
  expect({arm, fixed, Which::kMu, turning(3, 80)}, Sense::kMinimum, least);
  expect({arm, fixed, Which::kMu, turning(3, 101)}, Sense::kMaximum, 1.5);
  // The box about the disc that stands still, and the other way round.
  std::vector<RotatingPose> about = turning(0, 0);
  about[0].fixed = Real(-3), about[1].fixed = Real(-80);
  expect({arm, fixed, Which::kMu, about}, Sense::kMinimum, least);
  expect({fixed, arm, Which::kMuBack, turning(-3, -80)}, Sense::kMinimum, least);
}

/// What covers nothing at any time has a d* of 0, which rounding does not make negative.
TEST(RotatingMotion, NoDistanceIsBelowZero) {
  for (const Which which : {Which::kD1, Which::kDstar, Which::kDstarBack}) {
    for (const Sense sense : {Sense::kMinimum, Sense::kMaximum}) {
      const auto v = RotatingMotion(kSquare, room(2'000'000), which, turning(-7, 10)).extremum({}, sense);
      ASSERT_TRUE(v);
      EXPECT_GE(v->low, 0);
      EXPECT_GE(v->high, v->low);
    }
  }
}

/// Between two instants no distance of a pair of points is beyond the bound, whatever is known beside them.
TEST(SquaredBound, OfTwoPointsOnArms) {
  const auto at = [](double s) { return std::hypot(5 - 3 * std::cos(s), 3 * std::sin(s)); };
  const auto sample = [&](double s) { return SquaredSample{s, at(s), 0}; };
  const PairMotion motion{3, 3};
  for (double from = -1; from < 1; from += 0.0625) {
    const double to = from + 0.125;
    for (const PairsTaken taken : {PairsTaken::kNearest, PairsTaken::kFarthest}) {
      const auto low =
          squared_bound(taken, true, motion, sample(from), sample(to), sample(from - 0.125), sample(to + 0.125));
      const auto high =
          squared_bound(taken, false, motion, sample(from), sample(to), sample(from - 0.125), sample(to + 0.125));
      ASSERT_TRUE(low && high);
      for (double s = from; s <= to; s += 0.0078125) {
        EXPECT_LE(*low, at(s));
        EXPECT_GE(-*high, at(s));
      }
      EXPECT_GE(*low, std::min(at(from), at(to)) - 0.2);
    }
  }
  // A point on an arm, beyond lines at 2 to the right and above.
  const auto beyond = [](double s) { return SquaredSample{s, 3 * std::max(std::cos(s), std::sin(s)) - 2, 0}; };
  for (double from = -1; from < 1; from += 0.0625) {
    const double to = from + 0.125;
    const auto bound = [&](bool least) {
      return squared_bound(PairsTaken::kFarthestLine, least, motion, beyond(from), beyond(to), beyond(from - 0.125),
                           beyond(to + 0.125));
    };
    ASSERT_TRUE(bound(true) && bound(false));
    for (double s = from; s <= to; s += 0.0078125) {
      EXPECT_LE(*bound(true), beyond(s).f);
      EXPECT_GE(-*bound(false), beyond(s).f);
    }
    EXPECT_GE(*bound(true), std::min(beyond(from).f, beyond(to).f) - 0.3);
  }
  EXPECT_FALSE(squared_bound(PairsTaken::kNone, true, motion, sample(0), sample(1), {}, {}));
}

/// A distance that is 5 steps at every angle, as far as the work reaches.
TEST(RotationLeast, EndsWithItsWork) {
  const auto constant = [](const Real& level) {
    plane::count_cells(100);
    return plane::RotationMap::uniform(plane::Mark(compare(Real(5), level)));
  };
  const auto least = [&](long work) {
    plane::SearchWork left{work};
    const plane::ScopedSearchWork here(&left);
    RotatedLevels levels(constant, Real(1));
    return least_rotation(levels, plane::RotationMap::uniform(1), false);
  };
  EXPECT_EQ(*least(100'000).value(), Real(5));
  const RotationOptimum narrow = least(500), none = least(200);
  EXPECT_FALSE(narrow.proven() || none.proven());
  EXPECT_EQ(*narrow.value(), Real(6));
  EXPECT_EQ(*narrow.bound(), Real(4));
  EXPECT_FALSE(none.value());
  EXPECT_EQ(*none.bound(), Real(2));
}

/// A segment is nowhere deep in itself: what lies deep is its points in B.
TEST(RatedGap, ASegmentDeepInB) {
  const ShapePair pair(box(-10, -10, 10, 10), plane::region_of_chain(ring({{-30, 0}, {30, 0}})));
  const RatedGap gap(pair, false);
  const plane::SignMap high = gap.upper(Real(-4), Real(1));
  EXPECT_EQ(sign_at(high, at(0, 0)), -1);
  EXPECT_EQ(sign_at(high, at(0, 4)), -1);
  EXPECT_EQ(sign_at(high, at(0, 5)), 0);
  EXPECT_EQ(sign_at(high, at(0, 6)), 1);
  EXPECT_EQ(sign_at(gap.lower(Real(-4), Real(1)), at(0, 11)), 1);
  EXPECT_EQ(sign_at(gap.lower(Real(-4), Real(1)), at(0, 10)), -1);
  EXPECT_NEAR(gap.value(at(0, 6)), -4, 1e-9);
}

/// Across its slot the bar cannot leave the walls, which go on without end; what is higher than the slot never can.
TEST(RotatingMotion, AGapMayBeMinusInfinity) {
  const Region walls = plane::closure(plane::complement(box(-5000, -500, 5000, 500)));
  const RotatingMotion bar(box(-2000, -400, 2000, 400), walls, Which::kGamma1, turning(0, 90));
  EXPECT_NEAR(bar.instant({}, 0, Real(0))->low, 100, 1e-6);
  EXPECT_EQ(bar.instant({}, 0, Real(1))->high, -INFINITY);
  EXPECT_EQ(bar.extremum({}, Sense::kMinimum)->high, -INFINITY);
  const auto most = bar.extremum({}, Sense::kMaximum);
  ASSERT_TRUE(most);
  EXPECT_NEAR(most->low, 100, 1);
  EXPECT_GE(most->high, 100);
  const RotatingMotion high(box(-2000, -4000, 2000, 4000), walls, Which::kGamma1, turning(0, 90));
  const auto none = high.extremum({}, Sense::kMaximum);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->low, -INFINITY);
  EXPECT_LT(none->high, -1000);
}

TEST(RatedGap, ConvexSets) {
  const Region disc = plane::region_of_disc(0, 0, 5), square = box(0, 0, 4, 4), beside = box(4, 0, 8, 4),
               apart = box(9, 0, 12, 4), slab = box(-9, -1, 9, 1);
  const auto joined = [](const Region& a, const Region& b) { return plane::unite(std::array{&a, &b}); };
  EXPECT_TRUE(is_convex(disc));
  EXPECT_TRUE(is_convex(square));
  EXPECT_TRUE(is_convex(joined(square, beside)));
  EXPECT_TRUE(is_convex(polygon({{0, 0}, {2, 0}, {4, 0}, {0, 3}})));  // a vertex on a side
  EXPECT_TRUE(is_convex(plane::intersect(std::array{&disc, &slab})));
  EXPECT_FALSE(is_convex(joined(disc, slab)));
  EXPECT_FALSE(is_convex(joined(square, apart)));
  EXPECT_FALSE(is_convex(polygon({{0, 0}, {4, 0}, {4, 4}, {2, 1}})));
  EXPECT_FALSE(is_convex(polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {3, 5}, {5, 3}}})));
  EXPECT_FALSE(is_convex(plane::complement(disc)));
  EXPECT_FALSE(is_convex(plane::region_of_chain(ring({{0, 0}, {4, 0}}))));
}

/// As thin as the grid: rotated by many angles and put on it, it crosses itself.
Region splinter() {
  plane::Contour c{{.start = {0, 0}}, {.start = {400'000'000'000, 0}}};
  for (std::int64_t k = 99; k > 0; --k)
    c.push_back({.start = {k * 4'000'000'000 - (k * k % 7) * 100'000'001, 1 + k % 2}});
  return plane::region_of_rings(std::array{c});
}

/// Where an error says that it arose.
template <class Ask>
std::array<double, 2> place_of_error(Ask&& ask) {
  try {
    ask();
  } catch (const Error& e) {
    if (!e.geometry().empty()) return e.geometry()[0];
  }
  ADD_FAILURE() << "no error with a place";
  return {};
}

TEST(RotatingMotion, AnErrorSaysItsPlaceInTheUnit) {
  const auto expect_in_unit = [](auto&& ask) {
    constexpr double kSize = 400'000'000'000, kStep = 1.0 / 1024;
    const auto far = [&](double step) {
      const std::array<double, 2> place = place_of_error([&] { ask(step); });
      return std::hypot(place[0], place[1]);
    };
    EXPECT_GT(far(1), kSize / 1000);
    EXPECT_GT(far(kStep), kSize / 1000 * kStep);
    EXPECT_LT(far(kStep), kSize * 1.01 * kStep);
  };
  const Region thin = splinter();
  const Which gap = Which::kGamma1;
  expect_in_unit([&](double step) {
    const RotatingMotion f(thin, kSquare, gap, turning(0, 90), step);
    for (int k = 0; k < 200; ++k) static_cast<void>(f.instant({}, 0, Real::ratio(k, 200)));
  });
  expect_in_unit([&](double step) {
    static_cast<void>(RotationInTime(thin, kSquare, gap, {}, {}, turning(1, 84), step).extremum(Sense::kMinimum));
  });
  // By motion_maps.
  expect_in_unit([&](double step) { rotation_position_maps(kSquare, thin, gap, at(7, 9), 170, step); });
}

/// What is cut short is not kept.
TEST(TurningShapes, ExtremaAreSearchedForOnceAndCountTheSame) {
  const TurningShapes shapes(box(0, 0, 9, 9), box(4, 4, 8, 8), turning(0, 40), 1);
  int searches = 0;
  const auto search = [&] {
    ++searches;
    plane::count_cells(100);
    return std::optional(ValueRange{1, 2});
  };
  const auto left_of = [&](long cells, const exact::RealPoint& at) {
    plane::SearchWork work{cells};
    const plane::ScopedSearchWork here(&work);
    EXPECT_EQ(shapes.extremum({Which::kMu, true, 0, false, at}, search)->high, 2);
    return work.left;
  };
  EXPECT_EQ(left_of(100, at(0, 0)), 0);
  EXPECT_EQ(left_of(1000, at(0, 0)), 900);
  EXPECT_EQ(searches, 2);
  EXPECT_EQ(left_of(1000, at(0, 0)), 900);
  EXPECT_EQ(searches, 2);
  EXPECT_EQ(left_of(50, at(0, 0)), -50);
  EXPECT_EQ(left_of(1000, at(1, 0)), 900);
  EXPECT_EQ(searches, 4);
}

TEST(RotatingMotion, WhatIsMadeOfProtrusionsIsThatAtAllInstants) {
  const Region corner =
      polygon({{-9000, -9000}, {9000, -9000}, {9000, -3000}, {-3000, -3000}, {-3000, 9000}, {-9000, 9000}});
  const Region other = polygon({{-4000, -8000}, {5000, -8000}, {0, 6000}});
  const auto shapes = std::make_shared<const TurningShapes>(other, corner, turning(0, 300), 1);
  for (const Which which : {Which::kH, Which::kHBack, Which::kHausdorff, Which::kDstar, Which::kDstarBack}) {
    const RotatingMotion f(shapes, which);
    for (const exact::RealPoint& p : {at(0, 0), at(-3000, -2000), at(9000, 1000)}) {
      const auto least = f.extremum(p, Sense::kMinimum), most = f.extremum(p, Sense::kMaximum);
      ASSERT_TRUE(least && most);
      double lowest = INFINITY, highest = -INFINITY;
      for (int k = 0; k <= 64; ++k) {
        const auto v = f.instant(p, 0, Real::ratio(k, 64));
        ASSERT_TRUE(v);
        EXPECT_GE(v->high, least->low);
        EXPECT_LE(v->low, most->high);
        lowest = std::min(lowest, v->high);
        highest = std::max(highest, v->low);
      }
      EXPECT_LE(least->high, lowest + 1e-6);
      EXPECT_GE(most->low, highest - 1e-6);
      EXPECT_LT(least->high - least->low, 100);
      EXPECT_LT(most->high - most->low, 100);
    }
  }
}

/// Below 0 corners decide, and cost more; of few angles less is asked.
TEST(RotatedPair, MapsCountTheirWork) {
  const Region b = polygon({{-9, -2}, {9, -3}, {7, 4}, {0, 6}}), a = polygon({{2, -8}, {14, -5}, {9, 3}, {4, 1}});
  const RotatedPair pair(b, a, at(0, 0), at(0, 0));
  const plane::RotationMap few{
      {exact::Angle::of_degrees(Real(20)), exact::Angle::of_degrees(Real(21))}, {1, 1}, {1, 0}};
  const auto work = [](const RotatedPair& of, int level, unsigned threads) {
    const plane::ThreadLimit limit(threads);
    plane::SearchWork all{1'000'000};
    const plane::ScopedSearchWork here(&all);
    of.sign_map(Which::kGamma1, Real(level));
    return 1'000'000 - all.left;
  };
  const long contacts = work(pair, 1, 1), corners = work(pair, -1, 1);
  EXPECT_GT(contacts, 20);
  EXPECT_GT(corners, 2 * contacts);
  EXPECT_EQ(work(pair, 1, 2), contacts);
  EXPECT_EQ(work(pair, -1, 2), corners);
  EXPECT_LT(work(pair.within(few), -1, 1), corners);
}

/// Whatever is asked, the signs within a set are those of the whole map.
TEST(RotatedPair, SignsWithinASetAreThoseOfAllAngles) {
  const Region b = polygon({{-9, -2}, {9, -3}, {7, 4}, {0, 6}}), a = polygon({{2, -8}, {14, -5}, {9, 3}, {4, 1}});
  const RotatedPair pair(b, a, at(1, 0), at(2, 1));
  const auto place = [](int degrees) { return exact::Angle::of_degrees(Real(degrees)); };
  const plane::RotationMap sets[] = {{{place(20), place(70)}, {1, 1}, {1, 0}},
                                     {{place(20), place(300)}, {0, 1}, {0, 1}}};
  for (const Which which : {Which::kGamma1, Which::kGamma2, Which::kEta1, Which::kEta2, Which::kDelta1, Which::kMu,
                            Which::kMuBack, Which::kHausdorff, Which::kPenetration, Which::kDstar}) {
    for (const int level : {-2, 0, 3}) {
      const plane::RotationMap whole = pair.sign_map(which, Real(level));
      for (const plane::RotationMap& set : sets) {
        const plane::RotationMap part = pair.within(set).sign_map(which, Real(level));
        const plane::RotationMap wrong =
            plane::overlay(std::array<const plane::RotationMap*, 3>{&set, &whole, &part},
                           [](std::span<const plane::Mark> m) { return plane::Mark(m[0] != 0 && m[1] != m[2]); });
        EXPECT_TRUE(plane::intervals(wrong).empty()) << int(which) << " " << level;
      }
    }
  }
}

}  // namespace distance_rotation_motion
}  // namespace findspace::distance
