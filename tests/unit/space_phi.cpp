// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Phi-functions on examples whose values are known: the worked example of the paper, exact contact, ties, closed forms,
// polygons, unions with seams, distance limits.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "space/phi/depth_grid.h"
#include "space/phi/phi_union.h"
#include "space/phi/planar_phi_union.h"
#include "space/polytope/closed_forms.h"
#include "space/polytope/convex_polygon.h"

namespace findspace::space {
namespace space_phi {

using exact::Real;

Polytope box(std::int64_t x0, std::int64_t y0, std::int64_t z0, std::int64_t x1, std::int64_t y1, std::int64_t z1) {
  std::vector<Point> p;
  for (int i = 0; i < 8; ++i) p.push_back({i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0});
  return Polytope::hull(p);
}

PhiFunction example() {
  return PhiFunction(
      Polytope::hull(std::vector<Point>{{4, 10, 11}, {0, 10, 11}, {0, 10, 19}, {4, 10, 19}, {2, 4, 11}, {2, 4, 19}}),
      Polytope::hull(std::vector<Point>{{5, 15, 4}, {2, 15, 4}, {3, 14, 10}, {0, 9, 4}}));
}

TEST(PhiFunction, WorkedExampleOfThePaper) {
  const PhiFunction phi = example();
  EXPECT_EQ(phi.surface().facet_count(), 12);
  EXPECT_EQ(phi.surface().vertex_count(), 13);
  bool f9 = false;
  for (int f = 0; f < 12; ++f) f9 = f9 || phi.surface().plane(f) == Plane{{0, 6, -5}, 29};
  EXPECT_TRUE(f9) << "the printed constant is 39";
  EXPECT_NEAR(phi.max_form({0, 0, 0}), 3.713069518054, 1e-11);
  EXPECT_NEAR(phi.max_form({-3, -4, 2}), -0.147737201218, 1e-11);
  EXPECT_EQ(phi.sign({-3, -4, 2}), -1);
  EXPECT_EQ(phi.sign({4, 1, 7}), 0);
  EXPECT_EQ(phi.sign({0, 2, 7}), 1);
  EXPECT_NEAR(phi.normalised({5, 1, 7}), 1, 1e-14);
}

TEST(PhiFunction, TiesAreAllActive) {
  const PhiFunction phi(box(0, 0, 0, 2, 2, 2), box(0, 0, 0, 2, 2, 2));
  EXPECT_EQ(phi.active({0, 0, 0}).size(), 6u);
  EXPECT_EQ(phi.active({2, 2, 2}).size(), 3u);
  EXPECT_EQ(phi.active({2, 1, 0}).size(), 1u);
  EXPECT_EQ(phi.active({std::nextafter(2, 3), 2, 2}).size(), 1u);
  EXPECT_EQ(phi.depth({0.5, 0, 0}), 1.5);
  EXPECT_EQ(phi.penetration_depth({0.5, 0, 0}).x, 1.5);
  EXPECT_EQ(phi.depth({9, 0, 0}), 0);
  EXPECT_THROW(phi.max_form({std::nan(""), 0, 0}), Error);
  EXPECT_THROW(phi.sign({std::numeric_limits<double>::infinity(), 0, 0}), Error);
}

TEST(PhiFunction, TheSignIsExactOneUlpFromContact) {
  const PhiFunction phi = example();
  // Facet f10: -6x + 5y - 5 = 0 at (0, 1, z); one unit in the last place decides.
  const double y = 1;
  EXPECT_EQ(phi.sign({0, y, 10}), 0);
  EXPECT_EQ(phi.sign({0x1p-1000, y, 10}), 0);
  EXPECT_EQ(phi.sign({0, std::nextafter(y, 2), 10}), 1);
  EXPECT_EQ(phi.sign({-0x1p-1000, y, 10}), 1);
  EXPECT_EQ(phi.sign({0x1p-1000, std::nextafter(y, 0), 10}), -1);
}

TEST(PhiFunction, ExactAtDecimals) {
  const PhiFunction phi(box(0, 0, 0, 10, 10, 10), box(0, 0, 0, 10, 10, 10));
  const Real tenth = Real::ratio(1, 10), tiny = Real::parse_decimal("1e-30");
  const PhiAt apart = phi_at(phi, {Real(10) + tiny, tenth, tenth});
  EXPECT_EQ(apart.state, State::kApart);
  EXPECT_DOUBLE_EQ(apart.max_form, 1e-30);
  EXPECT_DOUBLE_EQ(apart.distance, 1e-30);
  EXPECT_EQ(phi_at(phi, {Real(10) - tiny, tenth, tenth}).state, State::kOverlap);
  const PhiAt corner = phi_at(phi, {Real(13), Real(14), Real(0)});
  EXPECT_EQ(corner.max_form, 4);
  EXPECT_EQ(corner.distance, 5);
  EXPECT_EQ(phi_at(phi, {tenth, tenth, -tenth}).active.size(), 3u);
}

TEST(PhiFunction, HoldsNextToContactAndFarAway) {
  const PhiFunction phi(box(-1, -1, -1, 0, 0, 0), box(0, 0, 0, 1, 1, 1));
  const Real near = Real::parse_decimal("1e-170"), far = Real::parse_decimal("1e140");
  EXPECT_DOUBLE_EQ(phi_at(phi, {near, Real(), Real()}).distance, 1e-170);
  EXPECT_DOUBLE_EQ(phi_at(phi, {far, Real(), Real()}).distance, 1e140);
  EXPECT_THROW(phi_at(phi, {far * far, Real(), Real()}), Error);
}

TEST(PlanarPhiUnion, HoldsNextToContactAndFarAway) {
  const std::vector<Point2> unit{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, before{{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
  const std::vector<PlanarPart> a{{ConvexPolygon::hull(before), {}}}, b{{ConvexPolygon::hull(unit), {}}};
  const PlanarPhiUnion phi(a, b);
  const Real near = Real::parse_decimal("1e-170"), far = Real::parse_decimal("1e140");
  EXPECT_DOUBLE_EQ(phi.at({near, Real()}).at.distance, 1e-170);
  EXPECT_DOUBLE_EQ(phi.at({far, Real()}).at.distance, 1e140);
  EXPECT_THROW(phi.at({far * far, Real()}), Error);
  const std::vector<PlanarPart> disc{{ConvexPolygon::point({0, 0}), Real(1)}};
  const PlanarPhiUnion discs(disc, disc);
  EXPECT_DOUBLE_EQ(discs.at({Real(2) + near * near, Real()}).at.distance, 0);  // less than any double
  EXPECT_DOUBLE_EQ(discs.at({Real(2) + near, Real()}).at.distance, 1e-170);
}

TEST(DepthGrid, GivesTheSameBits) {
  const PhiFunction phi = example();
  const DepthGrid grid(phi);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> draw(-20, 20);
  std::vector<Vector> at;
  for (int i = 0; i < 20000; ++i) at.push_back({draw(random), draw(random), draw(random)});
  for (int v = 0; v < phi.surface().vertex_count(); ++v) at.push_back(phi.vertex(v));
  std::vector<double> fast(at.size()), slow(at.size());
  std::vector<int> facet(at.size());
  grid.evaluate(at, fast, facet);
  phi.evaluate(at, slow);
  for (std::size_t i = 0; i < at.size(); ++i) {
    ASSERT_EQ(fast[i], slow[i]);
    ASSERT_EQ(phi.plane_value(facet[i], at[i]), slow[i]);
  }
}

TEST(PhiUnion, SeamsNeedNoRule) {
  // phi-U01: a plate astride the seam of two boxes.
  const std::vector<Polytope> a{box(0, 0, 0, 20, 40, 40), box(20, 0, 0, 40, 40, 40)}, b{box(19, 10, 10, 21, 30, 30)};
  const PhiUnion phi(a, b);
  EXPECT_EQ(phi.sign({0, 0, 0}), -1);
  EXPECT_EQ(phi.max_form({0, 0, 0}), -1);
  EXPECT_EQ(phi.sign({21, 0, 0}), 0);
  EXPECT_EQ(phi.normalised({22, 0, 0}), 1);
}

TEST(ClosedForms, TheTwoRectangleDiscFormsAgree) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> draw(-4, 4), size(0, 2);
  for (int i = 0; i < 100000; ++i) {
    const Rectangle p{i % 7 == 0 ? 0 : size(random), size(random)};
    const double x = draw(random), y = draw(random), r = i % 5 == 0 ? 0 : size(random);
    ASSERT_NEAR(phi_rectangle_disc(x, y, p, r), phi_rectangle_disc_case_free(x, y, p, r), 4e-15);
  }
  EXPECT_EQ(phi_balls(5, 2, 1), 2);
  EXPECT_EQ(phi_balls_square(5, 2, 1), 16);
  EXPECT_EQ(phi_rectangles(5, 6, {1, 1}, {1, 1}), 4);
  EXPECT_EQ(phi_rectangles_normalised(5, 6, {1, 1}, {1, 1}), 5);
}

TEST(PlanarPhi, EqualsTheRectangleFormAndIsExactInContact) {
  const ConvexPolygon square = ConvexPolygon::hull(std::vector<Point2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {1, 1}});
  ASSERT_EQ(square.vertices().size(), 4u);
  const PlanarPhi phi(square, square);
  ASSERT_EQ(phi.edges().size(), 4u);
  for (const PlanarEdge& e : phi.edges()) EXPECT_EQ(e.contact, PlanarContact::kEE);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> draw(-6, 6);
  for (int i = 0; i < 10000; ++i) {
    const Vector2 u{draw(random), draw(random)};
    ASSERT_NEAR(phi.max_form(u), phi_rectangles(u.x, u.y, {1, 1}, {1, 1}), 1e-14);
    ASSERT_NEAR(phi.normalised(u), phi_rectangles_normalised(u.x, u.y, {1, 1}, {1, 1}), 1e-14);
  }
  EXPECT_EQ(phi.sign({2, 1}), 0);
  EXPECT_EQ(phi.sign({std::nextafter(2, 3), 1}), 1);
  EXPECT_EQ(phi.sign({std::nextafter(2, 0), 1}), -1);
  const ConvexPolygon triangle = ConvexPolygon::hull(std::vector<Point2>{{0, 0}, {4, 1}, {1, 3}});
  const PlanarPhi mixed(square, triangle);
  EXPECT_EQ(mixed.edges().size(), 7u);
  EXPECT_THROW(ConvexPolygon::hull(std::vector<Point2>{{0, 0}, {1, 1}, {2, 2}}), Error);
}

}  // namespace space_phi
}  // namespace findspace::space
