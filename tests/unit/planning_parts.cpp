// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The parts of simultaneous placement by themselves: linear programs against the vertices of all pairs of rows, convex
// cells against point location, and sets of conditions as disjunctions.
#include <gtest/gtest.h>

#include <random>

#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/locate.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"
#include "planning/order/convex_cells.h"
#include "planning/order/linear_program.h"
#include "planning/planar/pair_system.h"

namespace findspace::planning {
namespace planning_parts {

using exact::Real;
using exact::RealPoint;
using plane::Region;

struct Row {
  int a, b, c;
};

bool holds(const Row& r, const RealPoint& p) { return Real(r.a) * p.x + Real(r.b) * p.y <= Real(r.c); }

/// The greatest value over a bounded polygon is that of a vertex: a meeting of two rows that satisfies all.
std::optional<Real> by_vertices(const std::vector<Row>& rows, int a, int b) {
  std::optional<Real> best;
  for (const Row& r : rows)
    for (const Row& s : rows) {
      const int det = r.a * s.b - r.b * s.a;
      if (det == 0) continue;
      const RealPoint p{Real::ratio(r.c * s.b - r.b * s.c, det), Real::ratio(r.a * s.c - r.c * s.a, det)};
      bool all = true;
      for (const Row& t : rows) all = all && holds(t, p);
      const Real value = Real(a) * p.x + Real(b) * p.y;
      if (all && (!best || value > *best)) best = value;
    }
  return best;
}

TEST(LinearProgram, AgreesWithAllVertices) {
  std::mt19937 random(5);
  auto draw = [&](int n) { return int(random() % unsigned(2 * n + 1)) - n; };
  int empty = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Row> rows{{1, 0, 20}, {-1, 0, 20}, {0, 1, 20}, {0, -1, 20}};
    for (int k = 0; k < 5; ++k)
      if (Row r{draw(4), draw(4), draw(12)}; r.a != 0 || r.b != 0) rows.push_back(r);
    LinearProgram program(2);
    for (const Row& r : rows) program.add({Real(r.a), Real(r.b)}, Real(r.c));
    const int a = draw(5), b = draw(5);
    const std::optional<Real> want = by_vertices(rows, a, b);
    ASSERT_EQ(program.feasible(), want.has_value()) << trial;
    empty += !want;
    if (!want) continue;
    const auto at = program.maximise({Real(a), Real(b)});
    ASSERT_TRUE(at.has_value());
    EXPECT_EQ(Real(a) * (*at)[0] + Real(b) * (*at)[1], *want) << trial;
    for (const Row& r : rows) EXPECT_TRUE(holds(r, {(*at)[0], (*at)[1]}));
  }
  EXPECT_GT(empty, 20);
  EXPECT_LT(empty, 280);
}

TEST(LinearProgram, UnboundedAndWithoutRows) {
  LinearProgram none(2);
  EXPECT_TRUE(none.feasible());
  EXPECT_FALSE(none.maximise({Real(1), Real(0)}).has_value());
  LinearProgram half(1);
  half.add({Real(-1)}, Real(0));
  EXPECT_TRUE(half.feasible());
  EXPECT_FALSE(half.maximise({Real(1)}).has_value());
  EXPECT_EQ((*half.maximise({Real(-1)}))[0], Real(0));
}

Region box(int x0, int y0, int x1, int y1) {
  plane::Contour ring;
  for (const auto& [x, y] : {std::pair(x0, y0), std::pair(x1, y0), std::pair(x1, y1), std::pair(x0, y1)}) {
    plane::ContourEdge e;
    e.start = {x, y};
    ring.push_back(e);
  }
  return plane::region_of_rings(std::vector<plane::Contour>{ring});
}

bool in_cells(const std::vector<ConvexCell>& cells, const RealPoint& p) {
  for (const ConvexCell& cell : cells) {
    bool all = true;
    for (const HalfPlane& h : cell) {
      const int side = compare(Real(h.a) * p.x + Real(h.b) * p.y, h.c);
      all = all && (h.strict ? side < 0 : side <= 0);
    }
    if (all) return true;
  }
  return false;
}

void expect_same_set(const Region& r, const char* what) {
  const auto cells = convex_cells(r, plane::is_closed(r));
  plane::Locator locator(r);
  for (int x = -6; x <= 26; ++x)
    for (int y = -6; y <= 26; ++y) {
      const RealPoint p{Real::ratio(x, 2), Real::ratio(y, 2)};
      EXPECT_EQ(in_cells(cells, p), locator.mark(p) > 0) << what << " at " << x / 2.0 << ", " << y / 2.0;
    }
}

TEST(ConvexCells, AreTheSet) {
  const Region a = box(0, 0, 8, 6), b = box(4, 2, 10, 9), c = box(1, 1, 3, 3);
  const std::vector<const Region*> ab{&a, &b}, ac{&a, &c};
  const Region both = plane::unite(ab), cut = plane::subtract(ac), half_open = plane::subtract(ab);
  expect_same_set(both, "union");
  expect_same_set(cut, "open hole");
  expect_same_set(half_open, "half open");
  expect_same_set(plane::interior(both), "open");
  expect_same_set(plane::complement(both), "open, unbounded");
  expect_same_set(plane::closure(plane::complement(cut)), "closed, unbounded");
  expect_same_set(plane::boundary(cut), "curves");
  const Region points = plane::region_of_points(std::vector<plane::GridPoint>{{1, 1}, {3, 2}});
  const std::vector<const Region*> dotted{&points, &c};
  expect_same_set(plane::unite(dotted), "with a point");
  const std::vector<const Region*> punctured{&a, &points};
  expect_same_set(plane::subtract(punctured), "punctured");
}

TEST(PairSystem, ThreeThatExcludeEachOther) {
  // Three bodies on the segment [0, n] of the x axis, 1 apart: possible from n = 2 on.
  const Region apart = plane::complement(plane::interior(box(-1, -1, 1, 1)));
  for (int n : {1, 2, 3}) {
    const Region segment = [&] {
      const std::vector<plane::GridPoint> ends{{0, 0}, {n, 0}};
      plane::Contour chain(2);
      chain[0].start = ends[0];
      chain[1].start = ends[1];
      return plane::region_of_chain(chain);
    }();
    PairSystem system{{segment, segment, segment}, {{{0, 1}, apart}, {{0, 2}, apart}, {{1, 2}, apart}}};
    const Projections found = project(std::move(system), Limit());
    ASSERT_TRUE(found.exact);
    EXPECT_EQ(plane::is_empty(found.positions[1]), n < 2);
    if (n == 2) {
      EXPECT_EQ(found.positions[1].vertices.size(), 3u);
    }
    if (n == 3) {
      EXPECT_TRUE(plane::is_closed(found.positions[1]));
    }
  }
}

}  // namespace planning_parts
}  // namespace findspace::planning
