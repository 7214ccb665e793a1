// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances over the time of a motion (distances.md 7.3) on random shapes and paths: sign maps against looking along
// the path one position at a time, levels below 0 included; the same path backwards or with more way points gives the
// same map; the value of every instant lies between inf and sup, which the sign maps confirm at their own values.
#include <gtest/gtest.h>

#include <algorithm>

#include "distance/planar/shape_pair.h"
#include "distance/rotation/over_time.h"
#include "law/plane_random.h"
#include "plane/query/locate.h"
#include "plane/query/section.h"

namespace findspace::distance {
namespace distance_over_time {

using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::Random;

constexpr plane::Variety kClosedShapes{.size = 4, .flat = true, .arcs = true, .plain = false};

ShapePair random_pair(Random& random) {
  auto closed = [&](std::int64_t size) {
    plane::Variety v = kClosedShapes;
    v.size = size;
    return plane::closure(plane::region_of(random_shape(random, v)));
  };
  plane::Region b = closed(2), a = closed(4);
  return ShapePair(std::move(b), std::move(a));
}

RelativePath random_path(Random& random) {
  RelativePath path;
  for (std::int64_t k = random.pick(1, 3); k >= 0; --k)
    path.push_back({Real::ratio(random.pick(-8, 8), 2), Real::ratio(random.pick(-12, 12), 3)});
  return path;
}

RealPoint random_position(Random& random) {
  return {Real::ratio(random.pick(-20, 20), 4), Real::ratio(random.pick(-20, 20), 4)};
}

RealPoint moved(const RealPoint& p, const RealPoint& w) { return {p.x + w.x, p.y + w.y}; }

/// The least and greatest mark along the path from p.
std::pair<int, int> look(const plane::SignMap& m, const RealPoint& p, const RelativePath& path) {
  std::vector<Real> times;
  for (std::size_t k = 0; k < path.size(); ++k) times.push_back(Real(int(k)));
  const plane::Section s = plane::section_of_path(m, p, path, times);
  int least = 1, most = -1;
  for (std::size_t k = 0; k < s.stops.size(); ++k) {
    least = std::min<int>(least, s.stops[k].at);
    most = std::max<int>(most, s.stops[k].at);
    if (k + 1 == s.stops.size()) break;
    least = std::min<int>(least, s.stops[k].after);
    most = std::max<int>(most, s.stops[k].after);
  }
  return {least, most};
}

int sign_at(const plane::SignMap& m, const RealPoint& p) { return mark_of(m, locate(m, p)); }

constexpr std::array<Which, 6> kSome{Which::kGamma1, Which::kEta1, Which::kDelta1,
                                     Which::kGamma2, Which::kMu,   Which::kD1};

TEST(OverTime, MapsAgreeWithLookingAlongThePath) {
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Random random(seed);
    const ShapePair pair = random_pair(random);
    const TDistancePointer f = pair.distance(kSome[std::size_t(random.pick(0, 5))]);
    const RelativePath path = random_path(random);
    const Real level = Real::ratio(random.pick(-4, 6), 2);
    const plane::SignMap at_once = f->sign_map(level);
    const plane::SignMap least = over_time(f, path, Sense::kMinimum)->sign_map(level);
    const plane::SignMap most = over_time(f, path, Sense::kMaximum)->sign_map(level);
    ASSERT_EQ(plane::fault(least), "") << "seed " << seed;
    ASSERT_EQ(plane::fault(most), "") << "seed " << seed;
    std::vector<RealPoint> places;
    for (const auto* m : {&least, &most})
      for (std::size_t v = 0; v < m->vertices.size(); v += 3) places.push_back(m->geometry.exact(m->vertices[v].point));
    for (int k = 0; k < 10; ++k) places.push_back(random_position(random));
    for (const RealPoint& p : places) {
      const auto [low, high] = look(at_once, p, path);
      ASSERT_EQ(sign_at(least, p), low) << "seed " << seed << " at " << p.x.text() << ", " << p.y.text();
      ASSERT_EQ(sign_at(most, p), high) << "seed " << seed << " at " << p.x.text() << ", " << p.y.text();
    }
  }
}

TEST(OverTime, BackwardsAndInSmallerLegsIsTheSame) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed + 300);
    const ShapePair pair = random_pair(random);
    const TDistancePointer f = pair.distance(kSome[std::size_t(random.pick(0, 2))]);
    const RelativePath path = random_path(random);
    const Real level = Real::ratio(random.pick(-2, 4), 2);
    RelativePath back(path.rbegin(), path.rend()), finer{path[0]};
    for (std::size_t k = 1; k < path.size(); ++k) {
      const Real part = Real::ratio(random.pick(1, 4), 5);
      finer.push_back(
          {path[k - 1].x + part * (path[k].x - path[k - 1].x), path[k - 1].y + part * (path[k].y - path[k - 1].y)});
      finer.push_back(path[k]);
    }
    for (Sense sense : {Sense::kMinimum, Sense::kMaximum}) {
      const plane::SignMap m = over_time(f, path, sense)->sign_map(level);
      for (const RelativePath* other : {&back, &finer}) {
        const plane::SignMap n = over_time(f, *other, sense)->sign_map(level);
        ASSERT_TRUE(plane::same_set(plane::remark(m, [](Mark k) { return Mark(k <= 0); }),
                                    plane::remark(n, [](Mark k) { return Mark(k <= 0); })))
            << "seed " << seed;
        ASSERT_TRUE(plane::same_counts(m, n)) << "seed " << seed;
      }
    }
  }
}

TEST(OverTime, InstantsLieBetweenInfAndSup) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed + 600);
    const ShapePair pair = random_pair(random);
    const TDistancePointer f = pair.distance(kSome[std::size_t(random.pick(0, 3))]);
    const RelativePath path = random_path(random);
    const RealPoint p = random_position(random);
    const auto inf = over_time(f, path, Sense::kMinimum), sup = over_time(f, path, Sense::kMaximum);
    const auto low = inf->value(p), high = sup->value(p);
    ASSERT_EQ(low.has_value(), f->defined()) << "seed " << seed;
    if (!low) continue;
    for (std::int64_t k = 0; k <= 6; ++k) {
      const std::size_t leg = std::size_t(random.pick(0, std::int64_t(path.size()) - 2));
      const Real part = Real::ratio(k, 6);
      const RealPoint w{path[leg].x + part * (path[leg + 1].x - path[leg].x),
                        path[leg].y + part * (path[leg + 1].y - path[leg].y)};
      const double v = f->value(moved(p, w))->value.to_double(), room = 1e-9;
      ASSERT_LE(low->value.to_double(), v + room) << "seed " << seed;
      ASSERT_GE(high->value.to_double(), v - room) << "seed " << seed;
      ASSERT_EQ(at_instant(f, w)->value(p)->value, f->value(moved(p, w))->value);
    }
    const Real small = Real::ratio(1, 1000000);
    ASSERT_LE(sign_at(inf->sign_map(low->value + small), p), 0) << "seed " << seed;
    ASSERT_GE(sign_at(inf->sign_map(low->value - small), p), 0) << "seed " << seed;
    ASSERT_LE(sign_at(sup->sign_map(high->value + small), p), 0) << "seed " << seed;
    ASSERT_GE(sign_at(sup->sign_map(high->value - small), p), 0) << "seed " << seed;
  }
}

}  // namespace distance_over_time
}  // namespace findspace::distance
