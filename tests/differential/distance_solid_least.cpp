// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Least values of distances of solids: against the exact ones of boxes, and against values at random positions, none
// of which may be less.
#include <gtest/gtest.h>

#include "distance/solid/box_maps.h"
#include "distance/solid/solid_least.h"
#include "findspace/error.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_solid_least {

using exact::Real;
using space::Body;
using space::box_body;
using space::RealVector;

Body hull(const std::vector<space::Point>& points) {
  Body b;
  b.parts.push_back({space::Polytope::hull(points), {}, Real()});
  return b;
}

TEST(SolidLeast, BoxesHaveTheirExactLeastValues) {
  std::mt19937 random(11);
  int defined = 0;
  for (int k = 0; k < 200; ++k) {
    const auto a = space::random_boxes(random, 3, 8), b = space::random_boxes(random, 2, 3);
    const BoxMaps boxes(space::box_set(b), space::box_set(a));
    for (const Which which : {Which::kGamma1, Which::kEta1, Which::kDelta1}) {
      const auto truth = boxes.least(which).or_throw();
      if (!truth) continue;  // the set is not made of separate boxes
      const auto found = solid_least(which, box_body(b), box_body(a)).or_throw();
      ASSERT_EQ(found.has_value(), !truth->at.empty()) << k << " " << static_cast<int>(which);
      if (!found) continue;
      ++defined;
      EXPECT_EQ(found->value, truth->value) << k << " " << static_cast<int>(which);
      EXPECT_EQ(truth->at.mark(found->at), 1);
      EXPECT_LE(*found->bounds().lower, truth->value);
      EXPECT_NEAR(found->bounds().lower->to_double(), truth->value.to_double(), 1e-10);
    }
  }
  EXPECT_GT(defined, 100);
}

/// No random position has less than the bound, and `at` has the value.
void compare(const char* name, const Body& b, const Body& a, Which which, double room) {
  const auto found = solid_least(which, b, a).or_throw();
  ASSERT_TRUE(found) << name;
  const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
  EXPECT_EQ(pair.value(which, found->at)->value, found->value) << name;
  EXPECT_LE(*found->bounds().lower, found->value) << name;
  EXPECT_LE((found->value - *found->bounds().lower).to_double(), room) << name << " " << static_cast<int>(which);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> near(-0.5, 0.5), far(-6, 6);
  for (int k = 0; k < 60; ++k) {
    RealVector p;
    for (std::size_t c = 0; c < 3; ++c)
      p[c] = k % 2 == 0 ? found->at[c] + Real::from_double(near(random)) : Real::from_double(far(random));
    EXPECT_GE(pair.value(which, p)->value, *found->bounds().lower) << name << " " << static_cast<int>(which);
  }
}

TEST(SolidLeast, SlantedSolids) {
  const Body tetrahedron = hull({{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}}),
             octahedron = hull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}),
             room = box_body({{{{0, 0, 0}, {6, 2, 4}}}, {{{0, 0, 0}, {2, 6, 4}}}});
  for (const Which which : {Which::kGamma1, Which::kEta1, Which::kEta2, Which::kMu, Which::kGamma2, Which::kD1,
                            Which::kH, Which::kPenetration, Which::kDstarBack, Which::kDiameter})
    compare("octahedron, tetrahedron", octahedron, tetrahedron, which, 1e-6);
  for (const Which which : {Which::kGamma1, Which::kEta1, Which::kEta2, Which::kMu, Which::kH})
    compare("octahedron, room", octahedron, room, which, 1e-6);
  for (const Which which : {Which::kDelta1, Which::kDelta2, Which::kMuBack, Which::kHBack, Which::kDstar})
    compare("octahedron around", room, octahedron, which, 1e-6);
}

TEST(SolidLeast, WhatDoesNotFitProtrudesByTheLeast) {
  // A bar of length 10 across the L of arms 6: nowhere inside; the excess is found by dividing cubes.
  const Body room = box_body({{{{0, 0, 0}, {6, 2, 4}}}, {{{0, 0, 0}, {2, 6, 4}}}}),
             bar = box_body({{{{0, 0, 0}, {10, 1, 1}}}});
  EXPECT_FALSE(solid_least(Which::kEta1, bar, room).or_throw());
  compare("bar, box", bar, box_body({{{{0, 0, 0}, {6, 2, 4}}}}), Which::kMu, 0.05);
  const auto found = solid_least(Which::kMu, bar, box_body({{{{0, 0, 0}, {6, 2, 4}}}})).or_throw();
  EXPECT_EQ(found->value, Real(2));
}

TEST(SolidLeast, BallInARoom) {
  Body ball;
  ball.parts.push_back({std::nullopt, {}, Real(1)});
  const Body room = box_body({{{{0, 0, 0}, {6, 3, 3}}}, {{{0, 0, 0}, {3, 6, 3}}}});
  const auto found = solid_least(Which::kEta1, ball, room).or_throw();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, Real::ratio(-1, 2));  // walls 3 apart
}

TEST(SolidLeast, ComplementsHaveNone) {
  Body outside = box_body({{{{0, 0, 0}, {6, 3, 3}}}});
  outside.outside = true;
  EXPECT_FALSE(solid_least(Which::kEta1, box_body({{{{0, 0, 0}, {1, 1, 1}}}}), outside));
}

}  // namespace distance_solid_least
}  // namespace findspace::distance
