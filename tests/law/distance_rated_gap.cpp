// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The bounds of a gap whose shapes turn, against the gap of the turned shapes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "distance/rotation/rated_gap.h"
#include "distance/rotation/rotation_motion.h"
#include "law/distance_random.h"
#include "plane/build/transform.h"
#include "plane/query/scaled.h"

namespace findspace::distance {
namespace distance_rated_gap {

TEST(RatedGap, BoundsHoldForShapesThatTurnALittle) {
  constexpr std::int64_t kUnit = 100000;  // grid steps
  int decided = 0, asked = 0, deep = 0;
  for (unsigned seed = 1; seed <= 120; ++seed) {
    Shapes random(seed);
    const Region b = plane::scaled(random.shape(), kUnit), a = plane::scaled(random.shape(), kUnit);
    const int b_turn = int(random.number(-2, 2)), a_turn = int(random.number(-2, 2));
    plane::Rounding rounding;
    const ShapePair pair(b, a), turned(plane::rotated(b, {0, 0}, Real(b_turn), 1, rounding),
                                       plane::rotated(a, {0, 0}, Real(a_turn), 1, rounding));
    const double moved = (std::abs(b_turn) * reach(b) + std::abs(a_turn) * reach(a)) * std::numbers::pi / 180;
    const Real off(std::int64_t(std::ceil(moved + 4 * rounding.largest)) + 1);
    const RatedGap gap(pair, is_convex(b) && is_convex(a));
    const TDistancePointer truth = turned.distance(Which::kGamma1), before = pair.distance(Which::kGamma1);
    for (const int level : {-2, -1, 0, 1}) {
      const Real steps(level * kUnit);
      const plane::SignMap low = gap.lower(steps, off), high = gap.upper(steps, off), exact = truth->sign_map(steps);
      for (int k = 0; k < 12; ++k) {
        const RealPoint q = random.position(), p{Real(kUnit) * q.x, Real(kUnit) * q.y};
        const int under = sign_at(low, p), sign = sign_at(exact, p), over = sign_at(high, p);
        ASSERT_LE(under, sign) << "seed " << seed << " level " << level << " position " << k;
        ASSERT_GE(over, sign) << "seed " << seed << " level " << level << " position " << k;
        ++asked;
        decided += under == over;
        const double g = before->value(p)->value.to_double();
        if (g >= 0) continue;
        ++deep;
        const double v = gap.value(p);
        ASSERT_GE(v, g - 1e-6) << "seed " << seed;
        ASSERT_LE(v, 0) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(decided, asked / 2);
  EXPECT_GT(deep, 40);
}

}  // namespace distance_rated_gap
}  // namespace findspace::distance
