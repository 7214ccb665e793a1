// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Unions by walks along outer sides against unions that are arranged, cell by cell: random polygons with holes, unions
// of them, sets in holes of others, and polygons over few lattice points, which touch, share corners and edges, or
// cross three at a point.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "findspace/error.h"
#include "plane/complex/cell_bytes.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/contour/contour.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace plane_unite_by_walks {

using Points = std::vector<GridPoint>;

Contour contour(const Points& points) {
  Contour c;
  for (const GridPoint& p : points) c.push_back({.start = p});
  return c;
}

std::optional<Region> region(const std::vector<Points>& rings) {
  std::vector<Contour> contours;
  for (const Points& r : rings) contours.push_back(contour(r));
  try {
    return region_of_rings(make_rings(std::move(contours), 1).contours);
  } catch (const Error&) {
    return std::nullopt;  // it touches itself or is flat
  }
}

/// Corners round a place, at random distances.
Points star(std::mt19937& rng, GridPoint at, int corners, std::int64_t least, std::int64_t most) {
  Points points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * (k + double(rng() % 1000) / 1500) / corners;
    const auto r = double(least + std::int64_t(rng() % std::uint64_t(most - least + 1)));
    points.push_back({at.x + std::llround(r * std::cos(angle)), at.y + std::llround(r * std::sin(angle))});
  }
  return points;
}

std::string bytes(const Region& r) {
  ByteWriter out;
  EXPECT_TRUE(put_cells(r, out));
  return std::move(out).take();
}

std::vector<const Region*> pointers(const std::vector<Region>& sets) {
  std::vector<const Region*> all;
  for (const Region& s : sets) all.push_back(&s);
  return all;
}

std::size_t inner_rings(const Region& r) {
  std::size_t count = 0;
  for (const Face& f : r.faces) count += f.inner.size();
  return count;
}

/// Does every vertex have two edges, so that rings that touch nowhere are the whole boundary?
bool is_rings(const Region& r) {
  return std::all_of(r.vertices.begin(), r.vertices.end(), [&](const Vertex& v) {
    return v.out != kNone && r.clockwise(v.out) != v.out && r.clockwise(r.clockwise(v.out)) == v.out;
  });
}

struct Count {
  int unions = 0, touching = 0, with_holes = 0, in_parts = 0;
};

/// The same cells: as many of each kind, and the same marks wherever the two are laid over each other.
void expect_same(const Region& walked, const Region& arranged, const std::string& what) {
  EXPECT_EQ(walked.vertices.size(), arranged.vertices.size()) << what;
  EXPECT_EQ(walked.edges.size(), arranged.edges.size()) << what;
  EXPECT_EQ(walked.faces.size(), arranged.faces.size()) << what;
  EXPECT_EQ(inner_rings(walked), inner_rings(arranged)) << what;
  const std::vector<const CellComplex*> both{&walked, &arranged};
  const auto differ = overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); });
  EXPECT_TRUE(differ.vertices.empty() && differ.faces.size() == 1 && differ.faces[0].mark == 0) << what;
}

/// The next half-edge and the first one at a vertex, as an arrangement would have them.
void expect_consistent(const Region& r, const std::string& what) {
  for (Index h = 0; h < r.half_edges.size(); ++h) {
    ASSERT_EQ(r.target(h), r.origin(r.next(h))) << what;
    ASSERT_EQ(r.face(h), r.face(r.next(h))) << what;
  }
  for (const Edge& e : r.edges)
    EXPECT_LT(compare_xy(r.geometry, r.vertices[e.v0].point, r.vertices[e.v1].point), 0) << what;
  const Region again = remark(r, [](Mark m) { return Mark(1 - m); });
  EXPECT_EQ(again.vertices.size(), r.vertices.size()) << what;
}

void compare(const std::vector<Region>& sets, const std::string& what, Count& count) {
  const auto operands = pointers(sets);
  const Region arranged = unite_arranged(operands);
  const auto walked = united_by_walks(operands);
  ++count.unions;
  ASSERT_TRUE(walked) << what;
  count.touching += !is_rings(arranged);
  expect_same(*walked, arranged, what);
  expect_consistent(*walked, what);
  count.with_holes += inner_rings(*walked) > walked->faces[0].inner.size();
  count.in_parts += walked->faces[0].inner.size() > 1;
}

TEST(PlaneUniteByWalks, PolygonsInGeneralPosition) {
  std::mt19937 rng(1);
  Count count;
  for (int k = 0; k < 300; ++k) {
    std::vector<Region> sets;
    const int n = 2 + int(rng() % 12);
    for (int i = 0; i < n; ++i) {
      const GridPoint at{std::int64_t(rng() % 4000000), std::int64_t(rng() % 4000000)};
      std::vector<Points> rings{star(rng, at, 3 + int(rng() % 12), 200000, 1000000)};
      if (rng() % 2) rings.push_back(star(rng, at, 3 + int(rng() % 6), 20000, 60000));
      if (auto made = region(rings)) sets.push_back(*std::move(made));
    }
    compare(sets, "union " + std::to_string(k), count);
  }
  EXPECT_GT(count.with_holes, 100);
  EXPECT_GT(count.in_parts, 50);
}

/// From rings, without regions; some have straight corners, or arcs.
TEST(PlaneUniteByWalks, Rings) {
  std::mt19937 rng(5);
  int unions = 0, done = 0;
  for (int k = 0; k < 600; ++k) {
    std::vector<std::vector<Contour>> sets;
    const int n = 1 + int(rng() % 8);
    const bool lattice = k % 2 != 0;
    for (int i = 0; i < n; ++i) {
      const std::int64_t x = std::int64_t(rng() % 3000), y = std::int64_t(rng() % 3000);
      std::vector<Contour> rings{contour(star(rng, {x, y}, 3 + int(rng() % 9), 300, 1000))};
      if (rng() % 3 == 0) rings.push_back(contour(star(rng, {x, y}, 5, 30, 100)));
      if (lattice) rings = {contour({{x % 9, y % 9}, {x % 9 + 4, y % 9}, {x % 9 + 4, y % 9 + 3}, {x % 9, y % 9 + 5}})};
      if (k % 20 == 0) rings = {circle_ring({x, y}, 500)};
      if (k % 30 == 5) rings = {contour({{x, y}, {x + 400, y}, {x + 900, y}, {x + 300, y + 700}})};
      try {
        sets.push_back(make_rings(std::move(rings), 1).contours);
      } catch (const Error&) {
      }
    }
    std::vector<std::span<const Contour>> polygons;
    std::vector<Region> regions;
    for (const auto& s : sets) {
      polygons.emplace_back(s);
      regions.push_back(region_of_rings(s));
    }
    if (sets.empty()) continue;
    const std::string what = "rings " + std::to_string(k);
    const Region arranged = unite_arranged(pointers(regions));
    const auto walked = united_by_walks(polygons);
    ++unions;
    done += walked.has_value();
    expect_same(walked ? *walked : unite_rings(polygons), arranged, what);
    if (!walked) continue;
    expect_consistent(*walked, what);
    const auto of_regions = united_by_walks(pointers(regions));
    ASSERT_TRUE(of_regions) << what;
    EXPECT_TRUE(bytes(*walked) == bytes(*of_regions)) << what;
  }
  EXPECT_GT(done, 400);
  EXPECT_GT(unions - done, 30);
}

TEST(PlaneUniteByWalks, EmptySetsAddNothing) {
  const Region box = *region({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}), nothing = Region::uniform(0);
  const std::vector<const Region*> some{&nothing, &box, &nothing, &box}, none{&nothing, &nothing};
  const auto united = united_by_walks(some), empty = united_by_walks(none);
  ASSERT_TRUE(united && empty);
  EXPECT_EQ(united->vertices.size(), 4u);
  EXPECT_EQ(empty->faces.size(), 1u);
  EXPECT_TRUE(empty->vertices.empty());
}

/// Their corners are crossings.
TEST(PlaneUniteByWalks, UnionsOfUnions) {
  std::mt19937 rng(2);
  Count count;
  for (int k = 0; k < 100; ++k) {
    std::vector<Region> sets;
    for (int i = 0; i < 4; ++i) {
      std::vector<Region> parts;
      for (int j = 0; j < 5; ++j)
        if (auto made = region({star(rng, {std::int64_t(rng() % 3000), std::int64_t(rng() % 3000)}, 7, 300, 900)}))
          parts.push_back(*std::move(made));
      if (auto made = united_by_walks(pointers(parts))) sets.push_back(*std::move(made));
    }
    compare(sets, "union " + std::to_string(k), count);
  }
  EXPECT_GT(count.with_holes, 3);
}

/// The same set again, sets in holes and in holes of sets in holes.
TEST(PlaneUniteByWalks, SetsInHolesOfOthers) {
  const auto square = [](std::int64_t r) { return Points{{-r, -r}, {r, -r}, {r, r}, {-r, r}}; };
  const Region outer = *region({square(100), square(90)}), middle = *region({square(80), square(70)});
  const Region inner = *region({square(60)}), cover = *region({square(75)});
  Count count;
  compare({outer, middle, inner}, "three", count);
  compare({inner, middle, outer}, "three backwards", count);
  compare({outer, middle, inner, cover}, "a hole filled", count);
  compare({outer, *region({square(95)})}, "all filled", count);
  compare({outer, Region::uniform(0), inner}, "an empty one", count);
  compare({Region::uniform(0), Region::uniform(0)}, "nothing", count);
  compare({outer, outer, inner}, "one twice", count);
  compare({outer, *region({square(90)})}, "a hole filled exactly", count);
  compare({outer, *region({square(100)}), cover}, "all filled exactly", count);
  EXPECT_FALSE(united_by_walks(pointers({outer, Region::uniform(1)})));
}

/// Their edges run along each other, they share corners, many cross at a point, and rings touch.
TEST(PlaneUniteByWalks, PolygonsOverFewLatticePoints) {
  std::mt19937 rng(3);
  Count count;
  for (int k = 0; k < 3000; ++k) {
    std::vector<Region> sets;
    const int n = 2 + int(rng() % 4), places = 4 + int(rng() % 12);
    while (int(sets.size()) < n) {
      Points points;
      const int corners = 3 + int(rng() % 5);
      for (int i = 0; i < corners; ++i) points.push_back({std::int64_t(rng() % places), std::int64_t(rng() % places)});
      if (auto made = region({points})) sets.push_back(*std::move(made));
    }
    compare(sets, "union " + std::to_string(k), count);
  }
  EXPECT_GT(count.unions - count.touching, 1000);
  EXPECT_GT(count.touching, 100);
  EXPECT_GT(count.with_holes, 100);
}

/// Parts in a row and stacked, on the lattice and off it.
TEST(PlaneUniteByWalks, BoxesAndTrianglesSideBySide) {
  std::mt19937 rng(6);
  Count count;
  for (int k = 0; k < 500; ++k) {
    std::vector<Region> sets;
    const std::int64_t size = k % 2 ? 1 : 1000;
    for (int i = 0, n = 2 + int(rng() % 30); i < n; ++i) {
      const std::int64_t x = size * std::int64_t(rng() % 6), y = size * std::int64_t(rng() % 6);
      const std::int64_t w = size * std::int64_t(1 + rng() % 2), h = size * std::int64_t(1 + rng() % 2);
      sets.push_back(rng() % 3 ? *region({{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}})
                               : *region({{{x, y}, {x + w, y}, {x, y + h}}}));
    }
    compare(sets, "side by side " + std::to_string(k), count);
  }
  EXPECT_GT(count.unions - count.touching, 100);
  EXPECT_GT(count.touching, 100);
}

/// Sets that overlap in many edges, so that a grid of cells chooses the pairs; and far more pairs of sets than edges.
TEST(PlaneUniteByWalks, ManyEdgesAndManySets) {
  std::mt19937 rng(4);
  Count count;
  for (int k = 0; k < 3; ++k) {
    std::vector<Region> sets;
    for (int i = 0; i < 2; ++i) {
      const GridPoint at{std::int64_t(rng() % 20000), std::int64_t(rng() % 20000)};
      sets.push_back(*region({star(rng, at, 400, 900000, 1000000)}));
    }
    compare(sets, "large " + std::to_string(k), count);
  }
  std::vector<Region> small;
  for (int i = 0; i < 400; ++i)
    small.push_back(*region({star(rng, {std::int64_t(rng() % 99999), std::int64_t(rng() % 99999)}, 5, 3000, 9000)}));
  compare(small, "many", count);
  std::vector<Region> nested;
  for (std::int64_t i = 1; i <= 400; ++i) nested.push_back(*region({{{-i, -i}, {i, -i - 1}, {0, i}}}));
  EXPECT_FALSE(united_by_walks(pointers(nested)));
  expect_same(unite(pointers(nested)), unite_arranged(pointers(nested)), "nested");
}

}  // namespace plane_unite_by_walks
}  // namespace findspace::plane
