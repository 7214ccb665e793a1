// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <array>
#include <mutex>
#include <random>
#include <vector>

#include "plane/build/swept.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/offset/level.h"
#include "plane/query/in_batches.h"
#include "plane/query/locate.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_in_batches {

using exact::Real;

constexpr BatchSizes kSmall{.least = 8, .each = 12};

/// Boxes and rings about boxes at random, some of which touch.
Region boxes(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<Region> all;
  for (int k = 0; k < count; ++k) {
    const std::int64_t x = std::int64_t(random() % 60), y = std::int64_t(random() % 60),
                       a = 2 + std::int64_t(random() % 6);
    Region made = box(x, y, x + a, y + a);
    if (random() % 3 == 0) {
      const Region outer = box(x - 3, y - 3, x + a + 3, y + a + 3), hole = box(x - 1, y - 1, x + a + 1, y + a + 1);
      const std::array<const Region*, 2> ring{&outer, &hole};
      const Region around = subtract(ring);
      const std::array<const Region*, 2> both{&made, &around};
      made = unite(both);
    }
    all.push_back(std::move(made));
  }
  std::vector<const Region*> sets;
  for (const Region& r : all) sets.push_back(&r);
  return unite(sets);
}

bool same(const Region& a, const Region& b) {
  const std::array<const CellComplex*, 2> both{&a, &b};
  const CellComplex differs = overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
  return is_empty(differs);
}

TEST(InBatches, PartsAloneAreTheSet) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Region set = boxes(seed, 40);
    const auto made = made_in_batches(
        set, {0, 0, 0, 0}, [](const CellComplex& part) { return part; }, kSmall);
    ASSERT_TRUE(made);
    EXPECT_TRUE(same(*made, set)) << seed;
    EXPECT_EQ(made->faces.size(), set.faces.size());
    EXPECT_EQ(made->edges.size(), set.edges.size());
  }
}

TEST(InBatches, WhatLiesInAVoidOfOthersIsMadeWithThem) {
  const Region bars[] = {box(0, 0, 40, 4),   box(0, 5, 4, 40),    box(5, 36, 40, 40),
                         box(36, 5, 40, 35), box(18, 18, 22, 22), box(90, 0, 94, 4)};
  std::vector<const Region*> sets;
  for (const Region& bar : bars) sets.push_back(&bar);
  const Region set = unite(sets);
  const auto offset = [](const CellComplex& part) { return distance_map(part, Real(2)); };
  const auto made = made_in_batches(set, {-2, -2, 2, 2}, offset, kSmall);
  ASSERT_TRUE(made);
  EXPECT_TRUE(same(*made, offset(set)));
  EXPECT_EQ(made->faces[0].inner.size(), 2u);  // the frame and the box far off, not the one within the frame
}

TEST(InBatches, OffsetsAreThoseOfTheWhole) {
  int compared = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Region set = boxes(seed, 20);
    const auto offset = [](const CellComplex& part) { return distance_map(part, Real(2)); };
    const auto made = made_in_batches(set, {-2, -2, 2, 2}, offset, kSmall);
    if (!made) continue;  // all within reach of each other
    EXPECT_TRUE(same(*made, offset(set))) << seed;
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST(InBatches, SumsAreThoseOfTheWhole) {
  int compared = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Region set = boxes(seed, 25), b = box(-1, -2, 1, 0);
    const auto sum = [&](const CellComplex& part) { return contact_map(part, b); };
    // The contacts of B's box (-1, -2) to (1, 0) reach from -1 to 1 and from 0 to 2.
    const auto made = made_in_batches(set, {-1, 0, 1, 2}, sum, kSmall);
    if (!made) continue;
    EXPECT_TRUE(same(*made, sum(set))) << seed;
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

/// Of sets that nothing bounds: what a box leaves, and what a box in pieces leaves.
TEST(InBatches, ContainmentsAreThoseOfTheWhole) {
  const Region pieces[] = {box(-1, 0, 0, 1), box(1, 0, 2, 1)};
  const std::array<const Region*, 2> two{&pieces[0], &pieces[1]};
  int compared = 0;
  for (const Region& b : {box(-1, 0, 2, 1), unite(two)})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const Region set = boxes(seed, 25);
      const auto left = [&](const CellComplex& part) { return containment_map(part, b); };
      const auto made = made_in_batches(set, {-2, -1, 1, 0}, left, kSmall);
      if (!made) continue;
      EXPECT_TRUE(same(*made, left(set))) << seed;
      EXPECT_EQ(made->faces[0].mark, 1);
      ++compared;
    }
  EXPECT_GT(compared, 20);
}

/// Least marks along a slanted window, one way and with an end far from its place.
TEST(InBatches, SweepsAreThoseOfTheWhole) {
  const Window window = window_between({Real(-1), Real(2)}, {Real(3), Real(1)});
  int compared = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const SignMap set = remark(boxes(seed, 20), [](Mark m) { return Mark(1 - 2 * m); });
    const auto sweep = [&](const CellComplex& part) {
      return swept(part, window, [](const Sight& s) { return s.inside; });
    };
    const auto made = made_in_batches(set, {-3, -2, 1, -1}, sweep, kSmall);
    if (!made) continue;
    EXPECT_TRUE(same(*made, sweep(set))) << seed;
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST(InBatches, WhatIsWiderThanAllThatIsLeftOutMeetsEverywhere) {
  const Region room = box(0, 0, 7, 4);
  for (const Region& wide : {box(0, 0, 8, 1), box(3, -2, 4, 3), region_of_disc(0, 0, Real::ratio(5, 2))}) {
    const SignMap map = containment_map(room, wide);
    EXPECT_TRUE(map.edges.empty());
    EXPECT_EQ(map.faces[0].mark, 1);
  }
  const SignMap just = containment_map(room, box(1, 1, 8, 3));
  EXPECT_EQ(mark_of(just, locate(just, {Real(-1), Real(0)})), 0);
  EXPECT_EQ(just.edges.size(), 1u);
}

TEST(InBatches, WhatIsWithinReachIsOnePart) {
  const auto make = [](const CellComplex& part) { return part; };
  EXPECT_FALSE(made_in_batches(boxes(1, 40), {-40, -40, 40, 40}, make, kSmall));
}

/// Large enough for batches of the usual size.
Region five_thousand_boxes() {
  std::vector<Contour> rings;
  for (std::int64_t k = 0; k < 5000; ++k) {
    const std::int64_t x = k % 70 * 9, y = k / 70 * 9, a = 2 + k % 3;
    rings.push_back({{.start = {x, y}}, {.start = {x + a, y}}, {.start = {x + a, y + a}}, {.start = {x, y + a}}});
  }
  std::vector<std::span<const Contour>> polygons;
  for (const Contour& ring : rings) polygons.emplace_back(&ring, 1);
  return region_of_polygons(polygons);
}

/// The base and the level batch by batch, for levels without, about and within the base; some results touch.
TEST(InBatches, LevelsWithoutTheBaseAreThoseOfIt) {
  const Region set = five_thousand_boxes(), b = box(-3, 1, -1, 2);
  const SignMap sum = contact_map(set, b);
  for (const Real& level :
       {Real(0), Real::ratio(3, 4), Real(1), Real::ratio(3, 2), Real::ratio(-1, 2), Real(-1), Real(-9)}) {
    const auto made = contact_level_in_batches(set, b, level);
    ASSERT_TRUE(made) << level.to_double();
    const SignMap whole = level_map(sum, level);
    EXPECT_EQ(made->edges.size(), whole.edges.size()) << level.to_double();
    EXPECT_EQ(made->faces.size(), whole.faces.size()) << level.to_double();
    EXPECT_TRUE(same(*made, whole)) << level.to_double();
  }
  EXPECT_FALSE(contact_level_in_batches(complement(set), b, Real(1)));
  EXPECT_FALSE(contact_level_in_batches(set, complement(b), Real(1)));
  EXPECT_FALSE(contact_level_in_batches(b, b, Real(1)));
}

/// A base that is not kept is moved into the level, with arcs and without.
TEST(InBatches, LevelsOfABaseThatGoesAreThoseOfIt) {
  const Region b = box(-3, 1, -1, 2);
  for (const Region& set :
       {box(0, 0, 9, 5), region_of_disc(3, -2, Real(7)), complement(region_of_disc(0, 0, Real(40)))})
    for (const Real& level : {Real(0), Real::ratio(3, 4), Real(-2)}) {
      const SignMap base = contact_map(set, b);
      EXPECT_TRUE(same(level_map(SignMap(base), level), level_map(base, level))) << level.to_double();
      EXPECT_TRUE(same(contact_map(Region(set), b), base));
    }
}

/// Through the public way.
TEST(InBatches, LargeSetsGoThroughBatches) {
  const Region set = five_thousand_boxes(), b = box(0, 0, 1, 2);
  const SignMap sum = contact_map(set, b), level = level_map(sum, Real(1));
  EXPECT_EQ(sum.edges.size(), 4 * 5000u);
  EXPECT_EQ(level.faces.size(), 5001u);
  // What lies in one of them: boxes of two sizes have room for it along both axes.
  const SignMap fits = containment_map(set, box(0, 0, 2, 2)),
                slide = swept(sum, window_along(1, 0, Real(0), Real(1)), [](const Sight&s) { return s.least(); });
  EXPECT_EQ(fits.edges.size(), 4 * 3333u);
  EXPECT_EQ(slide.edges.size(), 4 * 5000u);
  Locator in_sum(sum), in_level(level);
  for (std::int64_t k = 0; k < 5000; k += 37) {
    const std::int64_t x = k % 70 * 9, y = k / 70 * 9, a = 2 + k % 3;
    EXPECT_EQ(in_sum.mark({Real(x + a), Real(y)}), 0);
    EXPECT_EQ(in_sum.mark({Real(x), Real(y)}), -1);
    EXPECT_EQ(in_level.mark({Real(x + a + 1), Real(y)}), 0);
    EXPECT_EQ(in_level.mark({Real(x + a), Real(y)}), -1);
  }
}

TEST(InBatches, SmallSetsAndOnePartAreLeftAlone) {
  const auto make = [](const CellComplex& part) { return part; };
  EXPECT_FALSE(made_in_batches(box(0, 0, 4, 4), {0, 0, 0, 0}, make, {.least = 2, .each = 1}));
  EXPECT_FALSE(made_in_batches(boxes(1, 40), {0, 0, 0, 0}, make));
}

TEST(InBatches, BatchesDoNotDependOnThreads) {
  const Region set = boxes(3, 60);
  std::vector<std::size_t> sizes;
  std::mutex guard;
  const auto make = [&](const CellComplex& part) {
    const std::lock_guard<std::mutex> lock(guard);
    sizes.push_back(part.edges.size());
    return part;
  };
  const auto one = made_in_batches(set, {1, 1, 1, 1}, make, kSmall);
  ASSERT_TRUE(one);
  EXPECT_GT(sizes.size(), 2u);
  const auto again = made_in_batches(set, {1, 1, 1, 1}, make, kSmall);
  ASSERT_EQ(one->edges.size(), again->edges.size());
  for (std::size_t e = 0; e < one->edges.size(); ++e) EXPECT_EQ(one->edges[e].v0, again->edges[e].v0);
}

}  // namespace plane_in_batches
}  // namespace findspace::plane
