// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Curves of a convolution that overlap on one line become one; sums of staircases, whose curves nearly all do.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/grid/merged_curves.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"

namespace findspace::plane {
namespace plane_merged_curves {

/// Of a level line at `y`.
struct Curve {
  std::int64_t from, to, y = 0;
  InnerSide side{};
};

ReducedConvolution curves(const std::vector<Curve>& all) {
  ReducedConvolution out;
  for (const Curve& c : all) {
    auto& g = out.geometry;
    const Index line = g.add_line(0, 1, c.y), p = g.add_grid_point(c.from, c.y), q = g.add_grid_point(c.to, c.y);
    out.pieces.push_back({.supporting_curve = line, .p0 = p, .p1 = q});
    out.sides.push_back(c.side);
  }
  return out;
}

std::vector<Curve> merged(const std::vector<Curve>& all) {
  const ReducedConvolution c = merged_curves(curves(all));
  std::vector<Curve> out;
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    const exact::Point &p = c.geometry.points[c.pieces[k].p0], &q = c.geometry.points[c.pieces[k].p1];
    EXPECT_EQ(c.geometry.supporting_curves[c.pieces[k].supporting_curve].c, p.gy);
    out.push_back({p.gx, q.gx, p.gy, c.sides[k]});
  }
  return out;
}

bool operator==(const Curve& a, const Curve& b) {
  return a.from == b.from && a.to == b.to && a.y == b.y && a.side.left == b.side.left &&
         a.side.hides_at_p0 == b.side.hides_at_p0 && a.side.hides_at_p1 == b.side.hides_at_p1;
}

using Curves = std::vector<Curve>;
constexpr InnerSide kLeft{true, true, true}, kRight{false, true, true};

TEST(MergedCurves, ThoseThatOverlapBecomeOne) {
  EXPECT_EQ(merged({{0, 4, 0, kLeft}, {2, 6, 0, kLeft}, {5, 9, 0, kLeft}}), (Curves{{0, 9, 0, kLeft}}));
  EXPECT_EQ(merged({{3, 4, 0, kLeft}, {0, 9, 0, kLeft}}), (Curves{{0, 9, 0, kLeft}})) << "one inside the other";
  EXPECT_EQ(merged({{0, 4, 0, kLeft}, {0, 4, 0, kLeft}}), (Curves{{0, 4, 0, kLeft}})) << "the same twice";
}

TEST(MergedCurves, OthersStayAsTheyAre) {
  const Curves apart{{5, 9, 0, kLeft}, {0, 4, 0, kLeft}}, meet{{0, 4, 0, kLeft}, {4, 9, 0, kLeft}},
      sides{{0, 4, 0, kLeft}, {0, 4, 0, kRight}}, lines{{0, 4, 1, kLeft}, {0, 4, 0, kLeft}};
  EXPECT_EQ(merged(apart), apart) << "in their order";
  EXPECT_EQ(merged(meet), meet) << "at the common end the set need not lie behind the line";
  EXPECT_EQ(merged(sides), sides);
  EXPECT_EQ(merged(lines), lines);
}

TEST(MergedCurves, OneThatHidesAtAnEndIsEnough) {
  const InnerSide none{true, false, false}, first{true, true, false}, last{true, false, true};
  EXPECT_EQ(merged({{0, 4, 0, none}, {0, 4, 0, first}}), (Curves{{0, 4, 0, first}}));
  EXPECT_EQ(merged({{0, 4, 0, last}, {0, 4, 0, none}}), (Curves{{0, 4, 0, last}}));
  EXPECT_EQ(merged({{0, 4, 0, none}, {1, 3, 0, kLeft}}), (Curves{{0, 4, 0, none}})) << "not at these ends";
  EXPECT_EQ(merged({{0, 4, 0, none}, {1, 4, 0, kLeft}}), (Curves{{0, 4, 0, last}}));
}

TEST(MergedCurves, PaysWhereManyOverlap) {
  Curves few(200, {0, 4, 0, kLeft}), many(2000, {0, 4, 0, kLeft}), apart, pairs;
  for (std::int64_t k = 0; k < 2000; ++k) {
    apart.push_back({k, k + 1, 0, kLeft});
    pairs.push_back({k / 2, k / 2 + 1, 0, kLeft});
  }
  EXPECT_FALSE(merging_pays(curves(few)));
  EXPECT_TRUE(merging_pays(curves(many)));
  EXPECT_FALSE(merging_pays(curves(apart)));
  EXPECT_FALSE(merging_pays(curves(pairs)));
}

Region ring(const std::vector<GridPoint>& points) {
  Contour c;
  for (const GridPoint& p : points) c.push_back({.start = p});
  return region_of_rings(std::array{c});
}

/// The sum of `times` L shapes of 5 by 4 with legs of width 1: boxes of which each takes some of one leg.
Region boxes(std::int64_t times) {
  std::vector<Region> all;
  for (std::int64_t k = 0; k <= times; ++k) {
    const std::int64_t x = 5 * k + (times - k), y = k + 4 * (times - k);
    all.push_back(ring({{0, 0}, {x, 0}, {x, y}, {0, y}}));
  }
  std::vector<const Region*> parts;
  for (const Region& r : all) parts.push_back(&r);
  return unite(parts);
}

double area(const Region& r) {
  double sum = 0;
  for (std::size_t e = 0; e < r.edges.size(); ++e) {
    const bool left = r.faces[r.half_edges[2 * e].face].mark > 0,
               right = r.faces[r.half_edges[2 * e + 1].face].mark > 0;
    const exact::Point &p = r.geometry.points[r.vertices[r.edges[e].v0].point],
                       &q = r.geometry.points[r.vertices[r.edges[e].v1].point];
    sum += (double(left) - double(right)) * (p.x * q.y - q.x * p.y) / 2;
  }
  return sum;
}

TEST(MergedCurves, SumsOfSumsAreTheStaircases) {
  const std::array<double, 10> areas{8, 44, 200, 848, 3488, 14144, 56960, 228608, 915968, 3666944};
  Region sum = ring({{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}});
  for (std::size_t k = 1; k < areas.size(); ++k) {
    sum = minkowski_sum(sum, sum);
    const std::size_t times = std::size_t(1) << k;
    EXPECT_EQ(sum.vertices.size(), 2 * times + 4) << times;
    EXPECT_EQ(area(sum), areas[k]) << times;
    const Region expected = boxes(std::int64_t(times));
    EXPECT_TRUE(is_empty(overlay(std::array<const CellComplex*, 2>{&sum, &expected}, [](std::span<const Mark> m) {
      return Mark(m[0] != m[1]);
    }))) << times;
  }
}

}  // namespace plane_merged_curves
}  // namespace findspace::plane
