// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes made of few circles and boxes, so that those of one and of both shapes coincide: equal circles, concentric
// ones, rings, unions of unions, and positions that bring arcs onto each other. The value at a position, found from the
// boundaries or by search, and the sign maps, made from sums of whole sets, are decided by different means; they agree.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "distance/planar/at_position.h"
#include "distance/planar_least/extremum.h"
#include "distance_random.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

namespace findspace::distance {
namespace distance_coincident {

class Circles {
 public:
  explicit Circles(unsigned seed) : random_(seed) {}

  std::int64_t number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  RealPoint position() { return {Real::ratio(number(-8, 8), 2), Real::ratio(number(-8, 8), 2)}; }

  Region part() {
    const std::int64_t x = 2 * number(-1, 1), y = number(-1, 1);
    if (number(0, 3) == 0) return box(x - 2, y - 2, x + 2, y + 2);
    return plane::region_of_disc(x, y, number(1, 3));
  }

  /// A union, intersection or difference of two of them, closed and not empty.
  Region shape(int depth = 2) {
    for (;;) {
      const Region a = depth == 0 ? part() : shape(depth - 1), b = part();
      const std::array<const Region*, 2> both{&a, &b};
      const auto kind = number(0, 4);
      Region out = kind == 0 ? plane::intersect(both) : kind == 1 ? plane::subtract(both) : plane::unite(both);
      out = plane::closure(std::move(out));
      if (!plane::is_empty(out)) return out;
    }
  }

 private:
  std::mt19937 random_;
};

TEST(CoincidentCircles, ValuesAgreeWithSignMaps) {
  Circles random(71);
  int touching = 0;
  for (int k = 0; k < 36; ++k) {
    const auto pair = std::make_shared<ShapePair>(random.shape(int(random.number(0, 2))), random.shape(1));
    const AtPosition at(pair);
    const RealPoint p = random.position();
    for (const Which w : kAll) {
      SCOPED_TRACE(::testing::Message() << "case " << k << " distance " << int(w));
      const auto m = at.measure(w, p);
      const auto f = pair->distance(w);
      ASSERT_EQ(m.has_value(), f->defined());
      if (!m || m->minus_infinity) continue;
      const double value = m->value.to_double();
      // An exact 0 is 0 in the map; any value lies between levels just beside it.
      EXPECT_EQ(sign_at(f->sign_map(Real::from_double(value - 1e-9)), p), 1);
      EXPECT_EQ(sign_at(f->sign_map(Real::from_double(value + 1e-9)), p), -1);
      if (w <= Which::kDelta2 && m->value.is_rational()) {
        EXPECT_EQ(sign_at(f->sign_map(m->value), p), 0);
      }
      touching += w <= Which::kDelta2 && m->value.sign() == 0;
      const auto v = f->value(p);
      ASSERT_TRUE(v.has_value());
      EXPECT_NEAR(v->value.to_double(), value, 1e-12);
    }
  }
  EXPECT_GT(touching, 0);
}

TEST(CoincidentCircles, NoPositionIsBetterThanTheLeast) {
  Circles random(72);
  for (int k = 0; k < 3; ++k) {
    const auto pair = std::make_shared<ShapePair>(random.shape(1), random.shape(1));
    const AtPosition at(pair);
    for (const Which w : kAll) {
      SCOPED_TRACE(::testing::Message() << "case " << k << " distance " << int(w));
      const auto f = pair->distance(w);
      const Extremum e = least(*f);
      if (!e.exists() || e.unbounded) continue;
      for (int i = 0; i < 6; ++i) {
        EXPECT_GE(at.measure(w, random.position())->value.to_double(), e.answer->value.to_double() - 1e-11);
      }
      for (const auto& v : e.at.vertices) {
        if (v.mark > 0) {
          EXPECT_NEAR(at.measure(w, e.at.geometry.exact(v.point))->value.to_double(), e.answer->value.to_double(),
                      1e-11);
        }
      }
    }
  }
}

}  // namespace distance_coincident
}  // namespace findspace::distance
