// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces from rays: closed, outward, with the volume of the region, and every vertex on its frontier by an
// independent oracle.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "space/convolution/ray_pair.h"
#include "space/rays/ray_surface.h"
#include "space_voxels.h"

namespace findspace::space {
namespace space_ray_surface {

double volume(const RaySurface& s) {
  double sum = 0;
  for (const auto& [i, j, k] : s.faces) {
    const auto &a = s.vertices[i], &b = s.vertices[j], &c = s.vertices[k];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

void expect_closed(const RaySurface& s) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& f : s.faces) {
    for (int k = 0; k < 3; ++k) {
      const int a = f[k], b = f[(k + 1) % 3];
      sides[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  for (const auto& [side, balance] : sides) ASSERT_EQ(balance, 0) << side.first << " " << side.second;
}

RaySurface overlap_surface(const Triangles& a, const Triangles& b, const RayLattice& lattice) {
  return ray_surface(
      lattice, [&](int axis) { return std::make_unique<PairRays>(a, b, lattice.grid(axis)); },
      [](std::int8_t sign) { return sign <= 0; });
}

TEST(RaySurface, closed_and_on_the_frontier) {
  const Cells frame = extruded({"####", "#..#", "#..#", "####"}, 1), cube = extruded({"#"}, 1);
  const LinearMap on_frame{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}},
      on_cube{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};
  const Triangles a = surface(frame, on_frame), b = surface(cube, on_cube);
  const RayBody body(a), other(b);
  const RayLattice lattice = ray_lattice(body.low - other.high, body.high - other.low, 40);
  const RaySurface s = overlap_surface(a, b, lattice);
  ASSERT_GT(s.faces.size(), 1000u);
  expect_closed(s);
  const auto p = parts_of(frame, on_frame), q = parts_of(cube, on_cube);
  const PhiUnion oracle(p, q);
  for (const auto& v : s.vertices) {
    // Rounded once, so off the frontier by roundings of coordinates below 2^12.
    ASSERT_LT(std::fabs(oracle.normalised({v[0], v[1], v[2]})), 0x1p-30);
  }
  // The hole goes through: the Euler characteristic of a torus.
  std::map<std::pair<int, int>, int> sides;
  for (const auto& f : s.faces) {
    for (int k = 0; k < 3; ++k) ++sides[std::minmax(f[k], f[(k + 1) % 3])];
  }
  EXPECT_EQ(static_cast<int>(s.vertices.size()) - static_cast<int>(sides.size()) + static_cast<int>(s.faces.size()), 0);
}

TEST(RaySurface, volume_of_a_box) {
  const Cells cube = extruded({"#"}, 1);
  const Triangles a = surface(cube, stretch(30)), b = surface(cube, stretch(10));
  const RayLattice lattice = ray_lattice({-10, -10, -10}, {30, 30, 30}, 25);
  const RaySurface s = overlap_surface(a, b, lattice);
  expect_closed(s);
  EXPECT_NEAR(volume(s), 64000, 64000 * 0.02);  // edges are cut off
}

}  // namespace space_ray_surface
}  // namespace findspace::space
