// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "space/polytope/triangulate.h"

namespace findspace::space {
namespace space_triangulate {

int128 twice_area(std::span<const Point2> ring) {
  int128 sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += int128(a.x) * b.y - int128(a.y) * b.x;
  }
  return sum;
}

void expect_parts(const std::vector<std::vector<Point2>>& rings, std::size_t most) {
  const auto parts = convex_parts(rings);
  EXPECT_LE(parts.size(), most);
  int128 area = 0, whole = 0;
  for (const auto& part : parts) area += twice_area(part.vertices());
  for (const auto& ring : rings) whole += twice_area(ring);
  EXPECT_TRUE(area == whole);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) EXPECT_GE(PlanarPhi(parts[i], parts[j]).sign({0, 0}), 0);
  }
}

TEST(Triangulate, ConvexPartsOfPolygons) {
  expect_parts({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, 1);
  expect_parts({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}}}, 1);  // vertices on straight sides
  expect_parts({{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}}, 2);
  expect_parts({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}}, 4);
  expect_parts({{{0, 0}, {20, 0}, {20, 9}, {0, 9}},
                {{3, 3}, {3, 6}, {6, 6}, {6, 3}},
                {{12, 2}, {11, 5}, {14, 7}, {17, 5}, {16, 2}},
                {{8, 3}, {8, 4}, {9, 4}, {9, 3}}},
               14);
  expect_parts({{{0, -9}, {3, -3}, {9, -2}, {5, 3}, {6, 9}, {0, 6}, {-6, 9}, {-5, 3}, {-9, -2}, {-3, -3}}}, 6);
}

TEST(Triangulate, RefusesWhatIsNotSimple) {
  EXPECT_THROW(triangulate(std::vector<Point2>{{0, 0}, {4, 4}, {4, 0}, {0, 4}}), Error);
  EXPECT_THROW(triangulate(std::vector<Point2>{{0, 0}, {4, 0}, {8, 0}}), Error);
}

}  // namespace space_triangulate
}  // namespace findspace::space
