// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Laws of convex hulls: extensive, monotone, idempotent; hull(a u b) = hull(hull a u hull b); hulls of sums are sums of
// hulls (distances.md 2.3 a); what a hull adds lies between points of the set.
#include <gtest/gtest.h>

#include "findspace/error.h"
#include "law/plane_random.h"
#include "plane/build/hull.h"
#include "plane/offset/plain_sum.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace plane_hull {

using Kind = Shape::Kind;
using exact::Real;

Region unite(const Region& a, const Region& b) { return plane::unite(std::vector<const Region*>{&a, &b}); }

void expect_same(const Region& a, const Region& b, const char* law) {
  ASSERT_EQ(fault(a), "") << law;
  ASSERT_EQ(fault(b), "") << law;
  ASSERT_TRUE(same_set(a, b)) << law;
  ASSERT_TRUE(same_counts(a, b)) << law << ": not minimal";
}

/// Rounds in which every hull exists.
template <class Check>
void rounds(std::uint64_t count, const Variety& variety, Check check) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Random random(seed);
    ShapePtr a = random_shape(random, variety), b = random_shape(random, variety);
    SCOPED_TRACE(fmt::format("seed {}\na {}\nb {}", seed, show(*a), show(*b)));
    try {
      check(region_of(a), region_of(b));
    } catch (const Error& e) {
      ASSERT_EQ(e.code(), ErrorCode::kUnsupported);
      ++refused;
    }
    if (::testing::Test::HasFatalFailure()) return;
  }
  ASSERT_LT(std::uint64_t(refused), count);
}

void check_hulls(const Region& a, const Region& b) {
  if (is_empty(a) || is_empty(b)) return;
  Region h = hull(a), k = hull(b);
  ASSERT_TRUE(is_subset(a, h));
  expect_same(hull(h), h, "idempotence");
  ASSERT_EQ(is_open(a), is_open(a) && is_open(h));
  ASSERT_EQ(is_closed(a), is_closed(a) && is_closed(h));
  expect_same(hull(unite(a, b)), hull(unite(h, k)), "hull of a union");
  expect_same(hull(closure(a)), closure(h), "hull of the closure");
  expect_same(hull(translated(a, {3, -5})), translated(h, {3, -5}), "translation");
  Rounding rounding;
  expect_same(hull(rotated(a, {}, 90, 1, rounding)), rotated(h, {}, 90, 1, rounding), "quarter turn");
}

void check_sums(const Region& a, const Region& b) {
  expect_same(hull(plain_sum(a, b)), plain_sum(hull(a), hull(b)), "hull of a sum");
}

TEST(HullLaws, Polygons) { rounds(300, {.flat = false, .arcs = false}, check_hulls); }
TEST(HullLaws, PlainSets) { rounds(300, {.arcs = false}, check_hulls); }
TEST(HullLaws, Arcs) { rounds(300, {.size = 4}, check_hulls); }
TEST(HullLaws, SumsOfPolygons) { rounds(150, {.size = 3, .flat = true, .arcs = false}, check_sums); }

/// Discs of one radius about random points: the hull of the points, grown.
TEST(HullLaws, EqualDiscs) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    Real r = random.pick(0, 1) ? Real(random.pick(1, 4)) : sqrt(Real(random.pick(2, 7)));
    std::vector<GridPoint> centers;
    std::vector<ShapePtr> discs;
    for (std::int64_t k = random.pick(1, 6); k > 0; --k) {
      centers.push_back(random.point(4));
      discs.push_back(disc_of(centers.back(), r));
    }
    bool open = random.pick(0, 1) == 1;
    Region points = hull(region_of(points_of(centers))), all = region_of(node(Kind::kUnion, discs));
    Region disc = region_of(disc_of({}, r));
    SCOPED_TRACE(fmt::format("seed {} {}", seed, show(*points_of(centers))));
    expect_same(hull(open ? interior(all) : all), plain_sum(points, open ? interior(disc) : disc), "equal discs");
    if (HasFatalFailure()) return;
  }
}

}  // namespace plane_hull
}  // namespace findspace::plane
