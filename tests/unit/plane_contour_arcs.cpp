// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Arcs: exact construction, and meeting, orientation and enclosure of rings that have them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "findspace/error.h"
#include "plane/contour/contour.h"
#include "plane/contour/contour_meet.h"

namespace findspace::plane {
namespace plane_contour_arcs {

using exact::Real;

ContourEdge line(GridPoint from) { return {.start = from}; }

/// Both ends exactly on the circle.
void expect_on_circle(const ContourEdge& edge, GridPoint to) {
  for (GridPoint p : {edge.start, to}) {
    Real dx = Real(p.x) - edge.arc->cx, dy = Real(p.y) - edge.arc->cy;
    EXPECT_EQ(compare(dx * dx + dy * dy, edge.arc->r * edge.arc->r), 0);
  }
}

TEST(ContourArcs, RadiusArcHasAnExactCentre) {
  ContourEdge edge = radius_arc({10, 0}, {10, 10}, 5, false, true);
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(10));
  EXPECT_EQ(edge.arc->cy.integer(), exact::int128(5));
  edge = radius_arc({5, 0}, {0, 5}, 5, false, true);  // a quarter, centre rational
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(0));
  EXPECT_EQ(edge.arc->cy.integer(), exact::int128(0));
  edge = radius_arc({5, 0}, {0, 5}, 5, true, true);
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(5));
  edge = radius_arc({5, 0}, {0, 5}, 5, false, false);
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(5));
  for (bool large : {false, true}) {
    for (bool ccw : {false, true}) {
      edge = radius_arc({0, 0}, {3, 1}, 7, large, ccw);  // centre irrational
      EXPECT_FALSE(edge.arc->cx.is_rational());
      expect_on_circle(edge, {3, 1});
      double side = 3 * edge.arc->cy.to_double() - 1 * edge.arc->cx.to_double();
      EXPECT_EQ(side > 0, ccw != large);
    }
  }
}

TEST(ContourArcs, RadiusGrowsToReachBothEnds) {
  bool grown = false;
  ContourEdge edge = radius_arc({0, 0}, {8, 0}, 3, true, true, &grown);
  EXPECT_TRUE(grown);
  EXPECT_EQ(edge.arc->r.integer(), exact::int128(4));
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(4));
  grown = false;
  radius_arc({0, 0}, {8, 0}, 4, true, true, &grown);
  EXPECT_FALSE(grown);
  edge = radius_arc({0, 0}, {1, 1}, Real::ratio(1, 10), false, true);
  expect_on_circle(edge, {1, 1});
}

TEST(ContourArcs, BulgeArc) {
  ContourEdge edge = bulge_arc({4, 0}, {-4, 0}, 1);
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(0));
  EXPECT_EQ(edge.arc->r.integer(), exact::int128(4));
  EXPECT_TRUE(edge.ccw);
  edge = bulge_arc({4, 0}, {-4, 0}, Real::ratio(-1, 2));
  EXPECT_FALSE(edge.ccw);
  EXPECT_EQ(edge.arc->r.integer(), exact::int128(5));
  EXPECT_EQ(edge.arc->cy.integer(), exact::int128(3));
  bool moved = false;
  edge = bulge_arc({1000, 0}, {0, 1000}, Real::parse_decimal("0.41421356"), &moved);  // tan(22.5 degrees), cut off
  EXPECT_TRUE(moved);
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(0));
  EXPECT_EQ(edge.arc->r.integer(), exact::int128(1000));
  edge = bulge_arc({0, 0}, {7, 3}, Real::ratio(1, 3));
  expect_on_circle(edge, {7, 3});
}

TEST(ContourArcs, ThreePointArc) {
  ContourEdge edge = three_point_arc({5, 0}, {3, 4}, {-5, 0});
  EXPECT_TRUE(edge.ccw);
  EXPECT_EQ(edge.arc->cx.integer(), exact::int128(0));
  EXPECT_EQ(edge.arc->r.integer(), exact::int128(5));
  EXPECT_FALSE(three_point_arc({-5, 0}, {3, 4}, {5, 0}).ccw);
  EXPECT_FALSE(three_point_arc({0, 0}, {1, 1}, {2, 2}).arc);
  edge = three_point_arc({0, 0}, {100, 37}, {211, 5});
  expect_on_circle(edge, {211, 5});
}

TEST(ContourArcs, OrientationAndCircles) {
  Contour circle = circle_ring({3, 3}, 2);
  EXPECT_EQ(orientation(circle), 1);
  EXPECT_EQ(orientation(reversed(circle)), -1);
  EXPECT_EQ(make_rings({reversed(circle)}, 1).reversed_rings, 1);
  // A crescent whose two ends are its leftmost points, one above the other.
  Contour crescent{radius_arc({0, -5}, {0, 5}, 5, false, true), radius_arc({0, 5}, {0, -5}, 13, false, false)};
  EXPECT_EQ(orientation(crescent), 1);
  EXPECT_EQ(orientation(reversed(crescent)), -1);
  // A horn: both arcs leave the leftmost point upright and only their curvature tells which is above.
  Contour horn{radius_arc({0, 0}, {20, -20}, 20, false, true), line({20, -20}),
               radius_arc({10, -10}, {0, 0}, 10, false, false)};
  EXPECT_EQ(orientation(horn), 1);
  EXPECT_EQ(orientation(reversed(horn)), -1);
}

TEST(ContourArcs, RingsOfTwoEdges) {
  EXPECT_NO_THROW(make_rings({{radius_arc({0, 0}, {8, 0}, 5, false, true), line({8, 0})}}, 1));
  EXPECT_NO_THROW(
      make_rings({{radius_arc({0, 0}, {8, 0}, 5, false, true), radius_arc({8, 0}, {0, 0}, 5, false, true)}}, 1));
  Contour lens{radius_arc({0, 0}, {8, 0}, 5, false, true), radius_arc({8, 0}, {0, 0}, 5, false, false)};
  EXPECT_THROW(make_rings({lens}, 1), Error);  // there and back on the same arc
}

TEST(ContourArcs, NeighboursMayOnlyMeetAtTheirVertex) {
  // A line tangent to the arc it leaves, and one that cuts it again.
  Contour tangent{radius_arc({5, 0}, {0, 5}, 5, false, true), line({0, 5}), line({-9, 5}), line({-9, -9}),
                  line({5, -9})};
  EXPECT_NO_THROW(make_rings({tangent}, 1));
  Contour cutting{radius_arc({5, 0}, {-4, 3}, 5, false, true), line({-4, 3}), line({8, 9}), line({20, -9})};
  EXPECT_THROW(make_rings({cutting}, 1), Error);
  // Fillets: line, arc, line, all tangent.
  Contour slot{line({0, 0}), radius_arc({10, 0}, {10, 10}, 5, false, true), line({10, 10}),
               radius_arc({0, 10}, {0, 0}, 5, false, true)};
  EXPECT_NO_THROW(make_rings({slot}, 1));
  // Two arcs that continue each other on one circle, and one that folds back over the first.
  Contour pieces{radius_arc({5, 0}, {3, 4}, 5, false, true), radius_arc({3, 4}, {-5, 0}, 5, false, true),
                 line({-5, 0})};
  EXPECT_NO_THROW(make_rings({pieces}, 1));
  Contour back{radius_arc({5, 0}, {-3, 4}, 5, false, true), radius_arc({-3, 4}, {3, 4}, 5, false, false), line({3, 4}),
               line({9, 9}), line({9, -1})};
  EXPECT_THROW(make_rings({back}, 1), Error);
}

TEST(ContourArcs, TangencyIsTouching) {
  Contour box{line({-20, -20}), line({20, -20}), line({20, 20}), line({-20, 20})};
  EXPECT_NO_THROW(make_rings({box, circle_ring({0, 0}, 19)}, 1));
  EXPECT_THROW(make_rings({box, circle_ring({0, 0}, 20)}, 1), Error);
  EXPECT_NO_THROW(make_rings({box, circle_ring({0, 0}, 5), circle_ring({6, 8}, 4)}, 1));
  EXPECT_THROW(make_rings({box, circle_ring({0, 0}, 5), circle_ring({6, 8}, 5)}, 1), Error);   // from outside
  EXPECT_THROW(make_rings({box, circle_ring({0, 0}, 10), circle_ring({3, 4}, 5)}, 1), Error);  // from inside
  EXPECT_THROW(make_rings({box, circle_ring({0, 0}, 10), circle_ring({3, 4}, 4)}, 1), Error);  // hole in hole
  std::int64_t far =
      std::int64_t{1} << 39;  // (3, 4, 5) far out: the double filter cannot see the difference of one step
  Contour wide{line({-4 * far, -4 * far}), line({4 * far, -4 * far}), line({4 * far, 4 * far}),
               line({-4 * far, 4 * far})};
  std::int64_t k = far / 5;
  EXPECT_THROW(make_rings({wide, circle_ring({0, 0}, 2 * k), circle_ring({3 * k, 4 * k}, 3 * k)}, 1), Error);
  EXPECT_NO_THROW(make_rings({wide, circle_ring({0, 0}, 2 * k), circle_ring({3 * k, 4 * k}, 3 * k - 1)}, 1));
}

TEST(ContourArcs, EnclosesBetweenChordAndArc) {
  Contour half{radius_arc({5, 0}, {-5, 0}, 5, false, true), line({-5, 0})};
  EXPECT_TRUE(encloses(half, {0, 4}));
  EXPECT_FALSE(encloses(half, {0, -1}));
  EXPECT_FALSE(encloses(half, {5, 4}));
  Contour circle = circle_ring({0, 0}, 5);
  for (std::int64_t x = -6; x <= 6; ++x) {
    for (std::int64_t y = -6; y <= 6; ++y) {
      if (x * x + y * y == 25) continue;
      EXPECT_EQ(encloses(circle, {x, y}), x * x + y * y < 25) << x << " " << y;
    }
  }
}

/// An edge as the oracle sees it: a segment, or centre, radius and the angles of a counter-clockwise arc.
struct Oracle {
  bool arc;
  long double ax, ay, bx, by, cx, cy, r;
};

Oracle oracle_of(const Span& s) {
  GridPoint a = s.first(), b = s.last();
  Oracle o{s.arc != nullptr, (long double)a.x, (long double)a.y, (long double)b.x, (long double)b.y, 0, 0, 0};
  if (s.arc) {
    o.cx = s.arc->cx.to_double();
    o.cy = s.arc->cy.to_double();
    o.r = s.arc->r.to_double();
  }
  return o;
}

long double angle_from(const Oracle& o, long double x, long double y) {
  long double rotation = std::atan2(y - o.cy, x - o.cx) - std::atan2(o.ay - o.cy, o.ax - o.cx);
  while (rotation < 0) rotation += 2 * 3.14159265358979323846L;
  return rotation;
}

/// Least distance of a point to the edge.
long double distance(const Oracle& o, long double x, long double y) {
  long double ends = std::min(std::hypot(x - o.ax, y - o.ay), std::hypot(x - o.bx, y - o.by));
  if (o.arc) {
    bool within = angle_from(o, x, y) <= angle_from(o, o.bx, o.by);
    return within ? std::min(ends, std::abs(std::hypot(x - o.cx, y - o.cy) - o.r)) : ends;
  }
  long double dx = o.bx - o.ax, dy = o.by - o.ay, t = ((x - o.ax) * dx + (y - o.ay) * dy) / (dx * dx + dy * dy);
  if (t < 0 || t > 1) return ends;
  return std::min(ends, std::hypot(x - o.ax - t * dx, y - o.ay - t * dy));
}

/// Least distance between two edges: samples along the first, every local minimum of them refined.
long double least_distance(const Oracle& f, const Oracle& g) {
  constexpr int kSteps = 200;
  long double full = f.arc ? angle_from(f, f.bx, f.by) : 0, start = std::atan2(f.ay - f.cy, f.ax - f.cx);
  auto at = [&](long double t) {
    long double a = start + full * t;
    return f.arc ? distance(g, f.cx + f.r * std::cos(a), f.cy + f.r * std::sin(a))
                 : distance(g, f.ax + t * (f.bx - f.ax), f.ay + t * (f.by - f.ay));
  };
  std::vector<long double> d;
  for (int i = 0; i <= kSteps; ++i) d.push_back(at((long double)i / kSteps));
  long double best = 1e9L;
  for (int i = 0; i <= kSteps; ++i) {
    if ((i > 0 && d[i - 1] < d[i]) || (i < kSteps && d[i + 1] < d[i])) continue;
    long double lo = (long double)std::max(0, i - 1) / kSteps, hi = (long double)std::min(kSteps, i + 1) / kSteps;
    for (int k = 0; k < 80; ++k) {
      long double p = lo + (hi - lo) / 3, q = hi - (hi - lo) / 3;
      (at(p) < at(q) ? hi : lo) = at(p) < at(q) ? q : p;
    }
    best = std::min({best, d[i], at((lo + hi) / 2)});
  }
  return best;
}

TEST(ContourArcs, MeetAgreesWithDistances) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-8, 8), kind(0, 2), radius(3, 12);
  int met = 0, apart = 0;
  for (int trial = 0; trial < 600; ++trial) {
    std::array<ContourEdge, 2> edges;
    std::array<Span, 2> spans;
    for (int i = 0; i < 2; ++i) {
      GridPoint a{coordinate(random), coordinate(random)}, b{coordinate(random), coordinate(random)};
      if (a == b) b.x += 1;
      bool arc = kind(random) > 0;
      edges[i] = arc ? radius_arc(a, b, radius(random), kind(random) == 0, kind(random) == 0) : line(a);
      spans[i] = {a, b, edges[i].arc.get(), edges[i].ccw};
    }
    std::optional<CommonPoint> m = meet(spans[0], spans[1], nullptr, false);
    Oracle f = oracle_of(spans[0]), g = oracle_of(spans[1]);
    if (m) {
      EXPECT_LT(distance(f, m->x, m->y), 1e-9) << trial;
      EXPECT_LT(distance(g, m->x, m->y), 1e-9) << trial;
      ++met;
    } else {
      EXPECT_GT(std::min(least_distance(f, g), least_distance(g, f)), 1e-7L) << trial;
      ++apart;
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(apart, 100);
}

}  // namespace plane_contour_arcs
}  // namespace findspace::plane
