// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems in space as files.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/nesting/read_solids.h"
#include "io/nesting/write_solids.h"

namespace findspace::io {
namespace io_solids {

namespace fs = std::filesystem;

SolidProblemRead read(const std::string& text, const std::string& name = "problem.json") {
  return read_solids(text, name, {}, {});
}

std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

constexpr const char* kTwo = R"({"name": "two", "container": {"size-x": 4, "size-y": "2.5"},
  "shapes": {"slab": {"box": {"min": [0, 0, 0], "max": [2, 2, 0.25]}}},
  "item-types": [{"demand": 2, "shape": "slab"},
                 {"id": "tip", "demand": 1, "shape": {"polytope": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}}]})";

TEST(ReadSolids, ShapesOfAScene) {
  const packing::SolidProblem problem = read(kTwo).problem;
  EXPECT_EQ(problem.digits, 2);
  EXPECT_EQ(problem.depth, packing::Fraction(5, 2));
  ASSERT_EQ(problem.parts.size(), 2U);
  EXPECT_EQ(problem.parts[0].name, "slab");
  EXPECT_EQ(problem.parts[1].name, "tip");
  EXPECT_EQ(problem.items(), 3U);
  EXPECT_NEAR(packing::volume(problem), 2 + 1.0 / 6, 1e-12);
  EXPECT_EQ(packing::box_of(problem, problem.parts[0].forms[0]).high[2], packing::Fraction(1, 4));
}

TEST(ReadSolids, TellsProblemsApart) {
  EXPECT_TRUE(is_solid_problem(kTwo, "a"));
  EXPECT_FALSE(is_solid_problem(R"({"items": [], "strip_height": 3})", "a"));
  EXPECT_THROW(is_solid_problem("{", "a"), Error);
}

TEST(ReadSolids, SaysWhatIsWrong) {
  const std::string head = R"({"container": {"size-x": 4, "size-y": 2}, "item-types": )";
  EXPECT_NE(message_of(head + R"([{"demand": 1}]})").find("either a 'path' or a 'shape'"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"path": "a.obj"}]})").find("'demand' is missing"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"demand": 1, "path": "none.obj"}]})").find("none.obj"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"demand": 1, "path": 3}]})").find("a path is meant"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}}]})").find("'id'"),
            std::string::npos);
  const std::string ball = R"({"id": "b", "demand": 1, "shape": {"ball": {"center": [0,0,0], "radius": 1}}})";
  EXPECT_NE(message_of(head + "[" + ball + "]}").find("flat faces"), std::string::npos);
  const std::string wide = R"({"id": "w", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [5,1,1]}}})";
  EXPECT_NE(message_of(head + "[" + wide + "]}").find("does not stand on the floor"), std::string::npos);
  const std::string twice = R"({"id": "w", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}})";
  EXPECT_NE(message_of(head + "[" + twice + "," + twice + "]}").find("two items 'w'"), std::string::npos);
}

TEST(ReadSolids, Orientations) {
  const auto with = [](const std::string& allowed) {
    return R"({"container": {"size-x": 9, "size-y": 9}, "item-types": [{"id": "b", "demand": 1, "allowed_orientations": )" +
           allowed + R"(, "shape": {"box": {"min": [0,0,0], "max": [1,2,3]}}}]})";
  };
  EXPECT_EQ(read(with(R"("right-angles")")).problem.parts[0].forms.size(), 24U);
  EXPECT_EQ(read(with(R"("upright")")).problem.parts[0].forms.size(), 4U);
  const packing::SolidProblem lying = read(with("[[[0,0,1],[1,0,0],[0,1,0]]]")).problem;
  ASSERT_EQ(lying.parts[0].forms.size(), 1U);
  EXPECT_EQ(packing::box_of(lying, lying.parts[0].forms[0]).high,
            (std::array<packing::Fraction, 3>{3, 1, 2}));  // (x, y, z) goes to (z, x, y)
  packing::SolidLayout layout;
  layout.height = 2;
  layout.items = {{0, 1, 0, {0, 0, 0}}};
  const packing::SolidLayout back = read_solid_layout(layout_json(lying, layout, {}), "layout.json", lying);
  EXPECT_EQ(back.items[0].form, 0U);
  const packing::SolidProblem standing = read(with("[[[1,0,0],[0,1,0],[0,0,1]]]")).problem;
  EXPECT_THROW(read_solid_layout(layout_json(lying, layout, {}), "layout.json", standing), Error);
  EXPECT_NE(message_of(with("[]")).find("right-angles"), std::string::npos);
  EXPECT_NE(message_of(with("[[[1,0,0],[0,1,0],[0,0,-1]]]")).find("not a rotation"), std::string::npos);
  EXPECT_NE(message_of(with("[[[2,0,0],[0,1,0],[0,0,1]]]")).find("0, 1, -1"), std::string::npos);
}

/// A folder of its own that goes with the test.
class SolidFiles : public ::testing::Test {
 protected:
  SolidFiles() : folder_(fs::path(::testing::TempDir()) / "findspace_io_solids") { fs::create_directories(folder_); }
  ~SolidFiles() override { fs::remove_all(folder_); }

  SolidProblemRead read_with(const std::string& file, const std::string& content, const std::string& path) const {
    fs::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << content;
    return read(
        R"({"container": {"size-x": 30, "size-y": 30}, "item-types": [{"demand": 1, "path": ")" + path + "\"}]}",
        (folder_ / "problem.json").string());
  }

  fs::path folder_;
};

const std::string kTip = "v 0 0 0\nv 1.5 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string kTipFaces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

TEST_F(SolidFiles, GridHasTheDigitsOfTheFile) {
  const SolidProblemRead tip = read_with("tip.obj", kTip + kTipFaces, "tip.obj");
  EXPECT_EQ(tip.problem.digits, 1);
  EXPECT_EQ(tip.problem.parts[0].name, "tip");
  EXPECT_TRUE(tip.notes.empty());
}

TEST_F(SolidFiles, FoldersOfTheDataSets) {
  EXPECT_EQ(read_with("convex/tip.obj", kTip + kTipFaces, "Nobody et al. 2004/convex/tip.obj").problem.parts.size(),
            1U);
}

TEST_F(SolidFiles, LooseVertexOfAConvexMeshBelongsToIt) {
  const SolidProblemRead tip = read_with("tip.obj", kTip + "v 0 0 -1\n" + kTipFaces, "tip.obj");
  EXPECT_NEAR(packing::volume(tip.problem), 0.5, 1e-12);  // twice as high as without it
  EXPECT_EQ(tip.notes.size(), 2U);
}

TEST_F(SolidFiles, SlitOfARoundedCornerIsClosed) {
  // A box whose upper edge has a vertex in the middle on one side only, off the edge by the last digit.
  const std::string box =
      "v 0 0 0\nv 20 0 0\nv 20 10.000001 0\nv 0 10.000001 0\nv 0 0 10\nv 20 0 10\nv 20 10.000001 10\n"
      "v 0 10.000001 10\nv 9 0.000001 10\n"
      "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 9 8\nf 9 7 8\nf 9 6 7\n";
  const SolidProblemRead slit = read_with("slit.obj", box, "slit.obj");
  EXPECT_NEAR(packing::volume(slit.problem), 2000.0002, 1e-4);
  ASSERT_FALSE(slit.notes.empty());
  EXPECT_NE(slit.notes[0].find("slit"), std::string::npos);
  EXPECT_THROW(read_with("open.obj", kTip + "f 1 3 2\nf 1 2 4\nf 2 3 4\n", "open.obj"), Error);
}

TEST(WriteSolids, LayoutIsReadBack) {
  const packing::SolidProblem problem = read(kTwo).problem;
  packing::SolidLayout layout;
  layout.height = packing::Fraction(17, 3);
  layout.items = {
      {0, 1, 0, {0, 0, 0}}, {0, 2, 0, {2, 0, 0}}, {1, 1, 0, {packing::Fraction(1, 3), 0, packing::Fraction(1, 4)}}};
  const std::string text = layout_json(problem, layout, {});
  const packing::SolidLayout back = read_solid_layout(text, "layout.json", problem);
  EXPECT_EQ(back.height, layout.height);
  ASSERT_EQ(back.items.size(), 3U);
  EXPECT_EQ(back.items[2].at, layout.items[2].at);
  EXPECT_EQ(back.items[1].copy, 2);
  const Surface surface = layout_surface(problem, layout);
  EXPECT_EQ(surface.faces.size(), 2 * 6 + 4U);
  EXPECT_NE(layout_svg(problem, layout, {}).find("height 17/3"), std::string::npos);
}

}  // namespace io_solids
}  // namespace findspace::io
