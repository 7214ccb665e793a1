// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The vertex that the quick search takes for inside, located exactly: on random sets with arcs, holes and
// slots, at positions that put vertices above each other and on boundaries as often as not.

#include <gtest/gtest.h>

#include "distance/planar_features/common_corner.h"
#include "law/distance_random.h"
#include "plane/query/locate.h"

namespace findspace::distance {
namespace distance_common_corner {

TEST(CommonCorner, LiesInTheOtherShape) {
  Shapes random(31);
  int found = 0, meet = 0;
  for (int k = 0; k < 300; ++k) {
    const Region a = random.shape(), b = random.shape();
    const Boxed fixed(a), moving(b);
    for (int i = 0; i < 8; ++i) {
      const RealPoint p = random.position();
      const auto v = vertex_within(moving, fixed, p.x.to_double(), p.y.to_double());
      const ShapePair pair(b, a);
      const auto gap = i == 0 ? pair.distance(Which::kGamma1)->value(p) : std::nullopt;
      meet += gap && gap->value.sign() < 0;
      if (!v) continue;
      ++found;
      const RealPoint corner = b.geometry.exact(b.vertices[*v].point), at{corner.x + p.x, corner.y + p.y};
      EXPECT_GT(mark_of(a, locate(a, at)), 0) << "trial " << k << ", vertex " << *v;
      if (gap) {
        EXPECT_LE(gap->value.sign(), 0);
      }
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(meet, 30);
}

}  // namespace distance_common_corner
}  // namespace findspace::distance
