// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is known of a place changes no distance to a surface (surface_field.h), and known distances nearby bound it
// (field_samples.h).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "distance/surface/field_samples.h"
#include "distance/surface/surface_field.h"

namespace findspace::distance {
namespace distance_surface_field {

using space::Vector;

space::Triangles tetrahedron(std::int64_t size, const space::Point& at) {
  return space::moved(
      {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}, at);
}

/// One solid; two that are apart; one and a ball.
space::SurfaceSet solids(int which) {
  std::vector<space::RaySolid> all{space::RaySolid{tetrahedron(1000, {0, 0, 0}), {}}};
  if (which == 1) all.push_back(space::RaySolid{tetrahedron(500, {600, 600, 600}), {}});
  if (which == 2) all.push_back({{}, {900, 900, 900}, exact::Real(300)});
  space::SurfaceSet out;
  EXPECT_TRUE(out.add(all, 1));
  return out;
}

TEST(SurfaceField, WhatIsKnownChangesNoDistance) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> coordinate(-300, 1300);
  for (int which = 0; which < 3; ++which) {
    const space::SurfaceSet set = solids(which);
    const SurfaceField field(set, {});
    const FieldSamples samples(set);
    int inside = 0;
    for (int k = 0; k < 500; ++k) {
      const Vector x{coordinate(rng), coordinate(rng), coordinate(rng)};
      const SurfaceField::Signed at = field.at(x);
      inside += at.value < 0;
      for (int part = -1; part < static_cast<int>(field.parts()); ++part) {
        const SurfaceField::Signed again = field.at(x, {part, at.value < 0 ? -1 : 1});
        EXPECT_EQ(again.value, at.value);
        EXPECT_EQ(again.distance, at.distance);
        EXPECT_TRUE(again.certain);
        EXPECT_NEAR(std::fabs(field.distance(again.part, x)), at.distance, 1e-9);
      }
      samples.ask(x, 1, [&](const exact::Interval& known) {
        EXPECT_LE(known.lo, at.value + 1e-9);
        EXPECT_GE(known.hi, at.value - 1e-9);
        return known.hi - known.lo < 1e-9;
      });
    }
    EXPECT_GT(inside, 5);
  }
}

}  // namespace distance_surface_field
}  // namespace findspace::distance
