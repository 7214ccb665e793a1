// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids that balls are cut out of or that are cut off by them, with the functions that say so, for tests of their
// distances. Keywords: bowl, dome, lens, shell.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "unit/solid_shapes.h"

namespace findspace::distance {

using plane::ShapePtr;
using space::Vector;

inline ShapePtr box(const space::Point& low, const space::Point& high) {
  std::vector<space::Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return space::hull(std::move(corners));
}

inline double to_box(const Vector& x, const Vector& low, const Vector& high) {
  const double q[3] = {std::max(low.x - x.x, x.x - high.x), std::max(low.y - x.y, x.y - high.y),
                       std::max(low.z - x.z, x.z - high.z)};
  double square = 0;
  for (const double d : q) square += d > 0 ? d * d : 0;
  return std::sqrt(square) + std::min(0.0, std::max({q[0], q[1], q[2]}));
}

/// A solid with the function that is less than 0 in its interior and more than 0 outside.
struct Case {
  const char* name;
  ShapePtr shape;
  std::function<double(const Vector&)> level;
};

inline double to_ball(const Vector& x, const Vector& center, double radius) {
  return space::length(x - center) - radius;
}

inline std::vector<Case> cases() {
  using Kind = plane::Shape::Kind;
  using space::ball, space::node;
  const ShapePtr block = box({-20, -20, -20}, {20, 20, 20});
  const auto in_block = [](const Vector& x) { return to_box(x, {-20, -20, -20}, {20, 20, 20}); };
  return {
      {"bowl", node(Kind::kDifference, {block, ball({0, 0, 20}, 15)}),
       [=](const Vector& x) {
         return std::max(in_block(x), -to_ball(x, {0, 0, 20}, 15));
       }},
      {"dome", node(Kind::kIntersection, {ball({1, 0, -20}, 25), block}),
       [=](const Vector& x) {
         return std::max(in_block(x), to_ball(x, {1, 0, -20}, 25));
       }},
      {"lens", node(Kind::kIntersection, {ball({0, 0, -10}, 20), ball({3, 0, 10}, 19)}),
       [](const Vector& x) {
         return std::max(to_ball(x, {0, 0, -10}, 20), to_ball(x, {3, 0, 10}, 19));
       }},
      {"shell", node(Kind::kDifference, {ball({0, 0, 0}, 24), ball({2, 1, 0}, 18)}),
       [](const Vector& x) {
         return std::max(to_ball(x, {0, 0, 0}, 24), -to_ball(x, {2, 1, 0}, 18));
       }},
      {"half shell",
       node(Kind::kDifference,
            {node(Kind::kDifference, {ball({0, 0, 0}, 20), box({-30, -30, 0}, {30, 30, 30})}), ball({0, 0, 0}, 14)}),
       [](const Vector& x) {
         return std::max({to_ball(x, {}, 20), -to_ball(x, {}, 14), x.z});
       }},
      {"block with two pockets", node(Kind::kDifference, {block, ball({-20, -20, 0}, 17), ball({20, 20, 0}, 17)}),
       [=](const Vector& x) {
         return std::max({in_block(x), -to_ball(x, {-20, -20, 0}, 17), -to_ball(x, {20, 20, 0}, 17)});
       }},
  };
}

inline Vector any(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> pick(-size, size);
  return {pick(random), pick(random), pick(random)};
}

}  // namespace findspace::distance
