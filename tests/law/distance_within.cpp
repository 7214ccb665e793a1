// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The numbers between which a distance is said to lie hold its exact value: of convex, round and several parts, of
// complements, and of surfaces, with either of the two a mesh.
#include <gtest/gtest.h>

#include <random>

#include "distance/solid/solid_pair.h"
#include "distance/surface/surface_pair.h"
#include "unit/solid_shapes.h"
#include "unit/space_bodies.h"
#include "unit/space_bumps.h"

namespace findspace::distance {
namespace distance_within {

using exact::Interval;
using exact::Real;
using space::Body;
using space::Point;
using space::Vector;

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(engine_);
  }
  Vector place(double reach) {
    std::uniform_real_distribution<double> c(-reach, reach);
    return {c(engine_), c(engine_), c(engine_)};
  }
  /// A ball, a box, a tetrahedron or a segment, perhaps grown.
  space::BodyPart part() {
    const Point at{pick(-9, 9), pick(-9, 9), pick(-9, 9)};
    const std::int64_t x = pick(2, 12), y = pick(2, 12), z = pick(2, 12);
    const auto kind = pick(0, 3);
    if (kind == 0) return space::part_of(std::vector{at}, Real(x));
    std::vector<Point> points{at, at + Point{x, 0, 0}, at + Point{0, y, 0}, at + Point{0, 0, z}};
    if (kind == 1) points.resize(2);
    for (const Point& far : {Point{x, y, 0}, Point{x, 0, z}, Point{0, y, z}, Point{x, y, z}})
      if (kind == 2) points.push_back(at + far);
    return space::part_of(points, Real(kind == 1 ? y : pick(0, 1) * pick(1, 4)));
  }
  Body body(std::int64_t most) {
    Body out;
    for (std::int64_t k = pick(1, most); k > 0; --k) out.parts.push_back(part());
    return out;
  }

 private:
  std::mt19937 engine_;
};

/// How many of the values are bounded on both sides.
int expect_within(const PairDistances& pair, Draw& draw, double reach, std::initializer_list<Which> which) {
  int bounded = 0;
  for (int i = 0; i < 4; ++i) {
    const Vector p = draw.place(reach);
    for (const Which w : which) {
      const Interval found = pair.within(w, p);
      EXPECT_LE(found.lo, found.hi);
      const TriedAnswer v = pair.try_value(w, space::real(p));
      if (!v) continue;
      bounded += std::isfinite(found.lo) && std::isfinite(found.hi) ? 1 : 0;
      if (!*v) {
        EXPECT_EQ(found.hi, exact::kInfinity);
      } else if ((*v)->minus_infinity) {
        EXPECT_EQ(found.lo, -exact::kInfinity);
      } else {
        EXPECT_LE(found.lo, (*v)->value.to_double())
            << static_cast<int>(w) << " at " << p.x << " " << p.y << " " << p.z;
        EXPECT_GE(found.hi, (*v)->value.to_double())
            << static_cast<int>(w) << " at " << p.x << " " << p.y << " " << p.z;
      }
    }
  }
  return bounded;
}

TEST(Within, Solids) {
  Draw draw(5);
  int bounded = 0;
  for (int round = 0; round < 60; ++round) {
    const auto most = 1 + round % 2;
    const Body b = draw.body(most);
    Body a = draw.body(most);
    const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
    bounded += expect_within(pair, draw, 30, {Which::kGamma1, Which::kGamma2, Which::kD1, Which::kPenetration});
    if (most > 1) continue;
    bounded += expect_within(pair, draw, 8, {Which::kMu, Which::kMuBack, Which::kH, Which::kEta1, Which::kDelta1});
    a.outside = true;
    expect_within(solid_pair(space::shared(b), space::shared(a)), draw, 30, {Which::kGamma1, Which::kEta1});
  }
  EXPECT_GT(bounded, 600);
}

/// What a convex one leaves for another is known on both sides: a box in a box and in a tetrahedron, a ball in a ball.
TEST(Within, Fits) {
  Draw draw(8);
  const auto body = [](std::vector<Point> points, std::int64_t radius) {
    return Body{{space::part_of(points, Real(radius))}};
  };
  const Body box = space::box_body({{{{-2, -2, -2}, {2, 1, 3}}}}), ball = body({{1, 0, 0}}, 2);
  const Body room = body({{-20, -20, -20}, {30, -20, -20}, {-20, 30, -20}, {-20, -20, 30}}, 0);
  const Body round_room = body({{1, 2, 3}}, 9), narrow = space::box_body({{{{0, 0, 0}, {4, 3, 4}}}});
  for (const auto& [b, a] :
       std::vector<std::pair<Body, Body>>{{box, room}, {ball, room}, {ball, round_room}, {box, narrow}, {room, box}}) {
    const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
    const int bounded = expect_within(pair, draw, 25, {Which::kEta1});
    EXPECT_EQ(bounded, pair.value(Which::kEta1, space::place(0, 0, 0)) ? 4 : 0);
  }
}

/// In polyhedra of several parts.
TEST(Within, Rooms) {
  Draw draw(6);
  const Body a = space::box_body({{{{0, 0, 0}, {20, 20, 20}}}, {{{20, 0, 0}, {40, 12, 12}}}});
  const Body b = space::box_body({{{{0, 0, 0}, {3, 3, 3}}}});
  const PairDistances pair = solid_pair(space::shared(b), space::shared(a));
  EXPECT_GT(expect_within(pair, draw, 15, {Which::kEta1, Which::kDstarBack}), 0);
  EXPECT_LT(pair.within(Which::kEta1, {10, 5, 5}).hi, -4.99);
}

Surfaced surfaced(const Body& body, std::shared_ptr<space::SurfaceSet> set) {
  const auto shared = std::make_shared<const Body>(body);
  return {std::move(set), shared, body.convex(), shared};
}

TEST(Within, Surfaces) {
  Draw draw(7);
  const space::Mesh mesh = space::knobbly_ball(4, 1000, 3);
  auto rough = std::make_shared<space::SurfaceSet>();
  ASSERT_TRUE(rough->add({space::RaySolid{triangles(mesh), {}, {}}}, 1));
  Surfaced a{rough, nullptr, false, nullptr};
  for (int round = 0; round < 12; ++round) {
    Body b;
    do b.parts = {draw.part()};
    while (b.parts[0].radius.sign() > 0 && !b.parts[0].point());
    auto set = std::make_shared<space::SurfaceSet>();
    ASSERT_TRUE(set->add(b, 1));
    const Surfaced convex = surfaced(b, set);
    EXPECT_GT(expect_within(surface_pair(convex, a), draw, 3000, {Which::kGamma1, Which::kD1}), 0);
    EXPECT_GT(expect_within(surface_pair(a, convex), draw, 3000, {Which::kGamma1}), 0);
    Surfaced other = convex;
    other.convex = false;
    EXPECT_GT(expect_within(surface_pair(other, a), draw, 3000, {Which::kGamma1}), 0);
    // In the middle of the mesh it is not apart.
    EXPECT_EQ(surface_pair(convex, a).within(Which::kGamma1, {0, 0, 0}).lo, -exact::kInfinity);
    EXPECT_EQ(surface_pair(a, convex).within(Which::kGamma1, {0, 0, 0}).lo, -exact::kInfinity);
  }
}

/// Of one mesh the first shell lies outside the other mesh, the second within it.
TEST(Within, ShellsOfAMesh) {
  space::Mesh mesh;
  space::add_box(mesh, {5000, 5000, 5000}, {5020, 5020, 5020});
  space::add_box(mesh, {-10, -10, -10}, {10, 10, 10});
  const auto surfaced_mesh = [](const space::Mesh& of) {
    auto set = std::make_shared<space::SurfaceSet>();
    set->add({space::RaySolid{triangles(of), {}, {}}}, 1);
    return Surfaced{set, nullptr, false, nullptr};
  };
  const Surfaced shells = surfaced_mesh(mesh), rough = surfaced_mesh(space::knobbly_ball(4, 1000, 3));
  EXPECT_EQ(surface_pair(shells, rough).within(Which::kGamma1, {0, 0, 0}).lo, -exact::kInfinity);
  EXPECT_EQ(surface_pair(rough, shells).within(Which::kGamma1, {0, 0, 0}).lo, -exact::kInfinity);
  EXPECT_GT(surface_pair(shells, rough).within(Which::kGamma1, {5000, 0, 0}).lo, 2000);
}

}  // namespace distance_within
}  // namespace findspace::distance
