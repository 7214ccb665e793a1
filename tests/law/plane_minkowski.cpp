// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The identities of distances.md 2.1 and 2.2 on random open and closed sets, and every lattice position against the
// definition: p is in a (+) b where a meets p - b, which an overlay decides without any convolution.
#include <gtest/gtest.h>

#include "law/plane_random.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/locate.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace plane_minkowski {

using Kind = Shape::Kind;
using exact::Real;

const Variety kPolygons{.size = 3, .flat = false, .arcs = false, .plain = false};
const Variety kFlat{.size = 3, .flat = true, .arcs = false, .plain = false};
const Variety kArcs{.size = 3, .flat = true, .arcs = true, .plain = false};

/// A union of leaves, closed or open.
struct Operand {
  Region set;
  std::string text;
};

Operand draw(Random& random, const Variety& variety, bool may_be_open) {
  ShapePtr shape = random_shape(random, variety);
  if (may_be_open && random.pick(0, 2) == 0) shape = node(Kind::kInterior, {shape});
  return {region_of(shape), show(*shape)};
}

Region unite(const Region& a, const Region& b) { return plane::unite(std::vector<const Region*>{&a, &b}); }
Region intersect(const Region& a, const Region& b) { return plane::intersect(std::vector<const Region*>{&a, &b}); }
Region subtract(const Region& a, const Region& b) { return plane::subtract(std::vector<const Region*>{&a, &b}); }

void expect_same(const Region& a, const Region& b, const char* law) {
  ASSERT_EQ(fault(a), "") << law;
  ASSERT_EQ(fault(b), "") << law;
  ASSERT_TRUE(same_set(a, b)) << law;
  ASSERT_TRUE(same_counts(a, b)) << law << ": not minimal";
}

template <class Check>
void rounds(std::uint64_t count, const Variety& variety, bool may_be_open, Check check) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Random random(seed);
    Operand a = draw(random, variety, may_be_open), b = draw(random, variety, may_be_open);
    Operand c = draw(random, variety, may_be_open);
    SCOPED_TRACE(fmt::format("seed {}\na {}\nb {}\nc {}", seed, a.text, b.text, c.text));
    check(a.set, b.set, c.set);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

void check_sums(const Region& a, const Region& b, const Region& c) {
  Region ab = plain_sum(a, b);
  expect_same(ab, plain_sum(b, a), "a: commutativity");
  expect_same(plain_sum(ab, c), plain_sum(a, plain_sum(b, c)), "a: associativity");
  expect_same(mirrored(plain_sum(a, mirrored(b))), plain_sum(b, mirrored(a)), "e: role exchange");
  expect_same(plain_sum(translated(a, {2, -1}), b), translated(ab, {2, -1}), "f: translation");
  if (is_open(a) == is_open(b))
    expect_same(plain_sum(unite(a, b), c), unite(plain_sum(a, c), plain_sum(b, c)), "b: union");
  ASSERT_TRUE(is_subset(plain_sum(intersect(a, b), interior(c)),
                        intersect(plain_sum(a, interior(c)), plain_sum(b, interior(c)))));
}

void check_differences(const Region& a, const Region& b, const Region& c) {
  Region ab = plain_difference(a, b);
  expect_same(plain_difference(ab, c), plain_difference(a, plain_sum(b, c)), "a: two erosions");
  expect_same(plain_difference(translated(a, {2, -1}), b), translated(ab, {2, -1}), "f: translation");
  expect_same(mirrored(plain_difference(mirrored(b), a)), plain_difference(b, mirrored(a)), "e: role exchange");
  if (is_open(b) == is_open(c))
    expect_same(plain_difference(a, unite(b, c)), intersect(ab, plain_difference(a, c)), "c: union of the second");
  if (is_open(a) == is_open(b))
    expect_same(plain_difference(intersect(a, b), c), intersect(plain_difference(a, c), plain_difference(b, c)),
                "c: intersection of the first");
  ASSERT_TRUE(is_subset(plain_sum(ab, mirrored(b)), a)) << "d: opening";
  ASSERT_TRUE(is_subset(a, plain_difference(plain_sum(a, b), mirrored(b)))) << "d: closing";
}

/// Sums and differences of sets that need be neither open nor closed, at all lattice positions.
void check_plain(const Region& a, const Region& b, const Region& c) {
  constexpr std::int64_t kReach = 6;
  Region sum = plain_sum(a, b), difference = plain_difference(a, b), back = mirrored(b);
  ASSERT_EQ(fault(sum), "");
  ASSERT_EQ(fault(difference), "");
  Locator in_sum(sum), in_difference(difference);
  for (std::int64_t x = -kReach; x <= kReach; ++x)
    for (std::int64_t y = -kReach; y <= kReach; ++y) {
      exact::RealPoint p{Real(x), Real(y)};
      Region there = translated(back, {x, y});
      ASSERT_EQ(in_sum.mark(p) > 0, !is_empty(intersect(a, there))) << "sum" << fmt::format(" at {} {}", x, y);
      ASSERT_EQ(in_difference.mark(p) > 0, is_subset(there, a)) << "difference" << fmt::format(" at {} {}", x, y);
    }
  expect_same(sum, plain_sum(b, a), "a: commutativity");
  expect_same(plain_sum(sum, c), plain_sum(a, plain_sum(b, c)), "a: associativity");
  expect_same(plain_sum(unite(a, b), c), unite(plain_sum(a, c), plain_sum(b, c)), "b: union");
  ASSERT_TRUE(is_subset(plain_sum(difference, mirrored(b)), a)) << "d: opening";
  ASSERT_TRUE(is_subset(a, plain_difference(sum, mirrored(b)))) << "d: closing";
}

TEST(MinkowskiLaws, PlainPolygons) {
  rounds(60, {.size = 3, .flat = false, .arcs = false, .plain = true}, false, check_plain);
}
TEST(MinkowskiLaws, PlainFlatSets) {
  rounds(40, {.size = 3, .flat = true, .arcs = false, .plain = true}, false, check_plain);
}
TEST(MinkowskiLaws, PlainArcs) {
  rounds(15, {.size = 3, .flat = true, .arcs = true, .plain = true}, false, check_plain);
}

TEST(MinkowskiLaws, SumsOfPolygons) { rounds(150, kPolygons, true, check_sums); }
TEST(MinkowskiLaws, SumsOfFlatSets) { rounds(150, kFlat, true, check_sums); }
TEST(MinkowskiLaws, SumsOfArcs) { rounds(40, kArcs, true, check_sums); }
TEST(MinkowskiLaws, DifferencesOfPolygons) { rounds(150, kPolygons, false, check_differences); }
TEST(MinkowskiLaws, DifferencesOfFlatSets) { rounds(150, kFlat, false, check_differences); }
TEST(MinkowskiLaws, DifferencesOfArcs) { rounds(40, kArcs, false, check_differences); }

/// distances.md 2.2, for regular closed sets.
void check_regular(const Region& x, const Region& y, const Region&) {
  Region a = regularize(x), b = regularize(y), ia = interior(a), ib = interior(b);
  Region open = plain_sum(ia, ib), sum = plain_sum(a, b), difference = plain_difference(a, b);
  ASSERT_TRUE(is_regular(sum));
  expect_same(plain_sum(a, ib), open, "2.2 b");
  expect_same(plain_sum(ia, b), open, "2.2 b");
  expect_same(closure(open), sum, "2.2 b: closure");
  expect_same(plain_difference(a, ib), difference, "2.2 c");
  expect_same(plain_difference(ia, ib), difference, "2.2 c");
  expect_same(plain_difference(ia, b), interior(difference), "2.2 c: interior");
  expect_same(boundary(difference), boundary(plain_sum(complement(a), ib)), "2.2 e");
  ASSERT_TRUE(is_subset(boundary(sum), boundary(open))) << "2.2 d";
}

TEST(MinkowskiLaws, RegularPolygons) { rounds(150, kPolygons, false, check_regular); }
TEST(MinkowskiLaws, RegularArcs) {
  rounds(40, {.size = 3, .flat = false, .arcs = true, .plain = false}, false, check_regular);
}

/// distances.md 2.1 h: free positions. The region is open, so that what is left of it is.
void check_free(const Region& r, const Region& a, const Region& b) {
  Region room = interior(r);
  expect_same(plain_difference(subtract(room, a), mirrored(b)),
              subtract(plain_difference(room, mirrored(b)), plain_sum(a, mirrored(b))), "h: free positions");
}

TEST(MinkowskiLaws, FreePositions) { rounds(150, kFlat, false, check_free); }

bool meets(const Region& a, const Region& b) { return !is_empty(intersect(a, b)); }

/// Sum, difference and the two maps at all lattice positions.
void check_positions(const Region& a, const Region& b, std::int64_t reach) {
  Region sum = plain_sum(a, b), difference = plain_difference(a, b);
  SignMap contact = contact_map(a, b), containment = containment_map(a, b);
  ASSERT_EQ(fault(contact), "");
  ASSERT_EQ(fault(containment), "");
  Locator in_sum(sum), in_difference(difference), in_contact(contact), in_containment(containment);
  Region back = mirrored(b), inner_a = interior(a), inner_b = interior(b);
  for (std::int64_t x = -reach; x <= reach; ++x)
    for (std::int64_t y = -reach; y <= reach; ++y) {
      exact::RealPoint p{Real(x), Real(y)};
      std::string where = fmt::format(" at {} {}", x, y);
      Region there = translated(back, {x, y}), b_there = translated(b, {x, y}), b_inner = translated(inner_b, {x, y});
      ASSERT_EQ(in_sum.mark(p) > 0, meets(a, there)) << "sum" << where;
      ASSERT_EQ(in_difference.mark(p) > 0, is_subset(there, a)) << "difference" << where;
      int touch = meets(inner_a, b_there) || meets(a, b_inner) ? -1 : meets(a, b_there) ? 0 : 1;
      ASSERT_EQ(in_contact.mark(p), touch) << "contact" << where;
      int held = is_subset(b_there, inner_a) ? -1 : is_subset(b_there, a) ? 0 : 1;
      ASSERT_EQ(in_containment.mark(p), held) << "containment" << where;
    }
}

TEST(MinkowskiPositions, Polygons) {
  rounds(30, kPolygons, false, [](const Region& a, const Region& b, const Region&) { check_positions(a, b, 6); });
}
TEST(MinkowskiPositions, FlatSets) {
  rounds(40, kFlat, false, [](const Region& a, const Region& b, const Region&) { check_positions(a, b, 6); });
}
TEST(MinkowskiPositions, Arcs) {
  rounds(20, kArcs, false, [](const Region& a, const Region& b, const Region&) { check_positions(a, b, 6); });
}
TEST(MinkowskiPositions, UnboundedFirst) {
  rounds(30, kFlat, false,
         [](const Region& a, const Region& b, const Region&) { check_positions(closure(complement(a)), b, 6); });
}

}  // namespace plane_minkowski
}  // namespace findspace::plane
