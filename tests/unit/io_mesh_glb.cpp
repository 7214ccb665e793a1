// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// GLB read: what the program writes, and files made by hand with nodes, transforms, strips and fans, and broken ones.
#include <findspace/error.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "io/mesh/read_mesh.h"
#include "io/mesh/write_mesh_binary.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace io_mesh_glb {

using exact::Real;

space::Mesh read(const std::string& bytes, ReadContext& context) {
  return parse_mesh(bytes, ".glb", context, [](const std::optional<Real>& mm) { return mm.value_or(Real(1)); });
}

/// Six times the volume in cubic micrometres; the mesh has to be closed.
double six_volumes(const std::string& bytes) {
  ReadContext context;
  space::Mesh mesh = read(bytes, context);
  space::clean(mesh, 1e-6);
  return space::six_volumes(mesh).to_double() / 1e9;
}

std::string said(const std::string& bytes) {
  try {
    ReadContext context;
    read(bytes, context);
  } catch (const Error& e) {
    return e.message();
  }
  return "";
}

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string file(const std::string& json, const std::string& binary) {
  std::string out = "glTF";
  put(out, std::uint32_t{2});
  put(out, std::uint32_t(12 + 8 + json.size() + 8 + binary.size()));
  put(out, std::uint32_t(json.size()));
  out += "JSON" + json;
  put(out, std::uint32_t(binary.size()));
  out += std::string("BIN\0", 4) + binary;
  return out;
}

/// A tetrahedron of a metre: its corners, then the indices of its triangles in two bytes each.
std::string tetrahedron(float last = 1, std::vector<std::uint16_t> corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}) {
  std::string out;
  for (const float v : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, last}) put(out, v);
  for (const std::uint16_t c : corners) put(out, c);
  return out;
}

/// `nodes` and what else there is; mesh 0 is the tetrahedron, in `mode`.
std::string json(const std::string& nodes, int mode = 4, std::size_t corners = 12, const std::string& more = "") {
  return fmt::format(
      R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{}],
  "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "mode": {}}}]}}],
  "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}},
                {{"bufferView": 1, "componentType": 5123, "count": {}, "type": "SCALAR"}}],
  "bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": {}}}],
  "buffers": [{{"byteLength": {}}}]{}}})",
      nodes, mode, corners, 2 * corners, 48 + 2 * corners, more);
}

std::string placed(const std::string& nodes) { return file(json(nodes), tetrahedron()); }

TEST(MeshGlb, WhatIsWrittenIsRead) {
  const Surface cube{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}},
                     {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}},
                     {}};
  EXPECT_NEAR(six_volumes(glb_text(assembly_of(cube), "cube", "mm")), 48e9, 48e3);  // no sign: floats of metres
  EXPECT_EQ(six_volumes(glb_text(assembly_of(cube), "cube", "m")), 48e18);
}

TEST(MeshGlb, StandsUprightInMetres) {
  ReadContext context;
  const space::Mesh mesh = read(placed(R"({"mesh": 0})"), context);
  const std::int64_t metre = 1000000000;
  EXPECT_EQ(mesh.vertices[2], (space::Point{0, 0, metre}));
  EXPECT_EQ(mesh.vertices[3], (space::Point{0, -metre, 0}));
  EXPECT_EQ(six_volumes(placed(R"({"mesh": 0})")), 1e18);
}

TEST(MeshGlb, NodesPlaceMeshes) {
  EXPECT_EQ(six_volumes(placed(R"({"mesh": 0, "children": [1]}, {"mesh": 0, "translation": [2, 0, 0.5]})")), 2e18);
  EXPECT_EQ(six_volumes(placed(R"({"mesh": 0, "scale": [2, 1, -3]})")), 6e18);
  EXPECT_EQ(six_volumes(placed(R"({"mesh": 0, "matrix": [0, 2, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, 5, 5, 5, 1]})")), 4e18);
  // A quarter turn about z, of a length that is not 1, and a scale of its parent.
  ReadContext context;
  const space::Mesh turned =
      read(placed(R"({"scale": [2, 2, 2], "children": [1]}, {"mesh": 0, "rotation": [0, 0, 0.70710677, 0.70710677]})"),
           context);
  EXPECT_EQ(turned.vertices[1], (space::Point{0, 0, 2000000000}));
  EXPECT_EQ(turned.vertices[2], (space::Point{-2000000000, 0, 0}));
  EXPECT_EQ(context.rounding.points, 0);
}

TEST(MeshGlb, StripsFansAndLines) {
  const std::vector<std::uint16_t> strip{0, 2, 1, 3, 0, 2};
  EXPECT_EQ(six_volumes(file(json(R"({"mesh": 0})", 5, 6), tetrahedron(1, strip))), 1e18);
  ReadContext context;
  const space::Mesh fan = read(file(json(R"({"mesh": 0})", 6, 4), tetrahedron(1, {0, 1, 2, 3})), context);
  EXPECT_EQ(fan.faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_NE(said(file(json(R"({"mesh": 0})", 1), tetrahedron())).find("no triangles"), std::string::npos);
}

TEST(MeshGlb, SaysWhatIsWrong) {
  const std::string good = placed(R"({"mesh": 0})");
  EXPECT_EQ(said(good), "");
  for (std::size_t length = 12; length < good.size(); length += 7)
    EXPECT_NE(said(good.substr(0, length)), "") << length;
  const auto of = [](const std::string& nodes) { return said(placed(nodes)); };
  EXPECT_EQ(of(R"({"mesh": 1})"), "there is no number 1 in \"meshes\"");
  EXPECT_EQ(of(R"({"mesh": -1})"), "\"mesh\" is a whole number from 0 on");
  EXPECT_EQ(of(R"({"children": [0]})"), "node 0 stands in the scene twice");
  EXPECT_EQ(of(R"({"mesh": 0, "scale": [1, 0, 1]})"), "a transform flattens what it places");
  EXPECT_EQ(of(R"({"mesh": 0, "scale": [1, 1]})"), "\"scale\" of a node has 3 numbers");
  EXPECT_EQ(of(R"({"mesh": 0, "rotation": [0, 0, 0, 0]})"), "the \"rotation\" of a node is not 0");
  EXPECT_EQ(said(file(json(R"({"mesh": 0})"), tetrahedron(std::numeric_limits<float>::quiet_NaN()))),
            "a coordinate is not finite");
  EXPECT_EQ(said(file(json(R"({"mesh": 0})", 4, 3), tetrahedron(1, {0, 1, 4}))),
            "a triangle refers to a vertex that is not there");
  EXPECT_EQ(said(file(json(R"({"mesh": 0})", 4, 4), tetrahedron(1, {0, 1, 2, 3}))),
            "a primitive of triangles has a part of one");
  EXPECT_NE(said(file(json(R"({"mesh": 0})", 4, 14), tetrahedron())).find("shorter"), std::string::npos);
  const std::string draco = R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])";
  EXPECT_NE(said(file(json(R"({"mesh": 0})", 4, 12, draco), tetrahedron())).find("KHR_draco"), std::string::npos);
}

/// A mesh of so many primitives that share their vertices and corners.
std::string primitives(int count) {
  std::string text = json(R"({"mesh": 0})");
  const std::string one = R"({"attributes": {"POSITION": 0}, "indices": 1, "mode": 4})";
  std::string more;
  for (int k = 1; k < count; ++k) more += one + ", ";
  return file(text.insert(text.find(one), more), tetrahedron());
}

TEST(MeshGlb, PrimitivesShareTheirVertices) {
  ReadContext context;
  const space::Mesh mesh = read(primitives(3), context);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.faces.size(), 12u);
}

TEST(MeshGlb, CornersTakenOftenAreWork) {
  ReadContext context;
  context.work = plane::WorkBudget(500000);
  try {
    read(primitives(5000), context);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kLimit);
  }
}

TEST(MeshGlb, OneMeshPlacedOftenIsWork) {
  std::string nodes = R"({"children": [)";
  for (int k = 1; k <= 5000; ++k) nodes += fmt::format("{}{}", k == 1 ? "" : ", ", k);
  nodes += "]}";
  for (int k = 1; k <= 5000; ++k) nodes += fmt::format(R"(, {{"mesh": 0, "translation": [0.{:04}, 0, 0]}})", k);
  ReadContext context;
  context.work = plane::WorkBudget(500000);
  try {
    read(placed(nodes), context);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kLimit);
  }
}

}  // namespace io_mesh_glb
}  // namespace findspace::io
