// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Scenes from text: what is refused with which words, and what is read.
#include <gtest/gtest.h>

#include <string>

#include "findspace/error.h"
#include "io/scene/scene.h"

namespace findspace::io {
namespace io_scene {

using plane::GridPoint;
using plane::Shape;

Scene scene(const std::string& text) { return read_scene_text(text, "/nowhere", "s.json"); }

/// A scene of one shape `a`, and a square `b` that it may refer to.
Scene with_shape(const std::string& shape, const std::string& more = "") {
  return scene(R"({"findspace": 1, "shapes": {"a": )" + shape + R"(, "b": {"box": {"min": [0,0], "max": [1,1]}}})" +
               more + "}");
}

std::string refusal(const std::string& text) {
  try {
    scene(text);
  } catch (const Error& e) {
    return e.what();
  }
  return "it was read";
}

struct Refused {
  const char* text;
  const char* words;
};

class SceneRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(SceneRefuses, WithItsWords) {
  std::string said = refusal(GetParam().text);
  EXPECT_NE(said.find(GetParam().words), std::string::npos) << GetParam().text << "\n" << said;
}

INSTANTIATE_TEST_SUITE_P(
    Json, SceneRefuses,
    ::testing::Values(
        Refused{"", "s.json:1:1"}, Refused{"{", "this is not JSON"}, Refused{"[1, 2]", "a scene must be an object"},
        Refused{"{\"findspace\": 1}", "\"shapes\" is missing"}, Refused{"{\"shapes\": {}}", "\"findspace\" is missing"},
        Refused{"{\"shapes\": {}, \"exact\": {}}", "unknown key 'exact'"},
        Refused{"{\"findspace\": 1, \"shapes\": {}} x", "s.json:1:32"},
        Refused{"{\"findspace\": 1,\n \"findspace\": 1}", "s.json:2:2: the key 'findspace' stands twice"},
        Refused{"{\"findspace\": NaN}", "s.json:1:15"}, Refused{"{\"findspace\": 2, \"shapes\": {}}", "format 1"},
        Refused{"{\"findspace\": \"1\", \"shapes\": {}}", "must be a number, not a text"},
        Refused{"{\"findspace\": 1, \"shaps\": {}}", "unknown key 'shaps', did you mean 'shapes'?"},
        Refused{"{\"findspace\": 1, \"shapes\": []}", "\"shapes\" must be an object, not a list"},
        Refused{"{\"findspace\": 1, \"shapes\": {}, \"unit\": \"furlong\"}", "unknown unit 'furlong'"},
        Refused{"{\"findspace\": 1, \"shapes\": {}, \"grid\": 0}", "\"grid\" must be more than 0"},
        Refused{"{\"findspace\": 1, \"shapes\": {}, \"grid\": -1e-3}", "\"grid\" must be more than 0"},
        Refused{"\x00\xff\xfe\x80", "this is not JSON"},
        Refused{"{\"a\": [1 2]}", "s.json:1:10: this is not JSON: ',' or ']'"},
        Refused{"{\"a\": 01}", "s.json:1:8: this is not JSON: ',' or '}' is expected"},
        Refused{"{\"a\": 1.}", "s.json:1:9: this is not JSON: digits are expected after the decimal point"},
        Refused{"{\"a\": 1e}", "s.json:1:9: this is not JSON: digits are expected after the exponent's letter"},
        Refused{"{\"a\": 1e999}", "s.json:1:7: this is not JSON: the number is beyond 1e308"},
        Refused{"{\"a\": .5}", "s.json:1:7: this is not JSON: a value is expected"},
        Refused{"{\"a\" 5}", "s.json:1:6: this is not JSON: ':' is expected after the name"},
        Refused{"{\"a\": 5,}", "s.json:1:9: this is not JSON: a name in double quotes is expected"},
        Refused{"{'a': 5}", "s.json:1:2: this is not JSON: a name in double quotes is expected"},
        Refused{"{\"a\": \"b", "s.json:1:9: this is not JSON: the end comes too early; a text without its closing"},
        Refused{"{\"a\": \"\\u12\"}", "four hexadecimal digits are expected after '\\u'"},
        Refused{"{\"a\": \"\\q\"}", "no such escape in a text"}, Refused{"{\"a\": \"\xff\"}", "no UTF-8 in a text"},
        Refused{"{\"a\": 5 /* b", "the end comes too early; a comment without its end"},
        Refused{"\xEF\xBB\xBF{\"a\": −5}", "s.json:1:10: this is not JSON: stray character '−'; the minus is '-'"}));

#define SHAPE(text) "{\"findspace\": 1, \"shapes\": {\"a\": " text "}}"
INSTANTIATE_TEST_SUITE_P(
    Shapes, SceneRefuses,
    ::testing::Values(
        Refused{SHAPE("7"), "shape 'a' (s.json:1:34): a shape is an object, a name or a list, not a number"},
        Refused{SHAPE("{}"), "an empty object is not a shape"}, Refused{SHAPE("[]"), "an empty list of shapes"},
        Refused{SHAPE("{\"polygn\": []}"), "did you mean 'polygon'?"},
        Refused{SHAPE("{\"xyzzy\": []}"), "the kinds are polygon, disc"},
        Refused{SHAPE("{\"polygon\": [[0,0],[1,0],[0,1]], \"hols\": []}"), "unknown key 'hols', did you mean 'holes'?"},
        Refused{SHAPE("{\"polygon\": {}}"), "a list of points must be a list, not an object"},
        Refused{SHAPE("{\"polygon\": [[0,0],[1,0],[0,\"1\"]]}"), "shape 'a', vertex 2 (s.json:1:62)"},
        Refused{SHAPE("{\"polygon\": [[0,0],[1,0,0],[0,1]]}"), "a point needs 2 coordinates, not 3"},
        Refused{SHAPE("{\"polygon\": [[0,0],[2e15,0],[0,1]]}"), "more than 2^40 grid steps"},
        Refused{SHAPE("{\"polygon\": [[0,0],[1,0],[0,1]], \"holes\": [[[0,0],[1]]]}"), "hole 0, vertex 1"},
        Refused{SHAPE("{\"polygon\": [[0,0],[1,1],[1,0],[0,1]]}"), "meet at (0.5, 0.5)"},
        Refused{SHAPE("{\"polygon\": [[0,0],[1e-7,0],[0,1e-7]]}"), "fewer than three different points"},
        Refused{SHAPE("{\"disc\": {\"center\": [0,0]}}"), "\"radius\" is missing"},
        Refused{SHAPE("{\"disc\": {\"center\": [0,0], \"radius\": 0}}"), "a radius must be more than 0"},
        Refused{SHAPE("{\"disc\": {\"centre\": [0,0], \"radius\": 1}}"), "did you mean 'center'?"},
        Refused{SHAPE("{\"disc\": {\"center\": [0,0], \"radius\": 2e15}}"), "2^40"},
        Refused{SHAPE("{\"box\": {\"min\": [0,0], \"max\": [1,0]}}"), "must be less than \"max\""},
        Refused{SHAPE("{\"points\": []}"), "an empty list"},
        Refused{SHAPE("{\"polyline\": [[0,0],[0,0]]}"), "two different points"},
        Refused{SHAPE("{\"union\": []}"), "needs at least 1 shape"},
        Refused{SHAPE("{\"difference\": [\"a\"]}"), "needs at least 2"},
        Refused{SHAPE("{\"minkowski_sum\": [\"a\",\"a\",\"a\"]}"), "exactly 2"},
        Refused{SHAPE("{\"union\": \"a\"}"), "must be a list"},
        Refused{SHAPE("\"a\""), "'a' is made from itself: a -> a"},
        Refused{SHAPE("{\"hull\": \"b\"}, \"b\": {\"mirror\": \"a\"}"), "'a' is made from itself: a -> b -> a"},
        Refused{SHAPE("{\"hull\": \"bord\"}, \"board\": {\"points\": [[0,0]]}"),
                "unknown shape 'bord', did you mean 'board'?"},
        Refused{SHAPE("{\"translate\": [1,1]}"), "\"of\" is missing"},
        Refused{SHAPE("{\"file\": \"x.svg\"}"), "there is no such file"},
        Refused{SHAPE("{\"file\": \"x.doc\"}"), "unknown kind '.doc'"},
        Refused{SHAPE("{\"file\": \"\"}"), "empty text"}, Refused{SHAPE("{\"path\": \"\"}"), "empty text"}));

TEST(Scene, RefusesDeepNesting) {
  std::string text = "1";
  for (int i = 0; i < 300; ++i) text = "[" + text + "]";
  EXPECT_NE(refusal(text).find("200 levels"), std::string::npos);
  const std::string first = R"("s0": {"points": [[0,0]]})";
  std::string up = first, down = first;  // each shape after the one it is made from, or before it
  for (int i = 1; i < 2000; ++i) {
    const std::string shape = "\"s" + std::to_string(i) + "\": {\"hull\": \"s" + std::to_string(i - 1) + "\"}";
    up += ", " + shape;
    down = shape + ", " + down;
  }
  for (const std::string& shapes : {up, down})
    EXPECT_NE(refusal("{\"findspace\": 1, \"shapes\": {" + shapes + "}}").find("made from the next"),
              std::string::npos);
}

TEST(Scene, NumbersAreExactDecimals) {
  Scene s = with_shape(R"({"disc": {"center": [1.1, -2e-1], "radius": 0.12345678901234567890123}})");
  EXPECT_EQ(s.shapes[0]->points[0], (GridPoint{1100000, -200000}));
  EXPECT_EQ(compare(s.shapes[0]->amount, exact::Real::parse_decimal("123456.78901234567890123")), 0);
  EXPECT_TRUE(s.notes.empty());
  s = scene(R"({"findspace": 1.0, "unit": "mil", "grid": 0.25, "shapes": {"a": {"points": [[1, -0.75]]}}})");
  EXPECT_EQ(s.shapes[0]->points[0], (GridPoint{4, -3}));
  EXPECT_EQ(s.unit, Unit::kMil);
}

TEST(Scene, RoundsOnceAndSaysSo) {
  Scene s = scene(
      R"({"findspace": 1, "unit": "mm", "shapes": {"a": {"points": [[0.0000005, 0], [-0.0000005, 0], [1, 1], [0, 0.00000131]]}}})");
  EXPECT_EQ(s.shapes[0]->points, (std::vector<GridPoint>{{1, 0}, {-1, 0}, {1000000, 1000000}, {0, 1}}));
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_EQ(s.notes[0], "3 points rounded to the grid, largest move 5e-07 mm");
}

TEST(Scene, CommentsPlacesAndOrder) {
  Scene s = scene(
      "// first\n{\"findspace\": 1, /* inside */ \"shapes\": { // more\n  \"z\": {\"points\": [[0,0]]},\n  \"a\": "
      "\"z\"},\n"
      " \"where\":\n  \"gamma1(a, z) > 0\"}");
  ASSERT_EQ(s.shapes.size(), 2u);
  EXPECT_EQ(s.shapes[0]->name, "z");
  EXPECT_EQ(s.shapes[0]->place, "shape 'z' (s.json:3:8)");
  EXPECT_EQ(s.shapes[1]->name, "a");
  EXPECT_EQ(s.shapes[1]->points.size(), 1u);
  EXPECT_EQ(s.where.text, "gamma1(a, z) > 0");
  EXPECT_EQ(s.where.line, 6);
  EXPECT_EQ(s.where.column, 4);
  EXPECT_EQ(s.find("z"), s.shapes[0]);
  EXPECT_EQ(s.find("y"), nullptr);
  EXPECT_THROW(s.shape("y"), Error);
}

TEST(Scene, Primitives) {
  auto polygon =
      with_shape(R"({"polygon": [[0,0],[0,4],[4,4],[4,0],[0,0]], "holes": [[[1,1],[2,1],[2,2]]]})").shapes[0];
  EXPECT_EQ(polygon->kind, Shape::Kind::kRings);
  ASSERT_EQ(polygon->contours.size(), 2u);
  EXPECT_EQ(polygon->contours[0].size(), 4u);
  EXPECT_EQ(polygon->contours[0][1].start, (GridPoint{4000000, 0}));  // rotated
  auto box = with_shape(R"({"box": {"min": [-1,-2], "max": [3,4]}})").shapes[0];
  EXPECT_EQ(box->contours[0][1].start, (GridPoint{3000000, -2000000}));
  auto polyline = with_shape(R"({"polyline": [[0,0],[1,0],[1,1],[0,0]]})").shapes[0];
  EXPECT_EQ(polyline->kind, Shape::Kind::kPolyline);
  EXPECT_EQ(polyline->contours[0].size(), 4u);
}

TEST(Scene, ConstructiveNodes) {
  struct Node {
    const char* text;
    Shape::Kind kind;
    std::size_t children;
  };
  using Kind = Shape::Kind;
  for (const Node& node :
       {Node{R"({"union": ["b", "b"]})", Kind::kUnion, 2}, Node{R"({"intersection": ["b"]})", Kind::kIntersection, 1},
        Node{R"({"difference": ["b", {"points": [[0,0]]}, "b"]})", Kind::kDifference, 3},
        Node{R"({"complement": "b"})", Kind::kComplement, 1},
        Node{R"({"interior": {"hull": "b"}})", Kind::kInterior, 1}, Node{R"({"closure": "b"})", Kind::kClosure, 1},
        Node{R"({"boundary": "b"})", Kind::kBoundary, 1}, Node{R"({"regularize": "b"})", Kind::kRegularize, 1},
        Node{R"({"mirror": "b"})", Kind::kMirror, 1}, Node{R"({"hull": ["b", "b"]})", Kind::kHull, 1},
        Node{R"({"minkowski_sum": ["b", "b"]})", Kind::kMinkowskiSum, 2},
        Node{R"({"minkowski_difference": ["b", "b"]})", Kind::kMinkowskiDifference, 2}}) {
    auto shape = with_shape(node.text).shapes[0];
    EXPECT_EQ(shape->kind, node.kind) << node.text;
    EXPECT_EQ(shape->children.size(), node.children) << node.text;
  }
  auto moved = with_shape(R"({"translate": [1, 2.5], "of": "b"})").shapes[0];
  EXPECT_EQ(moved->points[0], (GridPoint{1000000, 2500000}));
  EXPECT_EQ(moved->children[0]->name, "b");
  auto rotated = with_shape(R"({"rotate": 22.5, "about": [1, 0], "of": "b"})").shapes[0];
  EXPECT_EQ(compare(rotated->degrees, exact::Real::ratio(45, 2)), 0);
  EXPECT_EQ(rotated->points[0], (GridPoint{1000000, 0}));
  auto eroded = with_shape(R"({"offset": -0.1, "of": "b"})").shapes[0];
  EXPECT_EQ(eroded->amount.integer(), exact::int128(-100000));
}

TEST(Scene, ListsAreCollectionsWhosePartsKeepTheirNames) {
  auto list = with_shape(R"(["b", {"points": [[5,5]]}])").shapes[0];
  EXPECT_EQ(list->kind, Shape::Kind::kUnion);
  EXPECT_TRUE(list->collection);
  EXPECT_EQ(list->name, "a");
  EXPECT_EQ(list->children[0]->name, "b");
  EXPECT_FALSE(with_shape(R"({"union": ["b"]})").shapes[0]->collection);
}

TEST(Scene, PathShapes) {
  auto key = with_shape(R"({"path": "M0 0 H10 A5 5 0 0 1 10 10 H0 Z"})").shapes[0];
  ASSERT_EQ(key->kind, Shape::Kind::kRings);
  ASSERT_EQ(key->contours[0].size(), 4u);
  EXPECT_TRUE(key->contours[0][1].arc);
  EXPECT_TRUE(key->contours[0][1].ccw);
  EXPECT_EQ(key->contours[0][1].arc->cy.integer(), exact::int128(5000000));
}

TEST(Scene, FilesCanBeSwitchedOff) {
  ReadOptions options;
  options.files = false;
  for (const char* file : {"x.svg", "x.stl"}) {
    std::string text = std::string(R"({"findspace": 1, "shapes": {"a": {"file": ")") + file + "\"}}}";
    try {
      read_scene_text(text, ".", "s.json", options);
      FAIL();
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::kUnsupported);
    }
  }
}

TEST(Scene, MissingFilesAndFolders) {
  EXPECT_THROW(read_scene("/nowhere/at/all.json"), Error);
  try {
    read_scene("/tmp");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kFile);
  }
}

}  // namespace io_scene
}  // namespace findspace::io
