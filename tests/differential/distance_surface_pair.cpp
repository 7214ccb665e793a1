// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What surfaces tell of distances against the same from convex parts: star-shaped meshes with dents, polytopes and
// balls, at positions apart, in contact, across each other and inside.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "distance/search/solid_protrusion.h"
#include "distance/surface/surface_pair.h"
#include "space/mesh/mesh.h"
#include "unit/space_bodies.h"

namespace findspace::distance {
namespace distance_surface_pair {

using exact::Real;
using space::RealVector;

const std::vector<Which> kOutside{Which::kGamma1, Which::kD1, Which::kPenetration, Which::kGamma2, Which::kDiameter};
const std::vector<Which> kInside{Which::kEta1, Which::kEta2,   Which::kMu,   Which::kDstarBack,
                                 Which::kH,    Which::kDelta1, Which::kDstar};

/// An octahedron's faces cut in four, the corners at random distances from the middle.
space::Mesh star(std::mt19937& random, int low, int high) {
  const auto pick = [&] { return std::uniform_int_distribution<int>(low, high)(random); };
  space::Mesh mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [slot, fresh] = numbers.emplace(at, static_cast<int>(mesh.vertices.size()));
    const int far = fresh ? pick() : 0;
    if (fresh) mesh.vertices.push_back({at[0] * far, at[1] * far, at[2] * far});
    return slot->second;
  };
  for (int k = 0; k < 8; ++k) {
    const std::array<int, 3> x{k & 1 ? 2 : -2, 0, 0}, y{0, k & 2 ? 2 : -2, 0}, z{0, 0, k & 4 ? 2 : -2};
    const auto middle = [](const auto& p, const auto& q) {
      return std::array<int, 3>{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    };
    const int a = vertex(x), b = vertex(y), c = vertex(z), ab = vertex(middle(x, y)), bc = vertex(middle(y, z)),
              ca = vertex(middle(z, x));
    for (std::vector<int> face : {std::vector{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
      mesh.faces.push_back(face);
  }
  clean(mesh, 1);
  return mesh;
}

struct Given {
  Surfaced surfaced;
  std::shared_ptr<const space::Body> body;
};

Given of_mesh(const space::Mesh& mesh) {
  space::ConvexParts parts = space::convex_parts(mesh);
  space::Body body;
  body.scale = parts.scale;
  body.moved = parts.moved;
  for (space::Polytope& p : parts.parts) body.parts.push_back({std::move(p), {}, Real()});
  auto set = std::make_shared<space::SurfaceSet>();
  set->add({space::RaySolid{triangles(mesh), {}, {}}}, 1);
  const bool convex = body.convex();
  return {{set, Outline::of(set, 1), convex}, shared(std::move(body))};
}

/// Over an L.
space::Mesh corner_room(int size) {
  const std::vector<std::array<int, 2>> ring{{0, 0}, {size, 0}, {size, 8}, {9, 8}, {9, size}, {0, size}};
  space::Mesh mesh;
  std::vector<int> floor, lid;
  for (int k = 0; k < 6; ++k) {
    for (const int z : {-8, 8}) mesh.vertices.push_back({ring[k][0] - 4, ring[k][1] - 4, z});
    const int next = (k + 1) % 6;
    mesh.faces.push_back({2 * k, 2 * next, 2 * next + 1, 2 * k + 1});
    lid.push_back(2 * k + 1);
    floor.insert(floor.begin(), 2 * k);
  }
  mesh.faces.push_back(lid);
  mesh.faces.push_back(floor);
  clean(mesh, 1);
  return mesh;
}

Given of_body(space::Body body) {
  auto set = std::make_shared<space::SurfaceSet>();
  EXPECT_TRUE(set->add(body, body.scale));
  auto made = shared(std::move(body));
  return {{set, made, made->convex(), made}, made};
}

Given drawn(std::mt19937& random, int kind) {
  space::Body body;
  if (kind == 0) return of_mesh(star(random, 5, 9));
  if (kind == 1) return of_mesh(star(random, 1, 3));
  if (kind == 2) body.parts.push_back({std::nullopt, {1, 0, -1}, Real(2)});
  if (kind == 3) body = space::box_body({{{{-1, -2, -1}, {1, 1, 2}}}, {{{1, -2, -1}, {3, 0, 0}}}});
  return of_body(std::move(body));
}

struct Decided {
  int all = 0, depths = 0, fits = 0, proven = 0;  // of them gamma1 below 0; eta1 above 0 and eta2; compared exactly
};

void expect_same(const PairDistances& parts, std::int64_t scale, const PairDistances& surfaces, const RealVector& p,
                 const std::vector<Which>& all, double moved, Decided& decided) {
  for (const Which which : all) {
    const TriedAnswer told = surfaces.try_value(which, p);
    if (!told) continue;
    const std::optional<Answer>& found = *told;
    ++decided.all;
    const auto wanted = parts.value(which, space::scaled(Real(scale), p));
    ASSERT_EQ(found.has_value(), wanted.has_value()) << int(which);
    if (!wanted) continue;
    decided.depths += which == Which::kGamma1 && found->value.sign() < 0;
    decided.fits += which == Which::kEta2 || (which == Which::kEta1 && found->value.sign() > 0);
    const Real value = wanted->value / Real(scale);
    if (wanted->proven && found->proven && moved == 0) {
      ++decided.proven;
      ASSERT_EQ((found->value - value).sign(), 0)
          << int(which) << " " << found->value.to_double() << " " << value.to_double();
    } else {
      ASSERT_NEAR(found->value.to_double(), value.to_double(), 4 * moved + 0x1p-30 * (1 + value.to_double()))
          << int(which);
    }
    if (!found->nearest || (which != Which::kGamma1 && which != Which::kEta1)) continue;
    // At the nearest such position the distance is 0.
    const TriedAnswer there = surfaces.try_value(which, *found->nearest);
    if (!there || !*there) continue;
    if (found->proven)
      ASSERT_EQ((*there)->value.sign(), 0) << int(which);
    else
      ASSERT_NEAR((*there)->value.to_double(), 0, 0x1p-30) << int(which);
  }
}

/// At eight positions.
void compare_all(std::mt19937& random, const Given& a, const Given& b, const std::vector<Which>& all, int reach,
                 Decided& decided) {
  const double moved = a.body->moved + b.body->moved;  // by which the parts are not the mesh
  const std::int64_t scale = std::lcm(a.body->scale, b.body->scale);
  const PairDistances parts = solid_pair(shared(at_scale(*b.body, scale)), shared(at_scale(*a.body, scale)));
  const PairDistances surfaces = surface_pair(b.surfaced, a.surfaced);
  for (int i = 0; i < 8; ++i) {
    const int far = i % 2 == 0 ? 4 : reach;
    const auto pick = [&] { return std::uniform_int_distribution<int>(-far, far)(random); };
    expect_same(parts, scale, surfaces, space::place(pick(), pick(), pick(), 1 + i % 2), all, moved, decided);
  }
}

TEST(SurfacePairs, Outside) {
  std::mt19937 random(77);
  Decided decided;
  for (int round = 0; round < 12; ++round) {
    const Given a = of_mesh(star(random, 5, 9)), b = drawn(random, round % 4);
    compare_all(random, a, b, kOutside, 30, decided);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(decided.all, 300);
  EXPECT_GT(decided.depths, 12);
}

TEST(SurfacePairs, Inside) {
  std::mt19937 random(78);
  Decided decided;
  for (int round = 0; round < 12; ++round) {
    const Given a = of_mesh(corner_room(12 + round)), b = drawn(random, 2 + round % 2);
    compare_all(random, a, b, kInside, 8, decided);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(decided.all, 150);
  EXPECT_GT(decided.fits, 40);
  EXPECT_GT(decided.proven, 300);
}

/// Out of a mesh with dents, in which the farthest place may be.
TEST(SurfacePairs, Protrudes) {
  std::mt19937 random(79);
  const auto pick = [&] { return std::uniform_int_distribution<int>(-20, 20)(random); };
  int corners = 0, decided = 0;
  for (int round = 0; round < 24; ++round) {
    const bool of_stars = round % 3 > 0;
    const Given a = of_mesh(of_stars ? star(random, 3, 9) : corner_room(14)),
                b = drawn(random, of_stars ? 1 + round % 3 : 1);
    const std::int64_t scale = std::lcm(a.body->scale, b.body->scale);
    const PairDistances surfaces = surface_pair(b.surfaced, a.surfaced);
    const RealVector p = space::place(pick(), pick(), pick());
    const TriedAnswer told = surfaces.try_value(Which::kMu, p);
    if (!told || (*told)->value.sign() <= 0) continue;
    const Answer& found = **told;
    const Answer wanted =
        protrusion_of_union(at_scale(*b.body, scale), at_scale(*a.body, scale), space::scaled(Real(scale), p));
    const double value = found.value.to_double(), one = 1 / double(scale);
    ASSERT_NEAR(value, wanted.value.to_double() * one,
                4 * (a.body->moved + b.body->moved) + found.error + wanted.error * one + 0x1p-30 * value)
        << round;
    ASSERT_LT(found.error, of_stars ? 0x1p-20 : 0x1p-6) << round;
    ++decided;
    corners += found.proven;
  }
  EXPECT_GT(decided, 18);
  EXPECT_GT(corners, 5);
}

/// The room in a cup is deepest in the middle of it, on no face of what fills the cup.
TEST(SurfacePairs, DeepestInside) {
  const Given a = of_mesh(corner_room(20)), b = of_body(space::box_body({{{{5, 5, -7}, {16, 16, 7}}}}));
  const PairDistances pair = surface_pair(b.surfaced, a.surfaced);
  const auto found = pair.value(Which::kMu, {});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, Real(11));  // above both walls of the L, at a corner
  space::Body ball;
  ball.parts.push_back({std::nullopt, {8, 8, 0}, Real(2)});
  const auto of_ball = surface_pair(of_body(std::move(ball)).surfaced, a.surfaced).value(Which::kMu, {});
  EXPECT_NEAR(of_ball->value.to_double(), 3.5 + std::sqrt(7) / 2, 0x1p-30);  // on the way between the walls
}

/// A dent that a corner fills exactly: they touch, and do not overlap.
TEST(SurfacePairs, Contact) {
  space::Body room = space::box_body({{{{-9, -9, -9}, {9, 9, 0}}}});
  const Given a = of_body(room), b = of_body(space::box_body({{{{-1, -1, 0}, {1, 1, 2}}}}));
  const PairDistances pair = surface_pair(b.surfaced, a.surfaced);
  const auto value = [&](Which which, const RealVector& p) { return pair.value(which, p)->value; };
  EXPECT_EQ(value(Which::kGamma1, {}).sign(), 0);
  EXPECT_EQ(value(Which::kD1, space::place(0, 0, -1, 1 << 20)).sign(), 0);
  EXPECT_FALSE(pair.try_value(Which::kGamma1, space::place(0, 0, -1, 1 << 20)));
  EXPECT_EQ(value(Which::kGamma1, space::place(0, 0, 1, 3)), Real(1) / Real(3));
  EXPECT_EQ(value(Which::kEta1, space::place(0, 0, -2)).sign(), 0);
}

}  // namespace distance_surface_pair
}  // namespace findspace::distance
