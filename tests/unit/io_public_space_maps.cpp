// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Maps of scenes of space as public values: regions of boxes and of convex sets, what is made of them, and pictures.
#include <findspace/findspace.h>
#include <gtest/gtest.h>

namespace findspace {
namespace {

using Found = Answer::Found;

Scene crate_scene(const std::string& more = "", const std::string& where = "inside(crate, room)") {
  return Scene::json(R"json({"findspace": 1, "unit": "mm", "shapes": {"room": {"box": {"min": [0, 0, 0],
    "max": [9, 9, 9]}}, "crate": {"box": {"min": [0, 0, 0], "max": [2, 1, 1]}}}, "moving": "crate",
    "where": ")json" +
                     where + "\"" + more + "}");
}

/// A ball beside a tetrahedron with a corner at the origin.
Scene ball_scene(const std::string& where) {
  return Scene::json(R"json({"findspace": 1, "shapes": {"rock": {"polytope": [[0, 0, 0], [9, 0, 0], [0, 9, 0],
    [0, 0, 9]]}, "ball": {"ball": {"center": [0, 0, 0], "radius": 1}}}, "moving": "ball", "where": ")json" +
                     where + "\"}");
}

ErrorCode code_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.code();
  }
  ADD_FAILURE() << "no error";
  return ErrorCode::kUsage;
}

TEST(PublicSpaceMaps, HaveTheRegionOfBoxes) {
  const Answer answer = crate_scene().map();
  EXPECT_EQ(answer.found(), Found::kYes);
  EXPECT_FALSE(answer.region().has_value());
  EXPECT_FALSE(answer.best().has_value());
  const SpaceRegion region = *answer.space_region();
  EXPECT_EQ(region.form(), SpaceRegion::Form::kBoxes);
  EXPECT_EQ(*region.volume(), 7 * 8 * 8);
  EXPECT_TRUE(region.contains(Point3{7, 8, 8}));
  EXPECT_FALSE(region.contains(Point3{"7.000001", 8, 8}));
  EXPECT_EQ(region.query().text(), "inside(crate, room)");
  EXPECT_EQ(answer.json(), region.json());
  EXPECT_NE(answer.text().find("volume  448 mm³"), std::string::npos);
  EXPECT_EQ(answer.endings().size(), 9u);  // JSON and the surfaces
  EXPECT_NE(answer.file(".svg").text.find("Positions of crate"), std::string::npos);
  EXPECT_NE(answer.file(".obj").text.find("v 7 8 8"), std::string::npos);
}

TEST(PublicSpaceMaps, AreMadeIntoWhatIsAskedFor) {
  const Scene scene = crate_scene();
  const SpaceRegion open = *scene.map({.apply = "interior"}).space_region();
  EXPECT_TRUE(open.open());
  EXPECT_FALSE(open.contains(Point3{7, 8, 8}));
  EXPECT_TRUE(open.contains(Point3{"6.9", 7, 7}));
  EXPECT_EQ(open.question().apply, "interior");
  const SpaceRegion rest = *scene.map({.apply = "complement"}).space_region();
  EXPECT_FALSE(rest.bounded());
  EXPECT_TRUE(rest.contains(Point3{-1, 0, 0}));
  EXPECT_EQ(scene.map({.apply = "boundary"}).space_region()->volume(), 0);
  EXPECT_EQ(scene.world().solve_space(scene.where(), {"boundary"}).boxes().size(),
            scene.map({.apply = "boundary"}).space_region()->boxes().size());
  EXPECT_EQ(code_of([&] { scene.map({.apply = "inner"}); }), ErrorCode::kBadValue);
}

TEST(PublicSpaceMaps, HaveTheBestPositions) {
  const Answer answer = crate_scene(R"(, "maximize": "z")").map();
  EXPECT_EQ(*answer.best()->value, 8);
  EXPECT_TRUE(answer.best()->at.empty());
  const SpaceRegion top = *answer.space_region();
  EXPECT_EQ(*top.volume(), 0);
  EXPECT_TRUE(top.contains(Point3{3, 3, 8}));
  EXPECT_FALSE(top.contains(Point3{3, 3, 7}));
  const World world = crate_scene().world();
  EXPECT_TRUE(
      world.solve_space("inside(crate, room)", {.minimize = "distance to [20, 4, 4]"}).contains(Point3{7, 4, 4}));
  EXPECT_EQ(code_of([&] { world.solve_space("inside(crate, room)", {{}, "x", "y"}); }), ErrorCode::kBadValue);
  EXPECT_EQ(code_of([&] {
              world.solve_space("inside(crate, room)", {{}, "gap(crate, room)"});
            }),
            ErrorCode::kUnsupported);
}

TEST(PublicSpaceMaps, SayThatNothingIsFound) {
  const Answer none = crate_scene("", "inside(room, crate)").map();
  EXPECT_EQ(none.found(), Found::kNo);
  EXPECT_TRUE(none.space_region()->empty());
  EXPECT_FALSE(none.space_region()->contains(Point3{0, 0, 0}));
}

TEST(PublicSpaceMaps, AreConvexAndRound) {
  const Answer answer = ball_scene("gap(ball, rock) <= 1").map();
  const SpaceRegion region = *answer.space_region();
  EXPECT_EQ(region.form(), SpaceRegion::Form::kConvex);
  const auto both = [&](const Point3& p) {
    EXPECT_EQ(region.contains(p), region.query().holds(p));
    return region.contains(p);
  };
  EXPECT_TRUE(both({-2, 0, 0}));  // gap 1, beside a corner
  EXPECT_FALSE(both({"-2.000001", 0, 0}));
  EXPECT_TRUE(both({"-1.2", "-1.2", "-1"}));
  EXPECT_FALSE(both({"-1.2", "-1.2", "-1.2"}));
  EXPECT_TRUE(both({1, 1, 1}));
  const SpaceRegion skin = *ball_scene("gap(ball, rock) <= 1").map({.apply = "boundary"}).space_region();
  EXPECT_TRUE(skin.contains(Point3{-2, 0, 0}));
  EXPECT_FALSE(skin.contains(Point3{"-1.9", 0, 0}));
  EXPECT_FALSE(skin.contains(Point3{1, 1, 1}));
  const bool out = ball_scene("gap(ball, rock) > 1").map().space_region()->contains(Point3{-2, 0, 0});
  EXPECT_FALSE(out);
  EXPECT_FALSE(answer.sampled());
}

TEST(PublicSpaceMaps, AreConvexAndFlat) {
  const Scene scene = Scene::json(R"json({"findspace": 1, "shapes": {"hole": {"polytope": [[0, 0, 0], [6, 0, 0],
    [0, 6, 0], [0, 0, 6]]}, "plug": {"polytope": [[0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6]]}}, "moving": "plug",
    "where": "inside(plug, hole)"})json");
  const SpaceRegion region = *scene.map().space_region();  // an exact fit
  EXPECT_EQ(region.form(), SpaceRegion::Form::kConvex);
  EXPECT_TRUE(region.contains(Point3{0, 0, 0}));
  EXPECT_FALSE(region.contains(Point3{"0.000001", 0, 0}));
  const Position3 at[2]{{0, 0, 0}, {1, 0, 0}};
  bool inside[2]{};
  region.contains(at, inside);
  EXPECT_TRUE(inside[0]);
  EXPECT_FALSE(inside[1]);
}

TEST(PublicSpaceMaps, OfSeveralOrientationsAreAskedOneByOne) {
  const Scene scene = crate_scene(R"(, "free": "pose", "angles": [{"axis": "z", "degrees": 90}])");
  EXPECT_EQ(code_of([&] { scene.map(); }), ErrorCode::kUnsupported);
  EXPECT_EQ(*scene.rotated(scene.free().rotations[0]).map().space_region()->volume(), 8 * 7 * 8);
}

/// A ball in a room beside another one: neither boxes nor convex.
Scene round_scene(const std::string& where = "inside(ball, room) and clear(ball, post)", const std::string& more = "") {
  return Scene::json(R"json({"findspace": 1, "unit": "mm", "shapes": {"room": {"box": {"min": [0, 0, 0],
    "max": [10, 10, 10]}}, "post": {"ball": {"center": [5, 5, 5], "radius": 2}},
    "ball": {"ball": {"center": [0, 0, 0], "radius": 1}}}, "moving": "ball", "where": ")json" +
                     where + "\"" + more + "}");
}

MapQuestion on_lines(const MapLines& lines) {
  MapQuestion out;
  out.lines = lines;
  return out;
}

TEST(PublicSpaceMaps, GoOnLinesWhereTheyHaveNoExactForm) {
  const Answer answer = round_scene().map(on_lines({.count = 16}));
  EXPECT_TRUE(answer.sampled());
  EXPECT_EQ(answer.found(), Found::kYes);
  EXPECT_FALSE(answer.space_region().has_value());
  const LineMap lines = *answer.on_lines();
  EXPECT_TRUE(lines.exact);
  EXPECT_EQ(lines.lines.size(), 100u);  // of 256
  EXPECT_EQ(*lines.lines[0].intervals[0].to, 9);
  const LineMap same = round_scene().world().on_lines("inside(ball, room) and clear(ball, post)", {.count = 16});
  EXPECT_EQ(same.volume, lines.volume);
  EXPECT_EQ(same.lines.size(), lines.lines.size());
  EXPECT_NE(answer.text().find("Positions of ball: on 256 lines"), std::string::npos) << answer.text();
  std::string parts;
  answer.write(".json", [&](std::string_view part) { parts += part; });
  EXPECT_EQ(parts, answer.json());
  EXPECT_NE(parts.find("\"lines\": ["), std::string::npos);
  EXPECT_EQ(answer.endings().size(), 9u);
  EXPECT_NE(answer.file(".obj").text.find("v "), std::string::npos);
  EXPECT_NE(answer.file(".svg").text.find("Positions of ball"), std::string::npos);
}

TEST(PublicSpaceMaps, OnLinesAreSparedTheirList) {
  MapQuestion question = on_lines({.count = 8, .axes = true});
  question.listed = false;
  const Answer answer = round_scene().map(question);
  EXPECT_EQ(answer.json().find("\"lines\": ["), std::string::npos);
  EXPECT_NE(answer.text().find("certified"), std::string::npos);
}

TEST(PublicSpaceMaps, OnLinesHoldCellsAboutThem) {
  const double whole = 8.0 * 8 * 8 - 36 * 3.14159265358979;
  const Answer inner = round_scene().map(on_lines({.count = 24, .side = MapLines::Side::kInner}));
  const Answer outer =
      round_scene().map(on_lines({.apart = "0.5", .axis = Shape::Axis::kX, .side = MapLines::Side::kOuter}));
  EXPECT_LT(inner.on_lines()->volume, whole);
  EXPECT_GT(outer.on_lines()->volume, whole);
  EXPECT_EQ(inner.found(), Found::kYes);
  EXPECT_EQ(outer.found(), Found::kUndecided);
  EXPECT_EQ(inner.endings(), (std::vector<std::string>{".json"}));
  const auto found = [](const std::string& where, const MapLines& lines) {
    return round_scene(where).map(on_lines(lines)).found();
  };
  EXPECT_EQ(found("inside(post, ball) and gap(ball, room) > 20", {.count = 4, .side = MapLines::Side::kOuter}),
            Found::kNo);
  EXPECT_EQ(found("gap(ball, post) <= 0 and gap(ball, post) >= 0 and depth(ball, post) > 100", {.count = 4}),
            Found::kUndecided);
}

Scene box_scene(const std::string& where, const std::string& more = "") {
  return Scene::json(R"json({"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [6, 6, 6]}},
    "crate": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}}, "moving": "crate", "where": ")json" +
                     where + "\"" + more + "}");
}

TEST(PublicSpaceMaps, OuterCellsHoldARegionWhoseLevelIsNearerThanACell) {
  // Moved by the radius of a cell the level is below what the depth has far away: every line lies in the set.
  const MapQuestion question = on_lines({.count = 20, .side = MapLines::Side::kOuter});
  const Answer answer = box_scene("depth(crate, room) > 0").map(question);
  EXPECT_EQ(answer.found(), Found::kUndecided);
  EXPECT_GT(answer.on_lines()->volume, 343);
  EXPECT_NE(answer.text().find("volume at most"), std::string::npos);
  const Answer lowest = box_scene("depth(crate, room) > 0", R"(, "minimize": "z")").map(question);
  EXPECT_LT(lowest.best()->lower, -1);
  const World world = box_scene("depth(crate, room) > 0").world();
  const VolumeBounds volume = world.volume("depth(crate, room) > 0", {20});
  EXPECT_LE(volume.lower, 343);
  EXPECT_GE(volume.upper, 343);
}

TEST(PublicSpaceMaps, OnLinesCutWhatHasNoEndAtTheWindow) {
  const Answer answer = box_scene("clear(crate, room)").map(on_lines({.count = 8}));
  const LineMap map = *answer.on_lines();
  EXPECT_TRUE(map.unbounded);
  EXPECT_LT(map.bounds->low[2], -1);
  EXPECT_GT(map.bounds->high[2], 6);
  EXPECT_NE(answer.json().find("\"points\": 0"), std::string::npos);
}

TEST(PublicSpaceMaps, ComponentsOfASearchAreNotCertified) {
  // Two sets that the plane x = 0 parts by less than what a search can tell.
  const Answer answer = Scene::json(R"json({"findspace": 1, "shapes": {"A": {"union": [
    {"ball": {"center": [1.5, 0, 0], "radius": 2}}, {"ball": {"center": [-1.5, 0, 0], "radius": 2}}]},
    "B": {"ball": {"center": [0, 0, 0], "radius": 0.5}}}, "moving": "B",
    "where": "gamma1(B, A) <= -2.0000000001"})json")
                            .map(on_lines({.apart = "3.000002", .axes = true}));
  EXPECT_NE(answer.json().find("\"on_lines\": \"outer\""), std::string::npos);
  EXPECT_EQ(answer.json().find("\"certified\": true"), std::string::npos);
}

TEST(PublicSpaceMaps, OnLinesHaveBestPositions) {
  const Answer answer =
      round_scene("inside(ball, room) and clear(ball, post)", R"(, "maximize": "z")").map(on_lines({.count = 9}));
  EXPECT_EQ(*answer.best()->value, 9);
  const Answer farthest =
      round_scene("inside(ball, room)", R"json(, "maximize": "gap(ball, post)")json").map(on_lines({.count = 9}));
  EXPECT_GT(*farthest.best()->value, 2.4);  // 3.93 in the corners, which no line meets
  EXPECT_LT(*farthest.best()->value, 3.94);
}

/// The lengths at which a ball on a line is as near to a bent wall as said, which are found by search.
Answer on_one_side(const std::string& where, const std::string& more) {
  return Scene::json(R"json({"findspace": 1, "shapes": {"bent": {"union": [
      {"box": {"min": [0, 0, 0], "max": [9, 9, 2]}}, {"box": {"min": [0, 0, 0], "max": [2, 9, 9]}}]},
      "ball": {"ball": {"center": [5, 5, 5], "radius": 2}}}, "moving": "ball",
      "free": {"line": {"through": [1, 4, 4], "direction": [1, 2, 1]}}, "where": ")json" +
                     where + "\"" + more + "}")
      .map();
}

TEST(PublicSpaceMaps, TheBestOfALineBetweenBoundsIsNoBound) {
  const char* const least = R"json(, "minimize": "distance to [1, 4, 4]")json";
  const Answer outer = on_one_side("protrusion(ball, bent) <= 3", least);
  EXPECT_TRUE(outer.intervals().empty());
  EXPECT_EQ(outer.possible().size(), 1u);
  EXPECT_EQ(*outer.possible()[0].from, *on_one_side("protrusion(ball, bent) <= 3", "").possible()[0].from);
  const Answer inner = on_one_side("protrusion(ball, bent) > 3", least);
  EXPECT_TRUE(inner.best().has_value());
  EXPECT_TRUE(inner.intervals().empty());
  EXPECT_FALSE(inner.possible().at(0).from.has_value());  // the whole line
}

TEST(PublicSpaceMaps, RefuseCellsAboutLinesOfThreeAxes) {
  const Scene slim = Scene::json(R"json({"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0],
    "max": [1, 1, 100]}}, "B": {"box": {"min": [0, 0, 0], "max": [0.5, 0.5, 0.5]}}}, "moving": "B",
    "where": "inside(B, A)"})json");
  const MapLines lines{.count = 10, .axes = true, .side = MapLines::Side::kOuter};
  EXPECT_EQ(code_of([&] { slim.map(on_lines(lines)); }), ErrorCode::kBadValue);
  ShapeQuestion shape;
  shape.lines = lines;
  EXPECT_EQ(code_of([&] { slim.describe("A", shape); }), ErrorCode::kBadValue);
}

TEST(PublicSpaceMaps, RefuseLinesThatAreNone) {
  const auto refused = [](const Scene& scene, const MapLines& lines) {
    return code_of([&] { scene.map(on_lines(lines)); });
  };
  EXPECT_EQ(refused(round_scene(), {}), ErrorCode::kBadValue);
  EXPECT_EQ(refused(round_scene(), {.count = 16385}), ErrorCode::kBadValue);
  EXPECT_EQ(refused(round_scene(), {.count = 4, .apart = 1}), ErrorCode::kBadValue);
  EXPECT_EQ(refused(round_scene(), {.apart = "0.00000000001"}), ErrorCode::kBadValue);
  EXPECT_EQ(refused(round_scene(), {.apart = -1}), ErrorCode::kBadValue);
  const Scene flat = Scene::json(R"json({"findspace": 1, "shapes": {"a": {"box": {"min": [0, 0], "max": [1, 1]}}},
    "moving": "a", "where": "true"})json");
  EXPECT_EQ(refused(flat, {.count = 4}), ErrorCode::kBadValue);
  MapQuestion made = on_lines({.count = 4});
  made.apply = "closure";
  EXPECT_EQ(code_of([&] { round_scene().map(made); }), ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace findspace
