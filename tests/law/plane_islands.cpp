// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets of many boundary_components, with holes, boundary_components in holes, points, chains, discs and walls that
// touch: what is near a window is the set itself there, and a sound complex. So are sets written side by side.
#include <gtest/gtest.h>

#include <random>

#include "../unit/plane_topology_sets.h"
#include "plane/build/build.h"
#include "plane/complex/extent.h"
#include "plane/complex/side_by_side.h"
#include "plane/query/boundary_components.h"
#include "plane/walk/unite.h"
#include "plane_invariants.h"

namespace findspace::plane {
namespace plane_islands {

std::vector<Region> random_parts(std::mt19937& random) {
  const auto pick = [&](int n) { return static_cast<std::int64_t>(random() % static_cast<unsigned>(n)); };
  std::vector<Region> parts;
  for (int k = 0; k < 14; ++k) {
    const std::int64_t x = 10 * pick(30), y = 10 * pick(30), w = 10 * (1 + pick(4));
    switch (pick(5)) {
      case 0:
        parts.push_back(box(x, y, x + w, y + 10));
        break;
      case 1:  // a frame with an island in its hole
        parts.push_back(box(x, y, x + 60, y + 60) - interior(box(x + 10, y + 10, x + 50, y + 50)) +
                        box(x + 20, y + 20, x + 30, y + 30));
        break;
      case 2:
        parts.push_back(disc(x, y, w));
        break;
      case 3:
        parts.push_back(point(x + 3, y + 3));
        break;
      default:
        parts.push_back(segment({x, y}, {x + w, y + 5}) + segment({x + w, y + 5}, {x + w, y + 20}));
    }
  }
  return parts;
}

std::vector<const Region*> pointers(const std::vector<Region>& parts) {
  std::vector<const Region*> all;
  for (const Region& p : parts) all.push_back(&p);
  return all;
}

Region random_set(std::mt19937& random) {
  const std::vector<Region> parts = random_parts(random);
  return unite(pointers(parts));
}

TEST(SideBySide, IsTheUnion) {
  std::mt19937 random(11);
  std::size_t several = 0, together = 0;
  for (int k = 0; k < 150; ++k) {
    const std::vector<Region> parts = random_parts(random);
    const std::vector<const Region*> all = pointers(parts);
    std::vector<Region> united;
    std::vector<PieceBox> boxes;
    for (const Region& part : parts) boxes.push_back(*extent(part));
    const IndexGroups groups = groups_apart(boxes);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::span<const Index> group = groups[g];
      std::vector<const Region*> members;
      for (const Index i : group) members.push_back(all[i]);
      united.push_back(unite(members));
      together += group.size() > 1;
    }
    several += united.size() > 1;
    const Region joined = side_by_side(pointers(united)), whole = unite(all);
    EXPECT_EQ(fault(joined), "");
    EXPECT_TRUE(same_set(joined, whole)) << k;
    EXPECT_EQ(joined.edges.size(), whole.edges.size());
    EXPECT_EQ(joined.vertices.size(), whole.vertices.size());
  }
  EXPECT_GT(several, 100u);
  EXPECT_GT(together, 100u);
}

ShapePtr shape_of(Shape::Kind kind, std::vector<ShapePtr> children) {
  Shape shape;
  shape.kind = kind;
  shape.children = std::move(children);
  return std::make_shared<const Shape>(std::move(shape));
}

/// A box with a square hole, a box, a disc or, now and then, the empty set or the outside of a disc.
ShapePtr random_operand(std::mt19937& random, bool unbounded) {
  const auto pick = [&](int n) { return static_cast<std::int64_t>(random() % static_cast<unsigned>(n)); };
  const std::int64_t x = 20 * pick(30), y = 20 * pick(30), w = 12 + pick(12);
  Shape shape;
  shape.kind = Shape::Kind::kDisc;
  shape.points = {{x, y}};
  shape.amount = exact::Real(w);
  if (unbounded || pick(20) == 0) {
    const auto disc = std::make_shared<const Shape>(std::move(shape));
    const ShapePtr outside = shape_of(Shape::Kind::kComplement, {disc});
    return unbounded ? outside : shape_of(Shape::Kind::kIntersection, {disc, outside});
  }
  if (pick(3) == 0) return std::make_shared<const Shape>(std::move(shape));
  shape.kind = Shape::Kind::kRings;
  shape.contours = {{{{x, y}}, {{x + w, y}}, {{x + w, y + w}}, {{x, y + w}}}};
  if (pick(2) == 0) shape.contours.push_back({{{x + 4, y + 4}}, {{x + 4, y + 8}}, {{x + 8, y + 8}}, {{x + 8, y + 4}}});
  return std::make_shared<const Shape>(std::move(shape));
}

TEST(SideBySide, UnionsOfShapesAreTheUnion) {
  std::mt19937 random(12);
  std::size_t apart = 0;
  for (int k = 0; k < 60; ++k) {
    std::vector<ShapePtr> operands;
    for (int i = 0; i < 60; ++i) operands.push_back(random_operand(random, k % 10 == 0 && i == 7));
    std::vector<Region> parts;
    for (const ShapePtr& operand : operands) parts.push_back(build(*operand, 1.0).region);
    const Region whole = unite(pointers(parts)), made = build(*shape_of(Shape::Kind::kUnion, operands), 1.0).region;
    EXPECT_EQ(fault(made), "");
    EXPECT_TRUE(same_set(made, whole)) << k;
    EXPECT_EQ(made.edges.size(), whole.edges.size());
    EXPECT_EQ(made.vertices.size(), whole.vertices.size());
    apart += made.faces.size() > 20;
  }
  EXPECT_GT(apart, 40u);
}

TEST(BoundaryComponents, NearIsTheSetThere) {
  std::mt19937 random(7);
  std::size_t left_out = 0, several = 0;
  for (int k = 0; k < 150; ++k) {
    const Region set = random_set(random);
    const BoundaryComponents boundary_components(set);
    several += boundary_components.size() > 3;
    const auto x = static_cast<std::int64_t>(random() % 300), y = static_cast<std::int64_t>(random() % 300);
    const PieceBox window{double(x), double(y), double(x + 50), double(y + 40)};
    const Region there = box(x, y, x + 50, y + 40), near = boundary_components.near(set, window),
                 part = within(near, window);
    EXPECT_EQ(fault(near), "");
    EXPECT_EQ(fault(part), "");
    EXPECT_TRUE(same_set(near & there, set & there)) << k;
    EXPECT_TRUE(same_set(part & there, set & there)) << k;
    EXPECT_TRUE(is_empty(part - set)) << k;
    left_out += near.edges.size() < set.edges.size();
  }
  EXPECT_GT(left_out, 100u);
  EXPECT_GT(several, 100u);
}

TEST(BoundaryComponents, AllOfThemAreTheWholeSet) {
  std::mt19937 random(8);
  for (int k = 0; k < 50; ++k) {
    const Region set = random_set(random), all = BoundaryComponents(set).near(set, *extent(set));
    EXPECT_EQ(all.edges.size(), set.edges.size());
    EXPECT_EQ(all.vertices.size(), set.vertices.size());
    EXPECT_TRUE(same_set(all, set)) << k;
  }
}

TEST(BoundaryComponents, OfNothingAreNone) { EXPECT_EQ(BoundaryComponents(CellComplex::uniform(0)).size(), 0u); }

}  // namespace plane_islands
}  // namespace findspace::plane
