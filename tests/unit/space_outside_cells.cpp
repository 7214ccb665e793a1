// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is outside a mesh: cells that fill its box with it, exactly, also where its convex parts are rounded; of moved,
// enlarged, reflected and united meshes as well. Of other rounded parts: no cracks between those that touched.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "space/body/outside_cells.h"
#include "space/polytope/partition.h"
#include "unit/solid_shapes.h"
#include "unit/space_bumps.h"

namespace findspace::space {
namespace space_outside_cells {

using exact::Real;

/// How many of the closed cells hold the place, and how many with their interiors.
std::array<int, 2> holding(const std::vector<OutsideCell>& cells, const RealVector& p) {
  std::array<int, 2> count{};
  for (const OutsideCell& cell : cells) {
    int highest = -1;
    for (const HalfSpace& h : cell.planes) highest = std::max(highest, h.value(p).sign());
    count[0] += highest <= 0;
    count[1] += highest < 0;
  }
  return count;
}

RealVector draw(std::mt19937& engine, std::int64_t reach) {
  RealVector p;
  for (Real& c : p) c = Real(static_cast<std::int64_t>(engine() % static_cast<unsigned>(2 * reach + 1)) - reach);
  return p;
}

TEST(OutsideCells, FillTheBoxWithTheMesh) {
  for (const int n : {2, 3, 4}) {
    const Mesh mesh = knobbly_ball(n, 1000, static_cast<unsigned>(n));
    const Body b = body_of(mesh);
    ASSERT_EQ(b.around.size(), 1u);
    Real sum = six_volumes(mesh);
    for (const ConvexRegion& cell : b.around[0].of->cells) sum += cell.six_volumes();
    const Bounds3 box = bounds(b);
    const RealVector size = minus(box.high, box.low);
    const Real scale(b.scale);
    EXPECT_TRUE(sum * scale * scale * scale == Real(6) * size[0] * size[1] * size[2]) << n;
  }
}

TEST(OutsideCells, HoldWhatTheMeshDoesNot) {
  const Mesh mesh = knobbly_ball(5, 1000, 7);
  const Body b = body_of(mesh);
  ASSERT_GT(b.rounded, 0);  // the parts are not the mesh
  const std::vector<OutsideCell> cells = outside_cells(b);
  std::mt19937 engine(3);
  for (int i = 0; i < 300; ++i) {
    const RealVector p = draw(engine, 1600);
    const auto [closed, open] = holding(cells, p);
    const int side = side_of_star(mesh, p);
    if (side > 0) {
      EXPECT_EQ(closed, 0);
    }
    if (side == 0) {
      EXPECT_EQ(open, 0);
    }
    if (side >= 0) continue;
    EXPECT_GE(closed, 1);
  }
  for (const Point& v : mesh.vertices) {
    EXPECT_GE(holding(cells, real(v))[0], 1);
    EXPECT_EQ(holding(cells, real(v))[1], 0);
  }
}

TEST(OutsideCells, MoveWithTheBody) {
  const Mesh mesh = knobbly_ball(3, 100, 5);
  const Body b = body_of(mesh), moved = translated(mirrored(at_scale(b, 3 * b.scale)), {40, -7, 9});
  const std::vector<OutsideCell> before = outside_cells(b), after = outside_cells(moved);
  ASSERT_EQ(before.size(), after.size());
  std::mt19937 engine(4);
  for (int i = 0; i < 100; ++i) {
    const RealVector p = draw(engine, 160), s = scaled(Real(b.scale), p);
    const RealVector q = plus(scaled(Real(-3), s), scaled(Real(moved.scale), real(Point{40, -7, 9})));
    EXPECT_EQ(holding(before, s), holding(after, q));
  }
}

TEST(OutsideCells, OfMeshesThatOverlap) {
  const Mesh one = knobbly_ball(2, 100, 5);
  const Body a = body_of(one), c = translated(a, {120, 30, -10});
  Body both = united({&a, &c});
  both.parts.push_back(
      {Polytope::hull(std::vector<Point>{{0, 0, 0}, {0, 300, 0}, {40, 300, 0}, {0, 300, 50}}), {}, {}});
  const std::vector<OutsideCell> cells = outside_cells(both);
  std::mt19937 engine(6);
  for (int i = 0; i < 200; ++i) {
    const RealVector p = draw(engine, 320), s = scaled(Real(both.scale), p);
    const int side = std::max(side_of_star(one, p), side_of_star(one, minus(p, real(Point{120, 30, -10}))));
    int highest = -1;
    for (const HalfSpace& h : both.parts.back().planes()) highest = std::max(highest, h.value(s).sign());
    const auto [closed, open] = holding(cells, s);
    if (side > 0 || highest < 0) {
      EXPECT_EQ(closed, 0);
    }
    if (side >= 0 || highest <= 0) {
      EXPECT_EQ(open, 0);
    }
    if (side < 0 && highest > 0) {
      EXPECT_GE(closed, 1);
    }
  }
}

/// Where the one part ends in the other's plane nothing flat is left between them.
TEST(OutsideCells, HaveInteriorBetweenFlushParts) {
  const auto prism = [](const std::vector<std::array<std::int64_t, 2>>& ring, std::int64_t low, std::int64_t high) {
    std::vector<Point> corners;
    for (const auto& [x, y] : ring) {
      for (const std::int64_t z : {low, high}) corners.push_back({x, y, z});
    }
    return part_of(corners, Real());
  };
  const Body b{{prism({{12, 0}, {1, 8}, {-13, 6}, {-8, -8}, {5, -11}}, 0, 8),
                prism({{-12, 4}, {-4, -3}, {8, -9}, {14, 1}, {6, 11}, {-2, 8}}, 8, 13),
                prism({{-4, -3}, {-2, -13}, {8, -9}}, 8, 13)}};
  for (const OutsideCell& cell : outside_cells(b)) {
    if (cell.bounded()) {
      EXPECT_GT(cell.planes.size(), 3u);
    }
  }
}

plane::ShapePtr upright(const std::vector<plane::GridPoint>& polygon, std::int64_t high) {
  Solid solid;
  solid.form = Solid::Form::kPrism;
  solid.high = high;
  plane::Contour& ring = solid.contours.emplace_back();
  for (const plane::GridPoint& p : polygon) ring.push_back({p});
  return primitive(std::move(solid));
}

/// How deep the place is in the set; less than 0 outside.
double depth(const BodyPart& part, const RealVector& at) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const HalfSpace& h : part.planes()) highest = std::max(highest, h.approx_value(rounded(at)));
  return -highest;
}

/// A plate with drilled holes, in parts with rounded corners: no cell reaches into the plate.
TEST(OutsideCells, HaveNoCracksBetweenRoundedParts) {
  using Kind = plane::Shape::Kind;
  const auto plate = upright({{0, 0}, {60000000, 0}, {60000000, 40000000}, {0, 40000000}}, 5000000);
  std::vector<plane::ShapePtr> shapes{plate};
  std::vector<BodyPart> drills;
  for (const auto& [x, y] : {std::pair(10, 10), {50, 10}, {50, 30}, {10, 30}}) {
    std::vector<plane::GridPoint> ring;
    for (int k = 0; k < 16; ++k) {
      const double angle = k * std::acos(-1.0) / 8;
      const auto at = [](int c, double by) { return c * 1000000 + std::lround(3000 * by) * 1000; };
      ring.push_back({at(x, std::cos(angle)), at(y, std::sin(angle))});
    }
    shapes.push_back(upright(ring, 5000000));
    drills.push_back(body(*shapes.back()).parts.at(0));
  }
  const Body drilled = body(*node(Kind::kDifference, shapes));
  ASSERT_GT(drilled.rounded, 0);
  ASSERT_EQ(drilled.scale, 1);
  const BodyPart whole = body(*plate).parts.at(0);
  const double tolerance = 4 * std::max(1.0, drilled.moved);
  const auto reaches_in = [&](const RealVector& at) {
    const auto in_drill = [&](const BodyPart& d) { return depth(d, at) > -tolerance; };
    return depth(whole, at) > tolerance && std::none_of(drills.begin(), drills.end(), in_drill);
  };
  for (const OutsideCell& cell : outside_cells(drilled)) {
    for (const RealVector& v : cell.vertices) {
      for (const RealVector& w : cell.vertices) EXPECT_FALSE(reaches_in(scaled(Real::ratio(1, 2), plus(v, w))));
    }
  }
}

/// One step wide, between parts that lie on the grid.
TEST(OutsideCells, HaveSlotsBetweenExactParts) {
  const Body b = body(*node(plane::Shape::Kind::kUnion, {upright({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 8),
                                                         upright({{11, 0}, {20, 0}, {20, 10}, {11, 10}}, 8)}));
  ASSERT_EQ(b.rounded, 0);
  EXPECT_EQ(holding(outside_cells(b), {Real::ratio(21, 2), Real(5), Real(4)})[1], 1);
}

}  // namespace space_outside_cells
}  // namespace findspace::space
