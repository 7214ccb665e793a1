// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One sum, one offset and one union of many curves, large enough to be divided among threads: on one, two and four the
// same cells in the same order, with the same numbers. ThreadSanitizer runs this, too.

#include <gtest/gtest.h>

#include <cmath>

#include "plane/base/parallel.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/offset/level.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace plane_one_sum_on_threads {

/// Spikes of uneven length about (x, y), jagged, so that its sums have many crossings.
Region star(int corners, int seed, std::int64_t x = 0, std::int64_t y = 0) {
  std::vector<Contour> rings(1);
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * k / corners;
    const double r = k % 2 == 0 ? 100000 + 17 * ((k * 7919 + seed * 104729) % 1000) : 50000;
    rings[0].push_back({.start = {x + std::llround(r * std::cos(angle)), y + std::llround(r * std::sin(angle))}});
  }
  return region_of_rings(make_rings(std::move(rings), 1).contours);
}

Region grown(const Region& set, std::int64_t by) {
  SignMap base = remark(set, [](Mark m) { return Mark(m > 0 ? -1 : 1); });
  for (Vertex& v : base.vertices) v.mark = 0;
  for (Edge& e : base.edges) e.mark = 0;
  return remark(level_map(base, exact::Real(by)), [](Mark m) { return Mark(m <= 0); });
}

void expect_equal(const CellComplex& a, const CellComplex& b) {
  const auto& p = a.geometry.points;
  const auto& q = b.geometry.points;
  ASSERT_EQ(p.size(), q.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    ASSERT_TRUE(p[k].kind == q[k].kind && p[k].root == q[k].root && p[k].i == q[k].i && p[k].j == q[k].j) << k;
    ASSERT_TRUE(p[k].gx == q[k].gx && p[k].gy == q[k].gy && p[k].x == q[k].x && p[k].y == q[k].y) << k;
    ASSERT_EQ(p[k].error, q[k].error) << k;
  }
  const auto& c = a.geometry.supporting_curves;
  const auto& d = b.geometry.supporting_curves;
  ASSERT_EQ(c.size(), d.size());
  for (std::size_t k = 0; k < c.size(); ++k) ASSERT_TRUE(same_supporting_curve(c[k], d[k])) << k;
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t k = 0; k < a.vertices.size(); ++k)
    ASSERT_TRUE(a.vertices[k].point == b.vertices[k].point && a.vertices[k].mark == b.vertices[k].mark) << k;
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t k = 0; k < a.edges.size(); ++k)
    ASSERT_TRUE(a.edges[k].v0 == b.edges[k].v0 && a.edges[k].v1 == b.edges[k].v1 && a.edges[k].mark == b.edges[k].mark)
        << k;
  ASSERT_EQ(a.half_edges.size(), b.half_edges.size());
  for (std::size_t k = 0; k < a.half_edges.size(); ++k)
    ASSERT_TRUE(a.half_edges[k].next == b.half_edges[k].next && a.half_edges[k].face == b.half_edges[k].face) << k;
  EXPECT_EQ(a.faces.size(), b.faces.size());
}

template <class Make>
void expect_same_on_threads(Make&& make) {
  const CellComplex one = [&] {
    const ThreadLimit limit(1);
    return make();
  }();
  EXPECT_GT(one.vertices.size(), 100u);
  for (const unsigned threads : {2u, 4u}) {
    const ThreadLimit limit(threads);
    SCOPED_TRACE(threads);
    expect_equal(one, make());
  }
}

TEST(OneSumOnThreads, Polygons) {
  const Region a = star(120, 1), b = star(120, 2);
  expect_same_on_threads([&] { return contact_map(a, b); });
}

/// Without a way for polygons alone: the whole convolution is arranged.
TEST(OneSumOnThreads, Arcs) {
  const Region a = grown(star(60, 1), 5000), b = star(60, 2);
  expect_same_on_threads([&] { return contact_map(a, b); });
}

TEST(OneSumOnThreads, Unions) {
  std::vector<Region> all;
  for (int k = 0; k < 60; ++k) all.push_back(star(60, k, k % 8 * 90000, k / 8 * 90000));
  all.push_back(grown(all[3], 3000));
  std::vector<const Region*> operands;
  for (const Region& r : all) operands.push_back(&r);
  expect_same_on_threads([&] { return unite(operands); });
}

/// A sum within a task of many.
TEST(OneSumOnThreads, Nested) {
  const Region a = star(100, 1), b = star(100, 2);
  const SignMap one = contact_map(a, b);
  std::vector<SignMap> many(6, CellComplex::uniform(0));
  const ThreadLimit limit(4);
  parallel_for(many.size(), [&](std::size_t k) { many[k] = contact_map(a, b); });
  for (const SignMap& m : many) expect_equal(one, m);
}

}  // namespace plane_one_sum_on_threads
}  // namespace findspace::plane
