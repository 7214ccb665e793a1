// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <cmath>

#include "findspace/error.h"
#include "law/plane_random.h"
#include "plane/build/transform.h"
#include "plane/complex/primitives.h"
#include "plane/query/locate.h"

namespace findspace::plane {
namespace plane_transform {

using exact::Real;
using Kind = Shape::Kind;

int mark_at(const Region& s, const Real& x, const Real& y) {
  exact::RealPoint p{x, y};
  return mark_of(s, locate(s, p));
}

Region rotation(const Region& s, const Real& degrees, Rounding& rounding, GridPoint about = {}) {
  return rotated(s, about, degrees, 1, rounding);
}

TEST(Translate, EmptySetAndPlane) {
  EXPECT_TRUE(is_empty(translated(Region::uniform(0), {3, 4})));
  EXPECT_TRUE(is_whole(translated(Region::uniform(1), {3, 4})));
}

TEST(Translate, ImplicitPointsMoveExactly) {
  // Corners at crossings of lines with lines, of lines with circles, and of circles with circles.
  ShapePtr set = node(Kind::kDifference,
                      {node(Kind::kUnion, {polygon_of({{0, 0}, {7, 1}, {2, 6}}), disc_of({6, 3}, sqrt(Real(5)))}),
                       disc_of({3, 1}, Real::ratio(5, 2))});
  Region s = region_of(set), t = translated(s, {100, -7});
  ASSERT_EQ(s.vertices.size(), t.vertices.size());
  for (Index v = 0; v < s.vertices.size(); ++v) {
    exact::RealPoint p = s.geometry.exact(s.vertices[v].point), q = t.geometry.exact(t.vertices[v].point);
    EXPECT_EQ(q.x, p.x + Real(100));
    EXPECT_EQ(q.y, p.y - Real(7));
    EXPECT_NEAR(t.point(v).x, q.x.to_double(), t.point(v).error + 1e-12);
  }
}

TEST(Translate, RefusesToLeaveTheGrid) {
  Region s = region_of(box_of(0, 0, 10, 10));
  EXPECT_NO_THROW(translated(s, {(std::int64_t(1) << 40) - 10, 0}));
  EXPECT_THROW(translated(s, {(std::int64_t(1) << 40) - 9, 0}), Error);
}

TEST(Mirror, ImplicitPointsMoveExactly) {
  EXPECT_TRUE(is_whole(mirrored_in_y_axis(Region::uniform(1))));
  // Crossings of lines, of lines with circles, and of circles; an open edge; a displaced line.
  ShapePtr set = node(Kind::kDifference,
                      {node(Kind::kUnion, {polygon_of({{0, 0}, {7, 1}, {2, 6}}), disc_of({6, 3}, sqrt(Real(5)))}),
                       disc_of({3, 1}, Real::ratio(5, 2))});
  Shape grown = *node(Kind::kOffset, {polygon_of({{-9, -9}, {-2, -8}, {-5, -3}})});
  grown.amount = Real::ratio(1, 3);
  Region s = region_of(node(Kind::kUnion, {set, std::make_shared<const Shape>(grown), points_of({{9, 9}})}));
  Region t = mirrored_in_y_axis(s);
  for (int x = -40; x <= 40; ++x)
    for (int y = -40; y <= 40; ++y)
      EXPECT_EQ(mark_at(s, Real::ratio(x, 4), Real::ratio(y, 4)), mark_at(t, -Real::ratio(x, 4), Real::ratio(y, 4)));
  for (const Vertex& v : s.vertices) {
    const exact::RealPoint p = s.geometry.exact(v.point);
    EXPECT_EQ(v.mark, mark_at(t, -p.x, p.y));
  }
  EXPECT_TRUE(same_set(s, mirrored_in_y_axis(t)));
}

TEST(Rotate, EmptySetAndPlane) {
  Rounding rounding;
  EXPECT_TRUE(is_empty(rotation(Region::uniform(0), 90, rounding)));
  EXPECT_TRUE(is_whole(rotation(Region::uniform(1), 17, rounding)));
  EXPECT_EQ(rounding.points, 0);
}

TEST(Rotate, LonelyPointIsRounded) {
  Rounding rounding;
  Region s = rotation(region_of(points_of({{10, 0}})), 60, rounding);
  EXPECT_EQ(mark_at(s, 5, 9), 1);  // (5, 8.66)
  EXPECT_EQ(rounding.points, 1);
  EXPECT_NEAR(rounding.largest, 9 - 5 * std::sqrt(3), 1e-9);
}

TEST(Rotate, QuarterRotationsAreExact) {
  Rounding rounding;
  Region s = region_of(node(Kind::kDifference, {disc_of({3, 0}, Real::ratio(5, 2)), box_of(0, 0, 9, 9)}));
  Region t = rotation(s, 90, rounding, {1, 1});  // (x, y) -> (2 - y, x)
  EXPECT_EQ(rounding.points, 0);
  for (int x = -20; x <= 20; ++x)
    for (int y = -20; y <= 20; ++y)
      EXPECT_EQ(mark_at(s, Real::ratio(x, 2), Real::ratio(y, 2)),
                mark_at(t, Real(2) - Real::ratio(y, 2), Real::ratio(x, 2)));
}

TEST(Rotate, CentreStaysAndRadiusStays) {
  Rounding rounding;
  Region s = rotation(region_of(disc_of({4, 5}, sqrt(Real(2)))), 33, rounding, {4, 5});
  EXPECT_TRUE(same_set(s, region_of(disc_of({4, 5}, sqrt(Real(2))))));
  EXPECT_EQ(rounding.points, 0);
}

TEST(Rotate, TwelveTimesThirtyDegrees) {
  ShapePtr slot =
      node(Kind::kDifference, {node(Kind::kUnion, {box_of(-5000000, -1000000, 5000000, 1000000),
                                                   disc_of({5000000, 0}, 1000000), disc_of({-5000000, 0}, 1000000)}),
                               disc_of({5000000, 0}, 300000)});
  Rounding rounding;
  Region s = region_of(slot), t = s;
  for (int k = 0; k < 12; ++k) t = rotation(t, 30, rounding, {17, 23});
  EXPECT_EQ(fault(t), "");
  EXPECT_LE(rounding.largest, std::sqrt(0.5) + 1e-9);
  EXPECT_GT(rounding.points, 0);
  Region grown = region_of(offset_of(slot, 40)), shrunk = region_of(offset_of(slot, -40));
  EXPECT_TRUE(is_subset(t, grown));
  EXPECT_TRUE(is_subset(shrunk, t));
}

TEST(Rotate, OpenAndClosedSidesStay) {
  // A square without its lower side but with that side's middle third.
  ShapePtr square = node(Kind::kUnion, {node(Kind::kDifference, {box_of(0, 0, 900, 900), chain_of({{0, 0}, {900, 0}})}),
                                        chain_of({{300, 0}, {600, 0}})});
  Rounding rounding;
  Region s = rotation(region_of(square), 45, rounding);
  EXPECT_EQ(fault(s), "");
  EXPECT_FALSE(is_open(s));
  EXPECT_FALSE(is_closed(s));
  EXPECT_EQ(mark_at(s, 0, 0), 0);
  EXPECT_EQ(mark_at(s, 212, 212), 1);
  EXPECT_EQ(mark_at(s, 424, 424), 1);
  EXPECT_EQ(s.vertices.size(), 6u);
  EXPECT_EQ(rounding.points, 5);  // all but the centre
}

TEST(Rotate, PunctureAndCrackStay) {
  ShapePtr set = node(Kind::kDifference, {node(Kind::kDifference, {box_of(0, 0, 900, 900), points_of({{200, 700}})}),
                                          chain_of({{300, 300}, {600, 300}})});
  Rounding rounding;
  Region s = rotation(region_of(set), 10, rounding);
  EXPECT_EQ(fault(s), "");
  EXPECT_EQ(s.vertices.size(), 7u);
  EXPECT_EQ(s.edges.size(), 5u);
}

TEST(Rotate, CircleWithoutOnePoint) {
  ShapePtr set = node(Kind::kDifference, {node(Kind::kBoundary, {disc_of({0, 0}, 500)}), points_of({{300, 400}})});
  Rounding rounding;
  Region s = rotation(region_of(set), 20, rounding);
  EXPECT_EQ(fault(s), "");
  EXPECT_EQ(s.faces.size(), 2u);
  int missing = 0;
  for (const Vertex& v : s.vertices) missing += v.mark == 0;
  EXPECT_EQ(missing, 1);
}

TEST(Rotate, ShortEdgesFallTogether) {
  Region comb = region_of(polygon_of({{0, 0}, {100, 0}, {100, 100}, {99, 100}, {0, 99}}));
  Rounding rounding;
  for (int degrees : {7, 23, 45, 71, 123, 200, 301}) EXPECT_EQ(fault(rotation(comb, degrees, rounding)), "") << degrees;
}

TEST(Rotate, SaysWhereAShapeCrossesItself) {
  Region needle = region_of(polygon_of({{0, 0}, {2000, 2}, {999, 1}}));
  Rounding rounding;
  int refused = 0;
  for (int degrees = 1; degrees < 90; ++degrees) {
    try {
      EXPECT_EQ(fault(rotation(needle, degrees, rounding)), "");
    } catch (const Error& e) {
      ++refused;
      EXPECT_EQ(e.code(), ErrorCode::kGeometry);
      EXPECT_EQ(e.geometry().size(), 1u);
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(Rotate, LargeCoordinates) {
  const std::int64_t far = std::int64_t(1) << 39;
  Rounding rounding;
  Region s = rotation(region_of(box_of(-far, -far, far, far)), 45, rounding);
  EXPECT_LE(rounding.largest, std::sqrt(0.5) + 1e-9);
  EXPECT_EQ(mark_at(s, 0, std::int64_t(far * std::sqrt(2)) - 1), 1);
  EXPECT_THROW(rotation(region_of(box_of(-2 * far, -2 * far, 2 * far, 2 * far)), 45, rounding), Error);
}

}  // namespace plane_transform
}  // namespace findspace::plane
