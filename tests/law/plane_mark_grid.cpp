// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// MarkGrid against the exact Locator: what it gives is right for every point within the stated error, and it leaves few
// points open.
#include <gtest/gtest.h>

#include "law/plane_random.h"
#include "plane/query/locate.h"
#include "plane/query/mark_grid.h"

namespace findspace::plane {
namespace plane_mark_grid {

struct Counts {
  long asked = 0, open = 0;
};

void expect_same(const MarkGrid& grid, Locator& locator, const MarkGrid::Query& q, Counts& n) {
  const std::optional<Mark> mark = grid.mark(q);
  ++n.asked;
  n.open += !mark;
  if (!mark) return;
  for (const auto& [dx, dy] : {std::pair{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
    const exact::RealPoint p{exact::Real::from_double(q.x) + exact::Real(dx) * exact::Real::from_double(q.error),
                             exact::Real::from_double(q.y) + exact::Real(dy) * exact::Real::from_double(q.error)};
    ASSERT_EQ(*mark, locator.mark(p)) << q.x << " " << q.y << " +- " << q.error;
    if (q.error == 0) break;
  }
}

/// Lattice points, halves, places beside vertices and far ones.
Counts ask(const Region& region, Random& random, std::int64_t size) {
  const MarkGrid grid(region);
  Locator locator(region);
  Counts n;
  for (std::int64_t x = -2; x <= 2 * size + 2; ++x)
    for (std::int64_t y = -2; y <= 2 * size + 2; ++y) expect_same(grid, locator, {double(x) / 2, double(y) / 2, 0}, n);
  for (int k = 0; k < 200; ++k) {
    const double x = double(random.pick(-1000, 1000 * size)) / 999, y = double(random.pick(-1000, 1000 * size)) / 999;
    expect_same(grid, locator, {x, y, k % 2 ? 0x1p-45 : 0}, n);
  }
  for (Index v = 0; v < region.vertices.size(); ++v) {
    const exact::Point& p = region.point(v);
    for (const double off : {0.0, 0x1p-30, -0x1p-30})
      for (const double error : {0.0, 0x1p-46}) expect_same(grid, locator, {p.x + off, p.y - off, error}, n);
  }
  return n;
}

TEST(MarkGrid, AgreesWithTheLocator) {
  Counts all;
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::int64_t size = seed % 3 == 0 ? 40 : 6;
    Counts n = ask(region_of(random_shape(random, {.size = size})), random, size);
    if (::testing::Test::HasFatalFailure()) return;
    all.asked += n.asked;
    all.open += n.open;
  }
  EXPECT_LT(all.open * 8, all.asked);
}

TEST(MarkGrid, GridPointsOfPolygonsAreNeverOpen) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Region region = region_of(random_triangle(random, 9));
    const MarkGrid grid(region);
    for (int x = -1; x <= 10; ++x)
      for (int y = -1; y <= 10; ++y) EXPECT_TRUE(grid.mark({double(x), double(y), 0}));
  }
}

TEST(MarkGrid, EmptyAndWholePlane) {
  EXPECT_EQ(MarkGrid(CellComplex::uniform(0)).mark({3, 4, 1}), Mark(0));
  EXPECT_EQ(MarkGrid(CellComplex::uniform(1)).mark({1e300, 4, 0}), Mark(1));
}

TEST(MarkGrid, LongEdgesAreListedInFewBuckets) {
  std::vector<ShapePtr> boxes;
  for (std::int64_t k = 0; k < 20000; ++k) boxes.push_back(box_of(0, 10 * k, 1000000, 10 * k + 5));
  const Region region = region_of(node(Shape::Kind::kUnion, boxes));
  ASSERT_GE(region.edges.size(), 80000u);
  const MarkGrid grid(region);
  EXPECT_LT(grid.listed(), 128 * region.edges.size());
  for (int k = 0; k < 20000; k += 999) {
    EXPECT_EQ(grid.mark({500000, 10.0 * k + 2, 0}), Mark(1));
    EXPECT_EQ(grid.mark({500000, 10.0 * k + 7, 0}), Mark(0));
  }
}

TEST(MarkGrid, LargeErrorsAreLeftOpen) {
  const MarkGrid grid(region_of(box_of(0, 0, 10, 10)));
  EXPECT_EQ(grid.mark({5, 5, 100}), std::nullopt);
  EXPECT_EQ(grid.mark({-200, 5, 100}), Mark(0));
}

}  // namespace plane_mark_grid
}  // namespace findspace::plane
