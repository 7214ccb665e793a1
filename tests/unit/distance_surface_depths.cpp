// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How near positions may be at which two solids do not overlap, one of them with a fine surface: of cubes that is
// known.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

#include "distance/surface/surface_depths.h"

namespace findspace::distance {
namespace distance_surface_depths {

using space::Vector;

/// About 0, each face in `across` times `across` squares, of two triangles each.
space::Triangles cube(std::int64_t half, std::int64_t across) {
  space::Triangles out;
  std::map<std::array<std::int64_t, 3>, int> known;
  const auto corner = [&](std::size_t axis, std::int64_t side, std::int64_t i, std::int64_t j) {
    std::array<std::int64_t, 3> at{};
    at[axis] = side * half;
    at[(axis + 1) % 3] = 2 * half * i / across - half;
    at[(axis + 2) % 3] = 2 * half * j / across - half;
    const auto [found, made] = known.emplace(at, static_cast<int>(out.points.size()));
    if (made) out.points.push_back({at[0], at[1], at[2]});
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::int64_t side : {-1, 1}) {
      for (std::int64_t i = 0; i < across; ++i) {
        for (std::int64_t j = 0; j < across; ++j) {
          const int a = corner(axis, side, i, j), b = corner(axis, side, i + 1, j),
                    c = corner(axis, side, i + 1, j + 1), d = corner(axis, side, i, j + 1);
          const bool out_is_along = side > 0;
          out.faces.push_back(out_is_along ? std::array{a, b, c} : std::array{a, c, b});
          out.faces.push_back(out_is_along ? std::array{a, c, d} : std::array{a, d, c});
        }
      }
    }
  }
  return out;
}

space::SurfaceSet surface(std::int64_t half, std::int64_t across) {
  space::SurfaceSet out;
  EXPECT_TRUE(out.add({space::RaySolid{cube(half, across), {}}}, 1));
  return out;
}

double widest(const Vector& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

constexpr std::int64_t kHalfOfA = 6700, kHalfOfB = 1000;
constexpr double kApart = kHalfOfA + kHalfOfB;  // along an axis they no longer overlap

TEST(SurfaceDepths, OverlapOfCubesIsNoMoreThanItIs) {
  const space::SurfaceSet a = surface(kHalfOfA, 67), b = surface(kHalfOfB, 1);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> pick(-1, 1);
  const auto any = [&](double size) { return Vector{size * pick(random), size * pick(random), size * pick(random)}; };
  int more = 0;
  for (const bool fine_moves : {false, true}) {
    SurfaceDepths depths(fine_moves ? a : b, fine_moves ? b : a, space::TouchSide::kOutside);
    int likely = SurfaceDepths::kNone;
    for (int k = 0; k < 200; ++k) {
      const Vector from = any(5000), middle = space::plus(from, any(4000)), half{200 + 100 * pick(random), 300, 400};
      const space::Extent box{middle - half, space::plus(middle, half)};
      const double known = 100, told = depths.overlap(box, from, known, likely);
      EXPECT_GE(told, known);
      if (!(told > known)) continue;
      ++more;
      for (int n = 0; n < 40; ++n) {
        const Vector off{half.x * pick(random), half.y * pick(random), half.z * pick(random)},
            q = space::plus(middle, off);
        if (space::length(q - from) < told) {
          EXPECT_LT(widest(q), kApart);
        }
      }
    }
  }
  EXPECT_GT(more, 20);
}

TEST(SurfaceDepths, OverlapOfCubesThatAreApartIsWhatIsKnown) {
  const space::SurfaceSet a = surface(kHalfOfA, 67), b = surface(kHalfOfB, 1);
  SurfaceDepths depths(b, a, space::TouchSide::kOutside);
  int likely = SurfaceDepths::kNone;
  const Vector far{kApart + 500, 0, 0}, half{100, 100, 100};
  EXPECT_EQ(depths.overlap({far - half, space::plus(far, half)}, {kApart - 100, 0, 0}, 50, likely), 50);
}

}  // namespace distance_surface_depths
}  // namespace findspace::distance
