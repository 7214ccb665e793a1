// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "space/polytope/longest_chord.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_longest_chord {

using exact::Real;

HalfSpace half_space(int x, int y, int z, int offset) {
  return HalfSpace(RealVector{Real(x), Real(y), Real(z)}, Real(offset));
}

RealVector vector(int x, int y, int z) { return {Real(x), Real(y), Real(z)}; }

TEST(LongestChord, DiagonalsOfACube) {
  const ConvexRegion cube(vector(0, 0, 0), vector(2, 2, 2));
  const LongestChord whole = longest_chord(cube, vector(1, 1, 1));
  EXPECT_EQ(whole.length, Real(2));
  EXPECT_EQ(whole.middle, vector(1, 1, 1));
  EXPECT_TRUE(whole.inside);
  // Those of the two faces and all between them: one between is taken.
  const LongestChord flat = longest_chord(cube, vector(2, -2, 0));
  EXPECT_EQ(flat.length, Real(1));
  EXPECT_EQ(flat.middle, vector(1, 1, 1));
  EXPECT_TRUE(flat.inside);
}

/// The longest are in the upright face of a wedge: nothing inside is as long.
TEST(LongestChord, InAFacetOnly) {
  ConvexRegion wedge(vector(0, 0, 0), vector(2, 1, 2));
  wedge.cut(half_space(1, 0, 1, -2));
  const LongestChord found = longest_chord(wedge, vector(0, 0, 1));
  EXPECT_EQ(found.length, Real(2));
  EXPECT_EQ(found.middle[0], Real(0));
  EXPECT_FALSE(found.inside);
}

/// A tetrahedron of two edges that cross seen from above.
TEST(LongestChord, BetweenCrossingEdges) {
  ConvexRegion tetrahedron(vector(-1, -1, 0), vector(1, 1, 1));
  for (const int side : {-1, 1}) {
    tetrahedron.cut(half_space(side, 0, 1, -1));
    tetrahedron.cut(half_space(0, side, -1, 0));
  }
  const LongestChord found = longest_chord(tetrahedron, vector(0, 0, 1));
  EXPECT_EQ(found.length, Real(1));
  EXPECT_EQ(found.middle, (RealVector{Real(0), Real(0), Real::ratio(1, 2)}));
  EXPECT_TRUE(found.inside);
}

/// No line through a lattice of places has a longer one, and the one found is as long as it says.
TEST(LongestChord, AsInBruteForce) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> some(-5, 5);
  for (int n = 0; n < 40; ++n) {
    ConvexRegion region(vector(-8, -8, -8), vector(8, 8, 8));
    for (int k = 0; k < 6; ++k) region.cut(half_space(some(random), some(random), 6, -20 - 3 * k));
    for (int k = 0; k < 6; ++k) region.cut(half_space(some(random), some(random), -5, -20 - 3 * k));
    const RealVector u = vector(some(random), some(random), 3);
    const LongestChord found = longest_chord(region, u);
    const auto length_at = [&](const Vector& x) {
      double from = -1e9, to = 1e9;
      for (const HalfSpace& h : region.planes()) {
        const double slope = dot(h.unit, rounded(u)), at = -h.approx_value(x) / slope;
        if (slope > 1e-12) to = std::min(to, at);
        if (slope < -1e-12) from = std::max(from, at);
        if (std::fabs(slope) <= 1e-12 && h.approx_value(x) > 1e-9) return -1.0;
      }
      return to - from;
    };
    const double most = found.length.to_double();
    EXPECT_NEAR(length_at(rounded(found.middle)), most, 1e-9);
    for (int i = -32; i <= 32; ++i) {
      for (int j = -32; j <= 32; ++j) EXPECT_LT(length_at({i / 4.0, j / 4.0, 0}), most + 1e-9);
    }
  }
}

/// Of a point grown the diameter; of a box where the direction leaves a box twice as large grown by twice the radius.
TEST(LongestChord, OfGrownSets) {
  const ConvexRegion point(vector(1, 2, 3), vector(1, 2, 3)), box(vector(0, 0, 0), vector(2, 4, 6)),
      segment(vector(0, 0, 0), vector(0, 0, 6));
  const LongestChord ball = longest_chord(point, Real(3), vector(1, 2, 2));
  EXPECT_EQ(ball.length, Real(2));
  EXPECT_EQ(ball.middle, vector(1, 2, 3));
  const LongestChord at_edge = longest_chord(box, Real(1), vector(3, 4, 0));
  EXPECT_EQ(at_edge.length * Real(5), (Real(22) + Real(2) * sqrt(Real(21))) / Real(5));  // at a cylinder
  EXPECT_TRUE(at_edge.inside);
  EXPECT_EQ(longest_chord(box, Real(1), vector(0, 0, 2)).length, Real(4));      // at a face
  EXPECT_EQ(longest_chord(segment, Real(1), vector(0, 0, 1)).length, Real(8));  // at an end
  EXPECT_EQ(longest_chord(segment, Real(1), vector(1, 0, 0)).length, Real(2));  // about the segment
  EXPECT_EQ(longest_chord(segment, Real(1), vector(1, 0, 1)).length, Real(2));
  // Half the face and the other edge of a tetrahedron: z at most 1 less twice what is across.
  ConvexRegion tetrahedron(vector(-1, -1, 0), vector(1, 1, 1));
  for (const int side : {-1, 1}) {
    tetrahedron.cut(half_space(side, 0, 1, -1));
    tetrahedron.cut(half_space(0, side, -1, 0));
  }
  EXPECT_EQ(longest_chord(tetrahedron, Real(1), vector(0, 0, 1)).length, Real(3));  // between two edges
}

}  // namespace space_longest_chord
}  // namespace findspace::space
