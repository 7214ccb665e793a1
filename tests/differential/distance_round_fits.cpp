// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Fits and depths of round shapes against formulas for the sets of positions behind them and samples of these: no
// sampled position of the set is nearer (farther) than the value says, the nearest one belongs to it, and a fine search
// comes as near as it can.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "distance/rays/ray_directional.h"
#include "distance/rays/ray_signs.h"
#include "distance/solid/solid_least.h"
#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_round_fits {

using exact::Real;
using space::Body;
using space::Point;
using space::Vector;

/// Less than 0 inside, 0 on the frontier; need not be a distance.
using Level = std::function<double(const Vector&)>;

Body rounded_box(const Point& c, const Point& half, const Real& radius) {
  Body b =
      space::box_body({{{{c.x - half.x, c.y - half.y, c.z - half.z}, {c.x + half.x, c.y + half.y, c.z + half.z}}}});
  b.parts[0].radius = radius;
  return b;
}

Body capsule(const Point& from, const Point& to, const Real& radius) {
  Body b;
  b.parts.push_back(space::part_of(std::vector<Point>{from, to}, radius));
  return b;
}

/// The distance to the box of half sizes h about 0, less the depth inside.
double to_box(const Vector& x, const Vector& h) {
  const double q[3] = {std::fabs(x.x) - h.x, std::fabs(x.y) - h.y, std::fabs(x.z) - h.z};
  double square = 0;
  for (const double d : q) square += d > 0 ? d * d : 0;
  return std::sqrt(square) + std::min(0.0, std::max({q[0], q[1], q[2]}));
}

double to_segment(const Vector& x, const Vector& a, const Vector& b) {
  const Vector e = b - a;
  const double t = std::clamp(space::dot(x - a, e) / space::dot(e, e), 0.0, 1.0);
  return space::length(x - a - space::scaled(t, e));
}

space::RealVector exact_place(const Vector& p) {
  return {Real::from_double(p.x), Real::from_double(p.y), Real::from_double(p.z)};
}

class Samples {
 public:
  explicit Samples(unsigned seed) : random_(seed) {}
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  Vector place(double size) { return {quarter(size), quarter(size), quarter(size)}; }
  Vector in_ball(const Vector& p, double radius) {
    for (;;) {
      const Vector d{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (space::length(d) < 1) return space::plus(p, space::scaled(radius, d));
    }
  }

 private:
  double quarter(double size) { return std::round(4 * uniform(-size, size)) / 4 + 1.0 / 64; }
  std::mt19937 random_;
};

/// From p at least as near as the set comes, by walks that keep to it and draw nearer to p (or farther off, `way` -1).
double walked(const Level& set, const Vector& p, double size, int way, Samples& samples) {
  double best = exact::kInfinity;
  for (int start = 0; start < 400; ++start) {
    Vector at = samples.in_ball({}, size);
    if (set(at) > 0) continue;
    for (double step = size / 4; step > 1e-7 * size; step *= 0.9) {
      for (int k = 0; k < 20; ++k) {
        const Vector next = samples.in_ball(at, step);
        if (way * (space::length(next - p) - space::length(at - p)) < 0 && set(next) <= 0) at = next;
      }
    }
    best = std::min(best, way * space::length(at - p));
  }
  return way * best;
}

/// Where `set` (<= 0) is what the distance leads to: E for eta1 above 0, the complement of U for the depth.
void expect_nearest(const PairDistances& pair, Which which, int side, const Level& set, double size, int count,
                    unsigned seed) {
  Samples samples(seed);
  int tested = 0;
  for (int n = 0; n < 40 * count && tested < count; ++n) {
    const Vector p = samples.place(size);
    if (set(p) < 0.01) continue;
    ++tested;
    const auto v = pair.value(which, exact_place(p));
    ASSERT_TRUE(v);
    const double d = side * v->value.to_double();
    EXPECT_GT(d, 0);
    ASSERT_TRUE(v->nearest);
    const Vector q = space::rounded(*v->nearest);
    EXPECT_NEAR(space::length(q - p), d, 1e-10);
    EXPECT_LT(set(q), 1e-9) << p.x << ' ' << p.y << ' ' << p.z;
    for (int k = 0; k < 3000; ++k) {
      const Vector s = samples.in_ball(p, d);
      EXPECT_TRUE(set(s) > 0 || space::length(s - p) > d - 1e-10) << p.x << ' ' << p.y << ' ' << p.z << ": " << d;
    }
  }
  EXPECT_EQ(tested, count);
}

void expect_farthest(const PairDistances& pair, const Level& set, double size, int count, unsigned seed) {
  Samples samples(seed);
  for (int n = 0; n < count; ++n) {
    const Vector p = samples.place(size);
    const auto v = pair.value(Which::kEta2, exact_place(p));
    ASSERT_TRUE(v);
    const double d = v->value.to_double(), found = walked(set, p, size, -1, samples);
    EXPECT_GE(d, found - 1e-9);
    EXPECT_LE(d, found + 1e-3 * size);
  }
}

const Vector kHalf{1, 2, 1};
/// The box [-1, 1] x [-2, 2] x [-1, 1] grown by 1 in [-4, 4] x [-3, 3] x [-5, 5] grown by 3: the room is the distance
/// to the box of the differences.
TEST(RoundFits, RoundedBoxInRoundedBox) {
  const PairDistances pair = solid_pair(space::shared(rounded_box({}, {1, 2, 1}, Real(1))),
                                        space::shared(rounded_box({}, {4, 3, 5}, Real(3))));
  const Level fits = [](const Vector& x) { return to_box(x, {3, 1, 4}) - 2; };
  expect_nearest(pair, Which::kEta1, 1, fits, 9, 60, 1);
  expect_farthest(pair, fits, 7, 6, 2);
}

/// Corner by corner, where it is as round as the room or rounder, and where it is less so.
TEST(RoundFits, RoundedBoxInCapsule) {
  for (const auto& [radius, seed] : {std::pair{Real(1), 3U}, {Real::ratio(1, 4), 4U}, {Real(5), 5U}}) {
    const PairDistances pair = solid_pair(space::shared(rounded_box({}, {1, 1, 1}, radius)),
                                          space::shared(capsule({-6, -1, 0}, {5, 2, 1}, Real(5))));
    const double r = radius.to_double();
    const Level fits = [r](const Vector& x) {
      double most = -1e9;
      for (int k = 0; k < 8; ++k) {
        const Vector corner{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
        most = std::max(most, to_segment(space::plus(x, corner), {-6, -1, 0}, {5, 2, 1}) + r - 5);
      }
      return most;
    };
    if (r == 5) {
      EXPECT_FALSE(pair.value(Which::kEta1, space::place(1, 2, 3)));
      EXPECT_FALSE(pair.value(Which::kEta2, space::place(1, 2, 3)));
      continue;
    }
    expect_nearest(pair, Which::kEta1, 1, fits, 9, 40, seed);
    expect_farthest(pair, fits, 8, 4, seed);
  }
}

/// An L: [0, 12] x [0, 4] and [0, 4] x [0, 12], both up to 8. What a rounded box has to be away from is a quadrant.
TEST(RoundFits, RoundedBoxesInRoom) {
  const Body room = space::box_body({{{{0, 0, 0}, {12, 4, 8}}}, {{{0, 0, 0}, {4, 12, 8}}}});
  const auto fits = [](const Vector& h, double r) -> Level {
    return [=](const Vector& x) {
      const double walls = std::min({x.x - h.x, x.y - h.y, 12 - h.x - x.x, 12 - h.y - x.y, x.z - h.z, 8 - h.z - x.z});
      const double corner = std::hypot(std::min(0.0, x.x - 4 + h.x), std::min(0.0, x.y - 4 + h.y));
      return r - std::min(walls, corner);
    };
  };
  Body plate;  // a flat core
  plate.parts.push_back(
      space::part_of(std::vector<Point>{{-1, 0, -2}, {1, 0, -2}, {1, 0, 2}, {-1, 0, 2}}, Real::ratio(1, 2)));
  const PairDistances box = solid_pair(space::shared(plate), space::shared(room));
  expect_nearest(box, Which::kEta1, 1, fits({1, 0, 2}, 0.5), 9, 40, 6);
  // The farthest place is a corner of one of the two arms.
  double most = 0;
  for (int k = 0; k < 8; ++k) {
    const double z = k & 1 ? 5.5 : 2.5;
    for (const Vector& corner :
         {Vector{k & 2 ? 10.5 : 1.5, k & 4 ? 3.5 : 0.5, z}, Vector{k & 2 ? 2.5 : 1.5, k & 4 ? 11.5 : 0.5, z}})
      most = std::max(most, space::length(corner - Vector{1, 2, 3}));
  }
  EXPECT_NEAR(box.value(Which::kEta2, space::place(1, 2, 3))->value.to_double(), most, 1e-10);
  // Two radii: both have to fit.
  Body small;
  small.parts.push_back({std::nullopt, {1, 0, 0}, Real::ratio(1, 2)});
  small.parts.push_back({std::nullopt, {0, 1, 1}, Real(1)});
  const PairDistances balls = solid_pair(space::shared(small), space::shared(room));
  const Level one = fits({}, 0.5), other = fits({}, 1);
  const Level both = [&](const Vector& x) {
    return std::max(one(space::plus(x, {1, 0, 0})), other(space::plus(x, {0, 1, 1})));
  };
  expect_nearest(balls, Which::kEta1, 1, both, 9, 40, 8);
  Samples samples(9);
  int inside = 0;
  for (int n = 0; n < 400; ++n) {
    const Vector p = samples.in_ball({2, 3, 4}, 4);
    if (both(p) > -0.01) continue;
    ++inside;
    EXPECT_NEAR(balls.value(Which::kEta1, exact_place(p))->value.to_double(), both(p), 1e-9);
  }
  EXPECT_GT(inside, 20);
}

/// A rounded box against two balls, a capsule and a ball: grown boxes and capsules.
TEST(RoundFits, DepthInUnions) {
  Body balls;
  balls.parts.push_back({std::nullopt, {-3, 0, 0}, Real(3)});
  balls.parts.push_back({std::nullopt, {3, 1, 0}, Real(2)});
  const PairDistances pair = solid_pair(space::shared(rounded_box({}, {1, 2, 1}, Real(1))), space::shared(balls));
  const Level apart = [](const Vector& x) {
    return std::max(4 - to_box(x - Vector{-3, 0, 0}, kHalf), 3 - to_box(x - Vector{3, 1, 0}, kHalf));
  };
  expect_nearest(pair, Which::kGamma1, -1, apart, 7, 60, 10);
  const PairDistances mixed = solid_pair(space::shared(balls), space::shared(capsule({0, -4, 0}, {0, 4, 1}, Real(1))));
  const Level off = [](const Vector& x) {
    const auto one = [&](const Vector& c, double r) {
      return r + 1 - to_segment(space::plus(x, c), {0, -4, 0}, {0, 4, 1});
    };
    return std::max(one({-3, 0, 0}, 3), one({3, 1, 0}, 2));
  };
  expect_nearest(mixed, Which::kGamma1, -1, off, 7, 60, 11);
}

/// How deep a rounded box lies in two balls, and how far it protrudes from boxes, against samples of all of it.
TEST(RoundFits, RoundedBoxAndUnions) {
  Samples samples(12);
  Body balls;
  balls.parts.push_back({std::nullopt, {-3, 0, 0}, Real(6)});
  balls.parts.push_back({std::nullopt, {4, 1, 0}, Real(6)});
  const Body b = rounded_box({}, {1, 2, 1}, Real(1));
  const PairDistances in_balls = solid_pair(space::shared(b), space::shared(balls));
  const Body boxes = space::box_body({{{{-5, -5, -5}, {5, 0, 5}}}, {{{-5, -5, -5}, {0, 5, 5}}}});
  const PairDistances in_boxes = solid_pair(space::shared(b), space::shared(boxes));
  const auto to_boxes = [](const Vector& x) {
    return std::min(to_box(x - Vector{0, -2.5, 0}, {5, 2.5, 5}), to_box(x - Vector{-2.5, 0, 0}, {2.5, 5, 5}));
  };
  int inside = 0;
  for (int n = 0; n < 30; ++n) {
    const Vector p = samples.in_ball({}, 5);
    double out = -1e9;
    bool in = true;
    for (int k = 0; k < 20000; ++k) {
      const Vector core{samples.uniform(-1, 1), samples.uniform(-2, 2), samples.uniform(-1, 1)};
      const Vector x = space::plus(space::plus(p, core), samples.in_ball({}, 1));
      out = std::max(out, to_boxes(x));
      in = in && (space::length(x - Vector{-3, 0, 0}) < 6 || space::length(x - Vector{4, 1, 0}) < 6);
    }
    const double h = in_boxes.value(Which::kH, exact_place(p))->value.to_double();
    EXPECT_GE(h, out - 1e-10);
    EXPECT_LE(h, std::max(out, 0.0) + 0.5);
    const double mu = in_balls.value(Which::kMu, exact_place(p))->value.to_double();
    EXPECT_TRUE(in || mu > 0);
    if (mu >= 0) continue;
    ++inside;
    // Around every point of B there are -mu of room, and no more: where the balls end is that near.
    for (int k = 0; k < 2000; ++k) {
      const Vector core{samples.uniform(-1, 1), samples.uniform(-2, 2), samples.uniform(-1, 1)};
      const Vector x = space::plus(space::plus(p, core), samples.in_ball({}, 1 - mu - 1e-9));
      EXPECT_TRUE(space::length(x - Vector{-3, 0, 0}) < 6 || space::length(x - Vector{4, 1, 0}) < 6);
    }
    double nearest = 1e9;
    for (int k = 0; k < 20000; ++k) {
      const Vector x = samples.in_ball(p, 9);
      if (space::length(x - Vector{-3, 0, 0}) < 6 || space::length(x - Vector{4, 1, 0}) < 6) continue;
      nearest = std::min(nearest, to_box(x - p, kHalf) - 1);
    }
    EXPECT_LE(-mu, nearest + 1e-10);
    EXPECT_GE(-mu, nearest - 0.6);
  }
  EXPECT_GE(inside, 5);
}

/// Signs on lines found by values, against the formula of the set at places that are not near its front.
TEST(RoundFits, SignsOnLines) {
  Body balls;
  balls.parts.push_back({std::nullopt, {-3, 0, 0}, Real(3)});
  balls.parts.push_back({std::nullopt, {3, 1, 0}, Real(2)});
  const Body b = rounded_box({}, {1, 2, 1}, Real(1));
  const space::RayGrid grid{2, 2, -13, -11, 5, 5, 6, 6};
  const Real level = Real::ratio(-1, 2);
  const PairDistances pair = solid_pair(space::shared(b), space::shared(balls));
  const auto rays = ray_sign_map(Which::kGamma1, level, b, balls, grid);
  ASSERT_TRUE(rays->searched());
  int negative = 0, ends = 0;
  for (int j = 0; j < grid.nv; ++j) {
    const space::RayRow row = rays->row(j);
    for (int i = 0; i < grid.nu; ++i) {
      ends += row.first[static_cast<std::size_t>(i) + 1] - row.first[static_cast<std::size_t>(i)];
      for (int z = -40; z <= 40; ++z) {
        const auto v =
            pair.value(Which::kGamma1, {Real::ratio(grid.u_at(i), 2), Real::ratio(grid.v_at(j), 2), Real::ratio(z, 4)});
        const double gap = (v->value - level).to_double();
        if (std::fabs(gap) < 1e-6) continue;
        const int sign = space::sign_at(row, i, Real::ratio(z, 2));
        EXPECT_EQ(sign, gap < 0 ? -1 : 1);
        negative += sign < 0;
      }
    }
  }
  EXPECT_GT(negative, 50);
  EXPECT_GT(ends, 20);
}

/// The best fit and the depth that no position exceeds, by symmetry known.
TEST(RoundFits, LeastValues) {
  const auto least = [](Which which, const Body& b, const Body& a) {
    const auto found = solid_least(which, b, a).or_throw();
    return found ? found->value.to_double() : INFINITY;
  };
  const Body small = rounded_box({}, {1, 2, 1}, Real(1)), large = rounded_box({}, {4, 3, 5}, Real(3));
  EXPECT_NEAR(least(Which::kEta1, small, large), -3, 1e-6);
  EXPECT_NEAR(least(Which::kDelta1, large, small), -3, 1e-6);
}

}  // namespace distance_round_fits
}  // namespace findspace::distance
