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
