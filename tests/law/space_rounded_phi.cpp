// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Phi-functions of rounded bodies in space against closed forms: balls, capsules, pillows, a box and a ball, rounded
// boxes (the signed distance to the box of the summed half sides, less the radii), and their least value for unions;
// roles exchanged.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "space/body/rounded_phi.h"

namespace findspace::space {
namespace space_rounded_phi {

using exact::Real;
using plane::Shape;
using plane::ShapePtr;
using Kind = plane::Shape::Kind;

ShapePtr solid(Solid s) {
  Shape shape;
  shape.solid = std::make_shared<const Solid>(std::move(s));
  return std::make_shared<const Shape>(std::move(shape));
}

ShapePtr ball(const Point& center, const Real& radius) {
  Solid s;
  s.form = Solid::Form::kBall;
  s.mesh.vertices = {center};
  s.radius = radius;
  return solid(std::move(s));
}

ShapePtr box(const Point& center, const Point& half) {
  Solid s;
  for (int i = 0; i < 8; ++i) {
    s.mesh.vertices.push_back({center.x + (i & 1 ? half.x : -half.x), center.y + (i & 2 ? half.y : -half.y),
                               center.z + (i & 4 ? half.z : -half.z)});
  }
  return solid(std::move(s));
}

ShapePtr node(Kind kind, std::vector<ShapePtr> children, const Real& amount = Real()) {
  Shape shape;
  shape.kind = kind;
  shape.children = std::move(children);
  shape.amount = amount;
  return std::make_shared<const Shape>(std::move(shape));
}

/// A box about a centre with rounded corners; a ball, a capsule or a pillow where sides are 0.
struct Rounded {
  Point center, half;
  Real radius;
  ShapePtr shape() const {
    if (half == Point{0, 0, 0}) return ball(center, radius);
    if (half.x == 0 || half.y == 0 || half.z == 0) return hull_of_balls();
    return radius.sign() > 0 ? node(Kind::kOffset, {box(center, half)}, radius) : box(center, half);
  }
  ShapePtr hull_of_balls() const {
    std::vector<ShapePtr> balls;
    const ShapePtr frame = box(center, half);
    for (const Point& corner : solid_of(*frame)->mesh.vertices) balls.push_back(ball(corner, radius));
    return node(Kind::kHull, std::move(balls));
  }
};

/// The square of the distance less the square of R outside the cores' box: its sign is that of Phi, exactly.
double signed_distance(const Rounded& a, const Rounded& b, const std::array<double, 3>& u, bool max_form) {
  const double at[3] = {u[0] - double(a.center.x - b.center.x), u[1] - double(a.center.y - b.center.y),
                        u[2] - double(a.center.z - b.center.z)};
  const double half[3] = {double(a.half.x + b.half.x), double(a.half.y + b.half.y), double(a.half.z + b.half.z)};
  double out = 0, most = -1e300;
  for (int k = 0; k < 3; ++k) {
    const double q = std::fabs(at[k]) - half[k];
    out += q > 0 ? q * q : 0;
    most = std::max(most, q);
  }
  const double radius = (a.radius + b.radius).to_double();
  if (max_form && radius == 0) return most;
  return (most > 0 ? std::sqrt(out) : most) - radius;
}

int sign_of(State state) { return state == State::kOverlap ? -1 : state == State::kApart; }

TEST(RoundedPhi, HasTheClosedForms) {
  std::mt19937 random(8);
  const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  const auto draw = [&] {
    Rounded r{{pick(-3, 3), pick(-3, 3), pick(-3, 3)}, {0, 0, 0}, Real(pick(0, 3))};
    const int least = r.radius.sign() == 0 ? 1 : -2;
    const auto side = [&] { return std::max(pick(least, 4), 0); };
    if (r.radius.sign() == 0 || pick(0, 2) > 0) r.half = {side(), side(), side()};
    return r;
  };
  int contacts = 0;
  for (int round = 0; round < 300; ++round) {
    const Rounded a = draw(), b = draw();
    const Body p = body(*a.shape()), q = body(*b.shape());
    const RoundedPhi phi(p.parts, q.parts), back(q.parts, p.parts);
    for (int i = 0; i < 20; ++i) {
      // Steps of 1 or of 1/4: many contacts of faces, and of balls at Pythagorean distances.
      const int part = i % 2 ? 1 : 4, c[3] = {pick(-9, 9) * part, pick(-9, 9) * part, pick(-9, 9) * part};
      const RealVector u{Real::ratio(c[0], 4), Real::ratio(c[1], 4), Real::ratio(c[2], 4)};
      const std::array<double, 3> v{c[0] / 4.0, c[1] / 4.0, c[2] / 4.0};
      const RoundedAt at = phi.at(u).at, other = back.at(negated(u)).at;
      const double want = signed_distance(a, b, v, false);
      // The closed form is a root of an integer over 16, less an integer: nearer to 0 than that it is 0.
      const int sign = std::fabs(want) < 1e-9 ? 0 : want < 0 ? -1 : 1;
      ASSERT_EQ(sign_of(at.state), sign);
      ASSERT_NEAR(at.normalised, want, 1e-12);
      ASSERT_NEAR(at.phi, signed_distance(a, b, v, true), 1e-12);
      ASSERT_EQ(at.distance, std::max(at.normalised, 0.0));
      ASSERT_NEAR(length(at.gradient), 1, 1e-12);
      ASSERT_EQ(other.state, at.state);
      ASSERT_NEAR(other.phi, at.phi, 1e-12);
      for (const int rho : {0, 1, 2}) {
        const double over = want - rho;
        ASSERT_EQ(phi.compare_distance(u, Real(rho)), std::fabs(over) < 1e-9 ? 0 : over < 0 ? -1 : 1);
      }
      contacts += sign == 0;
    }
  }
  EXPECT_GT(contacts, 50);
}

TEST(RoundedPhi, OfATiltedTriangleAndABallIsTheDistance) {
  std::mt19937 random(9);
  const auto pick = [&] { return std::uniform_int_distribution<int>(-9, 9)(random); };
  int tried = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Point> corners;
    std::vector<Vector> near;
    for (int k = 0; k < 3; ++k) {
      corners.push_back({pick(), pick(), pick()});
      near.push_back(exact::approx(corners.back()));
    }
    const Vector n = cross(near[1] - near[0], near[2] - near[0]);
    if (length(n) == 0) continue;
    const BodyPart plate = part_of(corners, Real(2)), small{{}, {}, Real(1)};
    const RoundedPhi phi(std::span(&plate, 1), std::span(&small, 1));
    ASSERT_FALSE(phi.pair(0).phi.has_value());
    const Vector u{double(pick()), double(pick()), double(pick())};
    const Vector off = u - nearest_on_polygon(u, scaled(1 / length(n), n), near);
    const RoundedAt at = phi.at(real(u)).at;
    ASSERT_NEAR(at.phi, length(off) - 3, 1e-12);
    ASSERT_NEAR(dot(at.gradient, off), length(off), 1e-12);
    ASSERT_NEAR(length(at.gradient), 1, 1e-12);
    ++tried;
  }
  EXPECT_GT(tried, 150);
}

TEST(RoundedPhi, OfAUnionIsTheLeastOfItsParts) {
  const Rounded a{{0, 0, 0}, {2, 2, 2}, Real()}, b{{6, 0, 0}, {0, 0, 0}, Real(2)}, c{{0, 0, 0}, {0, 0, 0}, Real(1)};
  const Body both = body(*node(Kind::kUnion, {a.shape(), b.shape()})), one = body(*c.shape());
  const RoundedPhi phi(both.parts, one.parts);
  ASSERT_EQ(phi.pair_count(), 2);
  for (int x = -20; x <= 40; ++x) {
    const RealVector u{Real::ratio(x, 2), Real(1), Real(0)};
    const std::array<double, 3> v{x / 2.0, 1, 0};
    const double want = std::min(signed_distance(a, c, v, false), signed_distance(b, c, v, false));
    ASSERT_NEAR(phi.at(u).at.normalised, want, 1e-12);
  }
}

TEST(RoundedPhi, SumsAndHullsKeepTheirCores) {
  const Rounded a{{0, 0, 0}, {2, 1, 3}, Real()}, b{{1, 0, 0}, {0, 0, 0}, Real(2)};
  const Body sum = body(*node(Kind::kMinkowskiSum, {a.shape(), b.shape()}));
  ASSERT_EQ(sum.parts.size(), 1u);
  EXPECT_EQ(sum.parts[0].radius, Real(2));
  EXPECT_EQ(sum.parts[0].vertices().size(), 8u);
  const ShapePtr far = node(Kind::kOffset, {box({9, 9, 9}, {1, 1, 1})}, Real(2));
  const ShapePtr near = node(Kind::kOffset, {a.shape()}, Real(2));
  EXPECT_EQ(body(*node(Kind::kHull, {near, far})).parts.size(), 1u);
  EXPECT_THROW(body(*node(Kind::kHull, {b.shape(), far, a.shape()})), Error);
  EXPECT_THROW(body(*node(Kind::kDifference, {a.shape(), b.shape()})), Error);
}

TEST(ContactSurface, OfAPolytopeAndAPointIsClosed) {
  const Polytope p = Polytope::hull(std::vector<Point>{{0, 0, 0}, {5, 0, 1}, {0, 4, 0}, {1, 1, 6}, {4, 4, 4}});
  const ContactSurface fixed(p, Point{2, 3, 5}), moving(Point{2, 3, 5}, p);
  EXPECT_FALSE(fixed.fault().has_value());
  EXPECT_FALSE(moving.fault().has_value());
  EXPECT_EQ(moving.facet_count(), p.facet_count());
}

TEST(ContactSurface, WithASegmentIsClosed) {
  const Polytope p = Polytope::hull(std::vector<Point>{{0, 0, 0}, {5, 0, 1}, {0, 4, 0}, {1, 1, 6}, {4, 4, 4}});
  const std::vector<Point> ends{{0, 0, 0}, {2, 1, 7}};
  const ContactSurface surface(p.vertices(), ends);
  EXPECT_FALSE(surface.fault().has_value());
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const auto [i, j] = surface.vertex_pair(v);
    EXPECT_EQ(surface.vertices()[v], p.vertices()[i] - ends[j]);
  }
}

TEST(RoundedPhi, RefusesPositionsWhoseSquaresAreNoDoubles) {
  const BodyPart small{{}, {}, Real(1)};
  const RoundedPhi phi(std::span(&small, 1), std::span(&small, 1));
  EXPECT_NO_THROW(phi.at(real(Vector{0x1p400, 0, 0})));
  EXPECT_THROW(phi.at(real(Vector{1e160, 0, 0})), Error);
  EXPECT_THROW(phi.compare_distance(real(Vector{0, -1e160, 0}), Real()), Error);
}

}  // namespace space_rounded_phi
}  // namespace findspace::space
