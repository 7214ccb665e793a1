// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/nearest.h"
#include "plane/walk/unite.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_nearest {

using exact::Real;

/// Boxes and discs on a lattice, so that many places are equally far from several of them.
Region shapes(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Region> all;
  for (std::int64_t k = 0; k < 30; ++k) {
    const std::int64_t x = k % 6 * 20, y = k / 6 * 20;
    all.push_back(random() % 2 == 0 ? box(x, y, x + 8, y + 8) : disc(x + 4, y + 4, 4));
  }
  all.push_back(point(-9, -9));
  std::vector<const Region*> sets;
  for (const Region& r : all) sets.push_back(&r);
  return unite(sets);
}

bool same(const std::optional<Nearest>& p, const std::optional<Nearest>& q) {
  return p && q && p->distance == q->distance && p->at.x == q->at.x && p->at.y == q->at.y && p->cell == q->cell;
}

TEST(NearestSearch, SaysWhatALookAtEveryCellSays) {
  const auto any = [](Mark) { return true; };
  const auto in = [](Mark m) { return m > 0; };
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Region set = shapes(seed);
    const NearestSearch all(set, any), inside(set, in);
    for (std::int64_t x = -16; x <= 130; x += 5)
      for (std::int64_t y = -16; y <= 130; y += 7) {
        const exact::RealPoint p{Real(x), Real::ratio(y, 2)};
        EXPECT_TRUE(same(all.nearest(p), nearest(set, any, p))) << x << " " << y;
        EXPECT_TRUE(same(inside.nearest(p), nearest(set, in, p))) << x << " " << y;
      }
  }
}

TEST(NearestSearch, OfNothing) {
  const Region set = box(0, 0, 4, 4);
  EXPECT_FALSE(NearestSearch(set, [](Mark) { return false; }).nearest({Real(1), Real(1)}));
}

}  // namespace plane_nearest
}  // namespace findspace::plane
