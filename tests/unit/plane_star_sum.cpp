// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <array>

#include "plane/complex/primitives.h"
#include "plane/contour/star_shaped.h"
#include "plane/grid/star_sum.h"

namespace findspace::plane {
namespace plane_star_sum {

using Points = std::vector<GridPoint>;

int way(const Points& p) {
  return star_shaped(p.size(), [&](std::size_t k) { return p[k]; });
}

TEST(StarShaped, Ways) {
  EXPECT_EQ(way({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), 1);
  EXPECT_EQ(way({{0, 0}, {0, 4}, {4, 4}, {4, 0}}), -1);
  EXPECT_EQ(way({{0, 0}, {8, 0}, {8, 8}, {4, 6}, {0, 8}}), 1) << "a reflex corner seen from the mean";
}

TEST(StarShaped, NotSeenFromTheMean) {
  EXPECT_EQ(way({{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}), 0) << "a thin L, though simple";
  EXPECT_EQ(way({{10, 0}, {-8, 6}, {3, -9}, {3, 9}, {-8, -6}}), 0) << "a pentagram goes round twice";
  EXPECT_EQ(way({{-3, 0}, {3, 0}, {0, 3}, {0, -3}}), 0) << "an edge through the mean";
  EXPECT_EQ(way({{0, 0}, {4, 0}, {8, 0}}), 0) << "flat";
}

std::optional<SignMap> sum(const Points& a, const Points& b) {
  auto faces = [](const Points& points) {
    Contour ring;
    for (const GridPoint& p : points) ring.push_back({.start = p});
    return region_of_rings(std::array{ring});
  };
  auto in = [](Mark m) { return m > 0; };
  const Region p = faces(a), q = faces(b);
  const auto f = grid_faces(p, in, false), g = grid_faces(q, in, false);
  ReducedConvolution curves = reduced_convolution({*f, p.geometry}, {*g, q.geometry});
  return star_sum(curves);
}

const Points kNotched{{0, 0}, {20, 0}, {20, 20}, {10, 18}, {0, 20}};

TEST(StarSum, AReflexCornerThatTurnsPastNoEdge) {
  // Both edges at the notch run on towards the left, (-10, -2) and (-10, 2): the triangle has no edge between them.
  const auto found = sum(kNotched, {{0, 0}, {2, 0}, {1, 3}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->faces.size(), 2u);
  EXPECT_EQ(found->vertices.size(), 7u);  // five and three edges, of which the two below are one
}

TEST(StarSum, NotWhereCurvesPartOrParallelEdgesMakeStraightCorners) {
  EXPECT_FALSE(sum(kNotched, {{0, 0}, {2, 0}, {2, 2}, {0, 2}})) << "the notch turns past the square's upper edge";
  const auto squares = sum({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  ASSERT_TRUE(squares);
  EXPECT_EQ(squares->vertices.size(), 4u);
}

}  // namespace plane_star_sum
}  // namespace findspace::plane
