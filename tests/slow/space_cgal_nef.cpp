// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Overlap on rays against CGAL's Minkowski sums of Nef polyhedra at 100,000 random positions a pair: brackets, a gear,
// a torus, a torus in a hole, a passage of no width, operands off the origin, both orders.
#include <cmath>

#include "differential/space_nef.h"
#include "differential/space_voxels.h"

namespace findspace::space {
namespace {

using nef_oracle::compare;

constexpr int kPlaces = 100000;

const LinearMap kSkew{{{100, 17, 3}, {-9, 90, 11}, {5, -13, 120}}}, kTilt{{{50, 3, -8}, {7, 40, 9}, {-5, 2, 60}}};

Point rounded(double x, double y, double z) { return {std::llround(x), std::llround(y), std::llround(z)}; }

/// About z.
Triangles torus(double radius, double tube, int around, int across) {
  Triangles t;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * (k + 0.5 * (i % 2)) / across;
      const double r = radius + tube * std::cos(v);
      t.points.push_back(rounded(r * std::cos(u), r * std::sin(u), tube * std::sin(v)));
    }
  }
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const int a = i * across + k, b = (i + 1) % around * across + k, next = (k + 1) % across;
      const int c = (i + 1) % around * across + next, d = i * across + next;
      t.faces.push_back({a, b, c});
      t.faces.push_back({a, c, d});
    }
  }
  return t;
}

/// A prism of `teeth` teeth, star-shaped about the axis.
Triangles gear(int teeth, double inner, double outer, double height) {
  Triangles t;
  const int n = 2 * teeth;
  for (const double z : {0.0, height}) {
    t.points.push_back(rounded(0, 0, z));
    for (int k = 0; k < n; ++k) {
      const double r = k % 2 ? outer : inner, u = M_PI * k / teeth;
      t.points.push_back(rounded(r * std::cos(u), r * std::sin(u), z));
    }
  }
  for (int k = 0; k < n; ++k) {
    const int a = 1 + k, b = 1 + (k + 1) % n, c = a + n + 1, d = b + n + 1;
    t.faces.push_back({0, b, a});
    t.faces.push_back({n + 1, c, d});
    t.faces.push_back({a, b, d});
    t.faces.push_back({a, d, c});
  }
  return t;
}

TEST(NefSlow, BracketAndGear) {
  const Triangles bracket = moved(surface(extruded({"##", "#."}, 1), kSkew), {1000, -500, 77});
  const Triangles wheel = moved(gear(5, 40, 90, 60), {-30, 40, 500});
  compare(bracket, wheel, kPlaces);
  compare(wheel, bracket, kPlaces);
}

TEST(NefSlow, Torus) {
  const Triangles ring = moved(torus(200, 70, 8, 5), {77, 5, -60}), cube = surface(extruded({"#"}, 1), kTilt);
  compare(ring, cube, kPlaces);
  compare(cube, ring, kPlaces);
}

/// A torus through the hole of a frame: overlaps with the Euler characteristic of a ring.
TEST(NefSlow, TorusInAHole) {
  compare(surface(extruded({"###", "#.#", "###"}, 1), kSkew), torus(60, 15, 6, 4), kPlaces);
}

TEST(NefSlow, PassageOfNoWidth) {
  const Triangles u = surface(extruded({"#.#..#", "######"}, 1), stretch(10)),
                  cube = surface(extruded({"#"}, 1), stretch(10));
  compare(u, cube, kPlaces);
  compare(cube, u, kPlaces);
}

}  // namespace
}  // namespace findspace::space
