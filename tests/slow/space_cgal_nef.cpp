// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Overlap on rays against CGAL's Minkowski sums of Nef polyhedra at 100,000 random positions a pair, and volumes on
// 512 x 512 lines: brackets, a gear, a torus, a torus in a hole, a passage of no width, operands off the origin, both
// orders.
#include "differential/space_nef.h"
#include "differential/space_voxels.h"
#include "differential/space_wheels.h"

namespace findspace::space {
namespace space_cgal_nef {

using nef_oracle::compare;
using nef_oracle::compare_volume;

constexpr int kPlaces = 100000;

const LinearMap kSkew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, kTilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};

TEST(NefSlow, BracketAndGear) {
  const Triangles bracket = moved(surface(extruded({"##", "#."}, 1), kSkew), {1000, -500, 77});
  const Triangles wheel = moved(gear(5, 40, 90, 60), {-30, 40, 500});
  compare(bracket, wheel, kPlaces);
  compare(wheel, bracket, kPlaces);
  compare_volume(bracket, wheel, 512);
}

TEST(NefSlow, Torus) {
  const Triangles ring = moved(torus(200, 70, 8, 5), {77, 5, -60}), cube = surface(extruded({"#"}, 1), kTilt);
  compare(ring, cube, kPlaces);
  compare(cube, ring, kPlaces);
  compare_volume(cube, ring, 512);
}

/// A torus through the hole of a frame: overlaps with the Euler characteristic of a ring.
TEST(NefSlow, TorusInAHole) {
  const Triangles frame = surface(extruded({"###", "#.#", "###"}, 1), kSkew), ring = torus(60, 15, 6, 4);
  compare(frame, ring, kPlaces);
  compare(ring, frame, kPlaces);
}

TEST(NefSlow, PassageOfNoWidth) {
  const Triangles u = surface(extruded({"#.#..#", "######"}, 1), stretch(10)),
                  cube = surface(extruded({"#"}, 1), stretch(10));
  compare(u, cube, kPlaces);
  compare(cube, u, kPlaces);
}

}  // namespace space_cgal_nef
}  // namespace findspace::space
