// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Surfaces that cross themselves, in general position and along coincident faces, and surfaces that only touch.
#include <gtest/gtest.h>

#include "space/convolution/mesh_crossing.h"
#include "space/mesh/mesh.h"
#include "unit/space_bodies.h"

namespace findspace::space {
namespace space_mesh_crossing {

void add_box(Mesh& mesh, const Point& low, const Point& high, bool hollow = false) {
  const int base = static_cast<int>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  for (std::vector<int> f :
       {std::vector{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    for (int& v : f) v += base;
    if (hollow) std::reverse(f.begin(), f.end());
    mesh.faces.push_back(f);
  }
}

bool crosses(const Mesh& mesh) { return crossing_faces(RaySheet(triangles(mesh))).has_value(); }

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
