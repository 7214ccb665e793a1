// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rings that touch or cross a little: what they mean, and how far they are from being valid.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <string>

#include "law/plane_random.h"
#include "plane/build/curve_nesting.h"
#include "plane/build/loose_nesting.h"
#include "plane/build/mended_rings.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/query/locate.h"
#include "plane/query/summary.h"
#include "plane/query/topology.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_mended_rings {

Contour ring(const std::vector<GridPoint>& points) { return contour_of(points); }
Contour box_ring(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
  return ring({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// All parts as one set.
Region set_of(const MendedRings& mended) {
  Region all = Region::uniform(0);
  for (const MendedPart& part : mended.parts) all = all + (part.cells ? *part.cells : region_of_rings(part.rings));
  return all;
}

struct Answer {
  Region set;
  std::size_t parts, places;
  double width, spike;
};

Answer mended(const std::vector<Contour>& rings) {
  const RingMender mender(rings);
  const MendedRings result = mender.mended();
  return {set_of(result), result.parts.size(), result.places, mender.width(), mender.spike()};
}

TEST(MendedRings, NothingToMend) {
  const Answer a = mended({box_ring(0, 0, 100, 100), box_ring(20, 20, 40, 40), box_ring(25, 25, 30, 30)});
  EXPECT_TRUE(same_set(a.set, box(0, 0, 100, 100) - interior(box(20, 20, 40, 40)) + box(25, 25, 30, 30)));
  EXPECT_EQ(a.parts, 2u);
  EXPECT_EQ(a.places, 0u);
  EXPECT_EQ(a.width, 0);
  EXPECT_EQ(a.spike, 0);
}

TEST(MendedRings, ManyLoopsAreNestedInTheirOrder) {
  constexpr std::size_t kSquares = 160;  // 157 is prime to it: squares in each other, four in a place, in no order
  std::vector<Contour> rings;
  for (std::size_t k = 0; k < kSquares; ++k) {
    const std::size_t at = k * 157 % kSquares;
    const auto x = std::int64_t(at / 4 * 100), in = std::int64_t(at % 4 * 10);
    rings.push_back(box_ring(x + in, in, x + 90 - in, 90 - in));
  }
  const std::vector<Loop> loops = loosely_nested(rings);
  ASSERT_EQ(loops.size(), kSquares);
  for (std::size_t k = 0; k < kSquares; ++k) {
    const std::size_t at = k * 157 % kSquares, within = loops[k].within * 157 % kSquares;
    EXPECT_EQ(loops[k].depth, at % 4);
    EXPECT_EQ(within, at % 4 == 0 ? at : at - 1);
  }
}

TEST(MendedRings, AHundredThousandLoopsAreNotComparedInPairs) {
  std::vector<Contour> rings;
  for (std::int64_t k = 0; k < 100000; ++k) {
    const std::int64_t x = k % 400 * 30, y = k / 400 * 30, size = 10 + k % 11;
    rings.push_back(box_ring(x, y, x + size, y + size));
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(loosely_nested(rings).size(), rings.size());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", std::to_string(seconds.count()));
  EXPECT_LT(seconds.count(), 10);  // all pairs take longer; room for sanitizers
}

TEST(MendedRings, TouchingIsNoFault) {
  // A corner on an edge, a hole with a side on the edge, and parts side by side.
  const Answer notch = mended({box_ring(0, 0, 100, 100), ring({{50, 0}, {60, 20}, {40, 20}})});
  EXPECT_TRUE(same_set(
      notch.set, box(0, 0, 100, 100) - interior(region_of_rings(std::array{ring({{50, 0}, {60, 20}, {40, 20}})}))));
  EXPECT_EQ(notch.width + notch.spike, 0);
  const Answer beside = mended({box_ring(0, 0, 100, 100), box_ring(100, 20, 150, 80)});
  EXPECT_TRUE(same_set(beside.set, box(0, 0, 100, 100) + box(100, 20, 150, 80)));
  EXPECT_EQ(beside.parts, 2u);
  EXPECT_EQ(beside.width + beside.spike, 0);
}

TEST(MendedRings, SidesSharedWithAHoleAreSpikes) {
  const Answer a = mended({box_ring(0, 0, 100, 100), box_ring(20, 0, 50, 20)});
  EXPECT_EQ(a.spike, 30);
  EXPECT_TRUE(same_set(a.set, region_of_rings(std::array{ring(
                                  {{0, 0}, {20, 0}, {20, 20}, {50, 20}, {50, 0}, {100, 0}, {100, 100}, {0, 100}})})));
}

TEST(MendedRings, LoopsSpikesAndOverlaps) {
  // A loop outside by sides that pass each other, 4 long and 2.4 wide.
  const Answer loop = mended({ring({{0, 0}, {104, 0}, {100, -3}, {100, 100}, {0, 100}})});
  EXPECT_EQ(loop.parts, 1u);
  EXPECT_EQ(loop.places, 1u);
  EXPECT_GT(loop.width, 1);
  EXPECT_LT(loop.width, 5);
  EXPECT_TRUE(same_set(loop.set, box(0, 0, 100, 100)));
  const Answer spike = mended({ring({{0, 0}, {100, 0}, {100, 50}, {107, 50}, {100, 50}, {100, 100}, {0, 100}})});
  EXPECT_TRUE(same_set(spike.set, box(0, 0, 100, 100)));
  EXPECT_EQ(spike.spike, 7);
  EXPECT_EQ(spike.places, 1u);
  // Holes that overlap, and one that sticks out.
  const Answer holes =
      mended({box_ring(0, 0, 100, 100), box_ring(20, 20, 42, 40), box_ring(40, 20, 60, 40), box_ring(70, -3, 80, 9)});
  EXPECT_TRUE(same_set(holes.set, closure(box(0, 0, 100, 100) - box(20, 20, 60, 40) - box(70, -3, 80, 9))));
  EXPECT_NEAR(holes.width, 3, 2);
  // Parts that overlap stay two.
  const Answer parts = mended({box_ring(0, 0, 100, 100), box_ring(98, 20, 150, 80)});
  EXPECT_EQ(parts.parts, 2u);
  EXPECT_TRUE(same_set(parts.set, box(0, 0, 100, 100) + box(98, 20, 150, 80)));
  EXPECT_NEAR(parts.width, 3, 1.1);
}

TEST(MendedRings, LargeFaultsAreLarge) {
  EXPECT_GT(mended({box_ring(0, 0, 100, 100), box_ring(50, 50, 150, 150)}).width, 49);
  EXPECT_GT(mended({box_ring(0, 0, 100, 100), box_ring(50, -50, 60, 50)}).width, 9);
  EXPECT_GT(mended({ring({{0, 0}, {100, 100}, {100, 0}, {0, 100}})}).width, 40);  // a bow tie without a corner between
  EXPECT_GE(mended({box_ring(0, 0, 100, 100), ring({{0, 0}, {100, 0}, {100, 50}, {100, 100}, {0, 100}})}).width, 99);
}

TEST(MendedRings, ArcsThatCrossAreOneSet) {
  // Discs that touch at (60.4, 80.5..) but for one step, each as a ring of two arcs.
  const Answer a = mended({circle_ring({0, 0}, 101), circle_ring({120, 160}, 100)});
  EXPECT_EQ(a.parts, 2u);
  EXPECT_GT(a.width, 0.9);
  EXPECT_LT(a.width, 1.1);
  EXPECT_TRUE(same_set(a.set, disc(0, 0, exact::Real(101)) + disc(120, 160, exact::Real(100))));
}

TEST(MendedRings, ArcsThatBarelyCrossAreNarrow) {
  // Circles of hundreds of millions of steps that touch but for the rounding of an arc's end: doubles alone place where
  // they cross to tens of steps.
  const GridPoint from{322403264, -18938090}, touch{229320000, 227409000}, to{0, 322959000};
  const Contour arcs{bulge_arc(from, touch, exact::Real::parse_decimal("0.213112923025143")),
                     bulge_arc(touch, to, exact::Real::ratio(1, 5)), ContourEdge{.start = to}};
  const Answer a = mended({arcs, circle_ring({360000000, 357000000}, 184041000)});
  EXPECT_EQ(a.parts, 2u);
  EXPECT_LT(a.width, 4);
}

TEST(MendedRings, AnOverlapAlongAnArcIsNarrow) {
  // A disc, and a part around three quarters of it that overlaps it by 2 all the way.
  const GridPoint o{0, 0}, a{0, -9998}, b{-9998, 0}, far{-20000, 0}, low{0, -20000};
  const Contour around{center_arc(b, a, o, false), ContourEdge{.start = a}, center_arc(low, far, o, true),
                       ContourEdge{.start = far}};
  const Answer overlap = mended({circle_ring(o, 10000), around});
  EXPECT_EQ(overlap.parts, 2u);
  EXPECT_GE(overlap.width, 2);
  EXPECT_LT(overlap.width, 2.1);
  // Discs one on the other are not, nor is a wedge.
  EXPECT_GT(mended({circle_ring(o, 10000), circle_ring({5000, 0}, 10000)}).width, 9000);
  EXPECT_GT(mended({circle_ring(o, 10000), box_ring(9000, -500, 12000, 500)}).width, 900);
}

TEST(MendedRings, SaysOnWhichSideTheSetIs) {
  const Contour outer = box_ring(0, 0, 100, 100), hole = box_ring(20, 20, 40, 40);
  const std::vector<Contour> rings{reversed(outer), hole};
  const RingMender mender(rings);
  EXPECT_EQ(mender.set_on_left(0), std::optional(false));
  EXPECT_EQ(mender.set_on_left(1), std::optional(false));
  EXPECT_FALSE(mender.is_hole(0));
  EXPECT_TRUE(mender.is_hole(1));
  EXPECT_FALSE(mender.winds_round_nothing());
  const std::vector<Contour> line{ring({{0, 0}, {10, 5}, {20, 30}, {10, 5}})};
  EXPECT_TRUE(RingMender(line).winds_round_nothing());
  const std::vector<Contour> eight{ring({{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}})};
  EXPECT_FALSE(RingMender(eight).winds_round_nothing());
}

/// How often the polygon winds around a point that is on none of its edges.
int winding(const Contour& ring, double x, double y) {
  double turn = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const GridPoint p = ring[k].start, q = end_of(ring, k);
    const double ax = double(p.x) - x, ay = double(p.y) - y, bx = double(q.x) - x, by = double(q.y) - y;
    turn += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return int(std::lround(turn / (2 * M_PI)));
}

/// Round polygons whose corners are moved by up to 30 of 10,000 steps cross themselves here and there.
TEST(MendedRings, TheSetIsWhereTheRingWindsOnce) {
  Random random(11);
  int crossing = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<GridPoint> points;
    const int n = 800;
    for (int k = 0; k < n; ++k)
      points.push_back({std::int64_t(std::lround(10000 * std::cos(2 * M_PI * k / n))) + random.pick(-60, 60),
                        std::int64_t(std::lround(10000 * std::sin(2 * M_PI * k / n))) + random.pick(-60, 60)});
    const std::vector<Contour> rings{ring(points)};
    const Answer a = mended(rings);
    crossing += a.width > 0;
    EXPECT_LT(a.width, 400);
    for (int sample = 0; sample < 300; ++sample) {
      const std::size_t k = std::size_t(random.pick(0, n - 1));
      const exact::RealPoint p{exact::Real::ratio(2 * points[k].x + random.pick(-99, 99) * 2 + 1, 2),
                               exact::Real::ratio(3 * points[k].y + random.pick(-150, 150) * 3 + 1, 3)};
      const bool in = mark_of(a.set, locate(a.set, p)) != 0;
      EXPECT_EQ(in, winding(rings[0], p.x.to_double(), p.y.to_double()) >= 1) << round << ' ' << sample;
    }
  }
  EXPECT_GT(crossing, 50);
}

/// Rings near curves that cannot tell how the curves lie are asked for again; what still cannot tell is not told.
TEST(CurveNesting, NearerRingsTellMore) {
  const auto nesting = [](double bound, double nearer, int& asked) {
    return CurveNesting({{box_ring(0, 0, 4000, 4000), bound}, {box_ring(150, 150, 3850, 3850), bound}},
                        [&asked, nearer](std::size_t k) {
                          ++asked;
                          const std::int64_t low = 150 * std::int64_t(k), high = 4000 - low;
                          return NearRing{reversed(box_ring(low, low, high, high)), nearer};
                        });
  };
  int asked = 0;
  CurveNesting sure = nesting(10, 1, asked);
  EXPECT_EQ(sure.orientation(1), 1);
  EXPECT_EQ(sure.around(), (std::vector<std::vector<std::size_t>>{{}, {0}}));
  EXPECT_EQ(asked, 0);
  CurveNesting near = nesting(300, 1, asked);
  EXPECT_EQ(near.orientation(1), -1);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(near.around(), (std::vector<std::vector<std::size_t>>{{}, {0}}));
  EXPECT_EQ(asked, 2);
  CurveNesting thin = nesting(300, 250, asked);
  EXPECT_FALSE(thin.orientation(0));
  EXPECT_FALSE(thin.around());
  int none = 0;
  EXPECT_EQ(nesting(0, 0, none).around(), (std::vector<std::vector<std::size_t>>{{}, {0}}));
  EXPECT_EQ(none, 0);
}

}  // namespace plane_mended_rings
}  // namespace findspace::plane
