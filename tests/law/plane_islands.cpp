// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets of many boundary_components, with holes, boundary_components in holes, points, chains, discs and walls that
// touch: what is near a window is the set itself there, and a sound complex. So are sets written side by side.
#include <gtest/gtest.h>

#include <random>

#include "../unit/plane_topology_sets.h"
#include "plane/complex/extent.h"
#include "plane/complex/side_by_side.h"
#include "plane/query/boundary_components.h"
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
    for (const std::vector<Index>& group : groups_apart(all)) {
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

TEST(SideBySide, WhatIsNotBoundedIsTogetherWithAll) {
  const std::vector<Region> parts{box(0, 0, 10, 10), complement(box(-50, -50, 50, 50)), box(20, 20, 30, 30)};
  EXPECT_EQ(groups_apart(pointers(parts)).size(), 1u);
  const std::vector<Region> empty{box(0, 0, 10, 10), Region::uniform(0)};
  EXPECT_EQ(groups_apart(pointers(empty)).size(), 1u);
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
