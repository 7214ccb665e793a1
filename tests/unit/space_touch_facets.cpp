// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What cuts a facet of touching: others that reach its plane in an edge or a corner, along its rim or across. The
// frontier is left where more facets meet than are allowed.
#include <gtest/gtest.h>

#include "space/surface/touch_rays.h"

namespace findspace::space {
namespace {

RayFacet facet(std::initializer_list<Point> corners) {
  RayFacet out;
  out.outer = true;
  out.corners = static_cast<std::int8_t>(corners.size());
  std::copy(corners.begin(), corners.end(), out.corner.begin());
  return out;
}

std::size_t cuts_of_square(const RayFacet& other) {
  const TouchFacets facets({facet({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}), other});
  TouchFacets::Planes made;
  return facets.cuts(0, made).size();
}

TEST(TouchFacets, EdgesThatReachAFacet) {
  EXPECT_EQ(cuts_of_square(facet({{0, 0, 0}, {4, 4, 0}, {0, 0, 9}})), 1U);  // from corner to corner, across
  EXPECT_EQ(cuts_of_square(facet({{0, 4, 0}, {1, 1, 9}, {4, 0, 0}})), 1U);
  EXPECT_EQ(cuts_of_square(facet({{0, 0, 0}, {4, 0, 0}, {0, 0, 9}})), 0U);  // along its rim
  EXPECT_EQ(cuts_of_square(facet({{0, 0, 0}, {1, 1, 9}, {0, 4, 0}})), 0U);
  EXPECT_EQ(cuts_of_square(facet({{0, 0, 0}, {1, 1, 9}, {1, 2, 9}})), 0U);  // at its corner
  EXPECT_EQ(cuts_of_square(facet({{0, 0, 0}, {1, 1, 0}, {1, 2, 9}})), 1U);
  EXPECT_EQ(cuts_of_square(facet({{1, 1, 0}, {1, 1, 9}, {1, 2, 9}})), 1U);
}

TEST(TouchFacets, NoMorePairsThanAllowed) {
  const Triangles corner{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const auto sheet = std::make_shared<const RaySheet>(corner);
  const RayGrid grid{2, 1, -20, -20, 20, 20, 4, 4};
  TouchPair pair{sheet, sheet, TouchSide::kOutside};
  EXPECT_TRUE(near_touching(pair, exact::Real(1), grid));
  EXPECT_TRUE(all_touching_near(pair, exact::Real(1), grid));
  pair.most_pairs = 9;
  EXPECT_FALSE(near_touching(pair, exact::Real(1), grid));
  EXPECT_FALSE(all_touching_near(pair, exact::Real(1), grid));
}

}  // namespace
}  // namespace findspace::space
