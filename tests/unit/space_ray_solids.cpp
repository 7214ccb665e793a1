// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces that ray maps take only in part: with walls inside the set, beyond 2^38 steps; and a vertex of many ridges.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_pair.h"
#include "space/convolution/ray_solids.h"
#include "space/shape/shape_rays.h"
#include "unit/solid_shapes.h"

namespace findspace::space {
namespace space_ray_solids {

using exact::Real;
using Kind = plane::Shape::Kind;

plane::ShapePtr mesh_shape(Mesh mesh) {
  Solid solid;
  solid.form = Solid::Form::kMesh;
  solid.mesh = std::move(mesh);
  return primitive(std::move(solid));
}

/// A large box and a smaller one, the wall of the one in that of the other, as one mesh.
plane::ShapePtr two_rooms() {
  Mesh mesh;
  add_box(mesh, {0, 0, 0}, {12, 12, 12});
  add_box(mesh, {12, 3, 3}, {21, 9, 9});
  return mesh_shape(std::move(mesh));
}

TEST(RaySolids, WallsWithinAreKnown) {
  const plane::ShapePtr rooms = two_rooms();
  EXPECT_TRUE(ray_solids(*rooms)[0].inner_walls);
  EXPECT_TRUE(ray_solids(*node(Kind::kMirror, {node(Kind::kTranslate, {rooms}, {1, 2, 3})}))[0].inner_walls);
  Mesh apart;
  add_box(apart, {0, 0, 0}, {12, 12, 12});
  add_box(apart, {13, 3, 3}, {21, 9, 9});
  EXPECT_FALSE(ray_solids(*mesh_shape(std::move(apart)))[0].inner_walls);
}

TEST(RaySolids, WhatIsShrunkGoesOnAcrossWallsWithin) {
  plane::Shape shrunk = *node(Kind::kOffset, {two_rooms()});
  shrunk.amount = Real(-1);
  const RaySourcePointer rays = shape_rays(shrunk, {.axis = 0, .u = 5, .v = 5, .nu = 1, .nv = 1});
  const RayRow row = rays->row(0);
  for (const int x : {1, 11, 12, 13, 20}) EXPECT_LE(sign_at(row, 0, Real(x)), 0) << x;
  for (const int x : {0, 21}) EXPECT_EQ(sign_at(row, 0, Real(x)), 1) << x;
}

Triangles box_at(const Point& low, const Point& high) {
  Mesh mesh;
  add_box(mesh, low, high);
  return triangles(mesh);
}

/// Rows that only some pairs meet, one that none does, and boxes that touch.
TEST(UnitedPairs, AreTheLeastOfAllPairs) {
  const std::vector<Triangles> a{box_at({0, 0, 0}, {4, 4, 4}), box_at({20, 0, 3}, {25, 9, 8}),
                                 box_at({4, 0, 4}, {9, 2, 9})};
  const std::vector<Triangles> b{box_at({0, 0, 0}, {2, 2, 2}), box_at({5, 5, 5}, {6, 7, 8})};
  for (int axis = 0; axis < 3; ++axis) {
    const RayGrid grid{axis, 2, -31, -33, 5, 4, 20, 24};
    const UnitedPairs united(a, b, grid);
    std::vector<RaySourcePointer> each;
    for (const Triangles& s : b) {
      for (const Triangles& t : a) each.push_back(std::make_unique<PairRays>(t, s, grid));
    }
    const RaySourcePointer least = least_rays(std::move(each));
    for (int round = 0; round < 2; ++round) {
      for (int j = 0; j < grid.nv; ++j) {
        const RayRow row = united.row(j), expected = least->row(j);
        EXPECT_EQ(row.before, expected.before);
        EXPECT_EQ(row.first, expected.first);
        ASSERT_EQ(row.events.size(), expected.events.size());
        for (std::size_t k = 0; k < row.events.size(); ++k) {
          EXPECT_EQ(compare_positions(row.events[k].at, expected.events[k].at), 0);
          EXPECT_EQ(row.events[k].here, expected.events[k].here);
          EXPECT_EQ(row.events[k].after, expected.events[k].after);
        }
        EXPECT_TRUE(!united.apart(j) || row.events.empty());
      }
    }
    EXPECT_TRUE(united.apart(grid.nv - 1));
  }
}

TEST(RaySolids, WhatLiesTooFarOutIsRefused) {
  constexpr std::int64_t kFar = std::int64_t{1} << 39;
  Mesh far;
  add_box(far, {kFar, 0, 0}, {kFar + 10, 10, 10});
  const auto there = try_ray_solids(*mesh_shape(std::move(far)));
  ASSERT_FALSE(there);
  EXPECT_FALSE(there.refusal().fault());
  const auto moved_there = try_ray_solids(*node(Kind::kTranslate, {two_rooms()}, {kFar, 0, 0}));
  ASSERT_FALSE(moved_there);
  EXPECT_FALSE(moved_there.refusal().fault());
}

/// A floor of pleats that meet in the origin, on a round block, and a ceiling over it.
Triangles pleated(int ridges) {
  constexpr std::int64_t kWide = 1000000, kHigh = 100000;
  Mesh mesh;
  const int count = 2 * ridges;
  mesh.vertices = {{0, 0, 0}, {0, 0, -kWide}};
  for (int k = 0; k < count; ++k) {
    const double angle = std::numbers::pi * k / ridges, wide = static_cast<double>(kWide);
    const std::int64_t x = std::llround(wide * std::cos(angle)), y = std::llround(wide * std::sin(angle));
    mesh.vertices.push_back({x, y, k % 2 == 0 ? kHigh : -kHigh});
    mesh.vertices.push_back({x, y, -kWide});
  }
  for (int k = 0; k < count; ++k) {
    const int top = 2 + 2 * k, next = 2 + 2 * ((k + 1) % count);
    mesh.faces.insert(mesh.faces.end(), {{0, top, next}, {1, next + 1, top + 1}, {top, top + 1, next + 1, next}});
  }
  add_box(mesh, {-2 * kWide, -2 * kWide, 3 * kHigh}, {2 * kWide, 2 * kWide, 4 * kHigh});
  return triangles(mesh);
}

TEST(RaySolids, AVertexOfManyRidges) {
  Mesh box;
  add_box(box, {-5, -5, -5}, {5, 5, 5});
  const Triangles housing = pleated(130), cube = triangles(box);
  const RayGrid line{.axis = 2, .u = 1, .v = 2, .nu = 1, .nv = 1};
  const PairRays of_cube(housing, cube, line);
  const BallRays of_ball(housing, Real(5), line);
  for (const RaySource* rays : std::initializer_list<const RaySource*>{&of_cube, &of_ball}) {
    const RayRow row = rays->row(0);
    EXPECT_EQ(sign_at(row, 0, Real(-100)), -1);
    EXPECT_EQ(sign_at(row, 0, Real(100000)), 1);
    EXPECT_EQ(sign_at(row, 0, Real(350000)), -1);
  }
}

}  // namespace space_ray_solids
}  // namespace findspace::space
