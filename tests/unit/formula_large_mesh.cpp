// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances to a mesh of thousands of triangles that its surface tells: no convex parts are made for them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formula/solid/solve_space.h"
#include "space/mesh/mesh.h"
#include "unit/space_bodies.h"

namespace findspace::formula {
namespace formula_large_mesh {

using exact::Real;

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
  clean(mesh, 1);
  space::Solid solid;
  solid.form = space::Solid::Form::kMesh;
  solid.mesh = std::move(mesh);
  plane::Shape shape;
  shape.name = "A";
  shape.solid = std::make_shared<const space::Solid>(std::move(solid));
  return shape;
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
