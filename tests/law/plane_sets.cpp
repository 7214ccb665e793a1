// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The laws of set algebra and of the topological operators on random plain sets: De Morgan, absorption, duality, the
// rewritings of distances.md 8.2; and membership of single points against the definition of every node.
#include <gtest/gtest.h>

#include "law/plane_random.h"
#include "plane/query/locate.h"
#include "plane/sum/minkowski.h"

namespace findspace::plane {
namespace plane_sets {

using Kind = Shape::Kind;
using exact::Real;

constexpr std::uint64_t kRounds = 400;

ShapePtr both(const ShapePtr& a, const ShapePtr& b) { return node(Kind::kIntersection, {a, b}); }
ShapePtr either(const ShapePtr& a, const ShapePtr& b) { return node(Kind::kUnion, {a, b}); }
ShapePtr without(const ShapePtr& a, const ShapePtr& b) { return node(Kind::kDifference, {a, b}); }
ShapePtr no(const ShapePtr& a) { return node(Kind::kComplement, {a}); }
ShapePtr inner(const ShapePtr& a) { return node(Kind::kInterior, {a}); }
ShapePtr closed(const ShapePtr& a) { return node(Kind::kClosure, {a}); }

void expect_same(const ShapePtr& left, const ShapePtr& right, const char* law) {
  Region a = region_of(left), b = region_of(right);
  ASSERT_EQ(fault(a), "") << law << "\n" << show(*left);
  ASSERT_EQ(fault(b), "") << law << "\n" << show(*right);
  ASSERT_TRUE(same_set(a, b)) << law << "\n" << show(*left) << "\n" << show(*right);
  ASSERT_TRUE(same_counts(a, b)) << law << ": not minimal\n" << show(*left) << "\n" << show(*right);
}

class SetLaws : public ::testing::Test {
 protected:
  template <class Check>
  void rounds(const Variety& variety, Check check) {
    for (std::uint64_t seed = 1; seed <= kRounds; ++seed) {
      SCOPED_TRACE(fmt::format("seed {}", seed));
      Random random(seed);
      ShapePtr a = random_shape(random, variety), b = random_shape(random, variety), c = random_shape(random, variety);
      check(a, b, c);
      if (HasFatalFailure()) return;
    }
  }
};

void check_algebra(const ShapePtr& a, const ShapePtr& b, const ShapePtr& c) {
  expect_same(no(either(a, b)), both(no(a), no(b)), "De Morgan");
  expect_same(no(node(Kind::kIntersection, {a, b, c})), node(Kind::kUnion, {no(a), no(b), no(c)}),
              "De Morgan for three");
  expect_same(either(a, a), a, "idempotence");
  expect_same(both(a, either(a, b)), a, "absorption");
  expect_same(either(a, both(a, b)), a, "absorption");
  expect_same(no(no(a)), a, "complement twice");
  expect_same(without(a, b), both(a, no(b)), "difference");
  expect_same(either(without(a, b), both(a, b)), a, "parts");
  expect_same(both(a, either(b, c)), either(both(a, b), both(a, c)), "distributivity");
  expect_same(node(Kind::kDifference, {a, b, c}), without(a, either(b, c)), "difference of several");
}

TEST_F(SetLaws, AlgebraOfLatticePolygons) { rounds({.size = 4, .flat = false, .arcs = false}, check_algebra); }
TEST_F(SetLaws, AlgebraOfPlainSets) { rounds({}, check_algebra); }

void check_topology(const ShapePtr& a, const ShapePtr& b, const ShapePtr&) {
  expect_same(closed(no(a)), no(inner(a)), "closure of the complement");
  expect_same(inner(no(a)), no(closed(a)), "interior of the complement");
  expect_same(closed(either(a, b)), either(closed(a), closed(b)), "closure of a union");
  expect_same(inner(both(a, b)), both(inner(a), inner(b)), "interior of an intersection");
  expect_same(closed(closed(a)), closed(a), "closure twice");
  expect_same(inner(inner(a)), inner(a), "interior twice");
  expect_same(node(Kind::kBoundary, {a}), without(closed(a), inner(a)), "boundary");
  expect_same(node(Kind::kBoundary, {a}), node(Kind::kBoundary, {no(a)}), "boundary of the complement");
  expect_same(node(Kind::kRegularize, {a}), closed(inner(a)), "regularize");
  Region x = region_of(a), y = region_of(b);
  std::vector<const Region*> pair{&x, &y};
  ASSERT_TRUE(
      is_subset(closure(intersect(pair)), intersect(std::vector<const Region*>{&(x = closure(x)), &(y = closure(y))})));
}

TEST_F(SetLaws, TopologyOfLatticePolygons) { rounds({.size = 4, .flat = false, .arcs = false}, check_topology); }
TEST_F(SetLaws, TopologyOfPlainSets) { rounds({}, check_topology); }

void check_motions(const ShapePtr& a, const ShapePtr& b, const ShapePtr&) {
  ShapePtr set = without(a, b);
  auto mirror = [](const ShapePtr& s) { return node(Kind::kMirror, {s}); };
  GridPoint by{5, -3};
  expect_same(mirror(mirror(set)), set, "mirror twice");
  expect_same(without(mirror(a), mirror(b)), mirror(set), "mirror of a difference");
  expect_same(translate_of(translate_of(set, by), {-5, 3}), set, "there and back");
  expect_same(without(translate_of(a, by), translate_of(b, by)), translate_of(set, by), "translate of a difference");
  expect_same(inner(translate_of(a, by)), translate_of(inner(a), by), "translate of an interior");
  expect_same(translate_of(mirror(set), by), mirror(translate_of(set, {-5, 3})), "mirror and translate");
}

void check_quarter_rotations(const ShapePtr& a, const ShapePtr& b, const ShapePtr&) {
  ShapePtr set = without(a, b);
  auto rotation = [](const ShapePtr& s, int degrees) { return rotate_of(s, {1, -2}, degrees); };
  expect_same(rotation(rotation(set, 90), 270), set, "a full turn");
  expect_same(rotation(rotation(set, -450), 90), set, "a full turn");
  expect_same(rotation(rotation(set, 90), 90), rotation(set, 180), "a half turn");
  expect_same(without(rotation(a, 90), rotation(b, 90)), rotation(set, 90), "turn of a difference");
  expect_same(rotation(set, 180), translate_of(node(Kind::kMirror, {set}), {2, -4}), "half turn and reflection");
  expect_same(rotate_of(set, {3, 4}, 90), translate_of(rotate_of(set, {}, 90), {7, 1}), "another centre");
}

TEST_F(SetLaws, Motions) { rounds({}, check_motions); }
TEST_F(SetLaws, QuarterRotations) { rounds({}, check_quarter_rotations); }

/// Is p in the closed polygon?
bool in_ring(const Contour& ring, const exact::RealPoint& p) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    GridPoint a = ring[k].start, b = ring[k + 1 == ring.size() ? 0 : k + 1].start;
    Real ax = Real(a.x) - p.x, ay = Real(a.y) - p.y, bx = Real(b.x) - p.x, by = Real(b.y) - p.y;
    int side = (ax * by - ay * bx).sign();
    if (side == 0 && (ax * bx + ay * by).sign() <= 0) return true;
    bool up = ay.sign() <= 0 && by.sign() > 0, down = ay.sign() > 0 && by.sign() <= 0;
    if ((up && side > 0) || (down && side < 0)) inside = !inside;
  }
  return inside;
}

bool in_chain(const Contour& chain, const exact::RealPoint& p) {
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    GridPoint a = chain[k].start, b = chain[k + 1].start;
    Real ax = Real(a.x) - p.x, ay = Real(a.y) - p.y, bx = Real(b.x) - p.x, by = Real(b.y) - p.y;
    if ((ax * by - ay * bx).sign() == 0 && (ax * bx + ay * by).sign() <= 0) return true;
  }
  return false;
}

/// Membership by definition, for leaves and Boolean nodes.
bool holds(const Shape& s, const exact::RealPoint& p) {
  auto child = [&](const ShapePtr& c) { return holds(*c, p); };
  switch (s.kind) {
    case Kind::kRings:
      return in_ring(s.contours[0], p);
    case Kind::kPolyline:
      return in_chain(s.contours[0], p);
    case Kind::kPoints:
      return std::any_of(s.points.begin(), s.points.end(),
                         [&](GridPoint q) { return p.x == Real(q.x) && p.y == Real(q.y); });
    case Kind::kDisc: {
      Real dx = p.x - Real(s.points[0].x), dy = p.y - Real(s.points[0].y);
      return dx * dx + dy * dy <= s.amount * s.amount;
    }
    case Kind::kUnion:
      return std::any_of(s.children.begin(), s.children.end(), child);
    case Kind::kIntersection:
      return std::all_of(s.children.begin(), s.children.end(), child);
    case Kind::kDifference:
      return child(s.children[0]) && std::none_of(s.children.begin() + 1, s.children.end(), child);
    default:
      return !child(s.children[0]);
  }
}

ShapePtr random_tree(Random& random, const Variety& variety, int depth) {
  if (depth == 0) return random_leaf(random, variety);
  Kind kind = std::array{Kind::kUnion, Kind::kIntersection, Kind::kDifference, Kind::kComplement}[random.pick(0, 3)];
  std::vector<ShapePtr> children;
  for (std::int64_t k = kind == Kind::kComplement ? 1 : random.pick(2, 3); k > 0; --k)
    children.push_back(random_tree(random, variety, depth - 1));
  return node(kind, children);
}

void expect_members(const ShapePtr& shape, std::int64_t size) {
  Region region = region_of(shape);
  ASSERT_EQ(fault(region), "") << show(*shape);
  Locator locator(region);
  auto check = [&](const exact::RealPoint& p) {
    ASSERT_EQ(locator.mark(p) > 0, holds(*shape, p)) << p.x.text() << " " << p.y.text() << "\n" << show(*shape);
  };
  for (std::int64_t x = -4; x <= 2 * size + 4; ++x)
    for (std::int64_t y = -4; y <= 2 * size + 4; ++y) {
      check({Real::ratio(x, 2), Real::ratio(y, 2)});
      if (::testing::Test::HasFatalFailure()) return;
    }
  for (Index v = 0; v < region.vertices.size(); ++v) {
    exact::RealPoint p = region.geometry.exact(region.vertices[v].point);
    Real nudge = Real::ratio(1, 1 << 20);
    check(p);
    check({p.x + nudge, p.y});
    check({p.x, p.y - nudge});
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(SetMembers, LatticePolygons) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    expect_members(random_tree(random, {.size = 4, .flat = false, .arcs = false, .plain = false}, 2), 4);
    if (HasFatalFailure()) return;
  }
}

TEST(SetMembers, ClosedSetsOfAllKinds) {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Random random(seed);
    expect_members(random_tree(random, {.plain = false}, 2), 6);
    if (HasFatalFailure()) return;
  }
}

}  // namespace plane_sets
}  // namespace findspace::plane
