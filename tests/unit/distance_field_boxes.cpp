// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "distance/search/field_boxes.h"

namespace findspace::distance {
namespace distance_field_boxes {

using space::Vector;

/// To a ring about the z axis.
double to_ring(const Vector& x) { return std::hypot(std::hypot(x.x, x.y) - 10, x.z) - 3; }

Vector somewhere(const Tetrahedron& t, std::mt19937& random) {
  Vector sum;
  double weights = 0;
  for (const Vector& v : t) {
    const double w = -std::log(std::uniform_real_distribution<double>(1e-9, 1)(random));
    sum = space::plus(sum, space::scaled(w, v));
    weights += w;
  }
  return space::scaled(1 / weights, sum);
}

TEST(FieldBoxes, WhatIsSaidToBeWithinIs) {
  int calls = 0;
  const FieldBoxes boxes({1, 0, -1}, 20, 7, [&](const Vector& x) {
    ++calls;
    return to_ring(x);
  });
  std::mt19937 random(3);
  const auto pick = [&](double far) { return std::uniform_real_distribution<double>(-far, far)(random); };
  int decided = 0, clear = 0;
  for (int round = 0; round < 3000; ++round) {
    const Vector at{pick(14), pick(14), pick(4)};
    Tetrahedron t;
    for (Vector& v : t) v = space::plus(at, {pick(1), pick(1), round % 5 == 0 ? 0 : pick(1)});
    const double most = pick(2);
    double greatest = -1e9;
    for (int k = 0; k < 50; ++k) greatest = std::max(greatest, to_ring(somewhere(t, random)));
    for (const Vector& v : t) greatest = std::max(greatest, to_ring(v));
    const bool within = boxes.within(t, most);
    ASSERT_TRUE(!within || greatest <= most) << round;
    decided += within;
    clear += greatest < most - 0.6;
  }
  EXPECT_GT(decided, 300);
  EXPECT_GE(decided, clear);
  EXPECT_FALSE(boxes.within({Vector{9, 0, 0}, {10, 0, 0}, {10, 1, 0}, {10, 0, 40}}, 100));  // beyond the cube
  const int made = calls;
  boxes.within({Vector{9, 0, 0}, {10, 0, 0}, {10, 1, 0}, {10, 0, 1}}, -0.5);
  const int after = calls;
  boxes.within({Vector{9, 0, 0}, {10, 0, 0}, {10, 1, 0}, {10, 0, 1}}, -0.5);
  EXPECT_EQ(calls, after);  // known
  EXPECT_GE(after, made);
}

TEST(FieldBoxes, APlaceHasNoMoreThanIsSaid) {
  const FieldBoxes boxes({1, 0, -1}, 20, 7, to_ring);
  std::mt19937 random(5);
  const auto pick = [&](double far) { return std::uniform_real_distribution<double>(-far, far)(random); };
  for (int round = 0; round < 2000; ++round) {
    const Vector at{pick(18), pick(18), pick(18)};
    const double off = std::ldexp(1.0, round % 5 - 2);
    const double most = boxes.most_at(at, off);
    ASSERT_GE(most, to_ring(at)) << round;
    ASSERT_LE(most, to_ring(at) + 4 * off) << round;
  }
  EXPECT_EQ(boxes.most_at({0, 0, 40}, 1), exact::kInfinity);
}

}  // namespace distance_field_boxes
}  // namespace findspace::distance
