// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces that are hard on ray maps: a vertex of many ridges.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "space/convolution/ray_ball.h"
#include "space/convolution/ray_pair.h"
#include "unit/solid_shapes.h"

namespace findspace::space {
namespace space_ray_solids {

using exact::Real;

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
