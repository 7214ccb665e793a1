// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Scenes that keep what they make for the next question, and what programs ask that let people drag shapes.

#include <gtest/gtest.h>

#include <cmath>

#include "findspace/error.h"
#include "findspace/scene.h"

namespace io_prepared_scenes {

using namespace findspace;

const char* const kPlate = R"json({
  // a peg on a plate with a hole
  "findspace": 1, "unit": "mm", "shapes": {
    "plate": {"polygon": [[2, 2], [12, 2], [12, 10], [2, 10]], "holes": [[[5, 4], [7, 4], [7, 6], [5, 6]]]},
    "table": {"box": {"min": [0, 0], "max": [20, 12]}},
    "peg": {"box": {"min": [-1, -1], "max": [1, 1]}}},
  "moving": "peg", "where": "inside(peg, table) and clear(peg, plate)"})json";

const char* const kRooms = R"json({"findspace": 1, "shapes": {
    "room": {"box": {"min": [0, 0, 0], "max": [9, 4, 3]}}, "crate": {"box": {"min": [0, 0, 0], "max": [2, 4, 1]}}},
  "moving": "crate", "where": "inside(crate, room)"})json";

Pose at(const char* x, const char* y) { return {{x, y}, {}, {}}; }

TEST(PreparedScene, AnswersAsBefore) {
  const Scene plain = Scene::json(kPlate), prepared = plain.prepared();
  EXPECT_FALSE(plain.is_prepared());
  EXPECT_TRUE(prepared.is_prepared());
  for (const Pose& pose : {at("6", "5"), at("6.25", "5"), at("3", "4"), at("40", "0.1"), at("19", "11")}) {
    EXPECT_EQ(prepared.check(pose).json(), plain.check(pose).json());
    EXPECT_EQ(prepared.measure(pose).json(), plain.measure(pose).json());
    EXPECT_EQ(prepared.explain(pose).json(), plain.explain(pose).json());
    EXPECT_EQ(prepared.nearest(pose).json(), plain.nearest(pose).json());
  }
  for (const char* apply : {"", "interior", "complement"}) {
    MapQuestion question;
    question.apply = apply;
    EXPECT_EQ(prepared.map(question).json(), plain.map(question).json());
    EXPECT_EQ(prepared.map(question).region()->inner, plain.map(question).region()->inner);
    EXPECT_EQ(prepared.map(question).file(".svg").text, plain.map(question).file(".svg").text);
  }
}

TEST(PreparedScene, OtherFormulasAndShapesAreNotKept) {
  const Scene scene = Scene::json(kPlate).prepared();
  EXPECT_EQ(scene.check(at("6", "5")).found(), Answer::Found::kYes);  // just in the hole
  Scene::Question apart, other;
  apart.where = "gap(peg, plate) >= 0.5";
  EXPECT_EQ(scene.asking(apart).check(at("6", "5")).found(), Answer::Found::kNo);
  EXPECT_EQ(scene.check(at("6", "5")).found(), Answer::Found::kYes);
  other.moving = {"plate"};
  EXPECT_EQ(scene.asking(other).moving(), std::vector<std::string>{"plate"});
  other.where = "inside(plate, table)";
  EXPECT_NEAR(*scene.asking(other).map().region()->inner.area(), 10 * 4, 1e-9);
  other.moving = {"plates"};
  EXPECT_THROW(scene.asking(other), Error);
}

TEST(PreparedScene, ExplainsAnAngleAsItChecksIt) {
  // Turned by 45 degrees B is 5*sqrt(2) = 7.07107 high; on the grid it is 7.0711.
  const auto scene = [](const std::string& where) {
    return Scene::json(R"json({"findspace": 1, "grid": 1e-4, "moving": "B", "shapes": {
      "B": {"box": {"min": [0, 0], "max": [5, 5]}}, "W": {"box": {"min": [-9, -1], "max": [9, 8]}},
      "low": {"box": {"min": [-9, -1], "max": [9, 0]}},
      "high": {"box": {"min": [-9, 7.0711], "max": [9, 8]}}}, "where": ")json" +
                       where + "\"}")
        .prepared();
  };
  const Scene clear = scene("inside(B, W) and gap(B, low) > 0 and gap(B, high) > 0");
  const Pose between{{0, "0.00001"}, Number(45), {}};
  EXPECT_EQ(clear.check(between).found(), Answer::Found::kYes);
  const Answer some = clear.explain(between);
  EXPECT_EQ(some.found(), Answer::Found::kYes);
  EXPECT_NE(some.text().find("on the grid no position is feasible"), std::string::npos) << some.text();
  const Scene touch = scene("gap(B, high) = 0");
  const Pose there{{0, 0}, Number(45), {}};
  EXPECT_EQ(touch.check(there).found(), Answer::Found::kNo);
  const Answer none = touch.explain(there);
  EXPECT_EQ(none.found(), Answer::Found::kNo);
  EXPECT_EQ(none.json().find("nearest"), std::string::npos) << none.json();
}

TEST(PreparedScene, SnapsToCornersThenEdges) {
  for (const Scene& scene : {Scene::json(kPlate), Scene::json(kPlate).prepared()}) {
    const auto snapped = [&](const Pose& pose, const char* within) { return scene.check(pose, {true, within}); };
    EXPECT_EQ(snapped(at("6.3", "5.2"), "1").at(), (Place{6, 5}));
    EXPECT_EQ(snapped(at("6.3", "5.2"), "1").found(), Answer::Found::kYes);
    EXPECT_EQ(snapped(at("6.3", "5.2"), "0.1").at(), (Place{6.3, 5.2}));
    EXPECT_EQ(snapped(at("1.2", "1.1"), "0.5").at(), (Place{1, 1}));
    EXPECT_EQ(snapped(at("15", "1.1"), "0.5").at(), (Place{15, 1}));
    EXPECT_TRUE(snapped(at("6.3", "5.2"), "0.1").nearest());
    EXPECT_THROW(snapped(at("6.3", "5.2"), "-1"), Error);
    EXPECT_FALSE(scene.check(at("6.3", "5.2"), {false, {}}).nearest());
  }
  EXPECT_THROW(Scene::json(kPlate).check({{"6", "5"}, Number(30), {}}, {true, "1"}), Error);
}

TEST(PreparedScene, RegionsSnapToWhatBelongsToThem) {
  // The left side, with its corners, is open.
  const Region region = Shape::box({0, 0}, {10, 10}).region() - Shape::box({0, 0}, {1, 10}).region();
  EXPECT_EQ(*region.snapped({1.25, 0.125}, 20), (Position{10, 0}));
  EXPECT_EQ(*region.snapped({1.25, 0.125}, 1), (Position{1.25, 0}));
  EXPECT_EQ(*region.snapped({1.25, 5.5}, 5), (Position{1.25, 10}));
  EXPECT_FALSE(region.snapped({1.25, 5.5}, 4));
}

TEST(PreparedScene, RegionsSnapAndShowThemselves) {
  const Region region = Scene::json(kPlate).map().region()->inner;
  EXPECT_EQ(*region.snapped({6.3, 5.2}, 1), (Position{6, 5}));
  EXPECT_FALSE(region.snapped({6.3, 5.2}, "0.1"));
  EXPECT_EQ(*region.some(), (Position{6, 5}));  // the isolated one
  EXPECT_FALSE((region - region).some());
  const Bounds all = *region.extent();
  EXPECT_LT(std::abs(all.low[0] - 1) + std::abs(all.high[0] - 19), 1e-9);
  const Region::Paths paths = region.paths(all);
  EXPECT_EQ(paths.points, (std::vector<Position>{{6, -5}}));  // y downwards
  EXPECT_FALSE(paths.faces.empty());
  EXPECT_FALSE(paths.closed.empty());
  EXPECT_TRUE(paths.open.empty());
  EXPECT_EQ(region.paths(all, true).points, (std::vector<Position>{{6, 5}}));
  EXPECT_FALSE(region.interior().paths(all).open.empty());
  // Outside of the plate nothing bounds it: cut off at the window.
  EXPECT_NE(region.complement().paths({{-50, -50}, {50, 50}}).faces.find("-50"), std::string::npos);
}

TEST(PreparedScene, IsRotatedInThePlane) {
  const char* const text = R"json({"findspace": 1, "shapes": {"slot": {"box": {"min": [0, 0], "max": [9, 2]}},
      "bar": {"box": {"min": [0, 0], "max": [1, 4]}}}, "moving": "bar", "where": "inside(bar, slot)",
      "free": {"angle": {"about": [0, 0]}}})json";
  for (const Scene& scene : {Scene::json(text), Scene::json(text).prepared()}) {
    const Scene lying = scene.rotated(Number(90));
    EXPECT_EQ(lying.free().kind, Scene::Free::Kind::kPosition);
    EXPECT_NEAR(*lying.map().region()->inner.area(), 5 * 1, 1e-9);
    EXPECT_TRUE(scene.rotated(Number(0)).map().region()->inner.empty());
    EXPECT_NE(lying.check(at("5", "1")).json().find("\"angle\": 90"), std::string::npos);
    EXPECT_EQ(lying.check(at("5", "1")).found(), scene.check({{"5", "1"}, Number(90), {}}).found());
    EXPECT_EQ(lying.rotated(Number(-90)).map().region()->inner.empty(), true);
    EXPECT_EQ(lying.shapes().at("bar").region().bounds()->low, (Position{-4, 0}));
    EXPECT_EQ(lying.world().shape("bar"), lying.shapes().at("bar").region());
  }
  // What is off the grid is put on it once, in both the same.
  const Scene plain = Scene::json(text), prepared = plain.prepared();
  Scene::Question near;
  near.where = "gap(bar, slot) <= 1";
  EXPECT_EQ(prepared.rotated(Number(30)).asking(near).map().json(),
            plain.rotated(Number(30)).asking(near).map().json());
  EXPECT_THROW(Scene::json(kRooms).rotated(Number(30)), Error);
}

TEST(PreparedScene, SaysWhatItsRotationRounds) {
  const Scene scene = Scene::json(kPlate).prepared();
  const std::vector<std::string> notes = scene.rotated(Number(30)).check(at("6", "5")).notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].find("4 rotated vertices were put on the grid, moved by at most "), 0u);
  EXPECT_TRUE(scene.rotated(Number(90)).check(at("6", "5")).notes().empty());
}

TEST(PreparedScene, WhatIsNearestBetweenBoundsIsNotKnown) {
  const Scene plain = Scene::json(R"json({"findspace": 1, "shapes": {"bar": {"box": {"min": [-2, -0.5],
      "max": [2, 0.5]}}, "disc": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "disc",
      "motion": {"time": [0, 1], "bar": {"path": [[0, 0], [0, 0]], "angles": [0, 90]}},
      "where": "clear(disc, bar)"})json");
  for (const Scene& scene : {plain, plain.prepared()}) {
    EXPECT_FALSE(scene.map().region()->inner.empty());
    EXPECT_FALSE(scene.check(at("0", "0")).nearest());
    EXPECT_EQ(scene.nearest(at("0", "0")).found(), Answer::Found::kUndecided);
    EXPECT_EQ(scene.nearest(at("0", "0")).json(), plain.nearest(at("0", "0")).json());
  }
}

/// One nearest position of the closure does not belong, and another one, as near, does.
TEST(PreparedScene, OfEquallyNearPositionsOneThatBelongsIsTaken) {
  const auto plain = [](const std::string& block, const std::string& edge) {
    return Scene::json(R"({"findspace": 1, "shapes": {"block": )" + block + R"(, "edge": )" + edge +
                       R"(, "peg": {"points": [[0, 0]]}}, "moving": "peg",
                          "where": "gap(peg, block) >= 0 and gap(peg, edge) > 0"})");
  };
  const auto expect = [](const Scene& scene, double distance, bool attained) {
    for (const Scene& s : {scene, scene.prepared()}) {
      const NearestPlace near = s.check(at("0", "0")).nearest().value();
      EXPECT_EQ(near.attained, attained);
      EXPECT_DOUBLE_EQ(near.distance, distance);
      EXPECT_DOUBLE_EQ(std::hypot(near.at[0], near.at[1]), distance);
      const auto of_map = s.map().region()->inner.nearest({0, 0});
      EXPECT_EQ(of_map->attained, attained);
      EXPECT_DOUBLE_EQ(of_map->distance, distance);
    }
  };
  const std::string box = R"({"box": {"min": [-5, -1], "max": [5, 1]}})",
                    disc = R"({"disc": {"center": [0, 0], "radius": 2}})";
  expect(plain(box, R"({"polyline": [[-5, 1], [5, 1]]})"), 1, true);
  expect(plain(box, R"({"polyline": [[-5, -1], [5, -1]]})"), 1, true);
  expect(plain(box, R"({"polyline": [[-5, 1], [5, 1], [5, -1], [-5, -1], [-5, 1]]})"), 1, false);
  expect(plain(disc, R"({"points": [[-2, 0], [2, 0], [0, 2], [0, -2]]})"), 2, true);
  expect(plain(disc, R"({"boundary": {"disc": {"center": [0, 0], "radius": 2}}})"), 2, false);
  expect(plain(R"({"disc": {"center": [1, 0], "radius": 2}})", R"({"points": [[-1, 0]]})"), 1, false);
}

TEST(PreparedScene, PositionsOfALineAreOnIt) {
  const Scene plain = Scene::json(R"json({"findspace": 1, "shapes": {"block": {"box": {"min": [0, 0],
      "max": [10, 10]}}, "peg": {"box": {"min": [0, 0], "max": [1, 1]}}}, "moving": "peg",
      "where": "gap(peg, block) >= 1", "free": {"line": {"through": [0, 2], "direction": [1, 0]}}})json");
  for (const Scene& scene : {plain, plain.prepared()}) {
    EXPECT_EQ(scene.check(at("4", "2")).nearest()->at, (Place{-2, 2}));  // and not (4, -2)
    EXPECT_EQ(scene.nearest(at("6", "2")).nearest()->at, (Place{11, 2}));
    const RegionBounds region = *scene.map().region();
    EXPECT_EQ(region.inner, region.outer);
    EXPECT_TRUE(region.inner.contains(Point{-2, 2}));
    EXPECT_FALSE(region.inner.contains(Point{-2, 3}));
  }
}

TEST(PreparedScene, ALineIsFollowedToWhatIsFarAway) {
  // The board is 2 * 10^11 grid steps long.
  const Scene plain = Scene::json(R"json({"findspace": 1, "unit": "um", "shapes": {"board": {"box": {"min": [0, 0],
      "max": [200000, 50000]}}, "part": {"box": {"min": [0, 0], "max": [1000, 1000]}}}, "moving": "part",
      "where": "inside(part, board)", "free": {"line": {"through": [0, 2000], "direction": [1, 0]}}})json");
  for (const Scene& scene : {plain, plain.prepared()}) {
    EXPECT_EQ(scene.nearest(at("300000", "2000")).nearest()->at, (Place{199000, 2000}));
    EXPECT_EQ(*scene.map().intervals().at(0).to, 199000);
    EXPECT_TRUE(scene.map().region()->inner.contains(Point{199000, 2000}));
    Scene::Question apart;
    apart.where = "disjoint(part, board)";
    EXPECT_EQ(scene.asking(apart).nearest(at("0", "2000")).nearest()->at, (Place{-1000, 2000}));
    EXPECT_EQ(scene.asking(apart).check(at("1000000", "2000")).found(), Answer::Found::kYes);
    EXPECT_TRUE(scene.asking(apart).map().region()->inner.contains(Point{300000, 2000}));
    EXPECT_FALSE(scene.asking(apart).map().intervals().at(1).to);
  }
}

TEST(PreparedScene, ABestValueBetweenBoundsLeavesAllFeasiblePositionsPossible) {
  const char* const line = R"json(, "free": {"line": {"through": [0, 0], "direction": [1, 0]}})json";
  for (const char* free : {"", line}) {
    const Scene plain =
        Scene::json(std::string(R"json({"findspace": 1, "shapes": {"a": {"disc": {"center": [0, 0], "radius": 1}},
      "b": {"disc": {"center": [7, 0], "radius": 2}}, "room": {"box": {"min": [-9, -9], "max": [19, 9]}},
      "peg": {"points": [[0, 0]]}}, "moving": "peg", "where": "inside(peg, room)",
      "minimize": "gap(peg, a) + 3 * gap(peg, b)")json") +
                    free + "}");
    for (const Scene& scene : {plain, plain.prepared()}) {
      const Answer map = scene.map();
      ASSERT_FALSE(map.best()->exact);
      const RegionBounds region = *map.region();
      EXPECT_FALSE(region.inner.contains(Point{15, 0}));
      EXPECT_TRUE(region.outer.contains(Point{15, 0}));
      EXPECT_FALSE(region.outer.contains(Point{20, 0}));
      if (*free == 0) continue;
      ASSERT_EQ(map.possible().size(), 1u);
      EXPECT_EQ(*map.possible()[0].from, -9);
      EXPECT_EQ(*map.possible()[0].to, 19);
    }
  }
}

TEST(PreparedScene, RangesOverSomethingElse) {
  const Scene scene = Scene::json(R"json({"findspace": 1, "shapes": {"slot": {"box": {"min": [-5, -2], "max": [5, 2]}},
      "bar": {"box": {"min": [-1, -3], "max": [1, 3]}}}, "moving": "bar", "where": "inside(bar, slot)"})json")
                          .prepared();
  Scene::Question question;
  question.free = Scene::Free::Kind::kAngle;
  const std::vector<Interval> angles = scene.asking(question).map().intervals();
  ASSERT_EQ(angles.size(), 2u);  // lying, either way
  question.free = Scene::Free::Kind::kTime;
  EXPECT_THROW(scene.asking(question), Error);
  question.free = Scene::Free::Kind::kLine;
  EXPECT_THROW(scene.asking(question), Error);
}

TEST(PreparedScene, MeasuresBetweenFeatures) {
  const Scene scene = Scene::json(kPlate);
  const Answer answer = scene.between({2, 2}, {5, 5}, at("16", "8"));
  ASSERT_EQ(answer.measured().size(), 1u);
  const DistanceValue value = *answer.measured()[0].value;
  EXPECT_EQ(*value.value, std::hypot(3, 2));
  ASSERT_EQ(value.features.size(), 2u);
  EXPECT_EQ(value.features[0].kind, Feature::Kind::kVertex);
  EXPECT_EQ(value.features[1].kind, Feature::Kind::kEdge);
  EXPECT_EQ(value.features[1].shape, "plate");
  // The moving shape stands elsewhere, and its features have their own coordinates.
  const DistanceValue moved = *scene.between({20, 6}, {16, 6.5}, at("15", "6")).measured()[0].value;
  EXPECT_EQ(*moved.value, 4);
  EXPECT_EQ(moved.features[1].shape, "peg");
  EXPECT_EQ(moved.features[1].points[0][0], 1);
  EXPECT_EQ(moved.points[1][0], 16);
  EXPECT_THROW(Scene::json(kRooms).between({0, 0}, {1, 1}, {}), Error);
}

TEST(PreparedScene, ItsTextIsEdited) {
  const Scene scene = Scene::json(kPlate);
  EXPECT_EQ(scene.edited_text(), kPlate);
  Scene::Question question;
  question.where = "gap(peg, table) >= 3";
  question.moving = {"peg", "plate"};
  const std::string text = scene.asking(question).edited_text();
  EXPECT_NE(text.find("// a peg on a plate with a hole"), std::string::npos);
  const Scene again = Scene::json(text);
  EXPECT_EQ(again.where().text(), *question.where);
  EXPECT_EQ(again.moving(), *question.moving);
  EXPECT_EQ(again.used(), (std::vector<std::string>{"peg", "table"}));
  EXPECT_THROW(scene.rotated(Number(30)).edited_text(), Error);
  question.where = "";
  EXPECT_FALSE(Scene::json(scene.asking(question).edited_text()).asks());
  EXPECT_TRUE(scene.asks());
  EXPECT_FALSE(scene.asking(question).asks());
}

TEST(PreparedScene, ItsTextSaysTheLastObjective) {
  Scene::Question least, greatest;
  least.minimize = "x";
  greatest.maximize = "y";
  const Scene scene = Scene::json(Scene::json(kPlate).asking(greatest).edited_text());
  const std::string text = scene.asking(least).edited_text();
  EXPECT_EQ(text.find("maximize"), std::string::npos);
  EXPECT_EQ(Scene::json(text).asking({}).edited_text(), text);
  EXPECT_EQ(scene.asking(least).asking(greatest).edited_text(), scene.edited_text());
}

TEST(PreparedScene, KeysAreTakenOutBesideComments) {
  const std::string begin =
      R"({"findspace": 1, "shapes": {"a": {"box": {"min": [0, 0], "max": [1, 1]}}}, "moving": "a")";
  Scene::Question greatest;
  greatest.maximize = "x";
  for (const char* end : {", \"where\": \"true\", // the \"minimize\", rules\n \"minimize\": \"y\"\n}",
                          ", \"minimize\": /* the \"least\" */ \"y\", \"where\": \"true\"}"}) {
    const std::string text = Scene::json(begin + end).asking(greatest).edited_text();
    EXPECT_EQ(Scene::json(text).asking({}).edited_text(), text);
    EXPECT_EQ(text.find("\"y\""), std::string::npos);
  }
}

TEST(PreparedScene, InSpace) {
  const Scene plain = Scene::json(kRooms), prepared = plain.prepared();
  const Pose near{{"7.25", "0", "2"}, {}, {}};
  for (const Scene& scene : {plain, prepared}) {
    EXPECT_EQ(scene.check(near, {true, "0.5"}).at(), (Place{7, 0, 2}));
    EXPECT_EQ(scene.check(near, {true, "0.125"}).at(), (Place{7.25, 0, 2}));
    EXPECT_EQ(scene.nearest(near).nearest()->at, (Place{7, 0, 2}));
    EXPECT_EQ(scene.explain(near).json(), plain.explain(near).json());
    MapQuestion flat;
    flat.surface = true;
    const Answer map = scene.map(flat);
    EXPECT_EQ(map.json(), plain.map(flat).json());
    EXPECT_TRUE(map.surface()->faces.empty());
    const SpaceRegion::Thin thin = map.space_region()->thin({{0, 0, 0}, {9, 9, 9}});
    ASSERT_EQ(thin.sheets.size(), 1u);  // no room to move along y
    EXPECT_EQ(thin.sheets[0].size(), 4u);
    EXPECT_TRUE(thin.curves.empty() && thin.points.empty());
  }
  EXPECT_EQ(plain.shapes().at("room").drawn_surface().faces.size(), 6u);
  const Shape ball = Shape::ball({0, 0, 0}, 2);
  EXPECT_TRUE(ball.drawn_surface(0).faces.empty());
  EXPECT_GT(ball.drawn_surface(16).faces.size(), 20u);
  EXPECT_THROW(Shape::disc({0, 0}, 2).drawn_surface(), Error);
}

TEST(PreparedScene, OnLinesWhereThereIsNoExactForm) {
  const Scene scene = Scene::json(R"json({"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [4, 4, 4]}},
      "B": {"ball": {"center": [0, 0, 0], "radius": 1}}}, "moving": "B",
      "where": "clear(B, A) and reach(B, A) <= 12"})json")
                          .prepared();
  MapQuestion question;
  question.surface = true;
  question.listed = false;
  question.resolution = 16;
  const Answer map = scene.map(question);
  EXPECT_TRUE(map.sampled());
  EXPECT_GT(map.surface()->faces.size(), 100u);
  EXPECT_NE(map.notes().at(0).find("16 x 16 lines"), std::string::npos);
  question.resolution = -1;
  EXPECT_THROW(scene.map(question), Error);
}

}  // namespace io_prepared_scenes
