// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sum of grid polygons from the curves that can be boundary, against the arrangement of the whole convolution, cell
// by cell: on shapes full of ties (lattice squares, with holes and slots), on random triangles, on stars whose
// convolution is pruned, in sheets, whose outside is unbounded, and on staircases and combs whose curves overlap. And
// whether points lie in sums of many corners.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>

#include "differential/whole_sum.h"
#include "findspace/error.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/grid/grid_faces.h"
#include "plane/grid/merged_curves.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/sum/pair_sums.h"

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

Region star(std::mt19937& rng, int n, double unit = 1000) {
  std::vector<GridPoint> points;
  for (int k = 0; k < n; ++k) {
    double r = (k % 2 ? 300 + rng() % 200 : 800 + rng() % 200) * unit, angle = 6.283185307179586 * k / n;
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

/// Of so many corners and rings that what is near a point alone decides about it.
TEST(GridSum, ManySmallRings) {
  std::mt19937 rng(3);
  std::vector<Region> boxes;
  for (std::int64_t x = 0; x < 60; x += 10) {
    for (std::int64_t y = 0; y < 400; y += 10) {
      const auto w = std::int64_t(1 + rng() % 7), h = std::int64_t(1 + rng() % 7);
      boxes.push_back(ring({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}));
    }
  }
  const Region all = united(boxes);
  compare(all, ring({{0, 0}, {3, 0}, {3, 2}, {0, 2}}), "a box");
  compare(all, ring({{0, 0}, {4, 1}, {1, 5}}), "a triangle");
  compare(all, ring({{0, 0}, {9, 0}, {9, 9}, {4, 3}, {0, 9}}), "a notched box, as large as the gaps");
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

/// Whether curves are made one.
bool merges(const Region& a, const Region& b) {
  const auto p = grid_faces(a, in, false), q = grid_faces(b, in, true);
  return p && q && merging_pays(reduced_convolution({*p, a.geometry}, {*q, b.geometry}));
}

Region stairs(int steps, std::int64_t width, std::int64_t height) {
  std::vector<GridPoint> points{{0, 0}, {width * steps, 0}};
  for (int k = steps; k-- > 0;)
    points.insert(points.end(), {{width * (k + 1), height * (steps - k)}, {width * k, height * (steps - k)}});
  return ring(points);
}

/// Teeth that point up.
Region comb(int teeth, std::int64_t width, std::int64_t gap, std::int64_t length) {
  const std::int64_t whole = (width + gap) * teeth - gap, spine = 40;
  std::vector<GridPoint> points{{0, 0}, {whole, 0}};
  for (int k = teeth; k-- > 0;) {
    const std::int64_t x = (width + gap) * k;
    points.insert(points.end(), {{x + width, spine + length}, {x, spine + length}});
    if (k > 0) points.insert(points.end(), {{x, spine}, {x - gap, spine}});
  }
  return ring(points);
}

TEST(GridSum, Staircases) {
  for (const std::int64_t width : {40, 41, 80}) {
    const Region a = stairs(30, 40, 30), b = stairs(31, width, 30), turned = mirrored(b);
    EXPECT_TRUE(merges(a, turned) || width != 40);
    compare(a, turned, "width " + std::to_string(width));
    compare(a, b, "mirrored, width " + std::to_string(width));
    if (HasFatalFailure()) return;
  }
}

/// Where widths and gaps are equal, the teeth of the sum touch: slots of no width stay between them.
TEST(GridSum, CombsWithSlotsOfNoWidth) {
  for (const std::int64_t gap : {20, 21, 40}) {
    const Region a = comb(19, 20, gap, 300), b = comb(18, 20, gap, 300), turned = mirrored(b);
    EXPECT_TRUE(merges(a, turned) || gap == 21);
    compare(a, turned, "gap " + std::to_string(gap));
    compare(a, b, "mirrored, gap " + std::to_string(gap));
    if (HasFatalFailure()) return;
  }
  const SignMap map = contact_map(comb(19, 20, 20, 300), mirrored(comb(18, 20, 20, 300)));
  const auto slots = std::count_if(map.edges.begin(), map.edges.end(), [&](const Edge& e) {
    const auto k = std::size_t(&e - map.edges.data());
    return e.mark == 0 && map.faces[map.half_edges[2 * k].face].mark < 0 &&
           map.faces[map.half_edges[2 * k + 1].face].mark < 0;
  });
  EXPECT_EQ(slots, 35) << "between 36 teeth";
}

/// A plate that lacks a comb, and the comb: it fits in one place only.
TEST(GridSum, CombsThatFitExactly) {
  const Region a = comb(24, 20, 20, 300), plate = ring({{-50, -50}, {1200, -50}, {1200, 500}, {-50, 500}});
  const std::array<const CellComplex*, 2> both{&plate, &a};
  const Region left = closure(overlay(both, [](std::span<const Mark> m) { return Mark(m[0] > 0 && m[1] <= 0); }));
  EXPECT_TRUE(merges(left, a));
  compare(left, a, "plate");
}

/// Whether places lie in a sum of so many corners that some of them are tried first (convolution_index.h), against the
/// winding numbers of all curves.
void compare_points(const Region& a, bool (*wanted)(Mark), const Region& b, std::mt19937& rng, std::int64_t far = 5) {
  const Operand first{a, wanted}, second{b, in, true};
  const auto p = first.grid(), q = second.grid();
  ASSERT_TRUE(p && q && (*p)[0].corners.size() * (*q)[0].corners.size() >= 10'000);
  const ConvolutionIndex index({*p, a.geometry}, {*q, b.geometry});
  SumOfPairs sum(true);
  for (const Part& x : first.solid_parts())
    for (const Part& y : second.solid_parts()) sum.add(x, y);
  PointWinding numbers = std::move(sum).numbers();
  exact::Geometry g = numbers.take_geometry();
  int inside = 0;
  for (int k = 0; k < 400; ++k) {
    // At sums of corners, and about them.
    const GridPoint u = (*p)[0].corners[rng() % (*p)[0].corners.size()].at;
    const GridPoint v = (*q)[0].corners[rng() % (*q)[0].corners.size()].at;
    const std::int64_t away = k % 4 == 0 ? 0 : k % 4 == 1 ? 1 : far;
    const auto some = [&] { return std::int64_t(rng() % std::uint64_t(2 * away + 1)) - away; };
    const Index point = g.add_grid_point(u.x + v.x + some(), u.y + v.y + some());
    bool unresolved = false;
    const bool holds = index.holds(g, point, unresolved);
    ASSERT_FALSE(unresolved);
    ASSERT_EQ(holds, numbers.at(g, point) > 0) << g.points[point].gx << ", " << g.points[point].gy;
    inside += holds;
  }
  EXPECT_GT(inside, 100);
}

TEST(GridSum, PointsOfManyCorners) {
  std::mt19937 rng(3);
  for (const std::int64_t width : {4, 20}) {
    const Region a = comb(30, width, width + 1, 300), b = comb(29, width, width + 1, 300);
    compare_points(a, in, b, rng);
    compare_points(a, in, mirrored(b), rng);
    compare_points(a, out, b, rng);
    compare_points(stairs(50, width, 7), in, stairs(51, width + 1, 7), rng);
    compare_points(star(rng, 120), in, star(rng, 120), rng);
    compare_points(star(rng, 120), in, star(rng, 120, 20), rng, 200'000);
    if (HasFatalFailure()) return;
  }
}

}  // namespace plane_grid_sum
}  // namespace findspace::plane
