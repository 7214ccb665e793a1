// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rows of rays found by values: a ball, and what is refused.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "distance/rays/value_rays.h"

namespace findspace::distance {
namespace distance_value_rays {

using exact::Real;
using space::RealVector;

ValueRays rays(RayRule rule) { return {std::move(rule), {}, 10, 1, space::RayGrid{2, 1, 0, 0, 1, 1, 1, 1}}; }

TEST(ValueRays, FindTheEndsOfABall) {
  const auto row = rays([](const RealVector& p) {
                     const double d = std::sqrt(space::dot(p, p).to_double()) - 4;
                     return Between{d, d};
                   }).try_row(0);
  ASSERT_TRUE(row);
  EXPECT_EQ(space::sign_at(*row, 0, Real(0)), -1);
  EXPECT_EQ(space::sign_at(*row, 0, Real(5)), 1);
  EXPECT_EQ(space::sign_at(*row, 0, Real(-5)), 1);
}

TEST(ValueRays, RefuseWhereAValueIs) {
  const ValueRays all = rays([](const RealVector&) { return exact::Refusal("why"); });
  const auto row = all.try_row(0);
  ASSERT_FALSE(row);
  EXPECT_EQ(row.refusal().error.message(), "why");
  EXPECT_THROW(all.row(0), Error);
}

/// A function that is 0 on the whole line needs more values than the search has.
TEST(ValueRays, RefuseLongStretchesOfZeros) {
  EXPECT_FALSE(rays([](const RealVector&) { return Between{0, 0}; }).try_row(0));
}

}  // namespace distance_value_rays
}  // namespace findspace::distance
