// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids grown by a ball: solids of boxes against the exact distance to boxes, also along seams, walls and slits;
// slanted solids between a polytope inside the ball and one about it.
#include <gtest/gtest.h>

#include "space/convolution/ray_ball.h"
#include "space_voxels.h"

namespace findspace::space {
namespace space_ray_ball {

using exact::Real;

/// The sign of the distance of (x, y, z) to a union of cells of side k, less r.
int box_sign(const Cells& cells, std::int64_t k, const std::array<Real, 3>& p, const Real& r) {
  int least = 1;
  for (const Cell& c : cells) {
    Real square;
    for (int i = 0; i < 3; ++i) {
      const Real low(c[i] * k), high((c[i] + 1) * k);
      const Real gap = p[i] < low ? low - p[i] : p[i] > high ? p[i] - high : Real(0);
      square += gap * gap;
    }
    least = std::min(least, exact::compare(square, r * r));
  }
  return least;
}

void compare(const Cells& cells, std::int64_t k, const Real& r, const RayGrid& grid, int sense) {
  const Cells solid = sense > 0 ? cells : around(cells, 4);
  const BallRays rays(surface(cells, stretch(k)), r, grid,
                      sense > 0 ? BallRays::Side::kSolid : BallRays::Side::kComplement);
  int wrong = 0;
  const Real parts(grid.parts);
  const auto ask = [&](int i, int j, const Real& z, int sign) {
    std::array<Real, 3> p;
    p[(grid.axis + 1) % 3] = Real(grid.u_at(i)) / parts;
    p[(grid.axis + 2) % 3] = Real(grid.v_at(j)) / parts;
    p[grid.axis] = z / parts;
    const int truth = sense * box_sign(solid, k, p, r);
    if (truth != sign && ++wrong < 5) {
      ADD_FAILURE() << p[0].text() << " " << p[1].text() << " " << p[2].text() << ": " << sign << ", should be "
                    << truth;
    }
  };
  for (int j = 0; j < grid.nv; ++j) {
    const RayRow row = rays.row(j);
    for (int i = 0; i < grid.nu; ++i) {
      int before = row.before[i];
      for (int e = row.first[i]; e < row.first[i + 1]; ++e) {
        const Real at = row.events[e].at.to_real();
        ask(i, j, at, row.events[e].here);
        const Real below = e == row.first[i] ? at - Real(1) : row.events[e - 1].at.to_real();
        ask(i, j, (at + below) / Real(2), before);
        ask(i, j, (at * Real(7) + below) / Real(8), before);
        before = row.events[e].after;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

RayGrid square(int axis, std::int64_t parts, std::int64_t from, std::int64_t step, int count) {
  return {axis, parts, from, from, step, step, count, count};
}

const Cells kFork = extruded({"###", "#.#", "#.#"}, 1);

TEST(RayBall, boxes_beside_the_lattice) {
  compare(kFork, 4, Real(1), square(2, 8, -17, 11, 14), 1);
  compare(kFork, 4, Real::ratio(7, 2), square(0, 4, -19, 9, 11), 1);
}

TEST(RayBall, boxes_on_seams_and_in_walls) {
  // A slit of width 4 closes at radius 2: a sheet at distance exactly 2 is left.
  compare(kFork, 4, Real(2), square(2, 1, -3, 1, 18), 1);
  compare(kFork, 4, Real(2), square(1, 1, -3, 1, 18), 1);
}

TEST(RayBall, inside_by_the_complement) {
  compare(extruded({"###", "###", ".##"}, 2), 4, Real(2), square(2, 2, 0, 3, 8), -1);
  compare(extruded({"###", "###", ".##"}, 2), 4, Real(2), square(0, 1, 0, 2, 7), -1);
}

TEST(RayBall, slanted_solids_between_two_polytopes) {
  std::mt19937 random(5);
  const LinearMap map{{{90, 20, -15}, {-25, 110, 30}, {12, -28, 95}}};
  const Cells cells = random_cells(random, 9, 3);
  std::vector<Point> inner, outer;
  for (int a = -4; a <= 4; ++a) {
    for (int b = -4; b <= 4; ++b) {
      for (int c = -4; c <= 4; ++c) {
        if (std::max({std::abs(a), std::abs(b), std::abs(c)}) != 4) continue;
        const double s = std::sqrt(double(a * a + b * b + c * c));
        inner.push_back({std::int64_t(60 * a / s), std::int64_t(60 * b / s), std::int64_t(60 * c / s)});
        outer.push_back({std::llround(64 * a / s), std::llround(64 * b / s), std::llround(64 * c / s)});
      }
    }
  }
  const auto p = parts_of(cells, map);
  const std::vector<Polytope> low{Polytope::hull(inner)}, high{Polytope::hull(outer)};
  const PhiUnion within(p, low), about(p, high);
  const RayGrid grid = square(2, 1, -120, 13, 45);
  const BallRays rays(surface(cells, map), Real(60), grid);
  int decided = 0;
  for (int j = 0; j < grid.nv; ++j) {
    const RayRow row = rays.row(j);
    for (int i = 0; i < grid.nu; ++i) {
      int e = row.first[i], sign = row.before[i];
      for (int z = -200; z <= 500; z += 19) {
        while (e < row.first[i + 1] && row.events[e].at.value < z) sign = row.events[e++].after;
        const Vector u{double(grid.u_at(i)), double(grid.v_at(j)), double(z)};
        const bool nearer = within.sign(u)<0, farther = about.sign(u)> 0;
        decided += nearer || farther;
        if (nearer) {
          ASSERT_EQ(sign, -1) << u.x << " " << u.y << " " << u.z;
        }
        if (farther) {
          ASSERT_EQ(sign, 1) << u.x << " " << u.y << " " << u.z;
        }
      }
    }
  }
  EXPECT_GT(decided, 50000);
}

}  // namespace space_ray_ball
}  // namespace findspace::space
