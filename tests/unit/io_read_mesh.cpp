// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Mesh files: the same cube in every format and encoding, broken files, and surfaces written and read again.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cstring>

#include "io/mesh/read_mesh.h"
#include "io/mesh/write_mesh.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace io_read_mesh {

const char* kObj =
    "# cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\nvn 0 0 1\n"
    "f 1/1/1 3//1 4 2\nf 5 6 8 7\nf 1 2 6 5\nf -6 -2 -1 -5\nf 1 5 7 3\nf 2 4 8 6\n";

exact::Real plain(const std::optional<exact::Real>&) { return 1; }

space::Mesh cube() {
  ReadContext context;
  space::Mesh mesh = parse_mesh(kObj, ".obj", context, plain);
  space::clean(mesh, 1e-6);
  return mesh;
}

Surface surface(const space::Mesh& mesh) {
  Surface s;
  for (const auto& v : mesh.vertices) s.vertices.push_back({v.x / 1e6, v.y / 1e6, v.z / 1e6});
  s.faces = mesh.faces;
  return s;
}

void expect_unit_cube(const std::string& bytes, const std::string& ending) {
  ReadContext context;
  space::Mesh mesh = parse_mesh(bytes, ending, context, plain);
  space::clean(mesh, 1e-6);
  EXPECT_TRUE(space::is_convex(mesh)) << ending;
  EXPECT_EQ(space::six_volumes(mesh).to_double(), 6e18) << ending;
}

template <class T>
void append(std::string& bytes, T value, bool big = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string binary_stl(const space::Mesh& mesh) {
  std::string bytes(80, ' ');
  append(bytes, std::uint32_t{12});
  for (const auto& face : mesh.faces) {
    for (int i = 1; i <= 2; ++i) {
      for (int k = 0; k < 3; ++k) append(bytes, 0.0F);
      for (const int v : {face[0], face[i], face[i + 1]}) {
        const auto& p = mesh.vertices[v];
        for (const auto c : {p.x, p.y, p.z}) append(bytes, static_cast<float>(c) / 1e6F);
      }
      append(bytes, std::uint16_t{0});
    }
  }
  return bytes;
}

std::string ply(const space::Mesh& mesh, const std::string& format) {
  std::string bytes =
      "ply\nformat " + format +
      " 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property double z\nproperty uchar red\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
  const bool big = format == "binary_big_endian";
  if (format == "ascii") {
    for (const auto& p : mesh.vertices) {
      bytes += std::to_string(p.x / 1000000) + " " + std::to_string(p.y / 1000000) + " " +
               std::to_string(p.z / 1000000) + " 7\n";
    }
    for (const auto& f : mesh.faces) {
      bytes += "4";
      for (const int v : f) bytes += " " + std::to_string(v);
      bytes += "\n";
    }
    return bytes;
  }
  for (const auto& p : mesh.vertices) {
    append(bytes, static_cast<float>(p.x) / 1e6F, big);
    append(bytes, static_cast<float>(p.y) / 1e6F, big);
    append(bytes, static_cast<double>(p.z) / 1e6, big);
    append(bytes, std::uint8_t{7});
  }
  for (const auto& f : mesh.faces) {
    append(bytes, std::uint8_t{4});
    for (const int v : f) append(bytes, std::int32_t{v}, big);
  }
  return bytes;
}

TEST(ReadMesh, EveryFormatGivesTheSameCube) {
  const space::Mesh mesh = cube();
  expect_unit_cube(kObj, ".obj");
  Surface named = surface(mesh);
  named.labels.assign(named.faces.size(), "a\nf 1 2 3");
  expect_unit_cube(obj_text(named, "a\ncube"), ".obj");
  const std::string without_comment = std::string(kObj).substr(std::string_view("# cube\n").size());
  for (const auto& [text, ending] :
       {std::pair{without_comment, ".obj"}, {off_text(surface(mesh)), ".off"}, {ply(mesh, "ascii"), ".ply"}})
    expect_unit_cube("\xEF\xBB\xBF" + text, ending);
  expect_unit_cube(off_text(surface(mesh)), ".off");
  expect_unit_cube(stl_text(surface(mesh), "cube"), ".stl");
  expect_unit_cube(binary_stl(mesh), ".stl");
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
    expect_unit_cube(ply(mesh, format), ".ply");
}

ErrorCode refusal(const std::string& bytes, const std::string& ending) {
  ReadContext context;
  try {
    space::Mesh mesh = parse_mesh(bytes, ending, context, plain);
    space::clean(mesh, 1e-6);
  } catch (const Error& e) {
    EXPECT_FALSE(e.message().empty());
    return e.code();
  }
  return ErrorCode::kUsage;
}

TEST(ReadMesh, BrokenFilesAreRefused) {
  const space::Mesh mesh = cube();
  EXPECT_EQ(refusal("", ".obj"), ErrorCode::kGeometry);
  EXPECT_EQ(refusal("v 0 0\n", ".obj"), ErrorCode::kSyntax);
  EXPECT_EQ(refusal("v 0 0 x\n", ".obj"), ErrorCode::kSyntax);
  EXPECT_EQ(refusal("v 0 0 0\nf 1 2 3\n", ".obj"), ErrorCode::kSyntax);
  EXPECT_EQ(refusal("v 9e99 0 0\n", ".obj"), ErrorCode::kOutOfRange);
  EXPECT_EQ(refusal("OFF\n3 1 0\n0 0 0\n", ".off"), ErrorCode::kSyntax);
  EXPECT_EQ(refusal("OFF\n1 1 0\n0 0 0\n3 0 0 7\n", ".off"), ErrorCode::kSyntax);
  EXPECT_EQ(refusal("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", ".stl"), ErrorCode::kSyntax);
  EXPECT_EQ(refusal(binary_stl(mesh).substr(0, 300), ".stl"), ErrorCode::kFile);
  EXPECT_EQ(refusal("ply\nformat ascii 1.0\n", ".ply"), ErrorCode::kSyntax);
  EXPECT_EQ(refusal(ply(mesh, "binary_little_endian").substr(0, 260), ".ply"), ErrorCode::kFile);
  EXPECT_EQ(refusal("whatever", ".xyz"), ErrorCode::kFile);
  ReadContext context;
  EXPECT_THROW(read_mesh("/nowhere/at/all.obj", context, plain), Error);
}

TEST(WriteMesh, PictureShadesFacesAndDashesHiddenLines) {
  const std::string svg = svg_text(surface(cube()), "a < b", "mm");
  EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
  // Three faces are seen, each a shaded one with its edges: three of an edge are drawn once, with the nearer face.
  const auto dashed = svg.find("stroke-dasharray");
  ASSERT_NE(dashed, std::string::npos);
  const auto count = [&](std::string_view text, std::size_t from, std::size_t to) {
    std::size_t n = 0;
    for (std::size_t at = svg.find(text, from); at < to; at = svg.find(text, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("M", dashed, svg.size()), 3u);
  const std::size_t first = svg.find("fill-opacity");
  EXPECT_EQ(count("fill-opacity", 0, dashed), 3u);
  EXPECT_EQ(count("M", first, dashed), 2u + 9u);
  EXPECT_NE(svg.find(">x, mm<"), std::string::npos);
  EXPECT_THROW(surface_text({}, "", ".dwg", ""), Error);
}

}  // namespace io_read_mesh
}  // namespace findspace::io
