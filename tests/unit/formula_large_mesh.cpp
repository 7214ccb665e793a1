// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances to a mesh of thousands of triangles that its surface tells: no convex parts are made for them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "formula/solid/solve_space.h"
#include "space/mesh/mesh.h"
#include "unit/space_bodies.h"

namespace findspace::formula {
namespace formula_large_mesh {

using exact::Real;

plane::Shape mesh_shape(space::Mesh mesh) {
  clean(mesh, 1);
  space::Solid solid;
  solid.form = space::Solid::Form::kMesh;
  solid.mesh = std::move(mesh);
  plane::Shape shape;
  shape.name = "A";
  shape.solid = std::make_shared<const space::Solid>(std::move(solid));
  return shape;
}

/// A ring about the z axis: the radius of its middle is 1000, that of its tube 400.
plane::Shape ring(int around, int across) {
  space::Mesh mesh;
  const auto vertex = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double far = 1000 + 400 * std::cos(v);
      mesh.vertices.push_back(
          {std::llround(far * std::cos(u)), std::llround(far * std::sin(u)), std::llround(400 * std::sin(v))});
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh_shape(std::move(mesh));
}

SpaceWorld world(const plane::Shape& a, std::int64_t half) {
  SpaceWorld out;
  out.shapes["A"] = space_shape(a);
  out.shapes["B"].body = shared(space::box_body({{{{-half, -half, -half}, {half, half, half}}}}));
  out.moving = {"B"};
  out.step = Real(1);
  return out;
}

Distance named(Kind kind, bool rotated = false) {
  Distance d;
  d.kind = kind;
  d.first = {rotated ? "A" : "B"};
  d.second = {rotated ? "B" : "A"};
  return d;
}

TEST(LargeMesh, NeedsNoParts) {
  const SpaceSolver solver(world(ring(48, 24), 100));
  const auto value = [&](Kind kind, const space::RealVector& p, bool rotated = false) {
    const auto v = solver.value(named(kind, rotated), p);
    return v ? v->value : Real(-1);
  };
  const auto far = space::place(1900, 0, 0), within = space::place(1000, 0, 0), middle = space::place(0, 0, 0),
             across = space::place(1400, 0, 0);
  EXPECT_EQ(value(Kind::kGamma1, far), Real(400));
  EXPECT_EQ(value(Kind::kGamma1, middle).sign(), 1);
  EXPECT_EQ(value(Kind::kD1, across), Real());
  EXPECT_EQ(value(Kind::kPenetration, far), Real());
  EXPECT_EQ(value(Kind::kGamma1, across), Real(-100));
  EXPECT_EQ(value(Kind::kPenetration, across), Real(100));
  const auto fit = solver.value(named(Kind::kEta1), across);
  EXPECT_GT(fit->value, Real(100));
  EXPECT_EQ(value(Kind::kEta1, *fit->nearest), Real());
  EXPECT_GT(value(Kind::kEta2, far), Real(3100));
  EXPECT_EQ(value(Kind::kGamma2, far), sqrt(Real(3400) * Real(3400) + Real(2 * 100 * 100)));
  EXPECT_EQ(value(Kind::kEta1, within).sign(), -1);
  EXPECT_EQ(value(Kind::kEta1, within), value(Kind::kMu, within));
  EXPECT_EQ(value(Kind::kDstar, within, true), -value(Kind::kEta1, within));
  EXPECT_GT(value(Kind::kMu, far), Real(600));  // a corner's
  EXPECT_LT(value(Kind::kMu, far), Real(620));
  EXPECT_EQ(value(Kind::kMu, across).sign(), 1);
  EXPECT_EQ(value(Kind::kHausdorff, far), Real(3200));
  EXPECT_FALSE(solver.value(named(Kind::kDelta1), far));
  EXPECT_FALSE(solver.value(named(Kind::kDelta2), far));
  EXPECT_EQ(value(Kind::kMu, far, true), sqrt(Real(3200) * Real(3200)));
  EXPECT_FALSE(solver.world().shapes.at("A").body.made());
}

/// Two slanted boxes as one mesh, the wall of the one in that of the other; `n` x `n` faces to a side.
plane::Shape rooms(int n) {
  space::Mesh mesh;
  const auto add = [&](const space::Point& low, std::int64_t size) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 2 * n * n; ++k) {
        const int first = static_cast<int>(mesh.vertices.size());
        for (const auto [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          const std::int64_t across[3] = {k < n * n ? 0 : size, (k % n + u) * size / n, (k / n % n + v) * size / n};
          space::Point p = low;
          (axis == 0 ? p.x : axis == 1 ? p.y : p.z) += across[0];
          (axis == 0 ? p.y : axis == 1 ? p.z : p.x) += across[1];
          (axis == 0 ? p.z : axis == 1 ? p.x : p.y) += across[2];
          mesh.vertices.push_back({p.x + p.y, p.y, p.z});
        }
        mesh.faces.push_back({first, first + 1, first + 2, first + 3});
        if (k < n * n) std::reverse(mesh.faces.back().begin(), mesh.faces.back().end());
      }
    }
  };
  add({0, 0, 0}, 120);
  add({120, 40, 40}, 60);
  return mesh_shape(std::move(mesh));
}

/// By its surface as by the parts of the same mesh with fewer faces.
TEST(LargeMesh, WallsWithinAreNoFrontier) {
  const SpaceSolver few(world(rooms(1), 10)), many(world(rooms(4), 10));
  ASSERT_FALSE(few.world().shapes.at("A").surfaces);
  ASSERT_TRUE(many.world().shapes.at("A").surfaces);
  for (const Kind kind : {Kind::kEta1, Kind::kGamma1, Kind::kD1}) {
    for (const auto& p : {space::place(190, 70, 70), space::place(240, 70, 70), space::place(190, 70, 35),
                          space::place(130, 60, 130)}) {
      const auto expected = few.value(named(kind), p), found = many.value(named(kind), p);
      ASSERT_TRUE(expected && found);
      EXPECT_EQ(found->value, expected->value);
    }
  }
  EXPECT_EQ(many.value(named(Kind::kEta1), space::place(190, 70, 70))->value, Real(-20));
}

/// More than convex parts are made of.
TEST(LargeMesh, HundredThousandTriangles) {
  const SpaceSolver solver(world(ring(400, 140), 10));
  const auto v = solver.value(named(Kind::kGamma1), space::place(1910, 0, 0));
  ASSERT_TRUE(v);
  EXPECT_EQ(v->value, Real(500));
  ASSERT_TRUE(v->nearest);
  EXPECT_EQ((*v->nearest)[0], Real(1410));
  EXPECT_EQ(solver.value(named(Kind::kGamma1), space::place(1400, 0, 0))->value, Real(-10));
  EXPECT_GT(solver.value(named(Kind::kEta1), space::place(1400, 0, 0))->value, Real(10));
}

}  // namespace formula_large_mesh
}  // namespace findspace::formula
