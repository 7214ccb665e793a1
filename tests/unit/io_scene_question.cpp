// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene asks: moving, free, motion, place.
#include <gtest/gtest.h>

#include <string>

#include "findspace/error.h"
#include "io/scene/scene.h"

namespace findspace::io {
namespace io_scene_question {

using exact::Real;

Scene asking(const std::string& question) {
  return read_scene_text(
      R"({"findspace": 1, "shapes": {"A": {"points": [[0,0]]}, "B": {"points": [[1,1]]}}, )" + question + "}", ".",
      "s.json");
}

std::string refusal(const std::string& question) {
  try {
    asking(question);
  } catch (const Error& e) {
    return e.what();
  }
  return "it was read";
}

void expect_refused(const std::string& question, const std::string& words) {
  std::string said = refusal(question);
  EXPECT_NE(said.find(words), std::string::npos) << question << "\n" << said;
}

TEST(SceneQuestion, Moving) {
  expect_refused(R"("moving": "C")", "unknown shape 'C'");
  expect_refused(R"("moving": [])", "empty list");
  expect_refused(R"("moving": ["A", "A"])", "'A' stands here twice");
  expect_refused(R"("moving": 3)", "must be a list");
  EXPECT_EQ(asking(R"("moving": "B")").moving, (std::vector<std::string>{"B"}));
  EXPECT_EQ(asking(R"("moving": ["B", "A"])").moving, (std::vector<std::string>{"B", "A"}));
}

TEST(SceneQuestion, Formulas) {
  expect_refused(R"("where": "")", "\"where\" is an empty text");
  expect_refused(R"("where": 3)", "must be a text");
  expect_refused(R"("where": ["x", 3])", "must be a text");
  Scene s = asking(R"("minimize": "y", "maximize": "x")");
  EXPECT_EQ(s.minimize.text, "y");
  EXPECT_EQ(s.maximize.text, "x");
  EXPECT_TRUE(s.where.empty());
}

TEST(SceneQuestion, Free) {
  EXPECT_EQ(asking(R"("moving": "B")").free.kind, Free::Kind::kPosition);
  expect_refused(R"("free": "positon")", "did you mean 'position'?");
  expect_refused(R"("free": {"line": {"through": [0,0]}})", "needs \"through\" and \"direction\"");
  expect_refused(R"("free": {"line": {"through": [0,0], "direction": [0,0]}})", "must not be zero");
  expect_refused(R"("free": {"line": {"through": [0,0], "direction": [1e30,1]}})", "direction");
  expect_refused(R"("free": {"line": {"through": [0,0], "direction": [1]}})", "needs 2 numbers");
  expect_refused(R"("free": {"line": {"trough": [0,0], "direction": [1,0]}})", "did you mean 'through'?");
  expect_refused(R"("free": {"angle": {}, "angels": 3})", "unknown key 'angels'");
  expect_refused(R"("free": {"angle": [5, 0]})", "\"angle\" of \"free\"");
  expect_refused(R"("free": {})", "empty object");
  expect_refused(R"("free": "time")", "needs \"motion\"");
  expect_refused(R"("free": "pose")", "needs \"angles\"");
  expect_refused(R"("free": "pose", "angles": 0)", "whole number from 1");
  expect_refused(R"("free": "pose", "angles": 2.5)", "whole number from 1");
  expect_refused(R"("free": "pose", "angles": [])", "empty list");
  expect_refused(R"("free": "angle", "angles": 3)", "belongs to");
  expect_refused(R"("about": [0,0])", "belongs to");
}

TEST(SceneQuestion, Lines) {
  Free free = asking(R"("free": {"line": {"through": [4.5, 0], "direction": [0.6, -0.8]}})").free;
  EXPECT_EQ(free.kind, Free::Kind::kLine);
  EXPECT_EQ(free.through, (GridPosition{4500000, 0, 0}));
  EXPECT_EQ(free.direction, (GridPosition{3, -4, 0}));
  EXPECT_EQ(asking(R"("free": {"line": {"through": [0, 0], "direction": [0, 1000]}})").free.direction,
            (GridPosition{0, 1, 0}));
  EXPECT_EQ(asking(R"("free": {"line": {"through": [0, 0], "direction": [2e3, 5]}})").free.direction,
            (GridPosition{400, 1, 0}));
}

TEST(SceneQuestion, AnglesAndPosesInEverySpelling) {
  for (const char* text : {R"("free": "angle", "about": [1, 2])", R"("free": {"angle": {"about": [1, 2]}})",
                           R"("free": {"angle": {}, "about": [1, 2]})"}) {
    Free free = asking(text).free;
    EXPECT_EQ(free.kind, Free::Kind::kAngle) << text;
    EXPECT_EQ(free.about, (GridPosition{1000000, 2000000, 0})) << text;
  }
  Free pose = asking(R"("free": {"pose": {"angles": 7}})").free;
  ASSERT_EQ(pose.angles.size(), 7u);
  EXPECT_EQ(compare(pose.angles[1], Real::ratio(360, 7)), 0);
  pose = asking(R"("free": "pose", "angles": [0, 22.5])").free;
  EXPECT_EQ(compare(pose.angles[1], Real::ratio(45, 2)), 0);
}

TEST(SceneQuestion, Motion) {
  expect_refused(R"("motion": {"A": {"path": [[0,0]]}})", "\"time\" is missing");
  expect_refused(R"("motion": {"time": [1, 0], "A": {"path": [[0,0]]}})", "start < end");
  expect_refused(R"("motion": {"time": [0, 1]})", "moves no shape");
  expect_refused(R"("motion": {"time": [0, 1], "C": {"path": [[0,0]]}})", "unknown shape 'C'");
  expect_refused(R"("motion": {"time": [0, 1], "A": {"path": []}})", "at least one way point");
  expect_refused(R"("motion": {"time": [0, 1], "A": {"path": [[0,0],[1,1]], "times": [0]}})", "2 numbers are needed");
  expect_refused(R"("motion": {"time": [0, 1], "A": {"path": [[0,0],[1,1]], "times": [1, 0]}})", "must ascend");
  expect_refused(R"("motion": {"time": [0, 1], "A": {"path": [[0,0],[1,1]], "times": [0, 2]}})", "outside the time");
  expect_refused(R"("motion": {"time": [0, 1], "A": {"path": [[0,0]], "speed": 3}})", "unknown key 'speed'");
  Motion motion =
      asking(
          R"("motion": {"time": [0, 3], "A": {"path": [[0,0],[5,2],[1,1]]}, "B": {"path": [[1,0]], "times": [2], "angles": [90]}}, "free": "time")")
          .motion;
  ASSERT_EQ(motion.movements.size(), 2u);
  EXPECT_EQ(motion.movements[0].shape, "A");
  EXPECT_EQ(compare(motion.movements[0].times[1], Real::ratio(3, 2)), 0);
  EXPECT_EQ(motion.movements[0].angles[2].sign(), 0);
  EXPECT_EQ(motion.movements[1].path[0], (GridPosition{1000000, 0, 0}));
  EXPECT_EQ(motion.movements[1].angles[0].integer(), exact::int128(90));
}

TEST(SceneQuestion, Placement) {
  expect_refused(R"("place": {})", "\"shapes\" is missing");
  expect_refused(R"("place": {"shapes": ["A", "C"]})", "unknown shape 'C'");
  expect_refused(R"("place": {"shapes": ["A"], "method": "greedy"})", "sequential or simultaneous");
  expect_refused(R"("place": {"shapes": ["A"], "pair": "x"})", "did you mean 'pairs'?");
  Scene s = asking(R"--("place": {"shapes": ["A", "B"], "each": "inside(self, A0)", "pairs": "clear(self, other, 1mm)",
    "constraints": ["gamma1(A, B) <= 20"], "minimize": ["y", "x"], "method": "simultaneous"})--");
  EXPECT_TRUE(s.place.given());
  ASSERT_EQ(s.place.bodies.size(), 2u);
  EXPECT_EQ(s.place.bodies[1].shapes, (std::vector<std::string>{"B"}));
  EXPECT_EQ(s.place.each.text, "inside(self, A0)");
  EXPECT_EQ(s.place.constraints[0].line, 2);
  EXPECT_EQ(s.place.minimize[1].text, "x");
  EXPECT_EQ(s.place.method, Placement::Method::kSimultaneous);
  std::string named_self =
      R"({"findspace": 1, "shapes": {"self": {"points": [[0,0]]}}, "place": {"shapes": ["self"]}})";
  EXPECT_THROW(read_scene_text(named_self, ".", "s.json"), Error);
}

}  // namespace io_scene_question
}  // namespace findspace::io
