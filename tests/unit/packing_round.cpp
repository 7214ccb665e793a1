// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Parts with arcs: their exact boxes, polygons about them, the proof at contacts that no polygon decides, and what the
// search makes of them.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <random>

#include "packing/problem/arc_corners.h"
#include "packing/problem/round_part.h"
#include "packing/proof/interiors.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/strip_search.h"
#include "packing_found.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"

namespace findspace::packing {
namespace packing_round {

using exact::Real;

Part round_part(std::string name, plane::Region region, int demand = 1) {
  Part part{std::move(name), demand, {}};
  part.round = std::make_shared<const RoundPart>(std::move(region));
  part.shape = part.round->at(0, false).about;
  return part;
}

plane::Region disc(const Real& radius) { return plane::region_of_disc(0, 0, radius); }

/// Between two circles, each a grid circle.
plane::Region ring(std::int64_t inner, std::int64_t outer) {
  const std::vector<plane::Contour> rings{plane::circle_ring({0, 0}, outer),
                                          plane::reversed(plane::circle_ring({0, 0}, inner))};
  return plane::region_of_rings(rings);
}

/// A quarter of a disc: (0, 0), (r, 0), (0, r).
plane::Region quarter(std::int64_t r) {
  const std::vector<plane::Contour> rings{
      {{.start = {0, 0}}, plane::center_arc({r, 0}, {0, r}, {0, 0}, true), {.start = {0, r}}}};
  return plane::region_of_rings(rings);
}

Layout of_two(const Fraction& x, const Fraction& y) {
  Layout layout;
  layout.length = 100;
  layout.items = {{.part = 0, .copy = 1, .angle = 0, .mirrored = false, .x = 50, .y = 50},
                  {.part = 0, .copy = 2, .angle = 0, .mirrored = false, .x = Fraction(50) + x, .y = Fraction(50) + y}};
  return layout;
}

Problem strip(Fraction height, std::vector<Part> parts) {
  Problem problem;
  problem.height = height;
  problem.parts = std::move(parts);
  return problem;
}

TEST(RoundPart, ExactBoxAndPolygonAbout) {
  const RoundPart part(disc(sqrt(Real(2))));
  const RoundPart::Form& form = part.at(0, false);
  EXPECT_EQ(form.high.y, sqrt(Real(2)));
  EXPECT_EQ(form.low.x, -sqrt(Real(2)));
  EXPECT_EQ(form.box.high, (LatticePoint{2, 2}));
  const RoundPart fan(quarter(1000000));
  EXPECT_EQ(fan.at(0, false).box.low, (LatticePoint{0, 0}));
  EXPECT_EQ(fan.at(0, true).box.low, (LatticePoint{-1000000, 0}));
  EXPECT_EQ(fan.at(90, true).box.low, (LatticePoint{-1000000, -1000000}));
  EXPECT_NEAR(fan.at(-45, false).high.x.to_double(), 1000000, 1);  // the arc passes the axis
  EXPECT_NEAR(fan.twice_area(), 2e12 * std::atan(1), 1);
  EXPECT_GT(twice_area(fan.at(0, false).about), fan.twice_area());
  EXPECT_LT(twice_area(fan.at(0, false).about), 1.001 * fan.twice_area());
}

TEST(RoundPart, RefusesWhatIsNoArea) {
  EXPECT_THROW(RoundPart(plane::Region::uniform(0)), Error);
  EXPECT_THROW(RoundPart(plane::Region::uniform(1)), Error);
  const std::vector<plane::GridPoint> point{{3, 4}};
  EXPECT_THROW(RoundPart(plane::region_of_points(point)), Error);
}

TEST(RoundPart, AnErrorSaysItsPlaceInTheUnit) {
  constexpr double kSize = 400'000'000'000;
  const plane::Contour splinter{{.start = {0, 0}},
                                {.start = {400'000'000'000, 0}},
                                {.start = {390'000'000'000, 1}},
                                {.start = {300'000'000'000, 2}},
                                {.start = {250'000'000'000, 1}},
                                {.start = {200'000'000'000, 2}},
                                {.start = {140'000'000'000, 1}},
                                {.start = {90'000'000'000, 2}},
                                {.start = {30'000'000'000, 1}}};  // as thin as the grid
  const auto far = [&](double step) {
    const RoundPart part(plane::region_of_rings(std::array{splinter}), step);
    for (int angle = 1; angle < 90; ++angle) {
      try {
        static_cast<void>(part.at(angle, false));
      } catch (const Error& e) {
        return std::hypot(e.geometry().at(0)[0], e.geometry().at(0)[1]);
      }
    }
    return 0.0;
  };
  const double steps = far(1);
  EXPECT_GT(steps, kSize / 100);
  EXPECT_EQ(far(1.0 / 1024), steps / 1024);
}

TEST(RoundPart, APolygonIsKnown) {
  const std::vector<plane::Contour> rings{{{.start = {0, 0}}, {.start = {4, 0}}, {.start = {0, 3}}}};
  const auto polygon = rings_of(plane::region_of_rings(rings));
  ASSERT_TRUE(polygon.has_value());
  EXPECT_EQ(polygon->at(0).size(), 3u);
  EXPECT_FALSE(rings_of(quarter(3)).has_value());
}

TEST(ArcCorners, TangentsTouchAtLatticeDirections) {
  const Arc half{{0, 0}, 1, {1, 0}, {-1, 0}, true};
  const std::vector<Vec> tangents = corners_of(half, true), chords = corners_of(half, false);
  EXPECT_EQ(tangents.size(), 48u);
  EXPECT_EQ(chords.size(), 47u);
  for (const Vec p : tangents) EXPECT_NEAR(std::hypot(p.x, p.y), 1 / std::cos(std::atan(1) / 24), 1e-12);
  EXPECT_NEAR(chords[15].x, 0.5, 1e-12);  // 60 degrees
  const Arc back{{0, 0}, 1, {-1, 0}, {1, 0}, false};
  EXPECT_EQ(corners_of(back, false).size(), 47u);
  EXPECT_EQ(corners_of({{0, 0}, 1, {1, 0}, {std::cos(0.01), std::sin(0.01)}, true}, true).size(), 1u);
}

TEST(Apart, RingsThatCrossThemselvesCount) {
  const Ring eight{{0, 0}, {10, 0}, {10, 10}, {4, 10}, {4, 5}, {6, 5}, {6, 12}, {0, 12}};
  const Polygon inside{{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}}, beside{{{{20, 0}, {21, 0}, {21, 1}, {20, 1}}}};
  EXPECT_FALSE(are_apart({{eight}}, inside, 0));
  EXPECT_FALSE(are_apart(inside, {{eight}}, 0));
  EXPECT_TRUE(are_apart({{eight}}, beside, 9));
  EXPECT_FALSE(are_apart({{eight}}, beside, 10));
}

TEST(RoundProof, DiscsTouchBesideTheAxes) {
  const Problem problem = strip(100, {round_part("disc", disc(Real::ratio(5, 2)), 2)});
  EXPECT_TRUE(verify(problem, of_two(3, 4)).feasible());  // 5 apart, where no tangent of the polygons is
  EXPECT_TRUE(verify(problem, of_two(Fraction(65, 13), 0)).feasible());
  EXPECT_TRUE(verify(problem, of_two(Fraction(25, 13), Fraction(60, 13))).feasible());
  const Verdict verdict = verify(problem, of_two(3, Fraction::parse("3.999999999999")));
  ASSERT_EQ(verdict.faults.size(), 1u);
  EXPECT_EQ(verdict.faults[0].kind, Fault::Kind::kOverlap);
}

TEST(RoundProof, GapsAreTrueDistances) {
  Problem problem = strip(100, {round_part("disc", disc(2), 2)});
  problem.gap = 1;
  EXPECT_TRUE(verify(problem, of_two(3, 4)).feasible());
  problem.gap = Fraction::parse("1.000000001");
  const Verdict verdict = verify(problem, of_two(3, 4));
  ASSERT_EQ(verdict.faults.size(), 1u);
  EXPECT_EQ(verdict.faults[0].kind, Fault::Kind::kGap);
}

TEST(RoundProof, AnIrrationalBoxEndsWhereItEnds) {
  Problem problem = strip(3, {round_part("disc", disc(sqrt(Real(2))))});
  Layout layout;
  layout.length = 3;
  layout.items = {{.part = 0, .copy = 1, .angle = 0, .mirrored = false, .x = Fraction(3, 2), .y = Fraction(3, 2)}};
  EXPECT_TRUE(verify(problem, layout).feasible());  // 2.83 across
  layout.items[0].y = Fraction::parse("1.41421356");
  EXPECT_FALSE(verify(problem, layout).feasible());
  layout.items[0].y = Fraction::parse("1.41421357");
  EXPECT_TRUE(verify(problem, layout).feasible());
}

TEST(RoundProof, APegFillsItsHole) {
  Problem problem = strip(20, {round_part("ring", ring(4, 8)), round_part("peg", disc(4))});
  Layout layout;
  layout.length = 16;
  layout.items = {{.part = 0, .copy = 1, .angle = 0, .mirrored = false, .x = 8, .y = 10},
                  {.part = 1, .copy = 1, .angle = 0, .mirrored = false, .x = 8, .y = 10}};
  EXPECT_TRUE(verify(problem, layout).feasible());
  layout.items[1].y = Fraction::parse("10.0000000000001");
  EXPECT_FALSE(verify(problem, layout).feasible());
}

/// Pairs at random distances: the proof against the distance of the centres.
TEST(RoundProof, DiscsAtRandom) {
  const Problem problem = strip(100, {round_part("disc", disc(5), 2)});
  std::mt19937 random(7);
  std::uniform_int_distribution<int> at(-104, 104);
  for (int trial = 0; trial < 400; ++trial) {
    const int x = at(random), y = at(random);  // tenths
    const bool apart = x * x + y * y >= 100 * 100;
    EXPECT_EQ(verify(problem, of_two(Fraction(x, 10), Fraction(y, 10))).feasible(), apart) << x << " " << y;
  }
  EXPECT_TRUE(verify(problem, of_two(Fraction(28, 10), Fraction(96, 10))).feasible());
}

TEST(RoundSearch, DiscsInASquareLattice) {
  const Problem problem = strip(8, {round_part("disc", disc(2), 6)});
  EXPECT_EQ(found(problem, 2e6).length, Fraction(12));
}

TEST(RoundSearch, DiscsInAHexagonalLattice) {
  // Columns of three, two and three: each next one is 1000 sqrt(3) on.
  Problem problem = strip(6000, {round_part("disc", disc(1000), 8)});
  const double length = found(problem, 6e6).length.to_double();
  EXPECT_LT(length, 2000 + 2 * 1732.06 + 1);
  EXPECT_GE(length, 2000 + 2 * 1732.05);
}

TEST(RoundSearch, APegFindsItsHole) {
  const Problem problem = strip(16, {round_part("ring", ring(4, 8)), round_part("peg", disc(4))});
  EXPECT_EQ(found(problem, 2e6).length, Fraction(16));
}

TEST(RoundSearch, GapEdgeAndPolygons) {
  Problem problem = strip(12, {round_part("disc", disc(4000), 2)});
  problem.digits = 3;
  problem.parts.push_back({"box", 2, make_polygon({{{0, 0}, {3000, 0}, {3000, 8000}, {0, 8000}}}, "box"), {0, 90}});
  problem.gap = 1;
  problem.edge = 2;
  const Layout layout = found(problem, 4e6);
  EXPECT_LE(layout.length, Fraction(2 + 8 + 1 + 3 + 1 + 3 + 1 + 8 + 2));
}

TEST(RoundSearch, MirroredOnSheets) {
  Problem problem;
  problem.digits = 1;
  problem.sheets.push_back({"plate", 2, {}, make_polygon({{{0, 0}, {200, 0}, {200, 100}, {0, 100}}}, "plate")});
  problem.sheets[0].zones.push_back({make_polygon({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}, "zone"), {1}});
  problem.parts = {round_part("fan", quarter(100), 2), round_part("disc", disc(50))};
  problem.parts[0].mirrored = true;
  problem.parts[0].angles = {0, 90, 180, 270};
  const Layout layout = found(problem, 4e6);
  EXPECT_TRUE(layout.left_out.empty());
  for (const Placed& item : layout.items) {
    if (item.part == 1) {
      EXPECT_GE(item.x, Fraction(15));
    }
  }
}

TEST(RoundSearch, SeveralPieces) {
  const plane::Region far = plane::region_of_disc(12, 0, 2), near = disc(2);
  const plane::CellComplex* both[] = {&far, &near};
  const auto either = [](std::span<const plane::Mark> marks) { return plane::Mark(marks[0] > 0 || marks[1] > 0); };
  const Problem problem = strip(4, {round_part("pair", plane::overlay(both, either), 2)});
  EXPECT_EQ(problem.parts[0].shape.rings.size(), 2u);
  EXPECT_EQ(found(problem, 2e7).length, Fraction(20));  // one within the other
}

TEST(LowerBound, OfDiscs) {
  Problem problem = strip(8, {round_part("disc", disc(2), 6)});
  EXPECT_NEAR(lower_bound(problem).to_double(), 6 * 4 * 4 * std::atan(1) / 8, 1e-5);
  problem = strip(8, {round_part("disc", disc(sqrt(Real(2))))});
  EXPECT_EQ(lower_bound(problem), Fraction(2));  // no more than 2.83
}

/// A triangle whose corner (8/3, 4/3) is off the grid: the polygon about it ends at (3, 1).
TEST(LowerBound, OfASheetWithCornersOffTheGrid) {
  const plane::Region left = region_of(make_polygon({{{0, 0}, {4, 0}, {0, 4}}}, "left")),
                      right = region_of(make_polygon({{{0, 0}, {4, 0}, {4, 2}}}, "right"));
  const plane::Region* const both[] = {&left, &right};
  const Part area = round_part("both", plane::intersect(both));
  Problem problem;
  problem.sheets.push_back({"sheet", 2, {}, area.shape, {}, area.round});
  problem.parts = {{"dot", 5, make_polygon({{{0, 0}, {1, 0}, {0, 1}}}, "dot")}};  // 2.5 of 8/3
  EXPECT_EQ(lower_bound(problem), Fraction(1));
  problem.parts[0].demand = 6;
  EXPECT_EQ(lower_bound(problem), Fraction(2));
}

}  // namespace packing_round
}  // namespace findspace::packing
