// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sum of grid polygons from the curves that can be boundary, against the arrangement of the whole convolution, cell
// by cell: on shapes full of ties (lattice squares, with holes and slots), on random triangles, on stars whose
// convolution is pruned, and in sheets, whose outside is unbounded.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "differential/whole_sum.h"
#include "findspace/error.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/grid/grid_faces.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace plane_grid_sum {

Region triangles(std::mt19937& rng, std::int64_t size, int count) {
  std::vector<Region> parts;
  while (int(parts.size()) < count) {
    GridPoint p[3];
    for (auto& v : p) v = {std::int64_t(rng() % 9) * size, std::int64_t(rng() % 9) * size};
    std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) continue;
    if (area < 0) std::swap(p[1], p[2]);
    parts.push_back(ring({p[0], p[1], p[2]}));
  }
  return united(parts);
}

Region star(std::mt19937& rng, int n) {
  std::vector<GridPoint> points;
  for (int k = 0; k < n; ++k) {
    double r = (k % 2 ? 300 + rng() % 200 : 800 + rng() % 200) * 1000.0, angle = 6.283185307179586 * k / n;
    points.push_back({std::int64_t(r * std::cos(angle)), std::int64_t(r * std::sin(angle))});
  }
  return ring(points);
}

void compare(const Region& a, const Region& b, const std::string& what) {
  ASSERT_TRUE(grid_faces(a, in, false) && grid_faces(b, in, true)) << what;
  expect_same(contact_map(a, b), -1, whole_sum(a, in, b), what);
  if (!grid_faces(a, out, false)) return;
  expect_same(containment_map(a, b), 1, whole_sum(a, out, b), what + ", contained");
}

TEST(GridSum, SquaresWithSlotsAndHoles) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t side = seed % 2 ? 4 : 1000;
    compare(squares(rng, 5, 3 + rng() % 14, side), squares(rng, 3, 1 + rng() % 6, side),
            "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(GridSum, Triangles) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t size = seed % 2 ? 60 : 1000;
    compare(triangles(rng, size, 1), triangles(rng, size, 1), "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(GridSum, PartsInSheets) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t side = seed % 2 ? 4 : 1000;
    compare(squares(rng, 7, 20 + rng() % 20, side), squares(rng, 2, 1 + rng() % 3, side),
            "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

/// Star-shaped polygons with corners on a coarse lattice: parallel edges, ends that touch, curves that run along each
/// other.
std::optional<Region> lattice_star(std::mt19937& rng) {
  int n = 4 + int(rng() % 9);
  std::vector<Contour> rings(1);
  for (int k = 0; k < n; ++k) {
    double r = double(2 + rng() % 5), angle = 6.283185307179586 * k / n;
    rings[0].push_back({.start = {4 * std::llround(r * std::cos(angle)), 4 * std::llround(r * std::sin(angle))}});
  }
  try {
    return region_of_rings(make_rings(rings, 1).contours);
  } catch (const Error&) {
    return std::nullopt;  // it touches itself
  }
}

TEST(GridSum, LatticeStars) {
  int compared = 0;
  for (unsigned seed = 0; seed < 1500; ++seed) {
    std::mt19937 rng(seed);
    auto a = lattice_star(rng), b = lattice_star(rng);
    if (!a || !b) continue;
    ++compared;
    compare(*a, *b, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(compared, 300);
}

TEST(GridSum, SmallStars) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 rng(seed);
    compare(star(rng, 4 + 2 * int(rng() % 8)), star(rng, 4 + 2 * int(rng() % 8)), "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(GridSum, Stars) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    std::mt19937 rng(seed);
    compare(star(rng, 12 + 4 * int(seed)), star(rng, 40 - 2 * int(seed)), "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
  std::mt19937 rng(7);
  compare(star(rng, 60), star(rng, 64), "pruned");
}

}  // namespace plane_grid_sum
}  // namespace findspace::plane
