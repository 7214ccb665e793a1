// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Small shapes far from the origin: every distance has the values and the least level it has at the origin, and the
// same set of minimisers, displaced. The coordinates go up to 10^11 steps of the grid, the shapes have about 10.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "distance/planar/at_position.h"
#include "distance/planar_least/extremum.h"
#include "distance_random.h"
#include "plane/base/real_vector.h"
#include "plane/complex/overlay.h"
#include "plane/query/moved.h"
#include "plane/query/nearest.h"
#include "plane/query/topology.h"

namespace findspace::distance {
namespace distance_far {

using plane::operator+;
using plane::operator-;

/// Where two shapes are displaced to, and what that makes of positions.
struct Far {
  RealPoint b, a;
  RealPoint step() const { return a - b; }
};

Far far(Shapes& random) {
  constexpr std::array<std::int64_t, 3> kSizes{1000, 100'000'007, 99'999'999'977};
  const std::int64_t size = kSizes[std::size_t(random.number(0, 2))];
  const auto vector = [&] { return RealPoint{size * random.number(-1, 1), size * random.number(-1, 1)}; };
  return {vector(), vector()};
}

bool is_same_set(const Region& p, const Region& q) {
  const std::array<const plane::CellComplex*, 2> both{&p, &q};
  return plane::is_empty(
      plane::overlay(both, [](std::span<const plane::Mark> m) { return plane::Mark((m[0] > 0) != (m[1] > 0)); }));
}

double way_to(const Region& shape, const RealPoint& p) {
  const auto inside = [](plane::Mark m) { return m > 0; };
  return sign_at(shape, p) > 0 ? 0 : plane::nearest(shape, inside, p)->distance.to_double();
}

TEST(DistanceFar, ValuesAndWitnesses) {
  Shapes random(61);
  for (int k = 0; k < 60; ++k) {
    const Region b = random.shape(), a = random.shape();
    const Far by = far(random);
    const AtPosition here(std::make_shared<ShapePair>(b, a)),
        there(std::make_shared<ShapePair>(plane::moved(b, by.b), plane::moved(a, by.a)));
    const RealPoint p = random.position();
    for (const Which w : kAll) {
      const auto f = here.measure(w, p), g = there.measure(w, p + by.step());
      ASSERT_EQ(f.has_value(), g.has_value()) << int(w);
      if (!f) continue;
      EXPECT_EQ(f->minus_infinity, g->minus_infinity);
      EXPECT_NEAR(f->value.to_double(), g->value.to_double(), 1e-12) << int(w);
      ASSERT_EQ(f->witness.size(), g->witness.size()) << int(w);
      const auto h = there.pair().distance(w)->value(p + by.step());
      if (f->nearest && h && h->nearest) {
        EXPECT_EQ(sign_at(there.pair().distance(w)->sign_map(Real()), *g->nearest), 0) << int(w);
      }
      for (const Feature& at : g->witness)
        EXPECT_LT(way_to(at.of_moving ? b : a, at.of_moving ? at.at - (p + by.a) : at.at - by.a), 1e-12) << int(w);
    }
  }
}

TEST(DistanceFar, LeastLevelsAndMinimisers) {
  Shapes random(62);
  int fat = 0, proven = 0;
  for (int k = 0; k < 25; ++k) {
    const Region b = random.shape(), a = random.shape();
    const Far by = far(random);
    const ShapePair here(b, a), there(plane::moved(b, by.b), plane::moved(a, by.a));
    for (const Which w : kAll) {
      const Extremum e = least(*here.distance(w)), f = least(*there.searched(w));
      ASSERT_EQ(e.exists(), f.exists()) << int(w);
      if (!e.exists()) continue;
      EXPECT_NEAR(e.answer->value.to_double(), f.answer->value.to_double(), 1e-12) << int(w);
      EXPECT_EQ(e.proven(), f.proven()) << int(w);
      if (!e.proven() || !f.proven()) continue;
      EXPECT_EQ(e.attained, f.attained);
      EXPECT_TRUE(is_same_set(plane::moved(e.at, by.step()), f.at)) << int(w) << " case " << k;
      ++proven;
      fat += std::any_of(e.at.faces.begin(), e.at.faces.end(), [](const auto& face) { return face.mark > 0; });
    }
  }
  EXPECT_GT(proven, 300);
  EXPECT_GT(fat, 50);
}

}  // namespace distance_far
}  // namespace findspace::distance
