// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Trees of boxes, an octahedron and balls on lines, against the definition of the tree at single places: also at
// events, on faces and on spheres. Erosions of unions against those of the same sets as differences.
#include <gtest/gtest.h>

#include <random>

#include "findspace/error.h"
#include "space/convolution/ray_body.h"
#include "space/polytope/solid.h"
#include "space/shape/shape_rays.h"
#include "unit/solid_shapes.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_shape_rays {

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

bool holds_open(const Shape& shape, const RealVector& p);
bool holds_closed(const Shape& shape, const RealVector& p);

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
    case Kind::kInterior:
      return holds_open(*c[0], p);
    case Kind::kClosure:
    case Kind::kRegularize:
      return holds_closed(*c[0], p);
    case Kind::kBoundary:
      return holds_closed(*c[0], p) && !holds_open(*c[0], p);
    default:
      ADD_FAILURE();
      return false;
  }
}

/// The interior of trees that lines tell it of.
bool holds_open(const Shape& shape, const RealVector& p) {
  const auto& c = shape.children;
  const auto child = [&](const ShapePtr& s) { return holds_open(*s, p); };
  switch (shape.kind) {
    case Kind::kIntersection:
      return std::all_of(c.begin(), c.end(), child);
    case Kind::kDifference:
      return child(c[0]) && std::none_of(c.begin() + 1, c.end(), [&](const auto& s) { return holds_closed(*s, p); });
    case Kind::kComplement:
      return !holds_closed(*c[0], p);
    case Kind::kMirror:
      return holds_open(*c[0], negated(p));
    case Kind::kTranslate:
      return holds_open(*c[0], minus(p, real(Point{shape.points[0].x, shape.points[0].y, shape.lift})));
    case Kind::kInterior:
    case Kind::kClosure:
    case Kind::kRegularize:
      return child(c[0]);
    case Kind::kUnion:
      return std::any_of(c.begin(), c.end(), child);
    default:
      break;
  }
  const Solid* solid = solid_of(shape);
  if (solid->form == Solid::Form::kBall) {
    const RealVector d = minus(p, real(solid->mesh.vertices[0]));
    return dot(d, d) < solid->radius * solid->radius;
  }
  const Polytope polytope = Polytope::hull(solid->mesh.vertices);
  return std::all_of(polytope.planes().begin(), polytope.planes().end(),
                     [&](const Plane& h) { return HalfSpace(h).value(p).sign() < 0; });
}

/// The closure of trees that lines tell it of.
bool holds_closed(const Shape& shape, const RealVector& p) {
  const auto& c = shape.children;
  const auto child = [&](const ShapePtr& s) { return holds_closed(*s, p); };
  switch (shape.kind) {
    case Kind::kUnion:
      return std::any_of(c.begin(), c.end(), child);
    case Kind::kComplement:
      return !holds_open(*c[0], p);
    case Kind::kMirror:
      return holds_closed(*c[0], negated(p));
    case Kind::kTranslate:
      return holds_closed(*c[0], minus(p, real(Point{shape.points[0].x, shape.points[0].y, shape.lift})));
    case Kind::kInterior:
      return child(c[0]);
    default:
      return holds(shape, p);
  }
}

/// With `sets` also interiors, closures and boundaries.
ShapePtr random_tree(std::mt19937& random, int depth, bool sets = false) {
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
  const auto sub = [&] { return random_tree(random, static_cast<int>(pick(0, depth - 1)), sets); };
  switch (pick(0, sets ? 9 : 5)) {
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
    case 6:
    case 7:
      return node(Kind::kInterior, {sub()});
    case 8:
      return node(Kind::kClosure, {sub()});
    case 9:
      return node(Kind::kBoundary, {sub()});
    default:
      return node(Kind::kTranslate, {sub()}, {pick(-2, 2), pick(-2, 2), pick(-2, 2)});
  }
}

/// At events and between them; how many there are.
template <class Holds>
int check_rays(const RaySource& rays, const RayGrid& grid, Holds&& holds_at) {
  int events = 0;
  const auto ask = [&](int i, int j, const Real& z, std::int8_t sign) {
    RealVector p;
    const auto axis = static_cast<std::size_t>(grid.axis);
    p[(axis + 1) % 3] = Real::ratio(grid.u_at(i), grid.parts);
    p[(axis + 2) % 3] = Real::ratio(grid.v_at(j), grid.parts);
    p[axis] = z / Real(grid.parts);
    EXPECT_EQ(holds_at(p), sign < 0) << p[0].text() << " " << p[1].text() << " " << p[2].text();
  };
  for (int j = 0; j < grid.nv && !testing::Test::HasFailure(); ++j) {
    const RayRow row = rays.row(j);
    for (int i = 0; i < grid.nu; ++i) {
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
  return events;
}

TEST(ShapeRays, AgreeWithTheDefinition) {
  std::mt19937 random(7);
  int events = 0;
  for (int round = 0; round < 240 && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const ShapePtr tree = random_tree(random, 3);
    const RayGrid grid{round % 3, 2, -13, -12, 3, 4, 8, 7};
    const RaySourcePointer rays = shape_rays(*tree, grid);
    const bool unbounded = shape_box(*tree).unbounded;
    for (const std::int8_t before : rays->row(3).before) ASSERT_EQ(before < 0, unbounded);
    events += check_rays(*rays, grid, [&](const RealVector& p) { return holds(*tree, p); });
  }
  EXPECT_GT(events, 2000);
}

TEST(ShapeRays, InteriorsClosuresAndBoundariesAgreeWithTheDefinition) {
  std::mt19937 random(9);
  int events = 0, decided = 0;
  for (int round = 0; round < 400 && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    const ShapePtr tree = random_tree(random, 3, true);
    const RayGrid grid{round % 3, 2, -13, -12, 3, 4, 8, 7};
    RaySourcePointer rays;
    try {
      rays = shape_rays(*tree, grid);
    } catch (const Error& e) {
      ASSERT_EQ(e.code(), ErrorCode::kUnsupported);
      continue;
    }
    ++decided;
    events += check_rays(*rays, grid, [&](const RealVector& p) { return holds(*tree, p); });
  }
  EXPECT_GT(decided, 200);
  EXPECT_GT(events, 2000);
}

ShapePtr offset(ShapePtr of, const Real& by) {
  Shape shape;
  shape.kind = Kind::kOffset;
  shape.children = {std::move(of)};
  shape.amount = by;
  return std::make_shared<const Shape>(std::move(shape));
}

/// Whether the ball of radius r about p is in the shape: a primitive or what some have in common.
bool holds_ball(const Shape& shape, const RealVector& p, const Real& r) {
  const Solid* solid = solid_of(shape);
  if (!solid)
    return std::all_of(shape.children.begin(), shape.children.end(),
                       [&](const auto& c) { return holds_ball(*c, p, r); });
  if (solid->form == Solid::Form::kBall) {
    const RealVector d = minus(p, real(solid->mesh.vertices[0]));
    return r <= solid->radius && dot(d, d) <= (solid->radius - r) * (solid->radius - r);
  }
  const Polytope polytope = Polytope::hull(solid->mesh.vertices);
  return std::all_of(polytope.planes().begin(), polytope.planes().end(), [&](const Plane& h) {
    const RealVector n = HalfSpace(h).normal;
    return HalfSpace(h).value(p) + r * sqrt(dot(n, n)) <= Real();
  });
}

TEST(ShapeRays, MinkowskiDifferencesAgreeWithTheDefinition) {
  std::mt19937 random(10);
  int events = 0, empty = 0;
  for (int round = 0; round < 600 && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    ShapePtr a = random_tree(random, 0);
    if (round % 3 == 0) a = node(Kind::kIntersection, {a, random_tree(random, 0)});
    const ShapePtr b = random_tree(random, 0);
    const Solid& by = *solid_of(*b);
    const bool round_b = by.form == Solid::Form::kBall;
    const Real r = Real::ratio(1 + round % 5, 2);
    const RayGrid grid{round % 3, 2, -13, -12, 3, 4, 8, 7};
    const bool shrunk = round % 2 == 0;
    RaySourcePointer rays;
    try {
      rays = shape_rays(shrunk ? *offset(a, -r) : *node(Kind::kMinkowskiDifference, {a, b}), grid);
    } catch (const Error& e) {
      ASSERT_EQ(e.code(), ErrorCode::kGeometry) << e.what();
      ++empty;
      continue;
    }
    events += check_rays(*rays, grid, [&](const RealVector& p) {
      if (shrunk) return holds_ball(*a, p, r);
      if (round_b) return holds_ball(*a, minus(p, real(by.mesh.vertices[0])), by.radius);
      return std::all_of(by.mesh.vertices.begin(), by.mesh.vertices.end(),
                         [&](const Point& q) { return holds(*a, minus(p, real(q))); });
    });
  }
  EXPECT_GT(events, 500);
  EXPECT_LT(empty, 400);
}

ShapePtr block(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return hull(std::move(corners));
}

/// An L as a union, and as a block less a corner: what is outside is found from cells, or stated.
TEST(ShapeRays, ShrunkUnionsAreTheShrunkDifferences) {
  const ShapePtr both = node(Kind::kUnion, {block({-6, -6, -5}, {6, 0, 5}), block({-6, -6, -5}, {1, 6, 5})});
  const ShapePtr less = node(
      Kind::kDifference, {block({-6, -6, -5}, {6, 6, 5}), node(Kind::kInterior, {block({1, 0, -20}, {20, 20, 20})})});
  const ShapePtr by[] = {hull({{0, 0, 0}, {2, 1, 0}, {0, 2, 1}, {1, 0, 2}}), ball({1, 0, 0}, 2),
                         block({0, 0, 0}, {3, 1, 2}), node(Kind::kHull, {ball({0, 0, 0}, 1), ball({1, 2, 0}, 1)})};
  const RayGrid grid{2, 2, -13, -12, 1, 1, 25, 25};
  const auto agree = [&](const Shape& a, const Shape& b) {
    const RaySourcePointer of_a = shape_rays(a, grid), of_b = shape_rays(b, grid);
    const auto first = all_rows(*of_a), second = all_rows(*of_b);
    int inside = 0;
    for (std::size_t j = 0; j < first.size(); ++j) {
      for (int i = 0; i < grid.nu; ++i) {
        for (int z = -24; z <= 24; ++z) {
          const int sign = sign_at(first[j], i, Real::ratio(z, 2));
          ASSERT_EQ(sign, sign_at(second[j], i, Real::ratio(z, 2)));
          inside += sign < 0;
        }
      }
    }
    EXPECT_GT(inside, 100);
  };
  for (const ShapePtr& b : by)
    agree(*node(Kind::kMinkowskiDifference, {both, b}), *node(Kind::kMinkowskiDifference, {less, b}));
  agree(*offset(both, Real::ratio(-5, 4)), *offset(less, Real::ratio(-5, 4)));
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
      certain += sure;
      outside += never;
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
  EXPECT_THROW(shape_rays(*offset(two, Real(-1)), grid), Error);
}

}  // namespace space_shape_rays
}  // namespace findspace::space
