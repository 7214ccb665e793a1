// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets of boxes: degenerate cells, topological operations, sums, summaries; convex regions and the nearest complement
// points.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "space/body/open_union.h"
#include "space/box/box_operations.h"
#include "space/box/box_summary.h"
#include "space/box/box_topology.h"
#include "space/box/convex_set.h"
#include "space/polytope/min_ball.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_boxes {

using exact::Real;

TEST(BoxComplex, KeepsSheetsLinesPointsAndOpenEnds) {
  std::vector<IntervalBox> boxes(4);
  boxes[0] = {{{Real(0), Real(2), true, false}, {Real(0), Real(2), true, true}, {Real(0), Real(2), true, true}}};
  boxes[1] = {{{Real(3), Real(3), true, true}, {Real(0), Real(1), true, true}, {Real(0), Real(1), true, true}}};
  boxes[2] = {{{Real(3), Real(5), true, true}, {Real(0), Real(0), true, true}, {Real(0), Real(0), true, true}}};
  boxes[3] = {{{Real(7), Real(7), true, true}, {Real(7), Real(7), true, true}, {Real(7), Real(7), true, true}}};
  const BoxComplex set = BoxComplex::of_boxes(boxes);
  EXPECT_EQ(set.mark(place(2, 1, 1)), 0);
  EXPECT_EQ(set.mark(place(0, 1, 1)), 1);
  EXPECT_EQ(closure(set).mark(place(2, 1, 1)), 1);
  EXPECT_EQ(interior(set).mark(place(0, 1, 1)), 0);
  const SpaceSummary s = summarize(set, Real::ratio(1, 2));
  EXPECT_FALSE(s.open || s.closed || s.regular || s.empty);
  EXPECT_DOUBLE_EQ(*s.volume, 1);
  EXPECT_DOUBLE_EQ(s.dangling_area, 0.25);
  EXPECT_EQ(s.components.size(), 3u);  // the line touches the sheet
  EXPECT_DOUBLE_EQ(s.dangling_length, 1);
  ASSERT_EQ(s.isolated.size(), 1u);
  EXPECT_EQ(s.isolated[0], (Place3{3.5, 3.5, 3.5}));
}

TEST(BoxComplex, CavitiesSlitsAndUnboundedSets) {
  const BoxComplex outer = box_set({{{{0, 0, 0}, {6, 6, 6}}}}), inner = box_set({{{{2, 2, 2}, {4, 4, 4}}}});
  const BoxComplex shell = overlay(std::array<const BoxComplex*, 2>{&outer, &inner},
                                   [](std::span<const Mark> m) { return Mark(m[0] && !m[1]); });
  const SpaceSummary s = summarize(shell, Real(1));
  EXPECT_EQ(s.holes, 1);
  EXPECT_DOUBLE_EQ(*s.volume, 208);
  EXPECT_FALSE(s.closed);
  const SpaceSummary outside = summarize(complement(shell), Real(1));
  EXPECT_FALSE(outside.bounded);
  EXPECT_FALSE(outside.volume);
  EXPECT_EQ(outside.components.size(), 2u);
  EXPECT_TRUE(summarize(BoxComplex({}, 1), Real(1)).whole);
  EXPECT_TRUE(summarize(BoxComplex(), Real(1)).empty);
}

/// Of each component alone: its holes are cavities whatever lies in them.
TEST(BoxComplex, HolesOfComponentsWithinOthers) {
  const BoxComplex sets[] = {box_set({{{{0, 0, 0}, {12, 12, 12}}}}), box_set({{{{2, 2, 2}, {10, 10, 10}}}}),
                             box_set({{{{3, 3, 3}, {9, 9, 9}}}}), box_set({{{{5, 5, 5}, {7, 7, 7}}}})};
  const BoxComplex shells = overlay(std::array{&sets[0], &sets[1], &sets[2], &sets[3]},
                                    [](std::span<const Mark> m) { return Mark((m[0] && !m[1]) || (m[2] && !m[3])); });
  const auto holes = [](const SpaceSummary& s) {
    std::vector<int> out;
    for (const SpaceComponent& c : s.components) out.push_back(c.holes);
    std::sort(out.begin(), out.end());
    return out;
  };
  const SpaceSummary s = summarize(shells, Real(1)), around = summarize(complement(shells), Real(1));
  EXPECT_EQ(s.holes, 2);
  EXPECT_EQ(holes(s), (std::vector{1, 1}));
  EXPECT_EQ(around.holes, 2);
  EXPECT_EQ(holes(around), (std::vector{0, 1, 1}));
  EXPECT_FALSE(around.bbox);
  ASSERT_TRUE(s.bbox);
  EXPECT_EQ(s.bbox->high[1], 12);
}

/// Each of 4,096 components on its own part of the grid: minutes where it is a copy of the whole.
TEST(BoxComplex, SummaryOfManyComponents) {
  std::vector<Corners> cubes;
  for (std::int64_t k = 0; k < 16 * 16 * 16; ++k) {
    const std::int64_t x = 2 * (k % 16), y = 2 * (k / 16 % 16), z = 2 * (k / 256);
    cubes.push_back({{{x, y, z}, {x + 1, y + 1, z + 1}}});
  }
  const auto start = std::chrono::steady_clock::now();
  const SpaceSummary s = summarize(box_set(cubes), Real(1));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_EQ(s.components.size(), cubes.size());
  EXPECT_EQ(s.holes, 0);
  EXPECT_DOUBLE_EQ(*s.volume, 4096);
  for (const SpaceComponent& c : s.components) {
    ASSERT_EQ(c.holes, 0);
    ASSERT_TRUE(c.bbox);
    ASSERT_EQ(c.bbox->high[0] - c.bbox->low[0], 1);
  }
  EXPECT_LT(seconds, 20);  // about one where it was written; room for sanitizers
}

/// Made of too many coordinates a set has no cells, and neither has what is made of it.
TEST(BoxComplex, TooFineOnesAreRefused) {
  std::vector<IntervalBox> boxes;
  for (int k = 0; k < 300; ++k) {
    const Interval i{Real(2 * k), Real(2 * k + 1), true, true};
    boxes.push_back({{i, i, i}});
  }
  const BoxComplex fine = BoxComplex::of_boxes(boxes), cube = box_set({{{{0, 0, 0}, {1, 1, 1}}}});
  ASSERT_TRUE(fine.too_fine());
  EXPECT_FALSE(BoxComplex(fine).checked());
  EXPECT_TRUE(BoxComplex(cube).checked());
  const auto any = [](std::span<const Mark> m) { return Mark(m[0] || m[1]); };
  const RealVector by = place(1, 0, 0);
  for (const BoxComplex& set :
       {overlay(std::array<const BoxComplex*, 2>{&cube, &fine}, any), sum(cube, fine), mirrored(fine),
        translated(fine, by), closure(fine), interior(fine), complement(fine), fine.simplified()})
    EXPECT_TRUE(set.too_fine());
}

TEST(BoxComplex, SumOfOpenAndClosedBoxes) {
  const BoxComplex a = box_set({{{{0, 0, 0}, {2, 2, 2}}}}), b = box_set({{{{-1, -1, -1}, {0, 0, 0}}}});
  const BoxComplex open = sum(interior(a), b);
  EXPECT_EQ(open.mark(place(-1, 0, 0)), 0);
  EXPECT_EQ(open.mark(place(-1, 1, 1, 2)), 1);
  EXPECT_EQ(open.mark(place(2, 1, 1)), 0);
  EXPECT_EQ(sum(a, b).mark(place(-1, -1, -1)), 1);
}

/// Rows of several words, whose runs begin and end anywhere: at every cell what the definition says.
TEST(BoxComplex, RowsOfSeveralWords) {
  std::mt19937 random(7);
  const auto pick = [&](int a, int b) { return std::uniform_int_distribution<std::int64_t>(a, b)(random); };
  const auto some = [&](int count) {
    std::vector<Corners> boxes;
    for (int k = 0; k < count; ++k) {
      const std::int64_t x = pick(0, 90), y = pick(0, 5), z = pick(0, 5);
      boxes.push_back({{{x, y, z}, {x + pick(1, 12), y + pick(1, 3), z + pick(1, 3)}}});
    }
    return boxes;
  };
  const std::vector<Corners> of_a = some(60), of_b = some(30);
  const auto within = [](const std::vector<Corners>& boxes, const std::array<std::int64_t, 3>& twice, bool open) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Corners& c) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t from = 2 * c[0][k] + (open ? 1 : 0), to = 2 * c[1][k] - (open ? 1 : 0);
        if (twice[k] < from || to < twice[k]) return false;
      }
      return true;
    });
  };
  const BoxComplex a = box_set(of_a), b = box_set(of_b);
  const BoxComplex signs = overlay(std::array<const BoxComplex*, 2>{&a, &b}, [](std::span<const Mark> m) {
    return Mark(m[0] ? -1 : m[1] ? 0 : 1);
  });
  ASSERT_GT(signs.cells(0), 3 * kWordBits / 2);
  const BoxComplex turned = mirrored(signs.remarked([](Mark m) { return Mark(-m); })).simplified();
  const BoxComplex wide = sum(a, box_set({{{{0, 0, 0}, {1, 0, 0}}}}));
  const BoxComplex again = BoxComplex::of_boxes(complement(a).boxes()), edge = boundary(a);
  for (std::int64_t z = -1; z <= 18; ++z) {
    for (std::int64_t y = -1; y <= 18; ++y) {
      for (std::int64_t x = -1; x <= 210; ++x) {
        const bool in_a = within(of_a, {x, y, z}, false), in_b = within(of_b, {x, y, z}, false);
        const Mark sign = in_a ? Mark(-1) : in_b ? Mark(0) : Mark(1);
        const RealVector p = place(x, y, z, 2);
        ASSERT_EQ(signs.mark(p), sign) << x << ' ' << y << ' ' << z;
        ASSERT_EQ(turned.mark(place(-x, -y, -z, 2)), -sign) << x << ' ' << y << ' ' << z;
        ASSERT_EQ(again.mark(p) != 0, !in_a) << x << ' ' << y << ' ' << z;
        const bool seen = in_a || within(of_a, {x - 1, y, z}, false) || within(of_a, {x - 2, y, z}, false);
        ASSERT_EQ(wide.mark(p) != 0, seen) << x << ' ' << y << ' ' << z;
        if (!in_a || within(of_a, {x, y, z}, true)) {
          ASSERT_EQ(edge.mark(p), 0) << x << ' ' << y << ' ' << z;
        }
      }
    }
  }
  EXPECT_TRUE(interior(edge).empty());
}

/// A hundred million cells: work by words and runs, not by cells.
TEST(BoxComplex, ManyBoxesOfDifferentCoordinates) {
  std::vector<Corners> boxes;
  for (std::int64_t k = 0; k < 115; ++k) {
    const std::int64_t x = k * 37 % 115 * 4, y = k * 53 % 115 * 4, z = k * 4;
    boxes.push_back({{{x, y, z}, {x + 61, y + 63, z + 65}}});
  }
  const auto start = std::chrono::steady_clock::now();
  const BoxComplex set = box_set(boxes);
  ASSERT_FALSE(set.too_fine());
  const SpaceSummary s = summarize(complement(interior(set)), Real(1));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_TRUE(s.closed && s.regular && !s.bounded);
  EXPECT_FALSE(s.components.empty());
  EXPECT_LT(seconds, 20);  // less than two where it was written; room for sanitizers
}

TEST(ConvexRegion, CutsDownToAPoint) {
  ConvexRegion r(place(0, 0, 0), place(4, 4, 4));
  EXPECT_EQ(r.six_volumes(), Real(6 * 64));
  EXPECT_TRUE(r.cut(HalfSpace(place(1, 1, 1), Real(-4))));
  EXPECT_EQ(r.vertices().size(), 4u);
  EXPECT_EQ(r.six_volumes(), Real(64));
  EXPECT_EQ(r.edges().size(), 6u);
  EXPECT_FALSE(r.cut(HalfSpace(place(1, 1, 1), Real(-4))));
  EXPECT_TRUE(r.cut(HalfSpace(place(-1, -1, -1), Real(4))));  // the slanted facet alone
  EXPECT_EQ(r.dimension(), 2);
  EXPECT_TRUE(r.cut(HalfSpace(place(1, 0, 0), Real(0))));
  EXPECT_EQ(r.dimension(), 1);
  EXPECT_TRUE(r.cut(HalfSpace(place(0, 1, 0), Real(0))));
  EXPECT_EQ(r.dimension(), 0);
  EXPECT_EQ(r.vertices()[0].at, place(0, 0, 4));
  EXPECT_TRUE(r.cut(HalfSpace(place(0, 0, 1), Real(-3))));
  EXPECT_TRUE(r.empty());
}

TEST(ConvexSet, SummaryOfATetrahedron) {
  ConvexSet set{ConvexRegion(place(0, 0, 0), place(6, 6, 6)), true, true, false};
  set.region.cut(HalfSpace(place(1, 1, 1), Real(-6)));
  const SpaceSummary closed = summarize(set, Real(1));
  EXPECT_TRUE(closed.closed && closed.regular && !closed.open && closed.bounded);
  EXPECT_DOUBLE_EQ(*closed.volume, 36);
  set.inside = false;
  const SpaceSummary surface = summarize(set, Real(1));
  EXPECT_EQ(surface.holes, 1);
  EXPECT_EQ(surface.components.at(0).dimension, 2);
  EXPECT_NEAR(surface.dangling_area, 3 * 18 + std::sqrt(3) / 4 * 72, 1e-9);  // no sign: test
  set.outside = true;
  const SpaceSummary free = summarize(set, Real(1));
  EXPECT_TRUE(free.closed && free.regular && !free.bounded);
}

TEST(ConvexSet, TopologicalOperations) {
  const auto marks = [](const ConvexSet& s) { return std::array{s.inside, s.frontier, s.outside}; };
  using Marks = std::array<bool, 3>;
  const ConvexRegion box(place(0, 0, 0), place(6, 6, 6)), sheet(place(0, 0, 0), place(6, 6, 0));
  for (int k = 0; k < 8; ++k) {
    const ConvexSet set{box, (k & 1) != 0, (k & 2) != 0, (k & 4) != 0, {}};
    // The frontier is in the closure if anything is near it, in the interior if all is.
    EXPECT_EQ(marks(closure(set)), (Marks{set.inside, k != 0, set.outside}));
    EXPECT_EQ(marks(interior(set)), (Marks{set.inside, k == 7, set.outside}));
    EXPECT_EQ(marks(boundary(set)), (Marks{false, k != 0 && k != 7, false}));
    EXPECT_EQ(marks(complement(set)), (Marks{!set.inside, !set.frontier, !set.outside}));
    const ConvexSet flat{sheet, false, set.frontier, set.outside, {}};
    EXPECT_EQ(closure(flat).frontier, set.frontier || set.outside);
    EXPECT_EQ(interior(flat).frontier, set.frontier && set.outside);
  }
}

/// Grown sets against Pappus and other formulas of their own.
TEST(ConvexSet, SummaryOfGrownSets) {
  const auto grown = [](const RealVector& high, std::int64_t r) {
    return summarize(ConvexSet{ConvexRegion(place(0, 0, 0), high), true, true, false, Real(r)}, Real(1));
  };
  const double pi = 3.14159265358979324;
  const SpaceSummary ball = grown(place(0, 0, 0), 2), capsule = grown(place(0, 0, 5), 2),
                     lozenge = grown(place(3, 0, 5), 2), box = grown(place(3, 4, 5), 2);
  EXPECT_NEAR(*ball.volume, 32 * pi / 3, 1e-9);                             // no sign: test
  EXPECT_NEAR(*capsule.volume, 32 * pi / 3 + 20 * pi, 1e-9);                // no sign: test
  EXPECT_NEAR(*lozenge.volume, 32 * pi / 3 + 2 * pi * 16 + 60, 1e-9);       // no sign: test
  EXPECT_NEAR(*box.volume, 60 + 2 * 94 + pi * 4 * 12 + 32 * pi / 3, 1e-9);  // no sign: test
  EXPECT_TRUE(ball.closed && ball.regular && ball.isolated.empty());
  EXPECT_EQ(box.bbox->low[0], -2);
  EXPECT_EQ(box.bbox->high[2], 7);
  const SpaceSummary shell =
      summarize(ConvexSet{ConvexRegion(place(0, 0, 0), place(3, 4, 5)), false, true, false, Real(2)}, Real(1));
  EXPECT_NEAR(shell.dangling_area, 94 + 2 * pi * 2 * 12 + 16 * pi, 1e-9);  // no sign: test
  EXPECT_EQ(shell.components.at(0).dimension, 2);
}

TEST(OpenUnion, SlitsAndEmptyComplements) {
  const auto slab = [](std::int64_t from, std::int64_t to) {  // from < x < to
    return OpenUnion::Planes{HalfSpace(place(-1, 0, 0), Real(from)), HalfSpace(place(1, 0, 0), Real(-to))};
  };
  OpenUnion cover;
  cover.add(everywhere(), slab(0, 3));
  cover.add(everywhere(), slab(3, 9));
  EXPECT_FALSE(cover.covers(place(3, 5, 5)));
  EXPECT_TRUE(cover.covers(place(2, 5, 5)));
  EXPECT_EQ(*cover.nearest_in_complement(place(4, 5, 5)).at, place(3, 5, 5));
  EXPECT_EQ(*cover.nearest_in_complement(place(7, 5, 5)).at, place(9, 5, 5));
  EXPECT_EQ(*cover.nearest_touching(place(-2, 1, 1)), place(0, 1, 1));
  cover.add(everywhere(), slab(2, 4));
  EXPECT_EQ(*cover.nearest_in_complement(place(4, 5, 5)).at, place(0, 5, 5));
  OpenUnion all;
  all.add(everywhere(), OpenUnion::Planes{HalfSpace(place(1, 0, 0), Real(-1))});
  all.add(everywhere(), OpenUnion::Planes{HalfSpace(place(-1, 1, 0), Real(0))});
  all.add(everywhere(), OpenUnion::Planes{HalfSpace(place(-1, -1, 0), Real(0))});
  EXPECT_FALSE(all.nearest_in_complement(place(0, 0, 0)).at);
}

/// Beside the edge of a box: two of its planes are nearer than numbers tell, of a place so far from the third.
TEST(OpenUnion, FindsACornerBesidePlanes) {
  std::vector<HalfSpace> box;
  for (std::size_t k = 0; k < 3; ++k) {
    RealVector n;
    n[k] = Real(1);
    box.emplace_back(n, Real());
    box.emplace_back(negated(n), Real(-500000));
  }
  for (const double x : {0x1p-30, 0x1p-23, 0x1.6p-23, 0x1p-21}) {
    for (const double z : {0x1.8p-30, 0x1.2p-23, 0x1.6p-23, 0x1p-20}) {
      const auto q = nearest_in(box, {Real::from_double(x), Real(2000000), Real::from_double(z)});
      ASSERT_TRUE(q) << x << " " << z;
      EXPECT_EQ(*q, place(0, 0, 0)) << x << " " << z;
    }
  }
}

TEST(MinBall, OfPointsOnAndOffALine) {
  EXPECT_EQ(min_ball({place(1, 2, 3)}).square, Real(0));
  const EnclosingBall box = min_ball({place(0, 0, 0), place(2, 0, 0), place(0, 4, 0), place(2, 4, 6), place(1, 1, 1)});
  EXPECT_EQ(box.center, place(1, 2, 3));
  EXPECT_EQ(box.square, Real(14));
}

}  // namespace space_boxes
}  // namespace findspace::space
