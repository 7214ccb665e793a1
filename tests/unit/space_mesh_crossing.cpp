// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces that cross themselves, in general position and along coincident faces, and surfaces that only touch.
#include <gtest/gtest.h>

#include <cmath>

#include "space/convolution/mesh_crossing.h"
#include "space/mesh/mesh.h"
#include "unit/solid_shapes.h"

namespace findspace::space {
namespace space_mesh_crossing {

bool crosses(const Mesh& mesh) { return self_contact(RaySheet(triangles(mesh))).crossing.has_value(); }

Mesh two(const Point& low, const Point& high, bool hollow = false) {
  Mesh mesh;
  add_box(mesh, {0, 0, 0}, {10, 10, 10});
  add_box(mesh, low, high, hollow);
  return mesh;
}

TEST(MeshCrossing, SolidsThatOverlap) {
  EXPECT_TRUE(crosses(two({5, 5, 5}, {15, 15, 15})));
  EXPECT_TRUE(crosses(two({3, 3, -5}, {7, 7, 15})));       // a bar through it
  EXPECT_TRUE(crosses(two({5, 0, 0}, {15, 10, 10})));      // four pairs of coincident faces
  EXPECT_TRUE(crosses(two({5, 0, 0}, {15, 10, 12})));      // three
  EXPECT_TRUE(crosses(two({2, 2, 2}, {8, 8, 10}, true)));  // a hollow that reaches the frontier
  EXPECT_TRUE(crosses(two({2, 2, 5}, {8, 8, 12}, true)));  // a hollow that comes out
}

TEST(MeshCrossing, SolidsThatTouchOrAreApart) {
  Mesh one;
  add_box(one, {0, 0, 0}, {10, 10, 10});
  EXPECT_FALSE(crosses(one));
  EXPECT_FALSE(crosses(two({20, 0, 0}, {30, 10, 10})));
  EXPECT_FALSE(crosses(two({10, 2, 2}, {20, 8, 8})));      // face in face
  EXPECT_FALSE(crosses(two({10, 10, 3}, {20, 20, 7})));    // along an edge
  EXPECT_FALSE(crosses(two({10, 10, 10}, {20, 20, 20})));  // in a corner
  EXPECT_FALSE(crosses(two({2, 2, 2}, {8, 8, 8}, true)));  // a hollow inside
}

TEST(MeshCrossing, OneSurfaceTwistedThroughItself) {
  // A tetrahedron whose corner is pulled through the face across.
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {3, 3, 5}, {3, 3, -5}};
  mesh.faces = {{0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
  for (auto& f : mesh.faces) std::reverse(f.begin(), f.end());
  EXPECT_FALSE(crosses(mesh));
  mesh.vertices[4] = {3, 3, 9};
  mesh.vertices[3] = {3, 3, 5};
  EXPECT_FALSE(crosses(mesh));  // a tent with a ceiling
  mesh.vertices[4] = {30, 3, 2};
  EXPECT_TRUE(crosses(mesh));
}

TEST(MeshCrossing, ThroughACommonCorner) {
  // A part turned inside out: two sheets cross on a line that starts at a corner of both, and one of them passes
  // through the floor from there to a corner of that.
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 2}, {1, 0, -2}};
  mesh.faces = {{4, 0, 1}, {4, 1, 2}, {4, 2, 3}, {4, 3, 0}, {1, 0, 2}, {5, 3, 2}, {5, 2, 0}, {5, 0, 3}};
  EXPECT_TRUE(crosses(mesh));
}

/// A cone over a fine star: as many faces about its tip, and as many about the middle of its floor.
Mesh star_cone(int corners, const Point& tip) {
  Mesh mesh;
  mesh.vertices = {tip, {0, 0, 0}};
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners, radius = i % 2 == 0 ? 1e6 : 9e5;
    mesh.vertices.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle)), 0});
  }
  for (int i = 0; i < corners; ++i) {
    const int a = 2 + i, b = 2 + (i + 1) % corners;
    mesh.faces.push_back({0, a, b});
    mesh.faces.push_back({1, b, a});
  }
  return mesh;
}

TEST(MeshCrossing, ManyFacesAboutOneCorner) {
  for (const int corners : {40, 1000}) {
    Mesh cone = star_cone(corners, {0, 0, 500000});
    EXPECT_FALSE(crosses(cone));
    EXPECT_FALSE(crosses(star_cone(corners, {800000, 100000, 300000})));
    // A corner of the rim is pulled over to the other side of the fan: faces about the tip cross.
    cone.vertices[2] = {-1000000, 3000, 1000};
    EXPECT_TRUE(crosses(cone));
  }
}

bool has_inner_walls(const Mesh& mesh) { return self_contact(RaySheet(triangles(mesh))).inner_walls; }

TEST(MeshCrossing, WallsWithin) {
  EXPECT_TRUE(has_inner_walls(two({10, 2, 2}, {20, 8, 8})));
  EXPECT_TRUE(has_inner_walls(two({10, 5, 5}, {20, 15, 15})));
  EXPECT_TRUE(has_inner_walls(two({10, 0, 0}, {20, 10, 10})));
  EXPECT_FALSE(has_inner_walls(two({11, 2, 2}, {20, 8, 8})));
  EXPECT_FALSE(has_inner_walls(two({10, 10, 3}, {20, 20, 7})));
  EXPECT_FALSE(has_inner_walls(two({10, 10, 10}, {20, 20, 20})));
  EXPECT_FALSE(has_inner_walls(two({2, 2, 2}, {8, 8, 8}, true)));
}

/// Two cubes on the same corners of their wall, whose triangles are the same or those of the other diagonal.
Triangles two_cubes(bool same_triangles) {
  Triangles t;
  for (int i = 0; i < 12; ++i) t.points.push_back({i % 3 * 10, i / 3 % 2 * 10, i / 6 * 10});
  using Ring = std::array<int, 4>;
  const auto add = [&](const Ring& r, int at) {
    t.faces.push_back({r[0] + at, r[1] + at, r[2] + at});
    t.faces.push_back({r[0] + at, r[2] + at, r[3] + at});
  };
  for (const int at : {0, 1}) {
    for (const Ring& r : {Ring{0, 3, 4, 1}, {6, 7, 10, 9}, {0, 1, 7, 6}, {3, 9, 10, 4}, {1, 4, 10, 7}}) add(r, at);
    add(at == 0 || same_triangles ? Ring{0, 6, 9, 3} : Ring{6, 9, 3, 0}, at);
  }
  return t;
}

TEST(MeshCrossing, TwoCubesOfOneWall) {
  for (const bool same : {true, false}) {
    const auto made = RayBody::of(two_cubes(same));
    ASSERT_TRUE(made) << made.refusal().error.what();
    EXPECT_EQ(made->pieces, 2);
    EXPECT_EQ(made->euler(), 2);
    const SelfContact contact = self_contact(RaySheet(*made));
    EXPECT_FALSE(contact.crossing);
    EXPECT_TRUE(contact.inner_walls);
  }
}

TEST(MeshCrossing, AFoldIsRefusedWithItsPlace) {
  // From the edges of (8, 8, 0) the surface goes back flat on the bottom to (3, 3, 0), then up; steps of 0.5.
  Triangles t{{{0, 0, 0}, {4, 0, 0}, {8, 8, 0}, {0, 4, 0}, {3, 3, 0}, {0, 0, 4}},
              {{0, 3, 2}, {0, 2, 1}, {1, 2, 4}, {2, 3, 4}, {3, 5, 4}, {4, 5, 1}, {1, 5, 0}, {0, 5, 3}},
              0.5};
  const auto made = RayBody::of(t);
  ASSERT_FALSE(made);
  const std::string says = made.refusal().error.what();
  EXPECT_NE(says.find("folds back on itself at the edge ("), std::string::npos) << says;
  EXPECT_NE(says.find("(4, 4, 0)"), std::string::npos) << says;
  EXPECT_EQ(says.find("grid steps"), std::string::npos) << says;
  t.step = 0;
  EXPECT_NE(std::string(RayBody::of(t).refusal().error.what()).find(", in grid steps"), std::string::npos);
}

}  // namespace space_mesh_crossing
}  // namespace findspace::space
