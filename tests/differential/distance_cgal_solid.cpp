// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distance of convex polytopes against CGAL's Polytope_distance_d (a quadratic program in exact integers).
#include <CGAL/Gmpz.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <gtest/gtest.h>

#include <cmath>

#include "differential/space_oracle.h"
#include "distance/solid/solid_pair.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_cgal_solid {

using Kernel = CGAL::Homogeneous<CGAL::Gmpz>;
using Rival = CGAL::Polytope_distance_d<CGAL::Polytope_distance_d_traits_3<Kernel>>;

/// The vertices in half units, moved by `by` half units.
std::vector<Kernel::Point_3> halves(const space::Polytope& p, const std::array<std::int64_t, 3>& by) {
  std::vector<Kernel::Point_3> out;
  for (const space::Point& v : p.vertices()) {
    out.emplace_back(CGAL::Gmpz(double(2 * v.x + by[0])), CGAL::Gmpz(double(2 * v.y + by[1])),
                     CGAL::Gmpz(double(2 * v.z + by[2])));
  }
  return out;
}

TEST(SolidCgal, DistanceOfConvexPolytopes) {
  space::RandomPolytopes random(61);
  int apart = 0;
  for (int round = 0; round < 60; ++round) {
    const auto [a, b] = random.pair();
    space::Body of_a, of_b;
    of_a.parts.push_back({a, {}, exact::Real()});
    of_b.parts.push_back({b, {}, exact::Real()});
    const PairDistances pair = solid_pair(shared(std::move(of_b)), shared(std::move(of_a)));
    for (int i = 0; i < 5; ++i) {
      const std::array<std::int64_t, 3> by{random.pick(-60, 60), random.pick(-60, 60), random.pick(-60, 60)};
      const auto p = halves(a, {0, 0, 0}), q = halves(b, by);
      const Rival rival(p.begin(), p.end(), q.begin(), q.end());
      const double square = CGAL::to_double(rival.squared_distance_numerator()) /
                            CGAL::to_double(rival.squared_distance_denominator()) / 4;
      const auto d1 = pair.value(Which::kD1, space::place(by[0], by[1], by[2], 2));
      ASSERT_NEAR(d1->value.to_double(), std::sqrt(square), 1e-13 * (1 + std::sqrt(square)));  // no sign: test
      apart += square > 0;
    }
  }
  EXPECT_GT(apart, 100);
}

}  // namespace distance_cgal_solid
}  // namespace findspace::distance
