// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Polytope: degenerate input first (flat, duplicated, collinear, coplanar), then half spaces.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include "space/polytope/polytope.h"

namespace space_polytope {

using findspace::Error;
using findspace::ErrorCode;
using findspace::space::Plane;
using findspace::space::Point;
using findspace::space::Polytope;
using findspace::space::Repair;

std::vector<Point> box(std::int64_t x, std::int64_t y, std::int64_t z) {
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0});
  return points;
}

std::string refusal(const std::vector<Point>& points) {
  try {
    Polytope::hull(points);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kGeometry);
    return e.message();
  }
  return "accepted";
}

TEST(Polytope, RefusesFlatInputAndSaysWhatIsFlat) {
  EXPECT_NE(refusal({}).find("no points"), std::string::npos);
  EXPECT_NE(refusal({{1, 2, 3}, {1, 2, 3}}).find("one point"), std::string::npos);
  EXPECT_NE(refusal({{0, 0, 0}, {2, 4, 6}, {1, 2, 3}}).find("line of direction (1, 2, 3)"), std::string::npos);
  EXPECT_NE(refusal({{0, 0, 5}, {9, 0, 5}, {0, 9, 5}, {4, 4, 5}}).find("plane of normal (0, 0,"), std::string::npos);
  // Flat to doubles, not flat in truth: four points 2^40 apart, one a single step off the plane of the others.
  const std::int64_t big = std::int64_t{1} << 40;
  const Polytope thin =
      Polytope::hull(std::vector<Point>{{-big, -big, -big}, {big, big, big}, {big, -big, 0}, {1, 1, 2}});
  EXPECT_EQ(thin.facet_count(), 4);
}

TEST(Polytope, RefusesCoordinatesBeyondTheGrid) {
  std::vector<Point> points = box(1, 1, 1);
  points[3].x = (std::int64_t{1} << 40) + 1;
  EXPECT_THROW(Polytope::hull(points), Error);
}

TEST(Polytope, RepairsDuplicatesAndPointsThatAreNotExtreme) {
  std::vector<Point> points = box(4, 4, 4);
  points.insert(points.end(), {{2, 2, 0}, {2, 2, 2}, {4, 4, 4}, {4, 2, 0}, {2, 0, 0}, {3, 0, 0}, {1, 3, 4}});
  Repair repair;
  const Polytope cube = Polytope::hull(points, &repair);
  EXPECT_EQ(cube.vertex_count(), 8);
  EXPECT_EQ(cube.facet_count(), 6);
  EXPECT_EQ(cube.edge_count(), 12);
  EXPECT_EQ(repair.duplicates, 1);
  EXPECT_EQ(repair.not_extreme, 6);
  for (int f = 0; f < 6; ++f) EXPECT_EQ(cube.circuit_size(f), 4);
  EXPECT_DOUBLE_EQ(cube.volume(), 64);
}

TEST(Polytope, CircuitsRunCounterClockwiseSeenFromOutside) {
  const Polytope p = Polytope::hull(box(3, 4, 5));
  for (int f = 0; f < p.facet_count(); ++f) {
    const auto ring = p.circuit(f);
    const auto n = findspace::exact::cross(p.vertices()[ring[1]] - p.vertices()[ring[0]],
                                           p.vertices()[ring[2]] - p.vertices()[ring[1]]);
    const auto& plane = p.planes()[f];
    EXPECT_GT(n.x * plane.normal.x + n.y * plane.normal.y + n.z * plane.normal.z, 0);
    for (const Point& v : p.vertices()) EXPECT_LE(findspace::exact::dot(plane.normal, v) + plane.offset, 0);
  }
}

TEST(Polytope, MovesAndMirrorsExactly) {
  const Polytope p = Polytope::hull(box(3, 4, 5)), q = p.translated({7, -2, 1}), r = p.mirrored();
  for (int f = 0; f < 6; ++f) {
    for (const int v : q.circuit(f)) {
      EXPECT_TRUE(findspace::exact::dot(q.planes()[f].normal, q.vertices()[v]) + q.planes()[f].offset == 0);
    }
    EXPECT_TRUE(r.planes()[f].normal == -p.planes()[f].normal);
    EXPECT_TRUE(r.planes()[f].offset == p.planes()[f].offset);
  }
}

TEST(Polytope, FromHalfSpaces) {
  const std::vector<Plane> octant{{{1, 1, 1}, -6}, {{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}};
  const Polytope p = Polytope::from_half_spaces(octant);
  EXPECT_EQ(p.vertex_count(), 4);
  EXPECT_DOUBLE_EQ(p.volume(), 36);
  EXPECT_THROW(Polytope::from_half_spaces(std::span(octant).first(3)), Error);  // unbounded
  std::vector<Plane> empty = octant;
  empty.push_back({{-1, -1, -1}, 7});
  EXPECT_THROW(Polytope::from_half_spaces(empty), Error);
  std::vector<Plane> redundant = octant;
  redundant.push_back({{2, 2, 2}, -12});
  redundant.push_back({{1, 0, 0}, -100});
  EXPECT_EQ(Polytope::from_half_spaces(redundant).facet_count(), 4);
  std::vector<Plane> off{{{2, 3, 5}, -7}, {{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}};
  Repair repair;
  const Polytope rounded = Polytope::from_half_spaces(off, &repair);
  EXPECT_EQ(rounded.vertex_count(), 4);
  EXPECT_EQ(repair.rounded, 3);
  EXPECT_DOUBLE_EQ(repair.moved, 0.5);
}

}  // namespace space_polytope
