// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems in space as files.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/mesh/read_mesh.h"
#include "io/nesting/read_solids.h"
#include "io/nesting/write_solids.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_proof/verify_solids.h"
#include "space/mesh/mesh.h"

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
  try {
    read_nesting(R"({"item-types": []})", "none.json", {});
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("needs a 'container'"), std::string::npos) << e.what();
  }
  EXPECT_NE(message_of(head + R"([{"demand": 1}]})").find("either a 'path' or a 'shape'"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"path": "a.obj"}]})").find("'demand' is missing"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"demand": 1, "path": "none.obj"}]})").find("none.obj"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"demand": 1, "path": 3}]})").find("a path is meant"), std::string::npos);
  EXPECT_NE(message_of(head + R"([{"demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}}]})").find("'id'"),
            std::string::npos);
  const std::string round =
      R"({"id": "b", "demand": 1, "shape": {"offset": 0.1, "of": {"box": {"min": [0,0,0], "max": [1,1,1]}}}})";
  EXPECT_NE(message_of(head + "[" + round + "]}").find("flat faces"), std::string::npos);
  const std::string wide = R"({"id": "w", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [5,1,1]}}})";
  EXPECT_NE(message_of(head + "[" + wide + "]}").find("does not stand on the floor"), std::string::npos);
  const std::string twice = R"({"id": "w", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}})";
  EXPECT_NE(message_of(head + "[" + twice + "," + twice + "]}").find("two items 'w'"), std::string::npos);
  const std::string item = R"("id": "w", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}})";
  const std::string open = head + "[{" + item;
  EXPECT_THROW(read_solids(open + "}]}", "a", {.height = {}, .gap = -1, .edge = 0}, {}), Error);
  EXPECT_THROW(read_solids(open + "}]}", "a", {.height = {}, .gap = 0, .edge = -1}, {}), Error);
  EXPECT_NE(message_of(open + R"(}], "unit": "cm"})").find("no unit"), std::string::npos);
  EXPECT_NE(message_of(open + R"(}], "gap": 2})").find("unknown key 'gap', did you mean 'gaps'"), std::string::npos);
  EXPECT_NE(message_of(open + R"(, "mirrored": true}]})").find("unknown key 'mirrored'"), std::string::npos);
  EXPECT_NE(message_of(open + R"(}], "gaps": [{"between": ["w", "w"], "gap": 1, "x": 1}]})").find("key 'x'"),
            std::string::npos);
}

TEST(ReadSolids, ContainersOfAnyShape) {
  const auto with = [](const std::string& container) {
    return R"({"containers": [{"id": "c", )" + container +
           R"(}], "item-types": [{"id": "b", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}}]})";
  };
  const std::string tent = R"("polytope": [[1,0,0], [5,0,0], [3,0,2.5], [1,4,0], [5,4,0], [3,4,2.5]])";
  const SolidProblemRead made = read(with(R"("count": 2, "shape": {)" + tent + "}"));
  const packing::SolidContainer& c = made.problem.containers.at(0);
  EXPECT_EQ(made.problem.digits, 1);
  EXPECT_EQ(c.width, packing::Fraction(4));
  EXPECT_EQ(c.height, packing::Fraction(5, 2));
  EXPECT_NE(c.inside, nullptr);
  EXPECT_EQ(read(with(R"("shape": {"box": {"min": [1,1,1], "max": [3,3,4]}})")).problem.containers[0].inside, nullptr);
  const auto says = [&](const std::string& container, const char* words) {
    EXPECT_NE(message_of(with(container)).find(words), std::string::npos) << message_of(with(container));
  };
  says(R"("size-x": 3, "shape": {)" + tent + "}",
       "problem.json:1:39: a container has either sizes or a shape of its own");
  says(R"("path": "none.stl")", "there is no such file");
  const std::string ball = R"({"ball": {"center": [0,0,0], "radius": 2.5}})";
  says(R"("shape": {"complement": )" + ball + "}", "a container is bounded");
  says(R"("shape": {"union": [{)" + tent + "}, " + ball + "]}", "a container is a solid with flat faces, a ball");
  says(R"("shape": {"polytope": [[0,0,0], [1,0,0], [0,1,0], [1,1,0]]})", "container 'c' (problem.json:1:17)");
  says(R"("shape": {"mesh": {"vertices": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]], "faces": [[0,2,1], [0,1,3], [0,3,2]]}})",
       "not closed");
  says("\"count\": 1", "size-x");
  const SolidProblemRead tank = read(with(R"("shape": )" + ball));
  EXPECT_EQ(tank.problem.containers[0].depth, packing::Fraction(5));
  const SolidProblemRead both =
      read(with(R"("shape": {"union": [{)" + tent + R"(}, {"box": {"min": [0,0,0], "max": [1,1,1]}}]})"));
  EXPECT_EQ(both.problem.containers[0].width, packing::Fraction(5));
  EXPECT_NE(both.problem.containers[0].lacks, nullptr);
}

TEST(ReadSolids, FixedSolids) {
  const auto with = [](const std::string& fixed, const std::string& floor) {
    return R"({"fixed": [)" + fixed + "], " + floor +
           R"(, "item-types": [{"id": "b", "demand": 2, "shape": {"box": {"min": [0,0,0], "max": [1,2,3]}}}]})";
  };
  const std::string floor = R"("container": {"size-x": 4, "size-y": 4})";
  const std::string crates = R"("containers": [{"id": "crate", "count": 2, "size-x": 4, "size-y": 4, "size-z": 4}])";
  const packing::SolidProblem upon = read(with(R"({"part": "b", "at": ["1/3", 0, 5]})", floor)).problem;
  ASSERT_EQ(upon.fixed.size(), 1U);
  EXPECT_EQ(upon.fixed[0].placed.at, (std::array<packing::Fraction, 3>{packing::Fraction(1, 3), 0, 5}));
  EXPECT_EQ(upon.free_copies(0), 1);
  const packing::SolidProblem within = read(with(R"({"part": "b", "at": [0, 0, 0], "container": "crate"},
                   {"part": "b", "at": [3, 2, 1], "container": "crate", "number": 2})",
                                                 crates))
                                           .problem;
  EXPECT_EQ(within.fixed[1].placed.container, 1U);
  const auto says = [&](const std::string& fixed, const std::string& where, const char* words) {
    EXPECT_NE(message_of(with(fixed, where)).find(words), std::string::npos) << message_of(with(fixed, where));
  };
  says(R"({"part": "c", "at": [0, 0, 0]})", floor, "'c'");
  says(R"({"part": "b", "at": [0, 0]})", floor, "a list of three numbers");
  says(R"({"part": "b"})", floor, "'at' is missing");
  says(R"({"part": "b", "at": [0, 0, 0], "rotation": [[0,-1,0],[1,0,0],[0,0,1]]})", floor, "not allowed");
  says(R"({"part": "b", "at": [0, 0, 0], "container": "crate"})", floor, "there is only a floor");
  says(R"({"part": "b", "at": [0, 0, 0]})", crates, "'container' is missing");
  says(R"({"part": "b", "at": [0, 0, 0], "container": "crate", "number": 3})", crates, "no container crate number 3");
  says(R"({"part": "b", "at": [0, 0, 0], "container": "crate", "number": 2})", crates, "without a gap");
  says(R"({"part": "b", "at": [3.5, 0, 0]})", floor, "fixed: b#1 is outside by 0.5");
  says(R"({"part": "b", "at": [0, 0, 2], "container": "crate"})", crates, "is outside by 1");
  says(R"({"part": "b", "at": [0, 0, 0]}, {"part": "b", "at": [0.5, 0, 1]})", floor, "fixed: b#1 and b#2 overlap");
  says(R"({"part": "b", "at": [0, 0, 0]}, {"part": "b", "at": [1, 0, 0]}, {"part": "b", "at": [2, 0, 0]})", floor,
       "more copies of 'b' are fixed than its demand");
  says(R"({"part": "b", "at": [0, 0, 0], "angle": 90})", floor, "unknown key 'angle'");
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
  EXPECT_NE(message_of(with("[[[1,0,0],[0,1,0],[0,0,-1]]]")).find("determinant"), std::string::npos);
  EXPECT_NE(message_of(with("[[[2,0,0],[0,1,0],[0,0,1]]]")).find("length 2"), std::string::npos);
}

/// As scenes spell them.
TEST(ReadSolids, AnyRationalOrientation) {
  const auto with = [](const std::string& allowed) {
    return R"({"container": {"size-x": 9, "size-y": 9}, "item-types": [{"id": "b", "demand": 1, "allowed_orientations": [)" +
           allowed + R"(], "shape": {"box": {"min": [0,0,0], "max": [5,5,5]}}}]})";
  };
  const packing::SolidProblem problem =
      read(with(R"({"quaternion": [2, 0, 0, 1]}, {"matrix": [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]]},
                   {"axis": [1, 1, 1], "degrees": 120}, 90, [["3/5", "-4/5", 0], ["4/5", "3/5", 0], [0, 0, 1]])"))
          .problem;
  const auto& forms = problem.parts[0].forms;
  ASSERT_EQ(forms.size(), 5U);
  EXPECT_EQ(forms[0].rotation, forms[1].rotation);
  EXPECT_EQ(forms[0].rotation, forms[4].rotation);
  EXPECT_EQ(forms[0].rotation[0][0], packing::Fraction(3, 5));
  EXPECT_EQ(forms[2].rotation[0][2], packing::Fraction(1));
  EXPECT_EQ(packing::box_of(problem, forms[0]).high[1], packing::Fraction(7));
  packing::SolidLayout layout;
  layout.height = 5;
  layout.items = {{0, 1, 0, {4, 0, 0}}};
  EXPECT_EQ(read_solid_layout(layout_json(problem, layout, {}), "layout.json", problem).items[0].form, 0U);
  EXPECT_NE(message_of(with("30")).find("no rational matrix"), std::string::npos);
  EXPECT_NE(message_of(with(R"({"quaternion": [0, 0, 0, 0]})")).find("quaternion"), std::string::npos);
}

TEST(ReadSolids, Balls) {
  const std::string text = R"({"container": {"size-x": 9, "size-y": 9}, "item-types": [
    {"id": "ball", "demand": 3, "shape": {"ball": {"center": [0, 1, 0], "radius": 0.5}}},
    {"id": "pin", "demand": 1, "shape": {"union": [{"ball": {"center": [0, 0, 0], "radius": 1}},
                                                    {"box": {"min": [0, 0, 0], "max": [1, 1, 4]}}]}}]})";
  const packing::SolidProblem problem = read(text).problem;
  const packing::SolidBox bounds = packing::box_of(problem, problem.parts[0].forms[0]);
  EXPECT_EQ(bounds.low, (std::array<packing::Fraction, 3>{packing::Fraction(-1, 2), packing::Fraction(1, 2),
                                                          packing::Fraction(-1, 2)}));
  EXPECT_NEAR(packing::volume_of(problem, problem.parts[0]), 0.5235987756, 1e-9);
  EXPECT_EQ(problem.parts[1].forms[0].body.parts.size(), 2U);
}

TEST(ReadSolids, PartsOfAUnionMayOverlap) {
  const packing::SolidProblem problem =
      read(R"({"container": {"size-x": "1.5", "size-y": 1}, "item-types": [{"id": "u", "demand": 2, "shape": {"union": [
        {"box": {"min": [0,0,0], "max": [1,1,1]}}, {"box": {"min": [0.5,0,0], "max": [1.5,1,1]}},
        {"polytope": [[0.5,0,0], [1.5,0,0], [1.5,0,1], [0.5,1,0], [1.5,1,0], [1.5,1,1]]}]}}]})")
          .problem;
  EXPECT_EQ(packing::volume_of(problem, problem.parts[0]), 1.5);
  EXPECT_EQ(packing::lower_bound(problem), packing::Fraction(2));
}

TEST(ReadSolids, Containers) {
  const std::string head =
      R"({"containers": [{"id": "c", "size-x": 4, "size-y": 3, "size-z": 2, "count": 5, "cost": 1.5})";
  const std::string items =
      R"(], "item-types": [{"id": "b", "demand": 1, "value": "1/3", "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}}]})";
  const packing::SolidProblem problem = read(head + items).problem;
  ASSERT_EQ(problem.containers.size(), 1U);
  EXPECT_EQ(problem.containers[0].height, packing::Fraction(2));
  EXPECT_EQ(problem.containers[0].count, 5);
  EXPECT_EQ(problem.parts[0].value, packing::Fraction(1, 3));
  EXPECT_TRUE(is_solid_problem(head + items, "a"));
  EXPECT_NE(message_of(head + R"(,{"id": "d", "size-x": 1, "size-y": 1, "size-z": 1})" + items).find("a cost"),
            std::string::npos);
  EXPECT_NE(
      message_of(head + R"(,{"id": "d", "cost": 1, "size-x": 0, "size-y": 1, "size-z": 1})" + items).find("above 0"),
      std::string::npos);
  EXPECT_NE(message_of(head + R"(], "container": {"size-x": 1, "size-y": 1)" + "}" + items.substr(1)).find("either"),
            std::string::npos);
  packing::SolidLayout layout;
  layout.height = 1;
  layout.containers = {0, 0};
  layout.items = {{0, 1, 0, {0, 0, 0}, 1}};
  layout.left_out = {{0, 2, "no container was found for it"}};
  const packing::SolidLayout back = read_solid_layout(layout_json(problem, layout, {}), "layout.json", problem);
  EXPECT_EQ(back.containers, layout.containers);
  EXPECT_EQ(back.items[0].container, 1U);
  EXPECT_EQ(back.left_out[0].copies, 2);
  EXPECT_NE(layout_svg(problem, layout, {}).find("2 containers, 1 of the last"), std::string::npos);
}

TEST(ReadSolids, ConditionsOfPairs) {
  const auto with = [](const std::string& more) {
    return R"({"container": {"size-x": 9, "size-y": 9}, )" + more +
           R"(, "item-types": [{"id": "a", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}},
                               {"id": "b", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}}]})";
  };
  const packing::SolidProblem problem =
      read(with(R"("where": "reach(self, other) <= 9", "gaps": [{"between": ["a", "b"], "gap": 2}],
                   "pairs": [{"between": ["a", "b"], "where": "gap(self, other, along=(0, 0, 1)) >= 1"}],
                   "groups": [{"parts": ["b"], "within": 3}])"))
          .problem;
  EXPECT_EQ(problem.conditions.size(), 5U);
  EXPECT_EQ(problem.gap_of(1, 0), packing::Fraction(2));
  EXPECT_NE(message_of(with(R"("groups": [{"parts": ["b"]}])")).find("within"), std::string::npos);
  EXPECT_NE(message_of(with(R"("where": "gap(self, others) <= 2")")).find("'where'"), std::string::npos);
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

TEST_F(SolidFiles, AContainerFromAFile) {
  const auto read_in = [&](const std::string& faces, const std::string& more) {
    std::ofstream(folder_ / "hull.obj") << kTip << faces;
    return read(
        R"({"containers": [{"id": "hull", "path": "hull.obj")" + more +
            R"(}], "item-types": [{"id": "b", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [1,1,1]}}}]})",
        (folder_ / "problem.json").string());
  };
  const SolidProblemRead made = read_in(kTipFaces, "");
  EXPECT_EQ(made.problem.digits, 1);
  EXPECT_EQ(made.problem.containers[0].width, packing::Fraction(3, 2));
  EXPECT_NE(made.problem.containers[0].inside, nullptr);
  const auto refusal = [&](const std::string& faces, const std::string& more) -> std::string {
    try {
      read_in(faces, more);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(refusal(kTipFaces, R"(, "shape": "b")").find("a container has either a 'path' or a 'shape'"),
            std::string::npos);
  EXPECT_NE(refusal("f 1 3 2\nf 1 2 4\nf 2 3 4\n", "").find("hull.obj"), std::string::npos);  // open
}

TEST_F(SolidFiles, FoldersOfTheDataSets) {
  EXPECT_EQ(read_with("convex/tip.obj", kTip + kTipFaces, "Nobody et al. 2004/convex/tip.obj").problem.parts.size(),
            1U);
}

TEST_F(SolidFiles, LooseVertexOfAConvexMeshBelongsToIt) {
  const SolidProblemRead tip = read_with("tip.obj", kTip + "v 0 0 -1\n" + kTipFaces, "tip.obj");
  EXPECT_NEAR(packing::volume(tip.problem), 0.5, 1e-12);  // twice as high as without it
  const std::vector<std::string> notes{
      "tip.obj: 1 vertex belongs to no face; the convex hull of all vertices is taken"};
  EXPECT_EQ(tip.notes, notes);
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
  const Surface surface = united(layout_assembly(problem, layout));
  EXPECT_EQ(surface.faces.size(), 2 * 6 + 4U);
  EXPECT_NE(layout_svg(problem, layout, {}).find("height 17/3"), std::string::npos);
}

/// What all formats for surfaces hold of a layout, read again: as much volume in the same box.
TEST(WriteSolids, SurfacesAreReadBack) {
  const std::string text =
      R"({"name": "three", "containers": [{"id": "c", "size-x": 9, "size-y": 9, "size-z": 9, "count": 2}],
    "item-types": [{"id": "tip", "demand": 2, "allowed_orientations": [0, {"quaternion": [2, 0, 0, 1]}],
                    "shape": {"polytope": [[0,0,0], [5,0,0], [0,5,0], [0,0,3]]}},
                   {"id": "slab", "demand": 1, "shape": {"box": {"min": [0,0,0], "max": [4,2,1]}}}]})";
  const packing::SolidProblem problem = read(text).problem;
  packing::SolidLayout layout;
  layout.height = 6;
  layout.containers = {0, 0};
  layout.items = {{0, 1, 0, {0, 0, 0}, 0}, {0, 2, 1, {4, 0, 0}, 1}, {1, 1, 0, {0, 0, packing::Fraction(7, 2)}, 0}};
  ASSERT_TRUE(packing::verify(problem, layout).is_feasible());
  const Assembly assembly = layout_assembly(problem, layout);
  for (const char* ending : {".stl", ".obj", ".off", ".ply", ".3mf", ".glb"}) {
    ReadContext context;
    context.grid = Grid(exact::Real::ratio(1, 1000));
    const space::Mesh mesh =
        parse_mesh(assembly_text(assembly, "three", ending, "m"), ending, context, [](const auto& millimetres) {
          // 3MF states its unit, GLB is in metres.
          return millimetres ? *millimetres / exact::Real(1000) : exact::Real(1);
        });
    std::array<std::int64_t, 3> low{1 << 20, 1 << 20, 1 << 20}, high{-(1 << 20), -(1 << 20), -(1 << 20)};
    for (const space::Point& p : mesh.vertices) {
      const std::array<std::int64_t, 3> c{p.x, p.y, p.z};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], c[k]);
        high[k] = std::max(high[k], c[k]);
      }
    }
    const double unit = 1000;  // steps
    EXPECT_NEAR(low[0], 0, 1) << ending;
    EXPECT_NEAR(low[1], 0, 1) << ending;
    EXPECT_NEAR(high[0], (1.15 * 9 + 4 + 3) * unit, 1) << ending;  // the turned tip, beside the first container
    EXPECT_NEAR(high[1], 5 * unit, 1) << ending;
    EXPECT_NEAR(high[2], 4.5 * unit, 1) << ending;
    EXPECT_NEAR(space::six_volumes(mesh).to_double() / (unit * unit * unit), 6 * (2 * 12.5 + 8), 1.5) << ending;
  }
  // Every copy is an item of its own in 3MF, and a node in GLB.
  const std::string glb = assembly_text(assembly, "three", ".glb", "mm");
  for (const char* name : {"tip#1", "tip#2", "slab#1"}) EXPECT_NE(glb.find(name), std::string::npos);
}

}  // namespace io_solids
}  // namespace findspace::io
