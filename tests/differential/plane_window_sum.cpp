// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sum of grid polygons within a window against the whole sum, cell by cell inside the window: on lattice squares
// with holes and slots (windows whose borders run along curves, single free points on them), on triangles and stars,
// and for what is left of a container.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "differential/whole_sum.h"
#include "findspace/error.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/sum/local_sum.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace plane_window_sum {

Region star(std::mt19937& rng, int n, double size) {
  std::vector<GridPoint> points;
  for (int k = 0; k < n; ++k) {
    double r = (k % 2 ? 0.3 + double(rng() % 200) / 1000 : 0.8 + double(rng() % 200) / 1000) * size,
           angle = 6.283185307179586 * k / n;
    points.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return ring(points);
}

/// Where the marks of two maps differ within the open window.
Region difference(const SignMap& part, const SignMap& whole, const GridBox& w) {
  Region inside = ring({{w.x0, w.y0}, {w.x1, w.y0}, {w.x1, w.y1}, {w.x0, w.y1}});
  for (Edge& e : inside.edges) e.mark = 0;
  for (Vertex& v : inside.vertices) v.mark = 0;
  std::array<const CellComplex*, 3> all{&part, &whole, &inside};
  return overlay(all, [](std::span<const Mark> m) { return Mark(m[2] > 0 && (m[0] < 0) != (m[1] < 0)); });
}

bool is_nothing(const Region& r) {
  return r.faces.size() == 1 && r.faces[0].mark == 0 && r.edges.empty() && r.vertices.empty();
}

/// Windows about places of the whole map: at its vertices, and anywhere.
void compare(const LocalSum& local, const SignMap& whole, std::int64_t size, std::mt19937& rng,
             const std::string& what) {
  for (int k = 0; k < 6; ++k) {
    std::int64_t x = std::int64_t(rng() % (4 * size)) - 2 * size, y = std::int64_t(rng() % (4 * size)) - 2 * size;
    if (k % 2 == 0 && !whole.vertices.empty()) {
      const exact::Point& p = whole.point(Index(rng() % whole.vertices.size()));
      x = std::llround(p.x);
      y = std::llround(p.y);
    }
    std::int64_t wide = 1 + std::int64_t(rng() % std::uint64_t(size)),
                 high = 1 + std::int64_t(rng() % std::uint64_t(size));
    // A vertex of the map in the middle of the window, or on its border.
    GridBox w{x - (k % 3 ? wide : 0), y - (k % 3 == 1 ? high : 1), x + wide, y + high};
    auto curves = curves_in(local.index(), w, SIZE_MAX);
    EXPECT_FALSE(local.surely_has(curves.size() + 1, w)) << what;
    ASSERT_TRUE(is_nothing(difference(local.map(w, curves), whole, w)))
        << what << ", window " << w.x0 << " " << w.y0 << " " << w.x1 << " " << w.y1;
  }
}

void compare(const Region& a, const Region& b, std::int64_t size, unsigned seed, const std::string& what) {
  std::mt19937 rng(seed);
  auto contact = LocalSum::contact(a, b);
  ASSERT_TRUE(contact) << what;
  compare(*contact, contact_map(a, b), size, rng, what);
  auto inner = LocalSum::containment(a, b);
  if (!inner) return;
  SignMap leaves = containment_map(a, b);
  auto negated = [](auto& cells) {
    for (auto& c : cells) c.mark = Mark(-c.mark);
  };
  negated(leaves.faces);
  negated(leaves.edges);
  negated(leaves.vertices);
  compare(*inner, leaves, size, rng, what + ", contained");
}

TEST(WindowSum, SquaresWithSlotsAndHoles) {
  for (unsigned seed = 0; seed < 250; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t side = seed % 2 ? 4 : 1000;
    compare(squares(rng, 5, 3 + int(rng() % 14), side), squares(rng, 3, 1 + int(rng() % 6), side), 3 * side, seed,
            "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(WindowSum, PartsInSheets) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t side = seed % 2 ? 4 : 1000;
    compare(squares(rng, 7, 20 + int(rng() % 20), side), squares(rng, 2, 1 + int(rng() % 3), side), 4 * side, seed,
            "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(WindowSum, Stars) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 rng(seed);
    compare(star(rng, 4 + 2 * int(rng() % 12), 1000), star(rng, 4 + 2 * int(rng() % 12), seed % 3 ? 400 : 1000), 700,
            seed, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(WindowSum, CountsTheCurvesOfConvexFacesWithoutThem) {
  constexpr std::size_t kSide = 12;
  std::vector<Region> boxes;
  for (std::int64_t k = 0; k < std::int64_t(kSide * kSide); ++k) {
    const std::int64_t x = k % std::int64_t(kSide) * 10, y = k / std::int64_t(kSide) * 10;
    boxes.push_back(ring({{x, y}, {x + 6, y}, {x + 7, y + 5}, {x, y + 6}}));
  }
  std::vector<const Region*> all;
  for (const Region& box : boxes) all.push_back(&box);
  const Region a = unite(all), b = ring({{0, 0}, {2, 0}, {1, 1}});
  for (const auto& local : {LocalSum::contact(a, b), LocalSum::contact(b, a)}) {
    const GridBox w = *local->bounds(), part{w.x0, w.y0, w.x0 + 40, w.y0 + 60};
    const std::size_t every = curves_in(local->index(), w, SIZE_MAX).size();
    EXPECT_EQ(every, kSide * kSide * 7);
    EXPECT_TRUE(local->surely_has(every, w));
    EXPECT_FALSE(local->surely_has(every + 1, w));
    EXPECT_TRUE(local->surely_has(4 * 6 * 7, part));
    EXPECT_FALSE(local->surely_has(curves_in(local->index(), part, SIZE_MAX).size() + 1, part));
  }
}

TEST(WindowSum, PointsOneByOne) {
  // Every vertex and a point of every edge of the whole map, in the sum or not.
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 rng(seed);
    std::int64_t side = seed % 2 ? 4 : 1000;
    Region a = squares(rng, 5, 3 + int(rng() % 14), side), b = squares(rng, 3, 1 + int(rng() % 6), side);
    auto local = LocalSum::contact(a, b);
    SignMap whole = contact_map(a, b);
    for (const Vertex& v : whole.vertices)
      ASSERT_EQ(local->holds(whole.geometry.exact(v.point)), v.mark < 0) << "seed " << seed;
    for (const Edge& e : whole.edges) {
      exact::RealPoint p = whole.geometry.exact(whole.vertices[e.v0].point),
                       q = whole.geometry.exact(whole.vertices[e.v1].point);
      ASSERT_EQ(local->holds({(p.x + q.x) / exact::Real(2), (p.y + q.y) / exact::Real(2)}), e.mark < 0)
          << "seed " << seed;
    }
  }
}

}  // namespace plane_window_sum
}  // namespace findspace::plane
