// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Interiors that meet or only touch, fractions, and verdicts about layouts.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "packing/problem/fraction.h"
#include "packing/proof/fewest_bins.h"
#include "packing/proof/interiors.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"

namespace findspace::packing {
namespace packing_proof {

Polygon box(int x0, int y0, int x1, int y1) { return make_polygon({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}, "box"); }

Polygon frame() { return make_polygon({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}}, "frame"); }

TEST(Interiors, BoxesThatTouch) {
  EXPECT_FALSE(interiors_meet(box(0, 0, 2, 2), box(2, 0, 4, 2)));
  EXPECT_FALSE(interiors_meet(box(0, 0, 2, 2), box(2, 2, 4, 4)));
  EXPECT_FALSE(interiors_meet(box(0, 0, 2, 2), box(2, 1, 4, 7)));
  EXPECT_FALSE(interiors_meet(box(0, 0, 2, 2), box(5, 5, 7, 7)));
}

TEST(Interiors, BoxesThatOverlap) {
  EXPECT_TRUE(interiors_meet(box(0, 0, 2, 2), box(0, 0, 2, 2)));
  EXPECT_TRUE(interiors_meet(box(0, 0, 9, 9), box(3, 3, 4, 4)));
  EXPECT_TRUE(interiors_meet(box(0, 0, 9, 9), box(0, 0, 4, 4)));
  EXPECT_TRUE(interiors_meet(box(0, 2, 9, 4), box(3, 0, 5, 9)));
  EXPECT_TRUE(interiors_meet(box(0, 0, 4, 2), box(2, 0, 6, 2)));
}

TEST(Interiors, APartThatFitsItsHole) {
  EXPECT_FALSE(interiors_meet(frame(), box(2, 2, 4, 4)));
  EXPECT_FALSE(interiors_meet(frame(), box(2, 2, 3, 4)));
  EXPECT_TRUE(interiors_meet(frame(), box(2, 2, 5, 4)));
  EXPECT_TRUE(interiors_meet(frame(), box(1, 1, 5, 5)));
}

/// Each hole leaves the other one's corner to the part; only both together leave nothing.
TEST(Interiors, HolesThatTouchAtACorner) {
  const Polygon plate = make_polygon(
      {{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{3, 3}, {5, 3}, {5, 5}, {3, 5}}}, "plate");
  EXPECT_FALSE(interiors_meet(plate, box(1, 1, 3, 3)));
  EXPECT_FALSE(interiors_meet(box(3, 3, 5, 5), plate));
  EXPECT_TRUE(interiors_meet(plate, box(2, 2, 4, 4)));
  EXPECT_TRUE(interiors_meet(plate, box(3, 1, 5, 3)));
  EXPECT_TRUE(interiors_meet(box(3, 2, 4, 3), plate));
}

TEST(Interiors, EdgesThatRunAlongEachOther) {
  const Polygon slope = make_polygon({{{0, 0}, {6, 3}, {0, 3}}}, "slope");
  EXPECT_TRUE(run_along(box(0, 0, 2, 2), box(2, 1, 4, 9)));
  EXPECT_FALSE(run_along(box(0, 0, 2, 2), box(2, 2, 4, 4)));  // a corner
  EXPECT_FALSE(run_along(box(0, 0, 2, 2), box(3, 0, 5, 2)));  // on one line, apart
  EXPECT_TRUE(run_along(slope, make_polygon({{{4, 2}, {8, 4}, {8, 0}}}, "beside it")));
  EXPECT_FALSE(run_along(slope, make_polygon({{{6, 3}, {8, 4}, {8, 0}}}, "behind it")));
}

TEST(Interiors, CornersThatCrossAtVertices) {
  const Polygon diamond = make_polygon({{{0, -2}, {2, 0}, {0, 2}, {-2, 0}}}, "diamond");
  EXPECT_TRUE(interiors_meet(diamond, box(-2, -2, 2, 2)));
  EXPECT_TRUE(interiors_meet(diamond, box(0, 0, 5, 5)));
  EXPECT_FALSE(interiors_meet(diamond, box(2, -1, 5, 1)));
  // The hypotenuse passes through both corners of the box.
  const Polygon triangle = make_polygon({{{0, 0}, {4, 4}, {0, 4}}}, "triangle");
  EXPECT_TRUE(interiors_meet(triangle, box(1, 1, 3, 3)));
  EXPECT_FALSE(interiors_meet(triangle, box(2, 1, 3, 2)));
}

TEST(Interiors, FarBeyondSixtyFourBits) {
  const int128 big = power_of_ten(30);
  const auto square = [&](int128 x, int128 y) {
    return make_polygon({{{x, y}, {x + big, y}, {x + big, y + big}, {x, y + big}}}, "square");
  };
  EXPECT_FALSE(interiors_meet(square(0, 0), square(big, 0)));
  EXPECT_TRUE(interiors_meet(square(0, 0), square(big - 1, 0)));
}

TEST(Fraction, TextsAreExact) {
  EXPECT_EQ(Fraction::parse("1203.25").text(), "1203.25");
  EXPECT_EQ(Fraction::parse("-17/3").text(), "-17/3");
  EXPECT_EQ(Fraction::parse("0.5/0.25"), Fraction(2));
  EXPECT_EQ(Fraction::parse("1e-3").text(), "0.001");
  EXPECT_EQ((Fraction::parse("1/3") + Fraction::parse("1/6")).text(), "0.5");
  EXPECT_LT(Fraction::parse("0.333"), Fraction::parse("1/3"));
  EXPECT_THROW(Fraction::parse("1/0"), Error);
  EXPECT_THROW(Fraction::parse("1e99"), Error);
}

TEST(Polygon, WhatIsNoOutline) {
  EXPECT_THROW(make_polygon({{{0, 0}, {1, 0}}}, "two corners"), Error);
  EXPECT_THROW(make_polygon({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}, "crossed"), Error);
  EXPECT_THROW(make_polygon({{{0, 0}, {2, 0}, {1, 0}}}, "flat"), Error);
  EXPECT_EQ(make_polygon({{{0, 0}, {0, 2}, {0, 4}, {4, 4}, {4, 0}, {0, 0}}}, "square").rings[0].size(), 4u);
}

Problem two_squares() {
  Problem problem;
  problem.height = 4;
  problem.parts.push_back({"square", 2, box(0, 0, 3, 3), {0, 90}});
  return problem;
}

TEST(Verify, SaysWhatIsWrong) {
  const Problem problem = two_squares();
  Layout layout{6, {{0, 1, 0, false, 0, 0}, {0, 2, 0, false, 3, 1}}, {}};
  EXPECT_TRUE(verify(problem, layout).feasible());
  EXPECT_EQ(verify(problem, layout).used, Fraction(6));
  layout.items[1].x = Fraction::parse("8/3");
  const Verdict overlap = verify(problem, layout);
  ASSERT_EQ(overlap.faults.size(), 1u);
  EXPECT_EQ(overlap.faults[0].kind, Fault::Kind::kOverlap);
  EXPECT_NEAR(overlap.faults[0].depth, 1.0 / 3, 1e-9);
  layout.items[1] = {0, 2, 45, false, 3, Fraction::parse("1.001")};
  layout.items.pop_back();
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kCount);
  layout.left_out.push_back({0, 1, "no room"});
  EXPECT_TRUE(verify(problem, layout).feasible());
  layout.items[0].y = Fraction::parse("1.0000000001");
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kOutside);
  layout.items[0] = {0, 1, 180, false, 3, 3};
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kAngle);
}

TEST(Verify, GapsAndEdges) {
  Problem problem = two_squares();
  problem.height = 9;
  problem.edge = 1;
  Layout layout{11, {{0, 1, 0, false, 1, 1}, {0, 2, 0, false, 7, 5}}, {}};
  EXPECT_TRUE(verify(problem, layout).feasible());
  problem.edge = Fraction::parse("1.0001");
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kOutside);
  problem.edge = 0;
  layout.items[0].y = 0;
  layout.items[1].y = 6;  // the corners are sqrt(18) apart
  problem.gap = Fraction::parse("4.2426406871192851");
  EXPECT_TRUE(verify(problem, layout).feasible());
  problem.gap = Fraction::parse("4.2426406871192852");
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kGap);
  layout.items[1] = {0, 2, 0, false, 7, Fraction(3)};
  problem.gap = 3;
  EXPECT_TRUE(verify(problem, layout).feasible());
  problem.gap = Fraction::parse("3.000000000000001");
  EXPECT_EQ(verify(problem, layout).faults.at(0).kind, Fault::Kind::kGap);
}

TEST(LowerBound, AreaAndWidestPart) {
  Problem problem = two_squares();
  EXPECT_EQ(lower_bound(problem).text(), "4.5");
  problem.height = Fraction(13, 3);
  EXPECT_EQ(lower_bound(problem).text(), "4.153846");  // rounded down from 54/13
  problem.height = 4;
  problem.parts[0].shape = box(0, 0, 5, 4);
  problem.parts[0].demand = 1;
  EXPECT_EQ(lower_bound(problem), Fraction(5));
}

/// A bar that stands upright at 45 degrees where it is turned over, and lies along the strip where not.
TEST(LowerBound, AMirroredPartMayBeNarrower) {
  Problem problem;
  problem.height = 20;
  problem.parts.push_back({"bar", 1, make_polygon({{{0, 10}, {10, 0}, {11, 1}, {1, 11}}}, "bar"), {45}, true});
  const auto width = [&](bool mirrored) {
    const LatticeBox box = box_of(problem.parts[0], 45, mirrored);
    return Fraction(box.high.x - box.low.x, 1);
  };
  ASSERT_LT(width(true), width(false));
  EXPECT_LE(lower_bound(problem), width(true));
  problem.parts[0].mirrored = false;
  EXPECT_EQ(lower_bound(problem), width(false));
}

TEST(LowerBound, AFixedCopyMayStandAtAnyAngle) {
  Problem problem;
  problem.height = 20;
  problem.parts.push_back({"bar", 1, box(0, 0, 14, 1), {0}});
  EXPECT_EQ(lower_bound(problem), Fraction(14));
  problem.fixed = {{{.part = 0, .copy = 1, .angle = 90, .mirrored = false, .x = 1, .y = 0}, 0}};
  EXPECT_EQ(lower_bound(problem), Fraction(1));  // where it ends
  problem.edge = Fraction(1, 4);
  EXPECT_EQ(lower_bound(problem), Fraction(5, 4));
  problem.edge = 0;
  problem.parts[0].demand = 2;
  EXPECT_EQ(lower_bound(problem), Fraction(14));
}

/// Squares of area 2 whose corners are rounded so that they have area 1.
TEST(LowerBound, RoundedCopiesMayBeSmaller) {
  Problem problem;
  problem.height = 1;
  problem.parts.push_back({"square", 10, make_polygon({{{0, 0}, {1, 1}, {0, 2}, {-1, 1}}}, "square"), {45}});
  EXPECT_LE(lower_bound(problem), Fraction(10));
  problem.box = true;
  EXPECT_LE(lower_bound(problem), Fraction(10));
  problem.box = false;
  problem.parts[0].angles = {0};
  problem.parts[0].tilt = 45;
  EXPECT_LE(lower_bound(problem), Fraction(10));
  problem.parts[0].tilt = 0;
  EXPECT_GT(lower_bound(problem), Fraction(19));
  problem.digits = 6;  // of large parts they are hardly smaller
  problem.height = 8;
  problem.parts[0].shape = box(0, 0, 2000000, 2000000);
  problem.parts[0].angles = {45};
  EXPECT_NEAR(lower_bound(problem).to_double(), 5, 1e-3);
  problem.gap = Fraction(1, 100);
  EXPECT_NEAR(lower_bound(problem).to_double(), 5, 0.1);
}

TEST(LowerBound, HalfTheGapBelongsToAPart) {
  Problem problem = two_squares();  // of 3 by 3
  problem.height = 3;
  problem.gap = 1;
  const double pi = std::acos(-1.0), taken = 2 * (9 + 6 + pi / 4);
  EXPECT_NEAR(lower_bound(problem).to_double(), (taken - 3 - pi / 4) / 4, 2e-6);  // 7 is the least
  problem.edge = Fraction(1, 2);
  problem.height = 4;
  EXPECT_NEAR(lower_bound(problem).to_double(), (taken - 3 - pi / 4) / 4 + 1, 2e-6);
}

/// Equal squares in columns are packed best where the columns are full.
TEST(LowerBound, IsNotAboveColumnsOfSquares) {
  for (int side = 1; side <= 4; ++side)
    for (int gap = 0; gap <= 3; ++gap)
      for (int edge = 0; edge <= 2; ++edge)
        for (int rows = 1; rows <= 3; ++rows)
          for (int columns = 1; columns <= 3; ++columns) {
            Problem problem = two_squares();
            problem.parts[0].shape = box(0, 0, side, side);
            problem.parts[0].demand = rows * columns;
            problem.gap = gap;
            problem.edge = edge;
            problem.height = rows * side + (rows - 1) * gap + 2 * edge;
            const Fraction length(columns * side + (columns - 1) * gap + 2 * edge), least = lower_bound(problem);
            EXPECT_LE(least, length);
            if (gap == 0) EXPECT_EQ(least, length);
            problem.box = true;
            EXPECT_LE(lower_bound(problem).to_double(), length.to_double() * problem.height.to_double());
            Sheet sheet;
            sheet.count = 3;
            sheet.shape = box(0, 0, std::int64_t(length.to_double()), std::int64_t(problem.height.to_double()));
            problem.box = false;
            problem.sheets = {sheet};
            EXPECT_EQ(lower_bound(problem), Fraction(1));
          }
}

TEST(LowerBound, OfABox) {
  Problem problem = two_squares();
  problem.box = true;
  EXPECT_NEAR(lower_bound(problem).to_double(), 18, 2e-5);
  problem.gap = 2;
  EXPECT_NEAR(lower_bound(problem).to_double(), 3 * ((42 + 2 * std::acos(-1.0) + 4 - std::acos(-1.0)) / 5 - 2), 2e-5);
  problem.gap = 0;
  problem.edge = 1;
  EXPECT_NEAR(lower_bound(problem).to_double(), 18 + 4 * std::sqrt(18) + 4, 2e-5);  // 40 is the least
}

TEST(LowerBound, CountsSheets) {
  Problem problem = two_squares();
  problem.parts[0].shape = box(0, 0, 6, 6);
  problem.parts[0].demand = 5;
  Sheet sheet;
  sheet.count = 9;
  sheet.shape = box(0, 0, 10, 7);
  problem.sheets = {sheet};
  EXPECT_EQ(lower_bound(problem), Fraction(5));  // each covers more than half of a sheet; by the sum there were three
  problem.sheets[0].shape = box(0, 0, 13, 6);
  EXPECT_EQ(lower_bound(problem), Fraction(3));
  problem.edge = Fraction(1, 4);  // leaves 12.5 times 5.5
  EXPECT_EQ(lower_bound(problem), Fraction(5));
}

/// The fewest equal bins, by trying all ways.
std::size_t fewest_by_trying(int bin, const std::vector<int>& items, std::size_t next, std::vector<int>& bins) {
  if (next == items.size()) return bins.size();
  std::size_t best = items.size();
  for (std::size_t k = 0; k < bins.size(); ++k) {
    if (bins[k] + items[next] > bin) continue;
    bins[k] += items[next];
    best = std::min(best, fewest_by_trying(bin, items, next + 1, bins));
    bins[k] -= items[next];
  }
  bins.push_back(items[next]);
  best = std::min(best, fewest_by_trying(bin, items, next + 1, bins));
  bins.pop_back();
  return best;
}

TEST(FewestBins, IsNeverMoreThanAreNeeded) {
  std::mt19937 random(4);
  std::size_t equal = 0;
  constexpr int kCases = 300, kBin = 20;
  for (int i = 0; i < kCases; ++i) {
    std::vector<int> items;
    std::vector<Alike> alike;
    for (int k = 0; k < 7; ++k) {
      items.push_back(1 + int(random() % kBin));
      alike.push_back({exact::Real(items.back()), 1});
    }
    std::vector<int> bins;
    const std::size_t needed = fewest_by_trying(kBin, items, 0, bins);
    const std::size_t bound = fewest_bins({{exact::Real(kBin), 20}}, alike);
    EXPECT_LE(bound, needed);
    equal += bound == needed ? 1 : 0;
  }
  EXPECT_GT(equal, 250U);
}

TEST(FewestBins, TakesTheLargestAndSaysAllWhereTheyAreTooFew) {
  const std::vector<Alike> bins{{exact::Real(5), 4}, {exact::Real(20), 1}, {exact::Real(9), 0}};
  EXPECT_EQ(fewest_bins(bins, {{exact::Real(3), 9}}), 3U);
  EXPECT_EQ(fewest_bins(bins, {{exact::Real(3), 90}}), 5U);
  EXPECT_EQ(fewest_bins(bins, {{exact::Real(10), 2}, {exact::Real(3), 0}}), 1U);
  EXPECT_EQ(fewest_bins(bins, {}), 0U);
}

}  // namespace packing_proof
}  // namespace findspace::packing
