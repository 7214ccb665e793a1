// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Trees of boxes, an octahedron and balls on lines, against the definition of the tree at single places: also at
// events, on faces and on spheres.
#include <gtest/gtest.h>

#include <random>

#include "findspace/error.h"
#include "space/ray_body.h"
#include "space/shape_rays.h"
#include "space/solid.h"
#include "unit/solid_shapes.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace {

using exact::Real;
using plane::Shape;
using plane::ShapePtr;
using Kind = Shape::Kind;

/// The same as a surface of triangles.
ShapePtr mesh(std::vector<Point> points) {
  const Triangles surface = triangles(Polytope::hull(points));
  Solid solid;
  solid.form = Solid::Form::kMesh;
  solid.mesh.vertices = surface.points;
  for (const auto& f : surface.faces) solid.mesh.faces.emplace_back(f.begin(), f.end());
  return primitive(std::move(solid));
}

/// The definition.
bool holds(const Shape& shape, const RealVector& p) {
  if (const Solid* solid = solid_of(shape)) {
    if (solid->form == Solid::Form::kBall) {
      const RealVector d = minus(p, real(solid->mesh.vertices[0]));
      return dot(d, d) <= solid->radius * solid->radius;
    }
    const Polytope polytope = Polytope::hull(solid->mesh.vertices);
    return std::all_of(polytope.planes().begin(), polytope.planes().end(),
                       [&](const Plane& h) { return HalfSpace(h).value(p).sign() <= 0; });
  }
  const auto child = [&](const ShapePtr& c) { return holds(*c, p); };
  const auto& c = shape.children;
  switch (shape.kind) {
    case Kind::kUnion:
      return std::any_of(c.begin(), c.end(), child);
    case Kind::kIntersection:
      return std::all_of(c.begin(), c.end(), child);
    case Kind::kDifference:
      return child(c[0]) && std::none_of(c.begin() + 1, c.end(), child);
    case Kind::kComplement:
      return !child(c[0]);
    case Kind::kMirror:
      return holds(*c[0], negated(p));
    case Kind::kTranslate:
      return holds(*c[0], minus(p, real(Point{shape.points[0].x, shape.points[0].y, shape.lift})));
    default:
      ADD_FAILURE();
      return false;
  }
}

ShapePtr random_tree(std::mt19937& random, int depth) {
  const auto pick = [&](std::int64_t a, std::int64_t b) {
    return std::uniform_int_distribution<std::int64_t>(a, b)(random);
  };
  if (depth == 0) {
    const Point c{pick(-3, 3), pick(-3, 3), pick(-3, 3)};
    if (pick(0, 2) == 0) return ball(c, pick(1, 4));
    const auto flat = pick(0, 1) == 0 ? hull : mesh;
    if (pick(0, 1) == 0) {
      const std::int64_t r = pick(1, 4);
      return flat({c + Point{r, 0, 0}, c - Point{r, 0, 0}, c + Point{0, r, 0}, c - Point{0, r, 0}, c + Point{0, 0, r},
                   c - Point{0, 0, r}});
    }
    const Point d{c.x + pick(1, 4), c.y + pick(1, 4), c.z + pick(1, 4)};
    std::vector<Point> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? c.x : d.x, i & 2 ? c.y : d.y, i & 4 ? c.z : d.z});
    return flat(corners);
  }
  const auto sub = [&] { return random_tree(random, static_cast<int>(pick(0, depth - 1))); };
  switch (pick(0, 5)) {
    case 0:
      return node(Kind::kUnion, {sub(), sub(), sub()});
    case 1:
      return node(Kind::kIntersection, {sub(), sub()});
    case 2:
      return node(Kind::kDifference, {sub(), sub()});
    case 3:
      return node(Kind::kComplement, {sub()});
    case 4:
      return node(Kind::kMirror, {sub()});
    default:
      return node(Kind::kTranslate, {sub()}, {pick(-2, 2), pick(-2, 2), pick(-2, 2)});
  }
}

TEST(ShapeRays, AgreeWithTheDefinition) {
  std::mt19937 random(7);
  int events = 0;
  for (int round = 0; round < 240; ++round) {
    const ShapePtr tree = random_tree(random, 3);
    const RayGrid grid{round % 3, 2, -13, -12, 3, 4, 8, 7};
    const RaySourcePointer rays = shape_rays(*tree, grid);
    const ShapeBox box = shape_box(*tree);
    const auto ask = [&](int i, int j, const Real& z, std::int8_t sign) {
      RealVector p;
      const auto axis = static_cast<std::size_t>(grid.axis);
      p[(axis + 1) % 3] = Real::ratio(grid.u_at(i), grid.parts);
      p[(axis + 2) % 3] = Real::ratio(grid.v_at(j), grid.parts);
      p[axis] = z / Real(grid.parts);
      ASSERT_EQ(holds(*tree, p), sign < 0) << round << ": " << p[0].text() << " " << p[1].text() << " " << p[2].text();
    };
    for (int j = 0; j < grid.nv; ++j) {
      const RayRow row = rays->row(j);
      for (int i = 0; i < grid.nu; ++i) {
        ASSERT_EQ(row.before[static_cast<std::size_t>(i)] < 0, box.unbounded);
        std::int8_t before = row.before[static_cast<std::size_t>(i)];
        Real below(-60);
        for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
          const RayEvent& event = row.events[static_cast<std::size_t>(e)];
          const Real at = event.at.to_real();
          ask(i, j, (at + below) / Real(2), before);
          ask(i, j, at, event.here);
          before = event.after;
          below = at;
          ++events;
        }
        ask(i, j, Real(60), before);
      }
    }
  }
  EXPECT_GT(events, 2000);
}

/// At places of the cells about the lines: what the shrunk set holds is in the set, and what is in the set the grown
/// one holds.
TEST(ShapeRays, BoundsHoldInTheWholeCell) {
  std::mt19937 random(8);
  int certain = 0, outside = 0;
  for (int round = 0; round < 120; ++round) {
    const ShapePtr tree = random_tree(random, 3);
    const RayGrid grid{round % 3, 2, -13, -12, 3, 4, 8, 7};
    const Real radius = Real::ratio(5, 4);  // half the diagonal of a cell of 3/2 x 2
    const RaySourcePointer shrunk = shape_rays(*tree, grid, -radius), grown = shape_rays(*tree, grid, radius);
    const auto inner = all_rows(*shrunk), outer = all_rows(*grown);
    for (int k = 0; k < 200; ++k) {
      const int i = static_cast<int>(random() % 8), j = static_cast<int>(random() % 7);
      const auto within = [&](std::int64_t size) {
        return std::uniform_int_distribution<std::int64_t>(-size, size)(random);
      };
      RealVector p;
      const auto axis = static_cast<std::size_t>(grid.axis);
      p[(axis + 1) % 3] = Real::ratio(8 * grid.u_at(i) + within(4 * grid.du), 8 * grid.parts);
      p[(axis + 2) % 3] = Real::ratio(8 * grid.v_at(j) + within(4 * grid.dv), 8 * grid.parts);
      p[axis] = Real::ratio(within(60), 8);
      const Real z = p[axis] * Real(grid.parts);
      const bool in = holds(*tree, p);
      const auto row = static_cast<std::size_t>(j);
      const bool sure = sign_at(inner[row], i, z)<0, never = sign_at(outer[row], i, z)> 0;
      ASSERT_TRUE(in || !sure) << round;
      ASSERT_FALSE(in && never) << round;
      certain += sure, outside += never;
    }
  }
  EXPECT_GT(certain, 1000);
  EXPECT_GT(outside, 1000);
}

TEST(ShapeRays, RefusesWhatLinesCannotTell) {
  const RayGrid grid{2, 1, 0, 0, 1, 1, 2, 2};
  const ShapePtr two = node(Kind::kUnion, {ball({0, 0, 0}, 2), ball({3, 0, 0}, 2)});
  EXPECT_THROW(shape_rays(*node(Kind::kInterior, {two}), grid), Error);
  EXPECT_THROW(shape_rays(*node(Kind::kClosure, {node(Kind::kDifference, {two, two})}), grid), Error);
  EXPECT_NO_THROW(shape_rays(*node(Kind::kRegularize, {two}), grid));
}

}  // namespace
}  // namespace findspace::space
