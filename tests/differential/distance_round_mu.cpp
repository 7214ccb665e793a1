// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a ball protrudes from a union of boxes and balls, against samples of the whole ball: the greatest distance of
// samples is at most the value, and less by no more than the samples are apart.
#include <gtest/gtest.h>

#include <cmath>

#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_round_mu {

using exact::Real;
using space::Body;
using space::Vector;

constexpr int kAround = 48;  // samples about half a circle
constexpr double kApart = 3.1416 / kAround;

double distance_to_box(const space::Corners& c, const Vector& x) {
  const double at[3] = {x.x, x.y, x.z};
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = static_cast<double>(c[0][k]), high = static_cast<double>(c[1][k]);
    const double off = std::max({low - at[k], at[k] - high, 0.0});
    square += off * off;
  }
  return std::sqrt(square);
}

/// Of spheres of all radii up to `radius`, about as far apart as places on the outermost.
template <class Distance>
double most_over_ball(const Vector& center, double radius, Distance distance) {
  double most = 0;
  const int shells = kAround / 3;
  for (int s = 0; s <= shells; ++s) {
    const double r = radius * s / shells;
    for (int i = 0; i <= kAround; ++i) {
      for (int k = 0; k < 2 * kAround; ++k) {
        const double up = 3.14159265358979 * i / kAround, rotation = 3.14159265358979 * k / kAround;
        most = std::max(most, distance(space::plus(center, {r * std::sin(up) * std::cos(rotation),
                                                            r * std::sin(up) * std::sin(rotation), r * std::cos(up)})));
      }
    }
  }
  return most;
}

TEST(RoundMu, BallsInUnions) {
  std::mt19937 random(5);
  int inner = 0, outer = 0;
  for (int round = 0; round < 60; ++round) {
    const std::vector<space::Corners> boxes = space::random_boxes(random, 4, 6);
    Body a = space::box_body(boxes), b;
    const bool with_ball = round % 3 == 0;
    if (with_ball) a.parts.push_back({std::nullopt, {7, 7, 3}, Real(2)});
    const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    const double radius = pick(1, 6) / 2.0;
    b.parts.push_back({std::nullopt, {1, 0, 0}, Real::from_double(radius)});
    const Vector p{pick(-8, 28) / 4.0, pick(-4, 28) / 4.0, pick(-4, 28) / 4.0};
    if (a.parts.size() == 1) continue;
    const auto distance = [&](const Vector& x) {
      double least = with_ball ? std::max(0.0, space::length(x - Vector{7, 7, 3}) - 2) : 1e9;
      for (const space::Corners& c : boxes) least = std::min(least, distance_to_box(c, x));
      return least;
    };
    const Vector center = space::plus(p, {1, 0, 0});
    const double samples = most_over_ball(center, radius, distance);
    const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
    const auto value = pair.value(Which::kH, {Real::from_double(p.x), Real::from_double(p.y), Real::from_double(p.z)});
    ASSERT_TRUE(value);
    const double h = value->value.to_double();
    EXPECT_GE(h, samples - 1e-12) << "round " << round;
    EXPECT_LE(h, samples + radius * kApart) << "round " << round;
    // Most often the place farthest from the nearest part is on the ball; else two parts are equally near to one
    // inside.
    ++(h > distance(center) + radius - 1e-9 ? outer : inner);
  }
  EXPECT_GT(inner, 8);
  EXPECT_GT(outer, 8);
}

}  // namespace distance_round_mu
}  // namespace findspace::distance
