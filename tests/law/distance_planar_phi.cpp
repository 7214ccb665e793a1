// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Phi-function of the plane, made of convex parts, against gamma1, made of the exact contact map of the whole
// shapes: one sign everywhere, one distance outside, and inside the same depth for convex pairs, a lower bound of it
// for others.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "distance/planar/signed_distance.h"
#include "plane/build/build.h"
#include "plane/query/topology.h"
#include "space/phi/planar_phi_union.h"
#include "space/polytope/closed_forms.h"

namespace findspace::distance {
namespace distance_planar_phi {

using exact::Real;
using exact::RealPoint;
using plane::Shape;
using plane::ShapePtr;
using Kind = plane::Shape::Kind;

ShapePtr phi_node(Kind kind, std::vector<ShapePtr> children) {
  Shape shape;
  shape.kind = kind;
  shape.children = std::move(children);
  return std::make_shared<const Shape>(std::move(shape));
}

ShapePtr rings(const std::vector<std::vector<plane::GridPoint>>& corners) {
  Shape shape;
  shape.kind = Kind::kRings;
  for (const auto& ring : corners) {
    plane::Contour& contour = shape.contours.emplace_back();
    for (const plane::GridPoint& p : ring) contour.push_back({.start = p});
  }
  return std::make_shared<const Shape>(std::move(shape));
}

ShapePtr disc(std::int64_t x, std::int64_t y, const Real& radius) {
  Shape shape;
  shape.kind = Kind::kDisc;
  shape.points = {{x, y}};
  shape.amount = radius;
  return std::make_shared<const Shape>(std::move(shape));
}

ShapePtr offset(const ShapePtr& of, const Real& by) {
  Shape shape;
  shape.kind = Kind::kOffset;
  shape.amount = by;
  shape.children = {of};
  return std::make_shared<const Shape>(std::move(shape));
}

/// A position that is likely to be a contact.
RealPoint on_the_curve(const space::PlanarPair& pair, std::int64_t which, const Real& scale) {
  const auto edges = pair.edges();
  const Real half = Real::ratio(1, 2);
  if (edges.empty()) return {(Real(pair.apex.x) + pair.radius) / scale, Real(pair.apex.y) / scale};
  const auto e = static_cast<std::size_t>(which) % edges.size();
  const space::Point2 &p = edges[e].start, &q = edges[(e + 1) % edges.size()].start;
  const Real x = Real(p.x + q.x) * half + pair.radius * Real(edges[e].normal.x),
             y = Real(p.y + q.y) * half + pair.radius * Real(edges[e].normal.y);
  return {x / scale, y / scale};
}

class Bodies {
 public:
  explicit Bodies(unsigned seed) : random_(seed) {}
  std::int64_t number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  RealPoint position() { return {Real::ratio(number(-56, 56), 4), Real::ratio(number(-56, 56), 4)}; }

  ShapePtr convex() {
    switch (number(0, 3)) {
      case 0:
        return disc(number(-2, 2), number(-2, 2), Real::ratio(number(1, 9), number(1, 3)));
      case 1:
        return box();
      case 2:
        return offset(box(), Real::ratio(number(1, 8), 3));
      default:
        return rings({{{0, 0}, {number(3, 8), number(-2, 2)}, {number(0, 3), number(3, 7)}}});
    }
  }

  ShapePtr any() {
    switch (number(0, 7)) {
      case 0:
        return phi_node(Kind::kUnion, {box(), convex(), box()});
      case 1:
        return rings({{{-4, -4}, {5, -4}, {5, 4}, {-4, 4}}, {{-2, -2}, {-2, number(-1, 3)}, {number(-1, 3), -2}}});
      case 2:
        return rings({{{0, 0}, {6, 0}, {6, number(4, 6)}, {4, 4}, {number(2, 3), 2}, {1, 5}, {0, 5}}});
      case 3:  // a hole that touches the outer ring, and what two boxes leave of a box: vertices off the grid
        return phi_node(Kind::kDifference,
                        {rings({{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}}),
                         phi_node(Kind::kInterior, {rings({{{-5, -5}, {number(-2, 1), -3}, {-3, number(-2, 1)}}})}),
                         rings({{{0, 7}, {number(1, 3), 0}, {7, number(1, 6)}}})});
      case 4:
        return phi_node(Kind::kMirror, {any()});
      case 5:
        return offset(rings({{{0, 0}, {6, 0}, {6, 1}, {1, 1}, {1, 6}, {0, 6}}}), Real::ratio(number(1, 4), 2));
      case 6:
        return phi_node(Kind::kMinkowskiSum, {box(), convex()});
      default:
        return phi_node(Kind::kHull, {phi_node(Kind::kUnion, {box(), box()})});
    }
  }

 private:
  ShapePtr box() {
    const std::int64_t x = number(-5, 3), y = number(-5, 3), w = number(1, 6), h = number(1, 6);
    return rings({{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}});
  }
  std::mt19937 random_;
};

int sign_of(space::State state) { return state == space::State::kOverlap ? -1 : state == space::State::kApart; }

struct Case {
  space::PlanarPhiUnion phi;
  SignedDistance oracle;
  Real scale;
};

Case pair_of(const ShapePtr& a, const ShapePtr& b) {
  const auto p = space::planar_parts(*a), q = space::planar_parts(*b);
  EXPECT_TRUE(p && q);
  const std::int64_t scale = std::lcm(p->scale, q->scale);
  return {space::PlanarPhiUnion(*space::at_scale(*p, scale), *space::at_scale(*q, scale)),
          SignedDistance::gamma1(plane::closure(plane::build(*b).region), plane::closure(plane::build(*a).region)),
          Real(scale)};
}

void compare_at(const Case& c, const RealPoint& u, bool convex, int& contacts) {
  const auto found = c.phi.at({u.x * c.scale, u.y * c.scale}).at;
  const Real truth = c.oracle.value(u)->value;
  const double scale = c.scale.to_double(), value = truth.to_double();
  ASSERT_EQ(sign_of(found.state), truth.sign()) << u.x.text() << ", " << u.y.text();
  contacts += truth.sign() == 0;
  if (truth.sign() > 0 || convex)
    ASSERT_NEAR(found.normalised / scale, value, 1e-12 * (1 + std::fabs(value)));
  else
    ASSERT_GE(found.normalised / scale, value - 1e-12);
  ASSERT_LE(found.phi, found.normalised + 1e-12);
  ASSERT_NEAR(std::hypot(found.gradient.x, found.gradient.y), 1, 1e-12);
  // Limits, at the distance itself as well (one of its roots is rational where the value is).
  for (const Real& rho : {Real(), Real::ratio(1, 2), Real(3), truth.sign() > 0 ? truth : Real(1)}) {
    const int want = truth.sign() > 0 || rho.sign() > 0 ? compare(truth, rho) : truth.sign();
    ASSERT_EQ(c.phi.compare_distance({u.x * c.scale, u.y * c.scale}, rho * c.scale), want);
  }
}

TEST(PlanarPhiLaws, ConvexPairsAreTheSignedDistance) {
  Bodies random(5);
  int contacts = 0;
  for (int round = 0; round < 120; ++round) {
    const Case c = pair_of(random.convex(), random.convex());
    for (int i = 0; i < 20; ++i) {
      compare_at(c, i % 2 ? random.position() : on_the_curve(c.phi.pair(0), i / 2, c.scale), true, contacts);
      if (::testing::Test::HasFatalFailure()) FAIL() << "round " << round;
    }
  }
  EXPECT_GT(contacts, 100);
}

TEST(PlanarPhiLaws, UnionsHaveItsSignAndItsDistanceOutside) {
  Bodies random(6);
  int contacts = 0;
  for (int round = 0; round < 120; ++round) {
    const ShapePtr a = random.any(), b = random.number(0, 1) ? random.any() : random.convex();
    const Case c = pair_of(a, b);
    for (int i = 0; i < 20; ++i) {
      const auto k = static_cast<int>(random.number(0, c.phi.pair_count() - 1));
      compare_at(c, i % 2 ? random.position() : on_the_curve(c.phi.pair(k), i / 2, c.scale), false, contacts);
      if (::testing::Test::HasFatalFailure())
        FAIL() << "round " << round << ", kinds " << static_cast<int>(a->kind) << ", " << static_cast<int>(b->kind);
    }
  }
  EXPECT_GT(contacts, 100);
}

TEST(PlanarPhiLaws, ClosedFormsAndOtherForms) {
  Bodies random(7);
  for (int round = 0; round < 200; ++round) {
    const std::int64_t a = random.number(1, 5), b = random.number(1, 5), r = random.number(1, 4);
    const RealPoint u = random.position();
    const double x = u.x.to_double(), y = u.y.to_double();
    const ShapePtr p = rings({{{-a, -b}, {a, -b}, {a, b}, {-a, b}}}), d = disc(0, 0, Real(r));
    const space::Rectangle sides{static_cast<double>(a), static_cast<double>(b)};
    const double radius = static_cast<double>(r);
    const Case mixed = pair_of(p, d), rectangles = pair_of(p, p), discs = pair_of(d, d);
    EXPECT_NEAR(mixed.phi.at(u).at.phi, space::phi_rectangle_disc(x, y, sides, radius), 1e-12);
    EXPECT_NEAR(*space::other_forms(mixed.phi.pair(0), u).case_free, mixed.phi.at(u).at.phi, 1e-12);
    EXPECT_NEAR(rectangles.phi.at(u).at.phi, space::phi_rectangles(x, y, sides, sides), 1e-12);
    EXPECT_NEAR(rectangles.phi.at(u).at.normalised, space::phi_rectangles_normalised(x, y, sides, sides), 1e-12);
    const double square = space::other_forms(discs.phi.pair(0), u).square->to_double();
    EXPECT_NEAR(square, space::phi_balls_square(std::hypot(x, y), radius, radius), 1e-12);
    EXPECT_NEAR(discs.phi.at(u).at.phi, space::phi_balls(std::hypot(x, y), radius, radius), 1e-12);
  }
}

TEST(PlanarPhi, RefusesWhatIsNoBody) {
  const ShapePtr box = rings({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}), other = rings({{{2, 0}, {4, 0}, {4, 2}, {2, 2}}});
  EXPECT_THROW(space::planar_parts(*phi_node(Kind::kComplement, {box})), Error);
  EXPECT_THROW(space::planar_parts(*phi_node(Kind::kBoundary, {box})), Error);
  EXPECT_THROW(space::planar_parts(*phi_node(Kind::kIntersection, {box, other})), Error);
  EXPECT_THROW(space::planar_parts(*phi_node(Kind::kDifference, {box, box})), Error);
  EXPECT_THROW(space::planar_parts(*phi_node(Kind::kUnion, {box, phi_node(Kind::kBoundary, {other})})), Error);
  // A curve inside the body adds nothing to it.
  EXPECT_TRUE(space::planar_parts(*phi_node(Kind::kUnion, {box, phi_node(Kind::kBoundary, {box})})));
  // An arc that bounds no disc: not by parts.
  EXPECT_FALSE(space::planar_parts(*phi_node(Kind::kIntersection, {box, disc(0, 0, Real(2))})));
}

}  // namespace distance_planar_phi
}  // namespace findspace::distance
