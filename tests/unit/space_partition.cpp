// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A round surface is cut along each of its planes without a stack that grows with them.
#include <gtest/gtest.h>
#include <pthread.h>

#include "space/body/cell_parts.h"
#include "space/polytope/partition.h"

namespace findspace::space {
namespace space_partition {

using exact::Real;

constexpr std::int64_t kHalf = 1200, kDeep = kHalf * kHalf;

/// A prism over the points (x, x^2).
Polytope round_prism() {
  std::vector<Point> points;
  for (std::int64_t x = -kHalf; x <= kHalf; ++x) points.insert(points.end(), {{x, x * x, 0}, {x, x * x, 10}});
  return Polytope::hull(points);
}

std::vector<FacetPiece> facets_of(const Polytope& p) {
  std::vector<FacetPiece> out;
  for (int f = 0; f < p.facet_count(); ++f) {
    FacetPiece& piece = out.emplace_back(FacetPiece{p.planes()[static_cast<std::size_t>(f)], {}});
    for (const int v : p.circuit(f)) piece.corners.emplace_back(real(p.vertices()[static_cast<std::size_t>(v)]));
  }
  return out;
}

struct Task {
  std::vector<FacetPiece> facets;
  Cells cells{};
};

void* cut(void* at) {
  Task& task = *static_cast<Task*>(at);
  ConvexRegion bounds(real(Point{-kHalf, 0, 0}), real(Point{kHalf, kDeep, 10}));
  EXPECT_FALSE(partition(task.facets, bounds, 1000));
  task.cells = *partition(std::move(task.facets), std::move(bounds), 1'000'000'000);
  return nullptr;
}

TEST(Partition, OfARoundSurfaceOnASmallStack) {
  const Polytope prism = round_prism();
  Task task{facets_of(prism)};
  ASSERT_EQ(task.facets.size(), std::size_t{2 * kHalf + 3});
  pthread_attr_t small;
  pthread_t thread;
  ASSERT_EQ(pthread_attr_init(&small), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&small, 192 * 1024), 0);
  ASSERT_EQ(pthread_create(&thread, &small, cut, &task), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&small);
  ASSERT_EQ(task.cells.inside.size(), 1u);
  EXPECT_EQ(task.cells.inside[0].six_volumes(), six_volumes(prism));
  Real all = six_volumes(prism);
  for (const ConvexRegion& cell : task.cells.outside) all += cell.six_volumes();
  EXPECT_EQ(all, Real(6 * 2 * kHalf * kDeep * 10));
}

}  // namespace space_partition
}  // namespace findspace::space
