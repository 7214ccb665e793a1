// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Laws of the distances of solids under random input (distances.md 2.5, 3.1): translation, exchange of roles, order,
// Lipschitz bound, duality with the complement; and the two independent ways to the value of box unions (covers by
// convex sets, painted grids).
#include <gtest/gtest.h>

#include <cmath>

#include "differential/space_oracle.h"
#include "distance/solid/box_maps.h"
#include "distance/solid/solid_pair.h"
#include "space/box/box_topology.h"
#include "space/phi/phi_function.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_solid {

using exact::Real;
using space::Body;
using space::real;
using space::RealVector;

constexpr double kNear = 0x1p-36;

double number(const std::optional<Answer>& v) {
  return !v ? INFINITY : v->minus_infinity ? -INFINITY : v->value.to_double();
}

void expect_near(double a, double b) {
  if (std::isinf(a) || std::isinf(b)) {
    ASSERT_EQ(a, b);
  } else {
    ASSERT_NEAR(a, b, kNear * (1 + std::fabs(a)));
  }
}

Body body_of(const space::Polytope& p) {
  Body b;
  b.parts.push_back({p, {}, Real()});
  return b;
}

RealVector draw(space::RandomPolytopes& random, std::int64_t reach) {
  return space::place(random.pick(-2 * reach, 2 * reach), random.pick(-2 * reach, 2 * reach),
                      random.pick(-2 * reach, 2 * reach), 2);
}

TEST(SolidLaws, ConvexPairs) {
  space::RandomPolytopes random(41);
  for (int round = 0; round < 12; ++round) {
    const auto [a, b] = random.pair();
    const space::Point shift{random.pick(-9, 9), random.pick(-9, 9), random.pick(-9, 9)};
    const PairDistances pair = solid_pair(shared(body_of(b)), shared(body_of(a))),
                        back = solid_pair(shared(body_of(a)), shared(body_of(b))),
                        moved = solid_pair(shared(body_of(b.translated(shift))), shared(body_of(a)));
    for (int i = 0; i < 3; ++i) {
      const RealVector p = draw(random, 12), q = space::negated(p), r = space::plus(p, space::place(1, -1, 1, 4));
      const auto at = [&](Which w, const RealVector& x) { return number(pair.value(w, x)); };
      const double gamma1 = at(Which::kGamma1, p), mu = at(Which::kMu, p), mu_back = at(Which::kMuBack, p),
                   eta1 = at(Which::kEta1, p), delta1 = at(Which::kDelta1, p), gamma2 = at(Which::kGamma2, p);
      expect_near(gamma1, number(back.value(Which::kGamma1, q)));
      expect_near(eta1, number(back.value(Which::kDelta1, q)));
      expect_near(at(Which::kEta2, p), number(back.value(Which::kDelta2, q)));
      expect_near(mu, number(back.value(Which::kMuBack, q)));
      for (const Which w : {Which::kGamma1, Which::kGamma2, Which::kEta1, Which::kDelta1, Which::kMu, Which::kMuBack})
        expect_near(at(w, p), number(moved.value(w, space::minus(p, real(shift)))));
      ASSERT_LE(gamma1, mu + kNear);
      ASSERT_LE(gamma1, mu_back + kNear);
      ASSERT_LE(mu, eta1 + kNear);
      ASSERT_LE(mu_back, delta1 + kNear);
      ASSERT_LE(std::fabs(gamma1), gamma2 + kNear);
      if (eta1 <= 0) expect_near(mu, eta1);
      for (const Which w : {Which::kGamma1, Which::kGamma2, Which::kEta1, Which::kEta2, Which::kMu, Which::kMuBack}) {
        if (std::isinf(at(w, p))) continue;
        ASSERT_LE(std::fabs(at(w, p) - at(w, r)), std::sqrt(3) / 4 + kNear);
      }
      // Where the distance is zero, it is zero.
      for (const Which w : {Which::kGamma1, Which::kEta1}) {
        const auto v = pair.value(w, p);
        if (!v || !v->nearest) continue;
        ASSERT_EQ(pair.value(w, *v->nearest)->value.sign(), 0);
      }
    }
  }
}

TEST(SolidLaws, GammaIsThePhiFunction) {
  space::RandomPolytopes random(42);
  for (int round = 0; round < 25; ++round) {
    const auto [a, b] = random.pair();
    const space::PhiFunction phi(a, b);
    const PairDistances pair = solid_pair(shared(body_of(b)), shared(body_of(a)));
    for (int i = 0; i < 4; ++i) {
      const RealVector p = draw(random, 12);
      expect_near(number(pair.value(Which::kGamma1, p)), phi.normalised(space::rounded(p)));
      ASSERT_EQ(pair.value(Which::kGamma1, p)->value.sign(), phi.sign(space::rounded(p)));
    }
  }
}

TEST(SolidLaws, BoxUnionsTwoWays) {
  std::mt19937 random(43);
  const auto pick = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };
  for (int round = 0; round < 25; ++round) {
    const auto a = space::random_boxes(random, 4, 5), b = space::random_boxes(random, 2, 3);
    const PairDistances bodies = solid_pair(shared(space::box_body(b)), shared(space::box_body(a)));
    const BoxMaps boxes(space::box_set(b), space::box_set(a));
    const BoxMaps dual(space::box_set(b), closure(complement(space::box_set(a))));
    for (int i = 0; i < 4; ++i) {
      const RealVector p = space::place(pick(-8, 12), pick(-8, 12), pick(-8, 12), 2);
      for (const Which w : {Which::kGamma1, Which::kEta1, Which::kDelta1, Which::kEta2, Which::kDelta2,
                            Which::kPenetration, Which::kDstar, Which::kDstarBack}) {
        const auto x = bodies.value(w, p), y = boxes.distances().value(w, p);
        ASSERT_EQ(x.has_value(), y.has_value());
        if (!x) continue;
        ASSERT_EQ(x->value, y->value) << number(x) << ' ' << number(y);
      }
      const double eta1 = number(boxes.distances().value(Which::kEta1, p));
      expect_near(number(dual.distances().value(Which::kGamma1, p)), -eta1);
    }
  }
}

}  // namespace distance_solid
}  // namespace findspace::distance
