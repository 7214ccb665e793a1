// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Meshes: what is repaired, what is refused and how that is said; convex parts whose volumes add up exactly.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "space/body/convex_parts.h"
#include "space/mesh/mesh.h"
#include "space/phi/phi_union.h"

namespace findspace::space {
namespace space_mesh {

Mesh cube(std::int64_t size) {
  Mesh m;
  for (int i = 0; i < 8; ++i) m.vertices.push_back({i & 1 ? size : 0, i & 2 ? size : 0, i & 4 ? size : 0});
  m.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return m;
}

/// A prism over a polygon (counter-clockwise from above).
Mesh prism(const std::vector<std::array<std::int64_t, 2>>& polygon, std::int64_t height) {
  Mesh m;
  const int n = static_cast<int>(polygon.size());
  std::vector<int> top, bottom;
  for (int i = 0; i < n; ++i) {
    m.vertices.push_back({polygon[i][0], polygon[i][1], 0});
    m.vertices.push_back({polygon[i][0], polygon[i][1], height});
    top.push_back(2 * i + 1);
    bottom.insert(bottom.begin(), 2 * i);
    const int j = (i + 1) % n;
    m.faces.push_back({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
  }
  m.faces.push_back(top);
  m.faces.push_back(bottom);
  return m;
}

exact::Real volumes(const ConvexParts& parts) {
  exact::Real sum;
  for (const Polytope& p : parts.parts) {
    Mesh m{{p.vertices().begin(), p.vertices().end()}, {}};
    for (int f = 0; f < p.facet_count(); ++f) m.faces.push_back(p.circuit(f));
    sum += six_volumes(m);
  }
  return sum;
}

void expect_exact_parts(Mesh mesh, std::size_t most) {
  clean(mesh, 1);
  const ConvexParts parts = convex_parts(mesh);
  EXPECT_EQ(parts.rounded, 0);
  EXPECT_LE(parts.parts.size(), most);
  const exact::Real cube_of_scale = exact::Real(parts.scale) * exact::Real(parts.scale) * exact::Real(parts.scale);
  EXPECT_TRUE(volumes(parts) == six_volumes(mesh) * cube_of_scale);
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.parts.size(); ++j) {
      // Interiors do not meet: the origin is not inside A_i - A_j.
      EXPECT_GE(PhiFunction(parts.parts[i], parts.parts[j]).sign({0, 0, 0}), 0);
    }
  }
}

/// The cube of edge `size` at (x, x, x), added with its faces inward or outward.
void add_cube(Mesh& m, std::int64_t x, std::int64_t size, bool inward) {
  Mesh c = cube(size);
  const int first = static_cast<int>(m.vertices.size());
  for (const Point& p : c.vertices) m.vertices.push_back({p.x + x, p.y + x, p.z + x});
  for (auto& face : c.faces) {
    if (inward) std::reverse(face.begin(), face.end());
    for (int& v : face) v += first;
    m.faces.push_back(face);
  }
}

TEST(Mesh, TurnsShellsByTheirNesting) {
  // A cube, a cavity in it, an island in the cavity, and a cube apart.
  Mesh right;
  add_cube(right, 0, 9, false);
  add_cube(right, 2, 5, true);
  add_cube(right, 3, 2, false);
  add_cube(right, 20, 3, false);
  const exact::Real volume(6 * (729 - 125 + 8 + 27));
  Mesh as_stated = right;
  EXPECT_TRUE(clean(as_stated, 1).empty());
  EXPECT_TRUE(six_volumes(as_stated) == volume);
  const auto rotation = [](Mesh& m, std::size_t from, std::size_t to) {
    for (std::size_t f = from; f < to; ++f) std::reverse(m.faces[f].begin(), m.faces[f].end());
  };
  for (const auto& [from, to] : {std::pair{0, 24}, {18, 24}, {0, 18}, {7, 9}, {0, 1}, {1, 5}, {13, 20}}) {
    Mesh m = right;
    rotation(m, std::size_t(from), std::size_t(to));
    EXPECT_EQ(clean(m, 1).size(), 1u) << from;
    EXPECT_TRUE(six_volumes(m) == volume) << from;
  }
  Mesh filled = right;
  rotation(filled, 6, 12);  // what would be a cavity points outward
  EXPECT_THROW(clean(filled, 1), Error);
}

TEST(Mesh, TurnsFacesOutward) {
  Mesh m = cube(2);
  std::reverse(m.faces[0].begin(), m.faces[0].end());
  std::reverse(m.faces[3].begin(), m.faces[3].end());
  EXPECT_EQ(clean(m, 1), std::vector<std::string>{"2 faces were reversed to point outward"});
  EXPECT_TRUE(six_volumes(m) == exact::Real(48));
  EXPECT_TRUE(is_convex(m));
  for (auto& face : m.faces) std::reverse(face.begin(), face.end());
  clean(m, 1);
  EXPECT_TRUE(six_volumes(m) == exact::Real(48));
}

/// Edges that all bend outward, and a sphere's Euler number, but twice about.
TEST(Mesh, WhatGoesRoundTwiceIsNotConvex) {
  const std::vector<Point> star{{1000, 0, 0}, {-809, 588, 0}, {309, -951, 0}, {309, 951, 0}, {-809, -588, 0}};
  Mesh pyramids{star, {}}, prism{star, {}};
  for (const Point& p : star) prism.vertices.push_back(p + Point{0, 0, 300});
  pyramids.vertices.insert(pyramids.vertices.end(), {{0, 0, 500}, {0, 0, -500}});
  prism.vertices.insert(prism.vertices.end(), {{0, 0, 0}, {0, 0, 300}});
  for (int k = 0; k < 5; ++k) {
    const int next = (k + 1) % 5;
    pyramids.faces.insert(pyramids.faces.end(), {{k, next, 5}, {next, k, 6}});
    prism.faces.insert(prism.faces.end(), {{k, next, next + 5, k + 5}, {next, k, 10}, {k + 5, next + 5, 11}});
  }
  for (Mesh* mesh : {&pyramids, &prism}) {
    EXPECT_TRUE(clean(*mesh, 1).empty());
    EXPECT_FALSE(is_convex(*mesh));
  }
}

TEST(Mesh, WeldsAndSplitsEdges) {
  // A triangle soup of the cube, with the top cut in two halves that meet its sides in T-junctions.
  Mesh m = cube(2);
  Mesh soup;
  const auto add = [&](std::vector<Point> corners) {
    std::vector<int> face;
    for (const Point& p : corners) {
      face.push_back(static_cast<int>(soup.vertices.size()));
      soup.vertices.push_back(p);
    }
    soup.faces.push_back(face);
  };
  for (std::size_t f = 0; f < m.faces.size(); ++f) {
    if (f == 1) continue;
    std::vector<Point> corners;
    for (const int v : m.faces[f]) corners.push_back(m.vertices[v]);
    add({corners[0], corners[1], corners[2]});
    add({corners[0], corners[2], corners[3]});
  }
  add({{0, 0, 2}, {1, 0, 2}, {1, 2, 2}, {0, 2, 2}});
  add({{1, 0, 2}, {2, 0, 2}, {2, 2, 2}, {1, 2, 2}});
  add({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});  // without area
  clean(soup, 1);
  EXPECT_TRUE(is_convex(soup));
  EXPECT_TRUE(six_volumes(soup) == exact::Real(48));
}

TEST(Mesh, ARepairMovesNoVertexFartherThanAsked) {
  Mesh soup;
  const Mesh m = cube(100);
  for (std::size_t f = 0; f < m.faces.size(); ++f)
    for (const std::size_t k : {1, 2}) {
      for (const std::size_t c : {std::size_t{0}, k, k + 1}) {
        const Point& p = m.vertices[std::size_t(m.faces[f][c])];
        soup.vertices.push_back({p.x + std::int64_t(f % 2), p.y, p.z + std::int64_t(k == 2)});
      }
      const int n = int(soup.vertices.size());
      soup.faces.push_back({n - 3, n - 2, n - 1});
    }
  Mesh mended = soup, open = soup;
  EXPECT_THROW(clean(open, 1), Error);
  const auto notes = clean(mended, 1, {.width = 2});
  EXPECT_FALSE(notes.empty());
  for (const Point& p : mended.vertices)
    EXPECT_TRUE(std::find(soup.vertices.begin(), soup.vertices.end(), p) != soup.vertices.end());
  EXPECT_NEAR(six_volumes(mended).to_double(), 6e6, 6 * 2 * 60000);
  mended = soup;
  mended.faces.pop_back();
  open = mended;
  EXPECT_THROW(clean(mended, 1, {.width = 2, .hole = 100}), Error);
  clean(open, 1, {.width = 2, .hole = 150});
  EXPECT_NEAR(six_volumes(open).to_double(), 6e6, 6 * 2 * 60000);
}

TEST(Mesh, ARepairWiderThanItsFacesEnds) {
  Mesh m;
  m.vertices = {{0, 2, 0}, {1, 2, 3}, {1, 2, 0}, {0, 0, 3}, {0, 2, 3}, {1, 0, 0}, {1, 0, 3}};
  m.faces = {{0, 1, 2}, {3, 4, 0}, {5, 1, 6}};
  EXPECT_THROW(clean(m, 1, {.width = 2}), Error);
}

TEST(Mesh, RefusesOpenSurfacesAndListsTheEdges) {
  Mesh m = cube(2);
  m.faces.pop_back();
  try {
    clean(m, 0.5);
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kGeometry);
    EXPECT_NE(e.message().find("4 open edges"), std::string::npos);
    EXPECT_NE(e.message().find("(1, 1, 0)-(1, 0, 0) in 1 face"), std::string::npos) << e.message();
  }
  Mesh empty;
  EXPECT_THROW(clean(empty, 1), Error);
  Mesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  EXPECT_THROW(clean(flat, 1), Error);
}

TEST(ConvexParts, OfAnLAUAndAStar) {
  expect_exact_parts(cube(3), 1);
  expect_exact_parts(prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 2), 2);
  expect_exact_parts(prism({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 2), 3);
  // A star: cuts meet edges off the grid, so the parts come on a finer one.
  expect_exact_parts(
      prism({{0, -9}, {3, -3}, {9, -2}, {5, 3}, {6, 9}, {0, 6}, {-6, 9}, {-5, 3}, {-9, -2}, {-3, -3}}, 5), 12);
}

TEST(ConvexParts, OfASolidWithACavity) {
  // A cube with a cubic bubble: two nested surfaces, the inner one rotated inward.
  Mesh outer = cube(6), inner = cube(2);
  for (const auto& face : inner.faces) {
    outer.faces.emplace_back(face.rbegin(), face.rend());
    for (int& v : outer.faces.back()) v += 8;
  }
  for (const Point& p : inner.vertices) outer.vertices.push_back(p + Point{2, 2, 2});
  expect_exact_parts(outer, 8);
}

TEST(ConvexParts, OfTreesOfShapes) {
  const auto leaf = [](const Solid& solid) {
    plane::Shape shape;
    shape.solid = std::make_shared<const Solid>(solid);
    return std::make_shared<const plane::Shape>(std::move(shape));
  };
  Solid box, ball;
  box.mesh = cube(2);
  ball.form = Solid::Form::kBall;
  plane::Shape sum, mirror;
  sum.kind = plane::Shape::Kind::kMinkowskiSum;
  sum.children = {leaf(box), leaf(box)};
  EXPECT_EQ(convex_parts(sum).parts.at(0).volume(), 64);
  mirror.kind = plane::Shape::Kind::kMirror;
  mirror.children = {leaf(box)};
  EXPECT_EQ(convex_parts(mirror).parts.at(0).planes().size(), 6u);
  EXPECT_THROW(convex_parts(*leaf(ball)), Error);
  Solid flat;
  flat.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(convex_parts(*leaf(flat)), Error);
}

/// Twelve slanted cells of a lattice, with flat faces that are not convex. A cut leaves bridges of no width on them.
TEST(ConvexParts, OfFacesThatComeApart) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0},    {2, 3, 10},   {8, 23, 10},  {6, 20, 0},   {17, 16, 20}, {23, 36, 20},
                   {21, 33, 10}, {15, 13, 10}, {25, 13, 10}, {31, 33, 10}, {33, 36, 20}, {27, 16, 20},
                   {34, 6, 20},  {40, 26, 20}, {38, 23, 10}, {32, 3, 10},  {46, 20, 0},  {50, 26, 20},
                   {44, 6, 20},  {40, 0, 0},   {28, 23, 10}, {18, 23, 10}};
  mesh.faces = {{0, 1, 2, 3},     {4, 5, 6, 7},           {8, 9, 10, 11}, {12, 13, 14, 15},
                {16, 17, 18, 19}, {1, 0, 19, 18, 12, 15}, {8, 11, 4, 7},  {14, 13, 17, 16, 3, 2},
                {6, 5, 10, 9},    {16, 19, 0, 3},         {6, 9, 20, 21}, {7, 21, 2, 1, 15, 14, 20, 8},
                {17, 13, 12, 18}, {4, 11, 10, 5}};
  clean(mesh, 1);
  const ConvexParts parts = convex_parts(mesh);
  ASSERT_EQ(parts.scale, 1);
  const std::array<std::string, 2> levels{"xxxx xxxx ....", "...x .x.x .x.."};
  for (std::int64_t k = 0; k < 2; ++k) {
    for (std::int64_t j = 0; j < 3; ++j) {
      for (std::int64_t i = 0; i < 4; ++i) {
        const Point at{10 * i + 3 * j + 2 * k, 10 * j + 3 * k, 10 * k};
        const Point centre = at + Point{7, 6, 5};  // within the cell, and on no plane through its faces
        const bool in = std::any_of(parts.parts.begin(), parts.parts.end(), [&](const Polytope& p) {
          return std::all_of(p.planes().begin(), p.planes().end(),
                             [&](const Plane& h) { return exact::dot(h.normal, centre) + h.offset < 0; });
        });
        EXPECT_EQ(in, levels[std::size_t(k)][std::size_t(5 * j + i)] == 'x') << i << j << k;
      }
    }
  }
}

/// A torus of n by m quadrilaterals in triangles, on a fine grid.
Mesh torus(int n, int m) {
  Mesh mesh;
  const double rotation = 2 * std::acos(-1.0);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double a = rotation * i / n, b = rotation * j / m, r = 10000 + 3000 * std::cos(b);
      mesh.vertices.push_back(
          {std::llround(r * std::cos(a)), std::llround(r * std::sin(a)), std::llround(3000 * std::sin(b))});
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const int p = i * m + j, q = (i + 1) % n * m + j, r = (i + 1) % n * m + (j + 1) % m, s = i * m + (j + 1) % m;
      mesh.faces.push_back({p, q, r});
      mesh.faces.push_back({p, r, s});
    }
  }
  return mesh;
}

TEST(ConvexParts, OfATorusFillItAndLeaveItsHole) {
  Mesh mesh = torus(16, 10);
  clean(mesh, 1);
  const ConvexParts parts = convex_parts(mesh);  // checks the volume itself
  EXPECT_GT(parts.parts.size(), 50u);
  EXPECT_LT(parts.moved, 1);
  const std::vector<Polytope> scaled = at_scale(parts, parts.scale);
  const std::int64_t s = parts.scale;
  std::vector<Point> cube;
  for (int i = 0; i < 8; ++i) cube.push_back({(i & 1 ? 9 : -9) * s, (i & 2 ? 9 : -9) * s, (i & 4 ? 9 : -9) * s});
  const std::vector<Polytope> small{Polytope::hull(cube)};
  const PhiUnion phi(scaled, small);
  const double d = static_cast<double>(s);
  for (int k = 0; k < 64; ++k) {
    const double t = 2 * std::acos(-1.0) * k / 64, x = std::cos(t) * d, y = std::sin(t) * d;
    EXPECT_EQ(phi.sign({10000 * x, 10000 * y, 0}), -1);        // inside the tube
    EXPECT_EQ(phi.sign({6500 * x, 6500 * y, 0}), 1);           // in the hole
    EXPECT_EQ(phi.sign({13500 * x, 13500 * y, 0}), 1);         // around
    EXPECT_EQ(phi.sign({10000 * x, 10000 * y, 3100 * d}), 1);  // above
  }
}

}  // namespace space_mesh
}  // namespace findspace::space
