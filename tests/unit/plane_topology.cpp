// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include "plane/query/topology.h"
#include "plane_topology_sets.h"

namespace findspace::plane {
namespace plane_topology {

const Region kEmpty = Region::uniform(0), kPlane = Region::uniform(1);

/// A square with a whisker, a crack, a puncture and a point apart.
Region mixed() {
  return ((box(0, 0, 10, 10) + segment({10, 5}, {14, 5}) + point(20, 0)) - segment({2, 2}, {6, 2})) - point(5, 7);
}

TEST(Topology, EmptyAndPlaneAreOpenClosedRegular) {
  for (const Region& s : {kEmpty, kPlane}) {
    EXPECT_TRUE(is_open(s) && is_closed(s) && is_regular(s));
    EXPECT_TRUE(same_set(interior(s), s) && same_set(closure(s), s) && same_set(regularize(s), s));
    EXPECT_TRUE(is_empty(boundary(s)));
  }
  EXPECT_TRUE(is_empty(kEmpty) && !is_whole(kEmpty) && is_bounded(kEmpty));
  EXPECT_TRUE(!is_empty(kPlane) && is_whole(kPlane) && !is_bounded(kPlane));
  EXPECT_TRUE(is_whole(complement(kEmpty)));
}

TEST(Topology, PointAndSegmentHaveNoInterior) {
  for (const Region& s : {point(3, 4), segment({0, 0}, {4, 3})}) {
    EXPECT_TRUE(is_closed(s) && !is_open(s) && !is_regular(s) && is_bounded(s));
    EXPECT_TRUE(is_empty(interior(s)) && is_empty(regularize(s)));
    EXPECT_TRUE(same_set(boundary(s), s));
  }
}

TEST(Topology, OpenSegmentIsNeither) {
  Region s = segment({0, 0}, {4, 0}) - point(0, 0);
  EXPECT_FALSE(is_open(s) || is_closed(s));
  EXPECT_TRUE(same_set(closure(s), segment({0, 0}, {4, 0})));
}

TEST(Topology, Disc) {
  Region d = disc(0, 0, 5), open = interior(d);
  EXPECT_TRUE(is_closed(d) && is_regular(d) && !is_open(d));
  EXPECT_TRUE(is_open(open) && !is_closed(open) && !is_regular(open));
  EXPECT_TRUE(same_set(closure(open), d));
  EXPECT_TRUE(same_set(boundary(d), d - open));
  EXPECT_TRUE(same_set(boundary(open), boundary(d)));
}

TEST(Topology, PunctureIsOpenAndFilledByClosure) {
  Region s = interior(box(0, 0, 4, 4)) - point(2, 2);
  EXPECT_TRUE(is_open(s));
  EXPECT_TRUE(same_set(closure(s), box(0, 0, 4, 4)));
  EXPECT_TRUE(same_set(boundary(s), boundary(box(0, 0, 4, 4)) + point(2, 2)));
  Region whole = kPlane - point(0, 0);
  EXPECT_TRUE(is_open(whole) && !is_closed(whole) && !is_whole(whole));
}

TEST(Topology, VertexSeesTheFacesAroundIt) {
  // An isolated point of the set in a face of it would be an interior point; one outside is not.
  Region s = (interior(box(0, 0, 4, 4)) - segment({1, 2}, {3, 2})) + point(2, 2);
  EXPECT_FALSE(is_open(s));
  EXPECT_TRUE(same_set(interior(s), interior(box(0, 0, 4, 4)) - segment({1, 2}, {3, 2})));
}

TEST(Topology, MixedSet) {
  Region s = mixed();
  EXPECT_FALSE(is_open(s) || is_closed(s) || is_regular(s));
  Region expected_interior = (interior(box(0, 0, 10, 10)) - segment({2, 2}, {6, 2})) - point(5, 7);
  EXPECT_TRUE(same_set(interior(s), expected_interior));
  EXPECT_TRUE(same_set(closure(s), box(0, 0, 10, 10) + segment({10, 5}, {14, 5}) + point(20, 0)));
  EXPECT_TRUE(same_set(regularize(s), box(0, 0, 10, 10)));
}

TEST(Topology, LawsOnTheMixedSet) {
  for (const Region& s : {mixed(), complement(mixed()), disc(0, 0, 3) - segment({-5, 0}, {5, 0})}) {
    EXPECT_TRUE(same_set(complement(closure(s)), interior(complement(s))));
    EXPECT_TRUE(same_set(boundary(s), closure(s) - interior(s)));
    EXPECT_TRUE(same_set(boundary(s), closure(s) & closure(complement(s))));
    EXPECT_TRUE(same_set(regularize(s), closure(interior(s))));
    EXPECT_TRUE(is_open(interior(s)) && is_closed(closure(s)) && is_regular(regularize(s)));
    EXPECT_TRUE(same_set(complement(complement(s)), s));
  }
}

TEST(Topology, RegularizingIsNotTheInteriorOfTheClosure) {
  Region s = box(0, 0, 4, 4) - segment({0, 2}, {4, 2});
  EXPECT_TRUE(same_set(regularize(s), box(0, 0, 4, 4)));
  EXPECT_FALSE(same_set(regularize(s), interior(closure(s))));
}

/// A segment and an arc begin at S = (10, 0); their line and circle meet again at T = (8, 0). Turned by quarters.
TEST(Arrange, ASegmentAndAnArcWithACommonEndMayMeetAgain) {
  struct Arc {
    GridPoint to;
    bool ccw, through_t;
  };
  const Arc arcs[] = {{{12, 2}, true, false}, {{6, 2}, false, true}, {{6, 2}, true, false}, {{10, 0}, true, true}};
  const auto turned = [](GridPoint p, int quarters) {
    for (int k = 0; k < quarters; ++k) p = {-p.y, p.x};
    return p;
  };
  for (int quarters = 0; quarters < 4; ++quarters) {
    for (const Arc& arc : arcs) {
      for (const std::int64_t end : {20, 9, 0}) {
        PieceBuilder b;
        const auto add = [&](GridPoint p) {
          const GridPoint q = turned(p, quarters);
          return b.geometry.add_grid_point(q.x, q.y);
        };
        const GridPoint s{10, 0}, centre = turned({9, 3}, quarters);
        const Index from = add(s), to = arc.to == s ? from : add(arc.to);
        b.arc(b.geometry.add(exact::SupportingCurve::circle_at(centre.x, centre.y, sqrt(exact::Real(10)))), from, to,
              arc.ccw);
        const Index alone = arrange(b.geometry, b.pieces).vertex_count(), other = add({end, 0});
        b.segment(b.line(turned(s, quarters), turned({end, 0}, quarters)), from, other,
                  compare_xy(b.geometry, from, other) < 0);
        const bool again = arc.through_t && end < 8;
        EXPECT_EQ(arrange(b.geometry, b.pieces).vertex_count(), alone + 1 + (again ? 1 : 0))
            << quarters << " " << arc.to.x << " " << arc.ccw << " " << end;
      }
    }
  }
}

}  // namespace plane_topology
}  // namespace findspace::plane
