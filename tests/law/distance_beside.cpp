// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes that stand out of each other by next to nothing, 10^-3 to 10^-15 of their size. For a point outside A,
// gamma1 = d1 = mu = h, exactly. For all shapes gamma1 <= mu <= hausdorff and mu <= h. A value that is not exact says
// what it lies between.

#include <gtest/gtest.h>

#include "distance/planar/at_position.h"
#include "distance/planar_features/point_set.h"
#include "distance_random.h"
#include "plane/base/real_vector.h"
#include "plane/query/nearest.h"

namespace findspace::distance {
namespace distance_beside {

using plane::operator+;
using plane::operator-;

/// A point of the boundary of A, and a step of about `size` off it.
RealPoint beside(Shapes& random, const Region& a, const Real& size) {
  const auto vertex = [&](plane::Index v) { return a.geometry.exact(a.vertices[v].point); };
  const plane::Edge& e = a.edges[std::size_t(random.number(0, int(a.edges.size()) - 1))];
  const RealPoint p = vertex(e.v0), q = vertex(e.v1);
  const Real t = Real::ratio(random.number(0, 8), 8);
  const Real x = Real(int(random.number(-3, 3))) * size, y = Real(int(random.number(-3, 3))) * size;
  return {p.x + t * (q.x - p.x) + x, p.y + t * (q.y - p.y) + y};
}

Real size(Shapes& random) { return Real::from_double(std::ldexp(1.0, -int(random.number(10, 50)))); }

double lower(const PlanarAnswer& v) { return v.bounds().lower->to_double(); }
double upper(const PlanarAnswer& v) { return v.bounds().upper->to_double(); }

TEST(DistanceBeside, PointOutside) {
  Shapes random(11);
  const RealPoint origin{Real(), Real()};
  const Region point = point_set({&origin, 1});
  int seen = 0;
  for (int k = 0; k < 400; ++k) {
    const Region a = random.shape();
    const AtPosition at(std::make_shared<ShapePair>(point, a));
    const RealPoint p = beside(random, a, size(random));
    if (mark_of(a, plane::locate(a, p)) > 0) continue;
    ++seen;
    const Real d = plane::nearest(
                       a, [](plane::Mark m) { return m > 0; }, p)
                       ->distance;
    for (const Which w : {Which::kGamma1, Which::kD1, Which::kMu, Which::kH}) {
      const auto v = at.measure(w, p);
      ASSERT_TRUE(v.has_value());
      EXPECT_LE(lower(*v), d.to_double() * (1 + 1e-12)) << int(w);
      EXPECT_GE(upper(*v), d.to_double() * (1 - 1e-12)) << int(w);
      if (v->proven) {
        EXPECT_NEAR(v->value.to_double(), d.to_double(), d.to_double() * 1e-12) << int(w);
      }
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(DistanceBeside, OrderOfDistances) {
  Shapes random(12);
  for (int k = 0; k < 200; ++k) {
    const Region a = random.shape(), b = random.shape();
    const AtPosition at(std::make_shared<ShapePair>(b, a));
    const RealPoint corner = b.geometry.exact(b.vertices[0].point), p = beside(random, a, size(random)) - corner;
    const auto gamma = at.measure(Which::kGamma1, p), mu = at.measure(Which::kMu, p), h = at.measure(Which::kH, p),
               hausdorff = at.measure(Which::kHausdorff, p);
    ASSERT_TRUE(gamma && mu && h && hausdorff);
    EXPECT_LE(lower(*mu), upper(*mu));
    if (!gamma->minus_infinity) {
      EXPECT_LE(lower(*gamma), upper(*mu) * (1 + 1e-12));
    }
    EXPECT_LE(lower(*mu), upper(*h));
    EXPECT_LE(lower(*mu), upper(*hausdorff));
    // B protrudes from A where it is not contained, however little.
    const auto margin = at.measure(Which::kEta1, p);
    if (margin && !margin->minus_infinity && margin->value.sign() > 0) {
      EXPECT_GT(upper(*mu), 0);
    }
  }
}

}  // namespace distance_beside
}  // namespace findspace::distance
