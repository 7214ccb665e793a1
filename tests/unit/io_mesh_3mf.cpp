// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// 3MF, PLY and GLB: surfaces written and read again, packages made by hand with units, components and transforms, and
// broken ones.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "io/mesh/mesh_3mf.h"
#include "io/mesh/read_mesh.h"
#include "io/mesh/write_mesh_binary.h"
#include "io/mesh/zip_archive.h"
#include "space/mesh/mesh.h"

namespace findspace::io {
namespace io_mesh_3mf {

using exact::Real;

Real millimetres(const std::optional<Real>& stated) { return stated.value_or(Real(1)); }

const Surface kCube{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 0.1 + 1.9}},
                    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}},
                    {}};

/// Six times the volume in cubic steps of a millionth; the mesh has to be closed.
double six_volumes(const std::string& bytes, const std::string& ending) {
  ReadContext context;
  space::Mesh mesh = parse_mesh(bytes, ending, context, millimetres);
  space::clean(mesh, 1e-6);
  return space::six_volumes(mesh).to_double();
}

std::string package(const std::string& model) { return zip_bytes({{"3D/3dmodel.model", model}}); }

const std::string kTetrahedron =
    "<object id=\"1\" type=\"model\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" "
    "z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles><triangle "
    "v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle "
    "v1=\"0\" v2=\"3\" v3=\"2\"/></triangles></mesh></object>";

std::string model(const std::string& more, const std::string& build, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?><model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" " +
         attributes + "><resources>" + kTetrahedron + more + "</resources><build>" + build + "</build></model>";
}

TEST(Mesh3mf, WrittenAndReadAgain) {
  EXPECT_EQ(six_volumes(text_3mf(assembly_of(kCube), "a <cube> & \"more\"", "mm"), ".3mf"), 48e18);
  EXPECT_EQ(six_volumes(text_3mf(assembly_of(kCube), "", "cm"), ".3mf"), 48e21);
  EXPECT_NEAR(six_volumes(text_3mf(assembly_of(kCube), "", "mil"), ".3mf") / (48e18 * std::pow(0.0254, 3)), 1,
              1e-3);  // no sign: test
  EXPECT_EQ(text_3mf(assembly_of(kCube), "t", "mm"), text_3mf(assembly_of(kCube), "t", "mm"));
}

/// Copies are items of one object, and nodes of one mesh.
TEST(Mesh3mf, CopiesStandWhereTheyAre) {
  Assembly two = assembly_of(kCube);
  two.copies.push_back({0, "other", {{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}}}, {10, 20, 30}});
  EXPECT_EQ(six_volumes(text_3mf(two, "", "mm"), ".3mf"), 2 * 48e18);
  for (const char* ending : {".3mf", ".glb", ".off"}) {
    ReadContext context;
    const space::Mesh mesh = parse_mesh(assembly_text(two, "", ending, "mm"), ending, context, millimetres);
    ASSERT_EQ(mesh.vertices.size(), 16U) << ending;
    const space::Point& p = mesh.vertices[8 + 3];  // (2, 2, 0), turned and moved
    EXPECT_NEAR(p.x, (10 + 0.6 * 2 - 0.8 * 2) * 1e6, 1) << ending;
    EXPECT_NEAR(p.y, (20 + 0.8 * 2 + 0.6 * 2) * 1e6, 1) << ending;
    EXPECT_NEAR(p.z, 30 * 1e6, 1) << ending;
  }
}

TEST(Mesh3mf, ComponentsTransformsAndUnits) {
  EXPECT_EQ(six_volumes(package(model("", "<item objectid=\"1\"/>")), ".3mf"), 1e18);
  EXPECT_EQ(six_volumes(package(model("", "<item objectid=\"1\"/>", "unit=\"meter\"")), ".3mf"), 1e27);
  EXPECT_EQ(six_volumes(package(model("", "<item objectid=\"1\"/>", "unit=\"micron\"")), ".3mf"), 1e9);
  // Twice as large and moved, once mirrored (its faces turn): volumes 8 and 1.
  const std::string two =
      "<object id=\"2\"><components><component objectid=\"1\" transform=\"2 0 0 0 2 0 0 0 2 5 0 0\"/><component "
      "objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></components></object>";
  EXPECT_EQ(six_volumes(package(model(two, "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 .5 .5 .5\"/>")), ".3mf"),
            9e18);
  ReadContext context;
  const space::Mesh moved =
      parse_mesh(package(model("", "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 10 20 30\"/>")), ".3mf",
                 context, millimetres);
  EXPECT_EQ(moved.vertices[1], (space::Point{10000000, 21000000, 30000000}));
  EXPECT_EQ(moved.vertices[2], (space::Point{9000000, 20000000, 30000000}));
}

TEST(Mesh3mf, BrokenFilesAreRefused) {
  const auto refusal = [](const std::string& bytes) -> std::string {
    try {
      six_volumes(bytes, ".3mf");
    } catch (const Error& e) {
      return e.message();
    }
    return "nothing";
  };
  const std::string good = package(model("", "<item objectid=\"1\"/>"));
  EXPECT_NE(refusal("").find("ZIP"), std::string::npos);
  EXPECT_NE(refusal("solid x").find("ZIP"), std::string::npos);
  EXPECT_NE(refusal(good.substr(0, good.size() / 2)).find("ZIP"), std::string::npos);
  EXPECT_NE(refusal(zip_bytes({{"readme.txt", "no"}})).find("no 3D model"), std::string::npos);
  EXPECT_NE(refusal(package("<model>")).find("not XML"), std::string::npos);
  EXPECT_NE(refusal(package("<html/>")).find("no <model>"), std::string::npos);
  EXPECT_NE(refusal(package(model("", ""))).find("nothing with triangles"), std::string::npos);
  EXPECT_NE(refusal(package(model("", "<item objectid=\"7\"/>"))).find("no object 7"), std::string::npos);
  EXPECT_NE(refusal(package(model("", "<item objectid=\"1\"/>", "unit=\"league\""))).find("league"), std::string::npos);
  EXPECT_NE(refusal(package(model("", "<item objectid=\"1\"/>", "requiredextensions=\"b\""))).find("extension 'b'"),
            std::string::npos);
  EXPECT_NE(refusal(package(model("", "<item objectid=\"1\" transform=\"1 2 3\"/>"))).find("twelve"),
            std::string::npos);
  EXPECT_NE(
      refusal(package(model("", "<item objectid=\"1\" transform=\"1 0 0 0 1 0 1 1 0 0 0 0\"/>"))).find("flattens"),
      std::string::npos);
  const std::string itself = "<object id=\"3\"><components><component objectid=\"3\"/></components></object>";
  EXPECT_NE(refusal(package(model(itself, "<item objectid=\"3\"/>"))).find("component of itself"), std::string::npos);
  const std::string far =
      "<object id=\"4\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" "
      "v2=\"1\" v3=\"2\"/></triangles></mesh></object>";
  EXPECT_NE(refusal(package(model(far, "<item objectid=\"4\"/>"))).find("not there"), std::string::npos);
  const std::string odd =
      "<object id=\"4\"><mesh><vertices><vertex x=\"0\" y=\"a\" z=\"0\"/></vertices></mesh></object>";
  EXPECT_NE(refusal(package(model(odd, "<item objectid=\"4\"/>"))).find("'a'"), std::string::npos);
  std::string damaged = good;
  damaged[damaged.find("3dmodel.model") + 30] ^= 0x55;
  EXPECT_NE(refusal(damaged).find("damaged"), std::string::npos);
}

/// Items may stand before their objects; of two meshes in an object the first counts.
TEST(Mesh3mf, OrderDoesNotMatter) {
  const std::string mesh = kTetrahedron.substr(0, kTetrahedron.find("</object>"));
  EXPECT_EQ(six_volumes(package("<model><build><item objectid=\"2\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 "
                                "0 1 3 0 0\"/></build><resources><object id=\"2\"><components><component "
                                "objectid=\"1\"/></components></object>" +
                                mesh + "<mesh><vertices/></mesh></object></resources></model>"),
                        ".3mf"),
            2e18);
}

/// Of what other programs write: encodings that are misnamed or seldom used, and relations that are no XML.
TEST(Mesh3mf, OddPackages) {
  const std::string good = model("<!-- \xe9 -->", "<item objectid=\"1\"/>");
  for (const char* encoding : {"ISO-8859-1", "windows-1252", "latin1"}) {
    const std::string named =
        "<?xml version=\"1.0\" encoding=\"" + std::string(encoding) + "\"?>" + good.substr(good.find("<model"));
    EXPECT_EQ(six_volumes(package(named), ".3mf"), 1e18) << encoding;
  }
  const std::string plain = model("<!-- \xc3\xa9 -->", "<item objectid=\"1\"/>");
  for (const char* encoding : {"utf8", "utf-16"}) {
    const std::string named =
        "<?xml version=\"1.0\" encoding=\"" + std::string(encoding) + "\"?>" + plain.substr(plain.find("<model"));
    EXPECT_EQ(six_volumes(package(named), ".3mf"), 1e18) << encoding;
  }
  for (const char* relations : {"", "none", "<Relationships>", "<!DOCTYPE a><Relationships/>"}) {
    EXPECT_EQ(six_volumes(zip_bytes({{"_rels/.rels", relations}, {"3D/3dmodel.model", plain}}), ".3mf"), 1e18)
        << relations;
  }
}

/// What XML itself may do to a reader.
TEST(Mesh3mf, XmlThatIsHostile) {
  const auto refused = [](const std::string& model) {
    try {
      six_volumes(package(model), ".3mf");
    } catch (const Error& e) {
      return e.place() + ": " + e.message();
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refused("<model>\n  <resources></build>"), "3D/3dmodel.model:2:16: this is not XML: mismatched tag");
  EXPECT_EQ(refused("<!DOCTYPE model [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]><model>&c;</model>"),
            "3D/3dmodel.model:1:17: a document type, which is not read here");
  std::string many = "<model><resources>";
  for (int i = 0; i < 1000000; ++i) many += "<a" + std::to_string(i) + "/>";
  for (const std::string& model : {many, "<model a=\"" + std::string(20'000'000, 'a') + "\"/>", [] {
                                     std::string deep;
                                     for (int i = 0; i < 2'000'000; ++i) deep += "<model>";
                                     return deep;
                                   }()}) {
    EXPECT_NE(refused(model).find("too long, too deep or have too many names"), std::string::npos)
        << model.substr(0, 40);
  }
}

TEST(WriteMesh, PlyKeepsEveryBit) {
  Surface odd = kCube;
  for (auto& v : odd.vertices) v[0] /= 3;
  const std::string ply = ply_text(odd, "two\nlines");
  EXPECT_EQ(six_volumes(ply_text(kCube, ""), ".ply"), 48e18);
  double x = 0;
  std::memcpy(&x, ply.data() + ply.find("end_header\n") + 11 + 24, sizeof x);
  EXPECT_EQ(x, 2.0 / 3);
}

/// Reads the triangles back; every edge has to be there once each way.
TEST(WriteMesh, GlbIsClosedAndInMetres) {
  const std::string glb = glb_text(assembly_of(kCube), "cube", "mm");
  const auto number = [&](std::size_t at) {
    std::uint32_t v = 0;
    std::memcpy(&v, glb.data() + at, 4);
    return v;
  };
  ASSERT_EQ(glb.substr(0, 4), "glTF");
  ASSERT_EQ(number(8), glb.size());
  const std::size_t text = number(12), bin = 20 + text;
  const auto root = nlohmann::json::parse(glb.substr(20, text));
  EXPECT_EQ(number(bin), glb.size() - bin - 8);
  EXPECT_EQ(root["accessors"][0]["count"], 36);
  EXPECT_EQ(root["accessors"][1]["count"], 8);
  EXPECT_FLOAT_EQ(root["accessors"][1]["max"][1], 0.002F);
  EXPECT_FLOAT_EQ(root["accessors"][1]["min"][2], -0.002F);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < 12; ++t) {
    std::uint32_t v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = number(bin + 8 + 4 * (3 * t + k));
    for (std::size_t k = 0; k < 3; ++k) ++edges[{v[k], v[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  EXPECT_NE(glb_text({}, "nothing", "").find("\"scenes\""), std::string::npos);
}

}  // namespace io_mesh_3mf
}  // namespace findspace::io
