// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Overlap of solids that are not convex on rays against CGAL's Minkowski sum of Nef polyhedra: random positions on the
// lines, operands off the origin, in both orders, a body in the hole of a ring, and a passage of no width.
#include "differential/space_nef.h"
#include "differential/space_voxels.h"

namespace findspace::space {
namespace space_cgal_nef {

using nef_oracle::compare;

const LinearMap kSkew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, kTilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};

TEST(NefCgal, BracketAndCube) {
  const Triangles bracket = moved(surface(extruded({"##", "#."}, 1), kSkew), {1000, -500, 77});
  const Triangles cube = moved(surface(extruded({"#"}, 1), kTilt), {-30, 40, 500});
  compare(bracket, cube, 400);
  compare(cube, bracket, 400);
}

TEST(NefCgal, BarInTheHoleOfARing) {
  compare(surface(extruded({"###", "#.#", "###"}, 1), kSkew), surface(extruded({"#"}, 3), stretch(20)), 300);
}

TEST(NefCgal, BracketsOnALattice) {
  const Triangles u = surface(extruded({"#.#..#", "######"}, 1), stretch(10)),
                  cube = surface(extruded({"#"}, 1), stretch(10));
  compare(u, cube, 400);  // the cube just fits in: a passage of no width
}

}  // namespace space_cgal_nef
}  // namespace findspace::space
