// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions on the lines of three axes: which components are certified, and volumes of walls of any thickness.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "space/rays/piece_rays.h"
#include "space/rays/ray_axes.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_ray_axes {

using exact::Real;

/// Boxes with corners in 1/10 steps.
RayAxes boxes(const std::vector<Corners>& all, const Point& low, const Point& high, int n) {
  std::vector<LinePiece> pieces;
  for (const Corners& c : all) {
    std::vector<HalfSpace> planes;
    for (std::size_t k = 0; k < 3; ++k) {
      RealVector normal;
      normal[k] = Real(1);
      planes.emplace_back(normal, Real(-c[1][k]));
      planes.emplace_back(negated(normal), Real(c[0][k]));
    }
    const auto corner = [&](std::size_t k) {
      return Vector{static_cast<double>(c[k][0]), static_cast<double>(c[k][1]), static_cast<double>(c[k][2])};
    };
    pieces.push_back(polytope_piece(std::move(planes), corner(0), corner(1)));
  }
  const RayLattice lattice = ray_lattice(low, high, n);
  return ray_axes(
      lattice, [&](int axis) { return std::make_unique<PieceRays>(pieces, 10, lattice.grid(axis)); },
      [](std::int8_t sign) { return sign <= 0; });
}

TEST(RayAxes, VolumeOfWallsParallelToTheLines) {
  // 7.3 x 5.1 x 3.7: lines of one axis alone are wrong by up to a step for every wall along them.
  const RayAxes r = boxes({{{{3, 4, 5}, {76, 55, 42}}}}, {0, 0, 0}, {10, 10, 10}, 50);
  EXPECT_NEAR(r.summary.volume, 7.3 * 5.1 * 3.7, 0.4);  // edges cut off: 64.4 of them by at most half a step squared
  ASSERT_EQ(r.summary.components.size(), 1U);
  EXPECT_TRUE(r.summary.components[0].certified);
  EXPECT_DOUBLE_EQ(r.summary.low[0], 0.3);
  EXPECT_DOUBLE_EQ(r.summary.high[2], 4.2);
}

TEST(RayAxes, ThinWallsAreMeasuredAcross) {
  // A wall between two planes of the lattice: only lines along x meet it.
  const RayAxes r = boxes({{{{41, 0, 0}, {42, 100, 100}}}}, {0, 0, 0}, {10, 10, 10}, 10);
  EXPECT_TRUE(r.surface.faces.empty());
  ASSERT_EQ(r.summary.components.size(), 1U);
  EXPECT_NEAR(r.summary.components[0].volume, 10, 1e-9);  // no sign: test
  EXPECT_FALSE(r.summary.components[0].certified);
}

TEST(RayAxes, NeighboursThatOnlyOverlapAreNotCertified) {
  // Apart by a twentieth of a step of the lattice, between its planes: overlapping intervals join them.
  const std::vector<Corners> apart{{{{0, 0, 0}, {44, 90, 90}}}, {{{45, 0, 0}, {90, 90, 90}}}};
  const RayAxes r = boxes(apart, {0, 0, 0}, {9, 9, 9}, 9);
  ASSERT_EQ(r.summary.components.size(), 1U);
  EXPECT_FALSE(r.summary.components[0].certified);
  // A door through which lines along x pass certifies.
  std::vector<Corners> joined = apart;
  joined.push_back({{{40, 30, 30}, {50, 60, 60}}});
  const RayAxes s = boxes(joined, {0, 0, 0}, {9, 9, 9}, 9);
  ASSERT_EQ(s.summary.components.size(), 1U);
  EXPECT_TRUE(s.summary.components[0].certified);
  // Farther apart they are two.
  const RayAxes two = boxes({{{{0, 0, 0}, {30, 90, 90}}}, {{{50, 0, 0}, {90, 90, 90}}}}, {0, 0, 0}, {9, 9, 9}, 9);
  ASSERT_EQ(two.summary.components.size(), 2U);
  EXPECT_TRUE(two.summary.components[0].certified && two.summary.components[1].certified);
  EXPECT_GT(two.summary.components[0].volume, two.summary.components[1].volume);
}

TEST(RayAxes, CertifiedByAWayAroundACorner) {
  // An L: no line of its two arms is common, the crossing is at the corner.
  const RayAxes r = boxes({{{{0, 0, 0}, {90, 20, 20}}}, {{{0, 0, 0}, {20, 90, 20}}}, {{{0, 0, 0}, {20, 20, 90}}}},
                          {0, 0, 0}, {9, 9, 9}, 18);
  ASSERT_EQ(r.summary.components.size(), 1U);
  EXPECT_TRUE(r.summary.components[0].certified);
  EXPECT_NEAR(r.summary.volume, 3 * 36 - 2 * 8, 4);
}

/// x + y + z within 1/10 of one of the numbers, in a cube of 9 steps.
RayAxes slanted_plates(const std::vector<std::int64_t>& at) {
  std::vector<LinePiece> pieces;
  for (const std::int64_t c : at) {
    std::vector<HalfSpace> planes;
    for (std::size_t k = 0; k < 3; ++k) {
      RealVector normal;
      normal[k] = Real(1);
      planes.emplace_back(normal, Real(-90));
      planes.emplace_back(negated(normal), Real(0));
    }
    const RealVector slanted{Real(1), Real(1), Real(1)};
    planes.emplace_back(slanted, Real(-c - 1));
    planes.emplace_back(negated(slanted), Real(c - 1));
    pieces.push_back(polytope_piece(std::move(planes), {0, 0, 0}, {90, 90, 90}));
  }
  const RayLattice lattice = ray_lattice({0, 0, 0}, {9, 9, 9}, 9);
  return ray_axes(
      lattice, [&](int axis) { return std::make_unique<PieceRays>(pieces, 10, lattice.grid(axis)); },
      [](std::int8_t sign) { return sign <= 0; });
}

/// A cube, 9 steps wide but that its face at the end of one axis lies in a plane of the lattice for the lines of one
/// axis, and just before it for the others.
RayAxes disputed(std::size_t face, int lines) {
  const RayLattice lattice = ray_lattice({0, 0, 0}, {10, 10, 10}, 10);
  const auto source = [&](int axis) {
    std::vector<HalfSpace> planes;
    for (std::size_t k = 0; k < 3; ++k) {
      RealVector normal;
      normal[k] = Real(1);
      planes.emplace_back(normal, Real(k != face ? -9000 : axis == lines ? -9500 : -9499));
      planes.emplace_back(negated(normal), Real(0));
    }
    return std::make_unique<PieceRays>(std::vector{polytope_piece(std::move(planes), {0, 0, 0}, {9500, 9500, 9500})},
                                       1000, lattice.grid(axis));
  };
  return ray_axes(lattice, source, [](std::int8_t sign) { return sign <= 0; });
}

TEST(RayAxes, LinesOfThreeAxesMayDiffer) {
  for (std::size_t face = 0; face < 3; ++face) {
    for (int lines = 0; lines < 3; ++lines) {  // edges are cut off, by at most half a step squared
      const RayAxes r = disputed(face, lines);
      EXPECT_EQ(r.summary.components.size(), 1U) << face << lines;
      EXPECT_NEAR(r.summary.volume, 9 * 9 * 9.5, 20) << face << lines;
      std::map<std::array<int, 2>, int> sides;
      for (const auto& f : r.surface.faces) {
        for (std::size_t k = 0; k < 3; ++k) ++sides[{f[k], f[(k + 1) % 3]}];
      }
      for (const auto& [side, times] : sides) {
        const auto back = sides.find({side[1], side[0]});
        ASSERT_TRUE(back != sides.end() && back->second == times);
      }
    }
  }
}

TEST(RayAxes, SplintersGoWithWhatIsNear) {
  // No two neighbouring lines meet a slanted plate in intervals that overlap, and no two lines cross in it.
  const RayAxes one = slanted_plates({135});
  ASSERT_EQ(one.summary.components.size(), 1U);
  EXPECT_FALSE(one.summary.components[0].certified);
  EXPECT_GT(one.summary.intervals, 100);
  // Some steps apart they are two.
  EXPECT_EQ(slanted_plates({95, 185}).summary.components.size(), 2U);
}

/// A box is near a line only where the line passes it.
TEST(PieceRays, LinesThatMeetABox) {
  const RayGrid grid{2, 2, -20, -20, 20, 20, 3, 3};  // at -10, 0 and 10
  const auto meets = [&](double from, double to) {
    return PieceRays::any_line(grid, {from, -1, 0}, {to, 1, 1}, 1) &&
           PieceRays::any_line(grid, {-1, from, 0}, {1, to, 1}, 1);
  };
  EXPECT_TRUE(meets(-30, 30));
  EXPECT_TRUE(meets(10, 11));
  EXPECT_TRUE(meets(-11, -10));
  EXPECT_FALSE(meets(1, 9));
  EXPECT_FALSE(meets(-40, -11));
  EXPECT_FALSE(meets(11, 40));
  EXPECT_FALSE(PieceRays::any_line(grid, {1, -1, 0}, {19, 1, 1}, 2));
}

}  // namespace space_ray_axes
}  // namespace findspace::space
