// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances along a direction (distances.md 7.1) on random shapes: sign maps (made by sweeping) against values (read
// off one line) at every vertex and edge of the map, levels that are taken exactly among them; |f_u| >= |f| with
// equality towards the nearest point; both ways against one way and the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>

#include "distance/planar/directional.h"
#include "distance/planar/shape_pair.h"
#include "law/plane_random.h"
#include "plane/query/locate.h"

namespace findspace::distance {
namespace distance_direction {

using exact::Real;
using exact::RealPoint;
using plane::Random;
using plane::Region;

constexpr std::array<Which, 3> kSigned{Which::kGamma1, Which::kEta1, Which::kDelta1};
constexpr plane::Variety kClosedShapes{.size = 5, .flat = true, .arcs = true, .plain = false};

TranslationDirection random_track(Random& random) {
  TranslationDirection t;
  do {
    t.dx = random.pick(-3, 3);
    t.dy = random.pick(-3, 3);
  } while (t.dx == 0 && t.dy == 0);
  exact::make_primitive(t.dx, t.dy);
  if (random.pick(0, 1)) {
    t.dx = -t.dx;
    t.dy = -t.dy;
  }
  t.both_ways = random.pick(0, 1);
  return t;
}

RealPoint random_position(Random& random) {
  return {Real::ratio(random.pick(-24, 24), 4), Real::ratio(random.pick(-24, 24), 4)};
}

/// Small moving shapes fit into the fixed ones now and then.
ShapePair random_pair(Random& random) {
  auto closed = [](const plane::ShapePtr& s) { return plane::closure(plane::region_of(s)); };
  Region b = closed(random_shape(random, {.size = 2, .flat = true, .arcs = true, .plain = false}));
  Region a = closed(random_shape(random, kClosedShapes));
  if (random.pick(0, 2) == 0) std::swap(a, b);
  return ShapePair(std::move(b), std::move(a));
}

const plane::SignMap& base_of(const ShapePair& pair, Which which) {
  return static_cast<const SignedDistance&>(*pair.distance(which)).base();
}

PositionFunctionPointer directional(const ShapePair& pair, Which which, const TranslationDirection& direction,
                                    bool farthest) {
  if (farthest) return std::make_shared<DirectionalFarthest>(base_of(pair, which), direction);
  return std::make_shared<DirectionalSigned>(base_of(pair, which), direction);
}

int sign_against(const std::optional<PlanarAnswer>& v, const Real& level) {
  if (!v) return 1;
  return v->minus_infinity ? -1 : compare(v->value, level);
}

/// Vertices, and points of edges and beside them.
std::vector<RealPoint> probes(const plane::SignMap& m, Random& random) {
  std::vector<RealPoint> out;
  for (int k = 0; k < 6; ++k) out.push_back(random_position(random));
  auto at = [&](plane::Index v) { return m.geometry.exact(m.vertices[v].point); };
  for (int k = 0; k < 6 && !m.vertices.empty(); ++k)
    out.push_back(at(plane::Index(random.pick(0, std::int64_t(m.vertices.size()) - 1))));
  for (int k = 0; k < 6 && !m.edges.empty(); ++k) {
    const plane::Edge& e = m.edges[std::size_t(random.pick(0, std::int64_t(m.edges.size()) - 1))];
    const RealPoint p = at(e.v0), q = at(e.v1);
    out.push_back({(p.x + q.x) / Real(2), (p.y + q.y) / Real(2)});
  }
  return out;
}

TEST(Directional, SignMapsAgreeWithValues) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const ShapePair pair = random_pair(random);
    const TranslationDirection direction = random_track(random);
    const Which which = kSigned[std::size_t(random.pick(0, 2))];
    const bool farthest = random.pick(0, 2) == 0;
    const auto f = directional(pair, which, direction, farthest);
    Real level = Real::ratio(random.pick(-6, 8), 2);
    // Half of the time a level that some position takes exactly.
    const auto taken = f->value(random_position(random));
    if (random.pick(0, 1) && taken && !taken->minus_infinity) level = taken->value;
    const plane::SignMap map = f->sign_map(level);
    ASSERT_EQ(plane::fault(map), "") << "seed " << seed;
    for (const RealPoint& p : probes(map, random)) {
      ASSERT_EQ(int(mark_of(map, locate(map, p))), sign_against(f->value(p), level))
          << "seed " << seed << " which " << int(which) << (farthest ? " farthest" : "")
          << (direction.both_ways ? " along " : " toward ") << direction.dx << "," << direction.dy << " level "
          << level.text() << " at " << p.x.text() << ", " << p.y.text();
    }
  }
}

TEST(Directional, IsNeverCloserThanAllDirections) {
  int equal = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed + 1000);
    const ShapePair pair = random_pair(random);
    const Which which = kSigned[std::size_t(random.pick(0, 2))];
    const auto plain = pair.distance(which);
    const RealPoint p = random_position(random);
    const auto f = plain->value(p);
    const auto along = directional(pair, which, random_track(random), false)->value(p);
    if (!f) {
      ASSERT_FALSE(along.has_value()) << "seed " << seed;
      continue;
    }
    if (along && !along->minus_infinity) {
      ASSERT_GE(abs(along->value), abs(f->value)) << "seed " << seed;
      ASSERT_TRUE(along->value.sign() * f->value.sign() >= 0) << "seed " << seed;
    }
    if (f->value.sign() == 0) {
      ASSERT_TRUE(along && along->value.sign() == 0) << "seed " << seed;
      continue;
    }
    if (!f->nearest || !f->nearest->x.is_rational() || !f->nearest->y.is_rational()) continue;
    const auto d = plane::primitive_direction({f->nearest->x - p.x, f->nearest->y - p.y});
    ASSERT_TRUE(d.has_value());
    const auto straight = directional(pair, which, {d->x, d->y, false}, false)->value(p);
    ASSERT_TRUE(straight && straight->value == f->value) << "seed " << seed;
    ++equal;
  }
  EXPECT_GT(equal, 20);
}

TEST(Directional, BothWaysIsTheBetterOfTheTwo) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    Random random(seed + 2000);
    const ShapePair pair = random_pair(random);
    const Which which = kSigned[std::size_t(random.pick(0, 2))];
    TranslationDirection direction = random_track(random);
    const bool farthest = random.pick(0, 1);
    auto value = [&](int sign, bool both) {
      return directional(pair, which, {sign * direction.dx, sign * direction.dy, both}, farthest);
    };
    const RealPoint p = random_position(random);
    const auto both = value(1, true)->value(p), there = value(1, false)->value(p), back = value(-1, false)->value(p);
    ASSERT_EQ(both.has_value(), there.has_value() || back.has_value()) << "seed " << seed;
    if (!both) continue;
    auto size = [](const PlanarAnswer& v) {
      return v.minus_infinity ? std::optional<Real>() : std::optional<Real>(abs(v.value));
    };
    std::optional<Real> best;
    for (const auto* v : {&there, &back}) {
      if (!*v || !size(**v)) continue;
      const Real r = *size(**v);
      if (!best || (farthest ? *best < r : r < *best)) best = r;
    }
    ASSERT_EQ(both->minus_infinity, !best.has_value()) << "seed " << seed;
    if (best) {
      ASSERT_EQ(abs(both->value), *best) << "seed " << seed;
    }
  }
}

}  // namespace distance_direction
}  // namespace findspace::distance
