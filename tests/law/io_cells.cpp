// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets of the plane written as exact cells and as constructive shapes read back as the same sets: random shapes of
// every kind of node, with open edges, cracks, whiskers, single points, arcs of offset radius and rotated vertices;
// also on another grid. What is not a set of cells is refused.
#include <findspace/error.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "exact/number/real_text.h"
#include "io/scene/scene.h"
#include "io/write/write_cells.h"
#include "io/write/write_constructive.h"
#include "plane/build/build.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace io_cells {

using exact::Real;
using plane::Region;

Scene scene_of(const std::string& shape, const std::string& grid = "1e-3") {
  const std::string text =
      fmt::format(R"({{"findspace": 1, "unit": "mm", "grid": {}, "shapes": {{"S": {}}}}})", grid, shape);
  return read_scene_text(text, ".", "test");
}

Region region_of(const Scene& scene) { return plane::build(*scene.shape("S")).region; }

bool same_set(const Region& a, const Region& b) {
  const std::array<const Region*, 2> both{&a, &b};
  return plane::is_empty(
      plane::overlay(both, [](std::span<const plane::Mark> m) { return plane::Mark(m[0] != m[1]); }));
}

class Shapes {
 public:
  explicit Shapes(unsigned seed) : random_(seed) {}

  std::string shape(int depth) {
    if (depth == 0) return leaf();
    const auto child = [&] { return shape(depth - 1); };
    switch (number(0, 10)) {
      case 0:
        return fmt::format(R"({{"union": [{}, {}]}})", child(), child());
      case 1:
        return fmt::format(R"({{"intersection": [{}, {}]}})", child(), child());
      case 2:
      case 3:
        return fmt::format(R"({{"difference": [{}, {}]}})", child(), child());
      case 4:
        return fmt::format(R"({{"complement": {}}})", child());
      case 5:
        return fmt::format(R"({{"interior": {}}})", child());
      case 6:
        return fmt::format(R"({{"boundary": {}}})", child());
      case 7:
        return fmt::format(R"({{"regularize": {}}})", child());
      case 8:
        return fmt::format(R"({{"rotate": {}, "of": {}}})", number(1, 89), leaf());
      case 9:
        return fmt::format(R"({{"offset": {}, "of": {}}})", number(1, 9) / 4.0, leaf());
      default:
        return fmt::format(R"({{"minkowski_sum": [{}, {{"disc": {{"center": [0, 0], "radius": 0.7}}}}]}})", leaf());
    }
  }

 private:
  int number(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  std::string point() { return fmt::format("[{}, {}]", number(-6, 6), number(-6, 6)); }

  std::string leaf() {
    const int x = number(-6, 3), y = number(-6, 3);
    switch (number(0, 6)) {
      case 0:
        return fmt::format(R"({{"disc": {{"center": {}, "radius": {}}}}})", point(), number(1, 12) / 4.0);
      case 1:
        return fmt::format(R"({{"points": [{}, {}]}})", point(), point());
      case 2:
        return fmt::format(R"({{"polyline": [[{}, {}], [{}, {}]]}})", x, y, x + number(1, 4), y + number(-3, 3));
      case 3:
        return fmt::format(R"({{"path": "M{0} {1} h4 a2 2 0 0 1 0 4 h-4 z"}})", x, y);
      case 4:
        return fmt::format(R"({{"polygon": [[{0}, {1}], [{2}, {1}], [{0}, {3}]]}})", x, y, x + number(1, 6),
                           y + number(1, 6));
      case 5:
        return fmt::format(
            R"({{"polygon": [[-5, -5], [5, -5], [5, 5], [-5, 5]], "holes": [[[{0}, 0], [4, 0], [4, 3]]]}})",
            number(-4, 2));
      default:
        return fmt::format(R"({{"box": {{"min": [{}, {}], "max": [{}, {}]}}}})", x, y, x + number(1, 6),
                           y + number(1, 6));
    }
  }

  std::mt19937 random_;
};

TEST(Cells, ReadBackAsTheSameSet) {
  Shapes random(3);
  for (int round = 0; round < 250; ++round) {
    const std::string shape = random.shape(round % 4);
    const Scene scene = scene_of(shape);
    const Region region = region_of(scene);
    const Real step = scene.grid.step();
    const std::string cells = "{\"cells\": " + cells_json(region, step, "mm") + "}";
    const Region back = region_of(scene_of(cells));
    ASSERT_TRUE(same_set(region, back)) << shape << "\n" << cells;
    ASSERT_EQ(back.vertices.size(), region.vertices.size()) << shape;
    ASSERT_EQ(back.edges.size(), region.edges.size()) << shape;
    // In another unit, on another grid.
    const std::string metres =
        fmt::format(R"({{"findspace": 1, "unit": "m", "grid": 1e-6, "shapes": {{"S": {}}}}})", cells);
    ASSERT_TRUE(same_set(region, region_of(read_scene_text(metres, ".", "test")))) << shape;
    if (shape.find("rotate") != std::string::npos) continue;  // which rounds to the grid
    ASSERT_TRUE(same_set(region_of(scene_of(shape, "1e-4")), region_of(scene_of(cells, "1e-4")))) << shape;
  }
}

TEST(Constructive, MakesTheSameSet) {
  Shapes random(4);
  for (int round = 0; round < 250; ++round) {
    const std::string shape = random.shape(round % 4);
    const Scene scene = scene_of(shape);
    const Region region = region_of(scene);
    const std::string tree = constructive_json(region, scene.grid.step());
    ASSERT_TRUE(same_set(region, region_of(scene_of(tree)))) << shape << "\n" << tree;
    ASSERT_NO_THROW(read_scene_text(constructive_scene(region, "S", scene.grid, "mm"), ".", "test"));
  }
}

TEST(Constructive, SaysSimpleShapesSimply) {
  const auto tree = [](const std::string& shape) {
    const Scene scene = scene_of(shape);
    return constructive_json(region_of(scene), scene.grid.step());
  };
  EXPECT_EQ(tree(R"({"box": {"min": [0, 0], "max": [2, 1.5]}})"),
            R"({"polygon": [[0, 0], [2, 0], [2, 1.5], [0, 1.5]]})");
  EXPECT_EQ(tree(R"({"disc": {"center": [1, 2], "radius": 0.25}})"), R"({"disc": {"center": [1, 2], "radius": 0.25}})");
  EXPECT_EQ(tree(R"({"complement": {"points": [[1, 2]]}})"), R"({"complement": {"points": [[1, 2]]}})");
  EXPECT_EQ(tree(R"({"polyline": [[0, 0], [3, 1]]})"), R"({"polyline": [[0, 0], [3, 1]]})");
}

void expect_refused(const std::string& cells, const std::string& why) {
  try {
    scene_of("{\"cells\": " + cells + "}");
    FAIL() << why;
  } catch (const Error& e) {
    EXPECT_NE(e.message().find(why), std::string::npos) << e.message();
    EXPECT_NE(e.place().find("test:1:"), std::string::npos) << e.place();
  }
}

TEST(Cells, RefusesWhatIsNoSetOfCells) {
  const auto cells = [](const std::string& supporting_curves, const std::string& vertices, const std::string& edges) {
    return fmt::format(R"({{"step": 1, "outside": false, "supporting_curves": [{}], "vertices": [{}], "edges": [{}]}})",
                       supporting_curves, vertices, edges);
  };
  const std::string line = R"({"line": [0, 1, 0]})", a = R"({"at": [0, 0], "in": true})",
                    b = R"({"at": [4, 0], "in": true})";
  const std::string ab = R"({"on": 0, "from": 0, "to": 1, "in": true, "left": false, "right": false})";
  EXPECT_NO_THROW(scene_of("{\"cells\": " + cells(line, a + "," + b, ab) + "}"));
  expect_refused(
      cells(line, a + "," + b, R"({"on": 0, "from": 1, "to": 0, "in": true, "left": false, "right": false})"),
      "to the right");
  expect_refused(cells(line, a + "," + b, R"({"on": 0, "from": 0, "to": 1, "in": true, "left": true, "right": false})"),
                 "disagree");
  expect_refused(
      cells(line, a + "," + b, R"({"on": 1, "from": 0, "to": 1, "in": true, "left": false, "right": false})"),
      "from 0 to 0");
  expect_refused(cells(line, a + R"(,{"at": [4, 1], "in": true})", ab), "not on its supporting curve");
  expect_refused(cells(line, a + "," + b + R"(,{"at": [2, 0], "in": true, "around": false})", ab), "without a vertex");
  expect_refused(cells(line, a + "," + b + R"(,{"at": [2, 2], "in": true})", ab), "around");
  expect_refused(cells(R"({"circle": [0, 0, 0]})", "", ""), "radius");
  expect_refused(cells(R"({"circle": [0, 0, "1/0"]})", "", ""), "zero");
  expect_refused(cells(R"({"circle": [0, 0, "sqrt(2"]})", "", ""), "expected");
  expect_refused(cells(R"({"circle": [0, 0, "#0"]})", "", ""), "defined");
  expect_refused(
      cells(line + R"(, {"line": [0, 1, 2]})", R"({"on": [0, 1], "root": 0, "in": true, "around": false})", ""),
      "do not meet");
  expect_refused(cells(R"({"circle": [2, 0, 2]})", a + "," + b,
                       R"({"on": 0, "from": 0, "to": 1, "in": true, "left": false, "right": false})"),
                 "half");
}

TEST(ExactNumbers, ReadBackAsTheyWere) {
  exact::RealWriter writer;
  const Real five = sqrt(Real(5)), deep = sqrt(Real(2) + sqrt(Real(3))) * five + Real::ratio(1, 3);
  const std::vector<Real> all{
      Real(7),     Real::ratio(-5, 3),         five, (Real(1) - Real(2) * five) / Real(3), -five / Real(7), deep,
      deep * deep, sqrt(deep - Real(1)) / five};
  std::vector<std::string> texts;
  for (const Real& x : all) texts.push_back(writer.text(x));
  exact::RealReader reader;
  for (const std::string& d : writer.definitions()) reader.define(d);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(compare(reader.read(texts[i]), all[i]), 0) << texts[i];
  EXPECT_EQ(texts[3], "(1-2*sqrt(5))/3");
}

}  // namespace io_cells
}  // namespace findspace::io
