// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boards through the public headers.

#include <gtest/gtest.h>

#include "findspace/board.h"
#include "findspace/error.h"

namespace io_public_board {

using namespace findspace;

/// A part with a square courtyard of two millimetres.
std::string part(const std::string& name, const std::string& at) {
  return "(footprint \"F\" (layer \"F.Cu\") (at " + at + ")\n (fp_text reference \"" + name + "\" (at 0 0))\n" +
         " (fp_rect (start -1 -1) (end 1 1) (layer \"F.CrtYd\")))\n";
}

/// Ten by ten, with U1 and U2 on it.
std::string board(const std::string& second) {
  return "(kicad_pcb (version 20211014)\n (layers (0 \"F.Cu\" signal))\n"
         "(gr_rect (start 0 0) (end 10 10) (layer \"Edge.Cuts\"))\n" +
         part("U1", "2 2") + part("U2", second) + ")\n";
}

TEST(PublicBoard, ItsOwnRulesHold) {
  const Board apart = Board::text(board("5 5"));
  EXPECT_EQ(apart.parts(), (std::vector<std::string>{"U1", "U2"}));
  EXPECT_EQ(apart.source(), board("5 5"));
  EXPECT_EQ(apart.options().name, "board");
  const BoardVerdict verdict = apart.check();
  EXPECT_TRUE(verdict.holds());
  EXPECT_EQ(verdict.parts(), 2u);
  EXPECT_EQ(verdict.rules(), "inside(self, board) and clear(self, others)");
  EXPECT_EQ(verdict.text(), "all 2 parts keep the rules: inside(self, board) and clear(self, others)\n");
}

TEST(PublicBoard, SaysWhichPartsBreakARule) {
  const Board close = Board::text(board("3.5 2"));
  const BoardVerdict verdict = close.check();
  ASSERT_EQ(verdict.broken().size(), 2u);
  const BoardVerdict::Broken& first = verdict.broken()[0];
  EXPECT_EQ(first.part, "U1");
  EXPECT_DOUBLE_EQ(first.at[0], 2);
  EXPECT_FALSE(first.check.holds);
  ASSERT_FALSE(first.check.atoms.empty());
  EXPECT_DOUBLE_EQ(*first.check.atoms.back().distance.value, -0.5);
  EXPECT_NE(verdict.json().find("\"part\": \"U2\""), std::string::npos);
  EXPECT_NE(verdict.svg().find("parts that break the rules"), std::string::npos);
  EXPECT_NE(verdict.text(true).find(" ms"), std::string::npos);
  EXPECT_TRUE(Board::text(board("5 2")).check("clear(self, others, 1)").holds());
  EXPECT_FALSE(Board::text(board("5 2")).check("clear(self, others, 1.5)").holds());
}

TEST(PublicBoard, IsASceneThatAsks) {
  const Board apart = Board::text(board("5 5"), {.name = "small", .groups = {{"ends", {"U1"}}}});
  const Scene scene = apart.scene({.move = {"U2"}, .where = "inside(U2, board) and clear(U2, ends, 0.5)"});
  EXPECT_EQ(scene.moving(), (std::vector<std::string>{"U2"}));
  EXPECT_EQ(scene.board()->source(), apart.source());
  EXPECT_EQ(scene.board_question()->move, scene.moving());
  EXPECT_EQ(scene.groups().at("ends"), (std::vector<std::string>{"U1"}));
  EXPECT_EQ(scene.check({{5, 5}}).found(), Answer::Found::kYes);
  EXPECT_EQ(scene.check({{4, 4}}).found(), Answer::Found::kNo);
  EXPECT_EQ(scene.map().region()->inner.area(), apart.world({"U2"}).solve(scene.where()).area());
  const Scene turned = apart.scene({.move = {"U2"}, .angles = {0, "45"}});
  EXPECT_EQ(turned.free().kind, Scene::Free::Kind::kPose);
  EXPECT_EQ(turned.free().angles.size(), 2u);
  const Answer placed = apart.scene({.move = {"U1", "U2"}, .place = true}).place();
  EXPECT_EQ(placed.found(), Answer::Found::kYes);
  EXPECT_NE(placed.file(".kicad_pcb").text.find("kicad_pcb"), std::string::npos);
  for (const char* before : {"--", ""}) try {
      apart.scene({.move = {"U2"}, .where = "inside(U2, ", .before = before}).map();
      ADD_FAILURE();
    } catch (const Error& e) {
      EXPECT_EQ(e.place(), std::string(before) + "where:1:12");
    }
  EXPECT_FALSE(Scene::json(R"({"findspace": 1, "shapes": {}})").board());
}

TEST(PublicBoard, PartsAreWantedAtAnglesAsItsAnswersCount) {
  const Scene scene = Board::text(board("7 7")).scene({.move = {"U2"}, .place = true, .angles = {0, 90}});
  for (const Number& degrees : {Number(90), Number(450), Number(-270)}) {
    const Answer placed = scene.place({.near = {{.name = "U2", .at = {5, 5}, .degrees = degrees}}});
    EXPECT_EQ(placed.placement()->placed().at(0).degrees, 90);
  }
  EXPECT_THROW(scene.place({.near = {{.name = "U2", .at = {5, 5}, .degrees = -90}}}), Error);
  const Scene both = Board::text(board("7 7")).scene({.move = {"U2"}, .place = true, .angles = {90, -90}});
  EXPECT_EQ(both.place({.near = {{.name = "U2", .at = {5, 5}, .degrees = 90}}}).placement()->placed().at(0).degrees,
            90);
}

/// A scene in which an L with arms of 4 to the right and of 3 downwards moves on a board of 20 by 20.
Scene corner_piece(const std::vector<Number>& angles = {}) {
  const std::string file =
      "(kicad_pcb (version 20211014)\n (layers (0 \"F.Cu\" signal))\n"
      "(gr_rect (start 0 0) (end 20 20) (layer \"Edge.Cuts\"))\n"
      "(footprint \"F\" (layer \"F.Cu\") (at 5 5)\n (fp_text reference \"U1\" (at 0 0))\n"
      " (fp_poly (pts (xy 0 0) (xy 4 0) (xy 4 1) (xy 1 1) (xy 1 3) (xy 0 3)) (layer \"F.CrtYd\")))\n)\n";
  return Board::text(file).scene({.move = {"U1"}, .where = "inside(U1, board)", .angles = angles});
}

// A quarter turn counter-clockwise as it is seen takes the arms to (0, -4) and (3, 0).
TEST(PublicBoard, AllAnglesCountAsTheyAreSeen) {
  const Scene scene = corner_piece(), poses = corner_piece({0, 90});
  EXPECT_EQ(poses.free().angles, (std::vector<Number>{0, 90}));
  EXPECT_TRUE(scene.y_down());
  EXPECT_FALSE(scene.clockwise());
  const PoseMap::Slice quarter = poses.map().poses().value().slices.at(1);
  ASSERT_EQ(quarter.degrees, 90);
  Scene::Question over_angles;
  over_angles.free = Scene::Free::Kind::kAngle;
  const Scene angles = scene.asking(over_angles);
  for (const auto& [at, holds] : {std::pair(Point{1, 10}, true), {Point{10, 2}, false}, {Point{16, 5}, true}}) {
    const std::vector<Number> place{at.x, at.y};
    const auto found = holds ? Answer::Found::kYes : Answer::Found::kNo;
    EXPECT_EQ(quarter.region.contains(at), holds);
    for (const Scene& asked : {scene, scene.prepared()}) {
      const Answer posed = asked.check({place, 90}), rotated = asked.rotated(90).check({place});
      for (const Answer& answer : {posed, rotated, asked.rotated(30).rotated(60).check({place})}) {
        EXPECT_EQ(answer.found(), found);
        EXPECT_NE(answer.json().find("\"angle\": 90,"), std::string::npos);
      }
      EXPECT_EQ(asked.rotated(90).map().region()->inner.contains(at), holds);
      EXPECT_EQ(asked.measure({place, 90}).json(), asked.rotated(90).measure({place}).json());
    }
    const Answer why = scene.explain({place, 90});
    EXPECT_EQ(why.explanation()->here->holds, holds);
    EXPECT_EQ(why.explanation()->slack.at(0).angle, 90);
    bool among = false;
    for (const Interval& i : angles.map({{place}}).intervals())
      for (const double quarter_turn : {90, 450}) among = among || (*i.from <= quarter_turn && quarter_turn <= *i.to);
    EXPECT_EQ(among, holds);
  }
}

// In the corner at the right above, the arms have to go to the left and downwards: at three quarters of a turn.
TEST(PublicBoard, ExplanationsOverAnglesCountAsTheyAreSeen) {
  Scene::Question over_angles;
  over_angles.free = Scene::Free::Kind::kAngle;
  const Pose corner{{"16.5", "3.5"}};
  const Explanation wide = *corner_piece().asking(over_angles).explain(corner).explanation();
  ASSERT_TRUE(wide.feasible);
  EXPECT_NEAR(wide.slack.at(0).to, 3.5, 1e-6);
  EXPECT_NEAR(wide.slack[0].angle.value(), 270, 1e-4);
  over_angles.where = "inside(U1, board, 4)";
  const Explanation narrow = *corner_piece().asking(over_angles).explain(corner).explanation();
  ASSERT_FALSE(narrow.feasible);
  EXPECT_NEAR(narrow.relax.at(0).angle.value(), 270, 1e-4);
  EXPECT_NEAR(narrow.together.value().angle.value(), 270, 1);
}

TEST(PublicBoard, PadsThatNoFormulaNamesAreDrawnAtAngles) {
  const std::string file =
      "(kicad_pcb (version 20211014)\n (layers (0 \"F.Cu\" signal))\n"
      "(gr_rect (start 0 0) (end 10 10) (layer \"Edge.Cuts\"))\n"
      "(footprint \"F\" (layer \"F.Cu\") (at 2 2)\n (fp_text reference \"U1\" (at 0 0))\n"
      " (pad \"1\" smd rect (at 1 0) (size 0.5 0.5) (layers \"F.Cu\"))\n"
      " (fp_rect (start -1 -1) (end 2 1) (layer \"F.CrtYd\")))\n)\n";
  Scene::Question over_angles;
  over_angles.free = Scene::Free::Kind::kAngle;
  const Answer map =
      Board::text(file).scene({.move = {"U1"}, .where = "inside(U1, board)"}).asking(over_angles).map({{{1, 5}}});
  ASSERT_FALSE(map.intervals().empty());
  EXPECT_NE(map.file(".svg").text.find("°"), std::string::npos);
}

TEST(PublicBoard, MistakesHaveAPlace) {
  const auto place_of = [](const auto& ask) -> std::string {
    try {
      ask();
    } catch (const Error& e) {
      return e.place();
    }
    return "nothing was thrown";
  };
  const Board good = Board::text(board("5 5"));
  EXPECT_EQ(place_of([&] { good.check("clear(self,)"); }).rfind("rules:1:", 0), 0u);
  EXPECT_EQ(place_of([&] { good.check("clear(self,)", "--where"); }).rfind("--where:1:", 0), 0u);
  EXPECT_EQ(place_of([&] { Board::text("(", {.name = "b.kicad_pcb"}); }), "b.kicad_pcb:1:1");
  EXPECT_NE(place_of([&] { Board::file("no such file.kicad_pcb"); }), "nothing was thrown");
  EXPECT_THROW(Board::text(board("5 5"), {.groups = {{"power", {"U7"}}}}), Error);
  EXPECT_THROW(good.world({}), Error);
  EXPECT_THROW(good.world({"U7"}), Error);
}

TEST(PublicBoard, PartsMoveInAWorld) {
  const Board both = Board::text(board("5 5"), {.groups = {{"pair", {"U1", "U2"}}}});
  const World world = both.world({"U2"});
  EXPECT_EQ(world.unit(), "mm");
  EXPECT_TRUE(world.holds("inside(U2, board) and clear(U2, others, 1)", Point{5, 5}));  // where its anchor is
  EXPECT_FALSE(world.holds("clear(U2, others, 1)", Point{3, 2}));
  EXPECT_EQ(world.solve("inside(U2, board)").area(), 64);
  EXPECT_TRUE(both.check("inside(self, board) and gap(self, pair) >= 1").holds());
}

}  // namespace io_public_board
