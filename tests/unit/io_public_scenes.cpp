// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Scene files and explanations through the public headers.

#include <gtest/gtest.h>

#include <cmath>

#include "findspace/error.h"
#include "findspace/scene.h"

namespace io_public_scenes {

using namespace findspace;

const char* const kScene = R"json({"findspace": 1, "unit": "mm", "shapes": {
    "plate": {"box": {"min": [0, 0], "max": [10, 8]}}, "a": {"box": {"min": [0, 0], "max": [1, 1]}},
    "b": {"disc": {"center": [5, 4], "radius": 1}}, "peg": {"box": {"min": [-1, -1], "max": [1, 1]}}},
  "groups": {"both": ["a", "b"]}, "moving": "peg", "where": ["inside(peg, plate)", "clear(peg, both, 1)"],
  "minimize": "y"})json";

TEST(PublicScene, IsReadWithinLimits) {
  const char* const text = R"json({"findspace": 1, "shapes": {"a": {"file": "part.svg"}}})json";
  const auto code_of = [&](const ReadOptions& reading) {
    try {
      Scene::json(text, ".", reading);
    } catch (const Error& e) {
      return e.code();
    }
    return ErrorCode::kUsage;
  };
  EXPECT_EQ(code_of({}), ErrorCode::kFile);  // it is not there
  EXPECT_EQ(code_of({.files = false}), ErrorCode::kUnsupported);
  EXPECT_EQ(code_of({.work_limit = 1}), ErrorCode::kLimit);
}

TEST(PublicScene, KeepsHowItWasRead) {
  const Scene scene = Scene::json(kScene, "drawings", {.files = false, .root = "drawings"});
  EXPECT_FALSE(scene.reading().files);
  EXPECT_EQ(scene.reading().root, "drawings");
}

TEST(PublicScene, ARegionWithAUnitComesBack) {
  const Region plate = Scene::json(kScene).shapes().at("plate").region();
  const Region same = Shape::json(plate.exact_json()).region();
  EXPECT_EQ(same, plate);
  EXPECT_EQ(same.text(), plate.text());  // in its unit
}

TEST(PublicScene, ItsRegionsAreWritten) {
  const Scene scene = Scene::json(R"json({"findspace": 1, "unit": "mm", "shapes": {
    "ring": {"difference": [{"disc": {"center": [0, 0], "radius": 2}}, {"disc": {"center": [0, 0], "radius": 1}}]},
    "tilted": {"rotate": 30, "of": {"box": {"min": [0, 0], "max": [1, 1]}}}}})json");
  const Region& ring = scene.shapes().at("ring").region();
  EXPECT_EQ(ring.text("a ring").rfind("a ring\nbounded, not open, not closed, not regular; 1 component, 1 hole\n", 0),
            0u);
  EXPECT_NE(ring.text().find(" mm²"), std::string::npos);  // the scene's unit
  EXPECT_GT(ring.json(true).size(), ring.json().size());
  EXPECT_EQ(Scene::json(ring.scene_json("again")).shapes().at("again").region(), ring);
  const Region::Drawn dxf = ring.drawn(".dxf", "ring", DxfVersion::k2000);
  EXPECT_NE(dxf.text.find("AC1015"), std::string::npos);
  EXPECT_FALSE(dxf.lost.empty());  // its inner circle does not belong to it
  EXPECT_TRUE(Region(ring.closure()).drawn(".wkt").lost.empty());
  EXPECT_THROW(ring.drawn(".geojson"), Error);  // arcs
  EXPECT_THROW(ring.drawn(".doc"), Error);
  EXPECT_NE(ring.picture("a ring", "below").find("below"), std::string::npos);
  EXPECT_EQ(scene.shapes().at("ring").rotated_points().points, 0u);
  EXPECT_EQ(scene.shapes().at("tilted").rotated_points().points, 3u);  // all but the pole
  EXPECT_LT(scene.shapes().at("tilted").rotated_points().largest, 1e-6);
}

TEST(PublicScene, AsksWhatTheFileAsks) {
  const Scene scene = Scene::json(kScene);
  EXPECT_EQ(scene.shapes().size(), 5u);  // the group is one, too
  EXPECT_EQ(scene.world().unit(), "mm");
  EXPECT_EQ(scene.world().moving(), "peg");
  EXPECT_EQ(scene.minimize(), "y");
  EXPECT_EQ(scene.maximize(), "");
  const Region region = scene.world().solve(scene.where());
  EXPECT_TRUE(region.contains(Point{9, 7}));
  EXPECT_TRUE(region.contains(Point{5, 1}));
  EXPECT_FALSE(region.contains(Point{5, "1.000001"}));
  EXPECT_EQ(*scene.world().minimize(scene.minimize(), scene.where()).value, 1);
  World fewer = scene.world();
  fewer.remove("both");
  EXPECT_THROW(fewer.solve(scene.where()), Error);
  EXPECT_FALSE(fewer.solve("inside(peg, plate)").empty());
}

TEST(PublicScene, MovesInTimeAndStandsInSpace) {
  const Scene moving = Scene::json(R"json({"findspace": 1, "shapes": {"cart": {"disc": {"center": [0, 0], "radius": 1}},
    "post": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "cart", "where": "inf gap(cart, post) >= 0",
    "motion": {"time": [0, 1], "post": {"path": [[-5, 0], [5, 0.5]]}}})json");
  EXPECT_TRUE(moving.world().motion().has_value());
  EXPECT_EQ(moving.world().motion()->paths.at("post")[1].at.y.text(), "0.5");
  EXPECT_FALSE(moving.world().holds(moving.where(), Point{0, 1}));
  const Scene thirds = Scene::json(R"json({"findspace": 1, "shapes": {"cart": {"disc": {"center": [0, 0], "radius": 1}},
    "post": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "cart", "where": "gap(cart, post) >= 1",
    "motion": {"time": [0, 1], "post": {"path": [[0, 0], [1, 0], [2, 0], [3, 0]]}}})json");
  EXPECT_EQ(thirds.motion()->paths.at("post")[1].time, Number("1/3"));
  for (const Scene& scene : {thirds, thirds.prepared()}) {
    const World at = scene.world().at_time("1/3");
    EXPECT_TRUE(at.holds("gap(cart, post) = 1", Point{4, 0}));
    World changed = scene.world();
    changed.set("pin", Shape::disc({9, 0}, 1));
    EXPECT_TRUE(changed.at_time("2/3").holds("gap(cart, post) = 1", Point{5, 0}));
    EXPECT_EQ(scene.check({{4, 0}, {}, "1/3"}).found(), Answer::Found::kYes);
  }
  const Scene solid =
      Scene::json(R"json({"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}},
    "crate": {"box": {"min": [0, 0, 0], "max": [1, 2, 3]}}}, "moving": "crate", "where": "inside(crate, room)"})json");
  EXPECT_TRUE(solid.world().holds(solid.where(), Point3{8, 7, 6}));
}

TEST(PublicScene, SaysWhatIsWrong) {
  EXPECT_THROW(Scene::file("no such scene.json"), Error);
  EXPECT_THROW(Scene::json("{"), Error);
  const Scene still =
      Scene::json(R"json({"findspace": 1, "shapes": {"a": {"box": {"min": [0, 0], "max": [1, 1]}}}})json");
  EXPECT_EQ(*still.shapes().at("a").region().area(), 1);
  EXPECT_THROW(still.world(), Error);
}

TEST(PublicScene, SaysWhatIsFree) {
  const Scene scene = Scene::json(kScene, ".", {}, "a name");
  EXPECT_EQ(scene.names(), (std::vector<std::string>{"plate", "a", "b", "peg", "both"}));
  EXPECT_EQ(scene.moving(), (std::vector<std::string>{"peg"}));
  EXPECT_EQ(scene.dimension(), 2);
  EXPECT_EQ(scene.unit(), "mm");
  EXPECT_EQ(scene.name(), "a name");
  EXPECT_EQ(scene.free().kind, Scene::Free::Kind::kPosition);
  EXPECT_FALSE(scene.motion().has_value());
  const Scene line = Scene::json(R"json({"findspace": 1, "shapes": {"a": {"box": {"min": [0, 0], "max": [1, 1]}}},
    "moving": "a", "free": {"line": {"through": [0.5, -3], "direction": [2, 4]}}})json");
  EXPECT_EQ(line.free().kind, Scene::Free::Kind::kLine);
  EXPECT_EQ(line.free().through, (std::vector<Number>{"0.5", -3}));
  EXPECT_EQ(line.free().direction, (std::vector<Number>{1, 2}));
}

TEST(PublicScene, ChecksAPose) {
  const Scene scene = Scene::json(kScene);
  const Answer good = scene.check({{9, 7}});
  EXPECT_EQ(good.found(), Answer::Found::kYes);
  EXPECT_FALSE(good.nearest().has_value());
  EXPECT_TRUE(good.check().holds);
  const Answer bad = scene.check({{"9.5", 7}});
  EXPECT_EQ(bad.found(), Answer::Found::kNo);
  ASSERT_TRUE(bad.nearest().has_value());
  EXPECT_EQ(bad.nearest()->at, (Place{9, 7}));
  EXPECT_EQ(bad.nearest()->distance, 0.5);
  EXPECT_TRUE(bad.nearest()->attained);
  EXPECT_NE(bad.text().find("not feasible"), std::string::npos);
  EXPECT_NE(bad.text({.explain = true}).find(" ms"), std::string::npos);
  EXPECT_EQ(bad.endings(), (std::vector<std::string>{".json", ".svg"}));
  EXPECT_EQ(bad.file(".json").text, bad.json());
  EXPECT_NE(bad.file(".svg").text.find("Not feasible"), std::string::npos);
  EXPECT_THROW(bad.file(".doc"), Error);
  EXPECT_TRUE(bad.measured().empty());
  EXPECT_EQ(scene.check({{5, 1}, 90}).found(), Answer::Found::kYes);
  EXPECT_THROW(scene.check({{1, 2, 3}}), Error);
  EXPECT_THROW(scene.check({{"1e30", 0}}), Error);
  EXPECT_THROW(scene.check({{0, 0}, {}, 1}), Error);  // there is no motion
}

TEST(PublicScene, MeasuresAtAPose) {
  const Scene scene = Scene::json(kScene);
  const Answer all = scene.measure({{2, 2}});
  EXPECT_EQ(all.found(), Answer::Found::kYes);
  EXPECT_THROW(all.check(), Error);
  const Answer gaps = scene.measure({{2, 2}}, {"gap"});
  EXPECT_LT(gaps.measured().size(), all.measured().size());
  for (const Measured& one : gaps.measured()) EXPECT_EQ(one.text.rfind("gap(peg, ", 0), 0u) << one.text;
  for (const Measured& one : all.measured())
    if (one.text == "margin(peg, plate)") {
      EXPECT_EQ(*one.value->value, 1);
    }
  EXPECT_THROW(scene.measure({}, {"gpa"}), Error);
}

TEST(PublicScene, MapsPositions) {
  const Scene scene = Scene::json(kScene);
  const Answer best = scene.map();
  EXPECT_EQ(best.found(), Answer::Found::kYes);
  ASSERT_TRUE(best.best().has_value());
  EXPECT_EQ(*best.best()->value, 1);
  EXPECT_TRUE(best.best()->attained);
  EXPECT_EQ(best.region()->inner, best.best()->at);
  EXPECT_FALSE(best.region()->inner.contains(Point{9, 7}));
  const Answer all = scene.asking({.minimize = ""}).map();
  EXPECT_TRUE(all.region()->inner.contains(Point{9, 7}));
  EXPECT_EQ(all.region()->inner, all.region()->outer);
  EXPECT_FALSE(all.best().has_value());
  EXPECT_TRUE(all.intervals().empty());
  EXPECT_EQ(all.endings(), (std::vector<std::string>{".json", ".dxf", ".svg", ".wkt"}));
  EXPECT_GT(all.json({.exact = true}).size(), all.json().size());
  EXPECT_NE(all.file(".wkt").text.find("POLYGON"), std::string::npos);
  EXPECT_NE(all.file(".dxf", {.dxf = DxfVersion::k2000}).text.find("AC1015"), std::string::npos);
  EXPECT_EQ(scene.asking({.minimize = ""}).map({.pictures = false}).endings(),
            (std::vector<std::string>{".json", ".dxf", ".wkt"}));
  EXPECT_EQ(scene.asking({.minimize = ""}).map({.apply = "boundary"}).region()->inner, all.region()->inner.boundary());
  EXPECT_EQ(scene.asking({.where = "gap(peg, a) < -9"}).map().found(), Answer::Found::kNo);
}

TEST(PublicScene, MapsALineAnglesInstantsAndPoses) {
  const auto scene = [](const std::string& rest) {
    return Scene::json(R"json({"findspace": 1, "shapes": {"room": {"box": {"min": [-3, -1.5], "max": [3, 1.5]}},
      "bar": {"box": {"min": [-2, -1], "max": [2, 1]}}}, "moving": "bar", "where": "inside(bar, room)", )json" +
                       rest + "}");
  };
  const Answer line = scene(R"json("free": {"line": {"through": [0, 0], "direction": [1, 0]}})json").map();
  ASSERT_EQ(line.intervals().size(), 1u);
  EXPECT_EQ(*line.intervals()[0].from, -1);
  EXPECT_TRUE(line.intervals()[0].to_belongs);
  EXPECT_EQ(line.possible().size(), 1u);
  EXPECT_EQ(line.endings(), (std::vector<std::string>{".json"}));
  const Answer angles = scene(R"json("free": "angle")json").map();
  ASSERT_EQ(angles.intervals().size(), 2u);  // about 0 and about 180 degrees
  EXPECT_LT(*angles.intervals()[0].from, *angles.intervals()[0].to);
  EXPECT_FALSE(angles.region().has_value());
  EXPECT_THROW(scene(R"json("free": "angle")json").map({.apply = "closure"}), Error);
  const Scene posed = scene(R"json("free": "pose", "angles": [0, 90])json");
  const Answer poses = posed.map();
  ASSERT_EQ(poses.poses()->slices.size(), 2u);
  EXPECT_EQ(*poses.poses()->slices[0].region.area(), 2);
  EXPECT_TRUE(poses.poses()->slices[1].region.empty());
  EXPECT_NE(poses.file(".html").text.find("<html"), std::string::npos);
  EXPECT_TRUE(posed.explain().explanation()->feasible);
  EXPECT_THROW(posed.explain({{0, 0}}), Error);
  EXPECT_EQ(posed.explain({{}, 90}).found(), Answer::Found::kNo);
  EXPECT_EQ(posed.explain({{0, 0}, 0}).found(), Answer::Found::kYes);
  const Answer instants =
      scene(R"json("free": "time", "motion": {"time": [0, 1], "bar": {"path": [[0, 0], [4, 0]]}})json").map({{{0, 0}}});
  ASSERT_EQ(instants.intervals().size(), 1u);
  EXPECT_EQ(*instants.intervals()[0].to, 0.25);
}

TEST(PublicScene, MapsALineOfSpace) {
  const auto scene = [](const std::string& where, const std::string& rest = "") {
    return Scene::json(R"json({"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}},
      "crate": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}}, "ball": {"ball": {"center": [5, 5, 5], "radius": 2}}},
      "moving": "crate", "free": {"line": {"through": [1, 4, 4], "direction": [1, 0, 0]}}, "where": ")json" +
                       where + "\"" + rest + "}");
  };
  const Answer inside = scene("inside(crate, room) and clear(crate, ball)").map();
  EXPECT_EQ(inside.found(), Answer::Found::kYes);
  ASSERT_EQ(inside.intervals().size(), 2u);  // the last is the end of the room, where the crate touches the ball
  EXPECT_EQ(*inside.intervals()[0].from, -1);
  EXPECT_EQ(*inside.intervals()[1].from, *inside.intervals()[1].to);
  EXPECT_EQ(inside.possible().size(), 2u);
  EXPECT_EQ(inside.endings(), (std::vector<std::string>{".json"}));
  EXPECT_FALSE(inside.best().has_value());
  EXPECT_NE(inside.text().find("Positions of crate on the line"), std::string::npos);
  const Answer best = scene("inside(crate, room)", R"json(, "maximize": "x")json").map();
  EXPECT_EQ(*best.best()->value, 7);
  EXPECT_TRUE(best.best()->at.empty());
  EXPECT_EQ(*best.intervals()[0].from, 6);
  EXPECT_EQ(scene("inside(room, crate)").map().found(), Answer::Found::kNo);
  EXPECT_THROW(scene("inside(crate, room)").map({.apply = "closure"}), Error);
}

TEST(PublicScene, MapsALineOfSpaceOnOneSide) {
  const auto map = [](const std::string& where) {
    return Scene::json(R"json({"findspace": 1, "shapes": {"bent": {"union": [
      {"box": {"min": [0, 0, 0], "max": [9, 9, 2]}}, {"box": {"min": [0, 0, 0], "max": [2, 9, 9]}}]},
      "ball": {"ball": {"center": [5, 5, 5], "radius": 2}}}, "moving": "ball",
      "free": {"line": {"through": [1, 4, 4], "direction": [1, 2, 1]}}, "where": ")json" +
                       where + "\"}")
        .map();
  };
  const Answer outer = map("protrusion(ball, bent) <= 3");  // found by search
  EXPECT_EQ(outer.found(), Answer::Found::kYes);            // what is given has some
  EXPECT_TRUE(outer.intervals().empty());
  ASSERT_EQ(outer.possible().size(), 1u);
  EXPECT_NEAR(*outer.possible()[0].from, -5 * std::sqrt(6.0), 1e-6);  // no sign: a test
  EXPECT_EQ(outer.notes().size(), 1u);
  EXPECT_EQ(map("protrusion(ball, bent) <= 0.01").found(), Answer::Found::kNo);
  const Answer inner = map("protrusion(ball, bent) > 3");
  EXPECT_EQ(inner.found(), Answer::Found::kYes);
  EXPECT_EQ(inner.intervals().size(), 2u);
  ASSERT_EQ(inner.possible().size(), 1u);
  EXPECT_FALSE(inner.possible()[0].from.has_value());  // the whole line
}

TEST(PublicScene, ExplainsItself) {
  const Scene scene = Scene::json(kScene).asking({.where = "inside(peg, plate) and gap(peg, b) >= 6"});
  const Answer found = scene.explain({{1, 1}});
  EXPECT_EQ(found.found(), Answer::Found::kNo);
  EXPECT_EQ(found.explanation()->conflict.size(), 2u);
  EXPECT_EQ(found.text(), found.explanation()->text);
  EXPECT_EQ(found.json(), scene.world().explain(scene.where(), Point{1, 1}).json);
  EXPECT_FALSE(scene.map().explanation().has_value());
}

TEST(PublicScene, PlacesWhatItSays) {
  const auto scene = [](const std::string& place) {
    return Scene::json(R"json({"findspace": 1, "unit": "mm", "shapes": {
      "sheet": {"box": {"min": [0, 0], "max": [30, 20]}}, "bar": {"box": {"min": [0, 0], "max": [2, 25]}},
      "room": {"disc": {"center": [0, 0], "radius": 0.5}}}, "place": {)json" +
                       place + "}}");
  };
  const Scene bars = scene(R"json("shapes": ["bar"], "count": {"bar": 2}, "angles": {"bar": [0, 90]},
    "each": "inside(self, sheet)", "pairs": "clear(self, other, 1)", "minimize": ["y", "x"])json");
  EXPECT_TRUE(bars.places());
  EXPECT_FALSE(Scene::json(kScene).places());
  const Answer found = bars.place();
  EXPECT_EQ(found.found(), Answer::Found::kYes);
  ASSERT_TRUE(found.placement().has_value());
  const Placement placement = *found.placement();
  EXPECT_TRUE(placement.complete());
  ASSERT_EQ(placement.placed().size(), 2u);
  EXPECT_EQ(*placement.placed()[1].at, (Place{25, 3}));
  EXPECT_EQ(placement.placed()[1].degrees, 90);
  EXPECT_EQ(placement.placed()[1].exact_at[1].text(), "3");
  EXPECT_EQ(*placement.positions()[1].region.area(), 5 * 18);
  EXPECT_EQ(placement.json(), found.json());
  EXPECT_EQ(placement.svg(), found.file(".svg").text);
  EXPECT_EQ(found.endings(), (std::vector<std::string>{".json", ".dxf", ".svg"}));
  EXPECT_NE(found.file(".dxf").text.find("bar"), std::string::npos);
  EXPECT_FALSE(found.region().has_value());
  EXPECT_FALSE(Scene::json(kScene).map().placement().has_value());

  const Answer wanted = bars.place({{{"bar", 2, {"26.5", 9}, 90}}});
  EXPECT_EQ(wanted.placement()->placed()[0].copy, 2);  // it comes first
  EXPECT_EQ(*wanted.placement()->placed()[0].at, (Place{26.5, 9}));
  EXPECT_THROW(bars.place({{{"bar", 3, {0, 0}}}}), Error);
  EXPECT_THROW(bars.place({{{"bar", 1, {0, 0}, 45}}}), Error);
  EXPECT_THROW(bars.place({{{"bar", 1, {0, 0, 0}}}}), Error);
  EXPECT_THROW(Scene::json(kScene).place(), Error);

  EXPECT_EQ(scene(R"json("shapes": ["bar"], "each": "inside(self, sheet)")json").place().found(), Answer::Found::kNo);
  Options little;
  little.seconds = 1e-9;  // no sign: a time
  const Answer stopped = bars.with(little).place();
  EXPECT_EQ(stopped.found(), Answer::Found::kUndecided);
  EXPECT_FALSE(stopped.placement()->unproven().empty());
}

TEST(PublicScene, DescribesItsShapes) {
  const Scene scene = Scene::json(kScene);
  const Answer plate = scene.describe("plate");
  EXPECT_EQ(plate.found(), Answer::Found::kYes);
  EXPECT_EQ(plate.region()->inner.area(), 80);
  EXPECT_EQ(plate.text(), plate.region()->outer.text("plate"));
  EXPECT_NE(plate.json({.exact = true}).find("\"cells\""), std::string::npos);
  EXPECT_EQ(plate.json(), scene.shape("plate").region().json());
  EXPECT_EQ(plate.endings(), (std::vector<std::string>{".json", ".dxf", ".geojson", ".svg", ".wkt"}));
  EXPECT_NE(plate.file(".wkt").text.find("POLYGON"), std::string::npos);
  EXPECT_EQ(scene.groups().at("both"), (std::vector<std::string>{"a", "b"}));
  EXPECT_THROW(scene.describe("plat"), Error);
  EXPECT_THROW(scene.describe("plate", {.lines = MapLines{8}}), Error);
  const Scene solids = Scene::json(R"json({"findspace": 1, "unit": "mm", "shapes": {
    "box": {"box": {"min": [0, 0, 0], "max": [9, 2, 2]}}, "ball": {"ball": {"center": [0, 0, 0], "radius": 2}},
    "none": {"intersection": ["box", {"translate": [0, 3, 0], "of": "box"}]},
    "cut": {"difference": ["ball", "box"]}}})json");
  EXPECT_NE(solids.describe("box").text().find("volume  36 mm³"), std::string::npos);
  EXPECT_NE(solids.describe("box").file(".obj").text.find("v 9 2 2"), std::string::npos);
  EXPECT_EQ(solids.describe("none").found(), Answer::Found::kNo);
  EXPECT_FALSE(solids.describe("ball").sampled());
  EXPECT_TRUE(solids.describe("ball", {.surface = true}).sampled());
  const Answer cut = solids.describe("cut");
  EXPECT_TRUE(cut.sampled());
  EXPECT_FALSE(cut.on_lines()->lines.empty());
  EXPECT_EQ(cut.notes().size(), 1u);
  EXPECT_EQ(solids.describe("ball", {.lines = MapLines{.count = 4}}).on_lines()->lines.size(), 12u);
}

TEST(PublicScene, RefusesPosesThatItHasNot) {
  const Scene scene = Scene::json(kScene);
  scene.require({{3, "0.5"}});
  EXPECT_THROW(scene.require({{3}}), Error);
  EXPECT_THROW(scene.require({{"1e9", 0}}), Error);
  EXPECT_THROW(scene.require({{"x", 0}}), Error);
  EXPECT_THROW(scene.require({{}, {}, 1}), Error);
}

TEST(PublicScene, LinesThatAreNoneAreRefusedInTheWordsOfTheCaller) {
  const Scene scene = Scene::json(R"json({"findspace": 1, "shapes": {"a": {"box": {"min": [0, 0, 0],
    "max": [9, 2, 2]}}}})json");
  const auto fault = [&](const std::string& before) -> std::string {
    try {
      ShapeQuestion question;
      question.lines = MapLines{0, Number("0.00000015")};
      question.before = before;
      scene.describe("a", question);
    } catch (const Error& e) {
      return e.message();
    }
    return "";
  };
  EXPECT_EQ(fault("--"),
            "--step wants a decimal number of at least one grid step, and a multiple of it, not "
            "'0.00000015'");
  EXPECT_EQ(fault(""), "lines are apart by at least one grid step, and a multiple of it");
}

TEST(PublicScene, PlacesInSpace) {
  const Scene scene =
      Scene::json(R"json({"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [9, 2, 2]}},
    "crate": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}}}, "place": {"shapes": ["crate"], "count": {"crate": 4},
    "each": "inside(self, room)", "pairs": "clear(self, other)", "minimize": ["x"]}})json");
  const Answer found = scene.place();
  EXPECT_EQ(found.found(), Answer::Found::kYes);
  ASSERT_EQ(found.placement()->placed().size(), 4u);
  EXPECT_EQ(*found.placement()->placed()[3].at, (Place{6, 0, 0}));
  EXPECT_TRUE(found.placement()->positions().empty());
  EXPECT_EQ(found.placement()->svg(), found.file(".svg").text);
  EXPECT_NE(found.file(".obj").text.find("v 8 "), std::string::npos);
}

TEST(PublicScene, AsksSomethingElse) {
  const Scene scene = Scene::json(kScene);
  const Scene other = scene.asking({.where = "gap(peg, a) >= 20"});
  EXPECT_EQ(other.where().text(), "gap(peg, a) >= 20");
  EXPECT_EQ(other.minimize(), "y");
  EXPECT_EQ(other.check({{9, 7}}).found(), Answer::Found::kNo);
  EXPECT_EQ(scene.check({{9, 7}}).found(), Answer::Found::kYes);
  EXPECT_EQ(scene.asking({.maximize = "x"}).minimize(), "");
  try {
    scene.asking({.where = "gap(peg, nothing) > 0", .before = "--"}).check();
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.place(), "--where:1:10");
  }
}

TEST(PublicScene, IsTurnedInSpace) {
  const Scene scene =
      Scene::json(R"json({"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [9, 9, 2]}},
    "plank": {"box": {"min": [0, 0, 0], "max": [1, 1, 8]}}}, "moving": "plank", "where": "inside(plank, room)"})json");
  EXPECT_EQ(scene.check({{0, 0, 0}}).found(), Answer::Found::kNo);
  const Rotation lying = Rotation::read("y:90");
  EXPECT_TRUE(lying.exact());
  EXPECT_EQ(lying.matrix()[0][2], 1);
  const Scene turned = scene.rotated(lying);
  EXPECT_TRUE(turned.notes().empty());
  EXPECT_EQ(turned.check({{1, 0, 1}}).found(), Answer::Found::kYes);
  EXPECT_FALSE(scene.rotated(Rotation::read("1,1,0:45")).notes().empty());  // points off the grid
  EXPECT_FALSE(Rotation::read("z:30").exact());
  EXPECT_THROW(Rotation::read("z:"), Error);
  EXPECT_THROW(Rotation::read("0,0,0,0"), Error);
  EXPECT_THROW(scene.check({{0, 0, 0}, 90}), Error);
  EXPECT_THROW(Scene::json(kScene).rotated(lying), Error);
}

TEST(PublicScene, IsHeardAndEndsAtLimits) {
  std::vector<std::string> stages;
  const Scene scene =
      Scene::json(kScene).with(Scene::Listener{{}, [&](const std::string& stage) { stages.push_back(stage); }});
  scene.check({{9, 7}});
  EXPECT_EQ(stages, (std::vector<std::string>{"building the shapes", "checking"}));
  const Options stopped;
  stopped.cancel.request();
  EXPECT_THROW(scene.with(stopped).check({{9, 7}}), Stopped);
}

TEST(PublicExplanation, OfWhatHoldsNowhere) {
  const World world = Scene::json(kScene).world();
  const Explanation found = world.explain("inside(peg, plate) and gap(peg, b) >= 6", Point{1, 1});
  EXPECT_FALSE(found.feasible);
  EXPECT_EQ(found.conflict.size(), 2u);
  EXPECT_TRUE(found.smallest);
  ASSERT_EQ(found.relax.size(), 2u);
  const LevelChange& change = found.relax[1];
  EXPECT_EQ(change.text, "gap(peg, b) >= 6");
  EXPECT_EQ(change.kind, LevelChange::Kind::kTo);
  EXPECT_LE(change.lower, change.to);
  EXPECT_GE(change.upper, change.to);
  EXPECT_NEAR(change.to + change.by, 6, 1e-12);
  EXPECT_TRUE(world.holds("inside(peg, plate)", Point{change.at->at(0), change.at->at(1)}));
  ASSERT_TRUE(found.here.has_value());
  EXPECT_FALSE(found.here->holds);
  EXPECT_EQ(found.change, (std::vector<std::string>{"gap(peg, b) >= 6"}));
  EXPECT_NE(found.text.find("is not feasible; in the way"), std::string::npos);
  EXPECT_EQ(found.json.find("{\"unit\": \"mm\""), 0u);
}

TEST(PublicExplanation, OfWhatHasSlack) {
  const World world = Scene::json(kScene).world();
  const Explanation found = world.explain("margin(peg, plate) >= 1");
  EXPECT_TRUE(found.feasible);
  ASSERT_EQ(found.slack.size(), 1u);
  EXPECT_EQ(found.slack[0].to, 3);
  EXPECT_TRUE(found.slack[0].exact);
  EXPECT_FALSE(found.here.has_value());
  const World solid({{"a", Shape::ball({0, 0, 0}, 1)}, {"b", Shape::ball({0, 0, 0}, 2)}}, "a");
  const Explanation around = solid.explain("inside(a, b) and gap(a, b) >= -2", Point3{5, 0, 0});
  EXPECT_TRUE(around.feasible);
  ASSERT_EQ(around.slack.size(), 2u);
  EXPECT_FALSE(around.slack[1].exact);
  EXPECT_LE(around.slack[1].lower, -2 + 1e-3);
  EXPECT_EQ(around.slack[1].at->size(), 3u);
  EXPECT_EQ(around.change, (std::vector<std::string>{"inside(a, b)"}));
  EXPECT_THROW(solid.explain("inside(a, b)", Point{0, 0}), Error);
  EXPECT_THROW(world.explain("margin(peg, plate) >= 1", Point3{0, 0, 0}), Error);
}

TEST(PublicExplanation, OfSomeAngles) {
  const World world({{"room", Shape::box({0, 0}, {3, 5})}, {"bar", Shape::box({-2, -1}, {2, 1})}}, "bar");
  EXPECT_FALSE(world.explain("inside(bar, room)").feasible);
  const Explanation found = world.explain_poses("margin(bar, room) >= 0", {0, 90});
  EXPECT_TRUE(found.feasible);
  ASSERT_EQ(found.slack.size(), 1u);
  EXPECT_EQ(found.slack[0].to, 0.5);
  EXPECT_EQ(found.slack[0].angle, 90);
  EXPECT_EQ(found.slack[0].at, (std::vector<double>{1.5, 2.5}));
  const Explanation none = world.explain_poses("margin(bar, room) >= 1", {0, 90, 180}, {2, 1});
  EXPECT_FALSE(none.feasible);
  EXPECT_EQ(none.conflict, (std::vector<std::string>{"margin(bar, room) >= 1"}));
  ASSERT_TRUE(none.together.has_value());
  EXPECT_EQ(none.together->angle, 90);
  EXPECT_NE(none.text.find("no position is feasible at any of these angles"), std::string::npos);
  EXPECT_FALSE(world.explain("gap(bar, room) <= 1").slack.at(0).angle.has_value());
  EXPECT_THROW(world.explain_poses("inside(bar, room)", {}), Error);
}

TEST(PublicExplanation, OfAllAnglesAtAPosition) {
  const World world({{"room", Shape::box({-4, -4}, {4, 4})}, {"bar", Shape::box({-3, -1}, {3, 1})}}, "bar");
  const Explanation found = world.explain_angles("margin(bar, room) >= 0.25", Point{0.5, 0});
  EXPECT_TRUE(found.feasible);
  ASSERT_EQ(found.slack.size(), 1u);
  EXPECT_EQ(found.slack[0].to, 1);
  EXPECT_EQ(found.slack[0].angle, 90);
  EXPECT_FALSE(found.slack[0].at.has_value());
  EXPECT_NE(found.text.find("some angles are feasible"), std::string::npos);
  // At the diagonal corners touch a wall at 45 degrees: half the sides, less the way along.
  const Explanation best = world.explain_angles("margin(bar, room) >= 1.5", Point{0, 0});
  EXPECT_FALSE(best.feasible);
  EXPECT_EQ(best.conflict, (std::vector<std::string>{"margin(bar, room) >= 1.5"}));
  ASSERT_EQ(best.relax.size(), 1u);
  EXPECT_LE(best.relax[0].lower, 4 - 2 * std::sqrt(2) + 1e-12);
  EXPECT_GE(best.relax[0].upper, 4 - 2 * std::sqrt(2) - 1e-12);
  EXPECT_NEAR(*best.relax[0].angle, 45, 1e-5);
  ASSERT_TRUE(best.together.has_value());
  EXPECT_FALSE(best.together->at.has_value());
  EXPECT_TRUE(best.together->angle.has_value());
}

/// A bus that passes a post, 2 beside it while 3.5 <= time <= 5.5.
World passing_bus() {
  const World still({{"post", Shape::box({9, 3}, {11, 24})}, {"bus", Shape::box({0, 0}, {2, 1})}}, "bus");
  return still.with(Motion{0, 10, {{"bus", {{0, {0, 0}, 0}, {10, {20, 0}, 0}}}}});
}

TEST(PublicExplanation, OfTheInstantsOfAMotion) {
  const Explanation found = passing_bus().explain_instants("gap(bus, post) <= 3", Point{0, 0});
  EXPECT_TRUE(found.feasible);
  ASSERT_EQ(found.slack.size(), 1u);
  EXPECT_EQ(found.slack[0].to, 2);
  EXPECT_TRUE(found.slack[0].exact && found.slack[0].reached);
  EXPECT_EQ(found.slack[0].time, 3.5);
  EXPECT_FALSE(found.slack[0].at || found.slack[0].angle);
  EXPECT_NE(found.text.find("the last instant is 3.5"), std::string::npos);
  // The farthest corners are 25 apart until 2 and from 7 on; until then (6, 1) comes no nearer to (9, 3).
  const World world = passing_bus();
  const Explanation none = world.explain_instants("gap(bus, post) <= 3 and reach(bus, post) >= 25", Point{0, 0});
  EXPECT_FALSE(none.feasible);
  EXPECT_EQ(none.conflict, (std::vector<std::string>{"gap(bus, post) <= 3", "reach(bus, post) >= 25"}));
}

TEST(PublicExplanation, OfInstantsAtOpenEnds) {
  const World world = passing_bus();
  // The infimum of the distance, that of (6, 1) and (9, 3), is taken at 2 and 7 only.
  const Explanation open = world.explain_instants("gap(bus, post) <= 3 and reach(bus, post) > 25", Point{0, 0});
  EXPECT_FALSE(open.feasible);
  ASSERT_EQ(open.relax.size(), 2u);
  EXPECT_FALSE(open.relax[0].reached);
  EXPECT_EQ(open.relax[0].time, 2);
  EXPECT_TRUE(open.relax[0].exact);
  EXPECT_DOUBLE_EQ(open.relax[0].to, std::sqrt(13));
  EXPECT_THROW(world.explain_instants("eta1(bus, post, rotating=(0, 0)) >= 10", Point{0, 0}), Error);
  const World still({{"post", Shape::box({9, 3}, {11, 24})}, {"bus", Shape::box({0, 0}, {2, 1})}}, "bus");
  EXPECT_THROW(still.explain_instants("gap(bus, post) <= 3", Point{0, 0}), Error);
}

TEST(PublicExplanation, OfInstantsOfDistancesThatJumpOrAreOfAllTheTime) {
  const World world = passing_bus();
  const Explanation along = world.explain_instants("gap(bus, post, along=(0, 1)) <= 1", Point{0, 0});
  EXPECT_FALSE(along.feasible);
  EXPECT_EQ(along.relax.at(0).to, 2);
  EXPECT_TRUE(along.relax[0].reached);
  EXPECT_EQ(along.relax[0].time, 3.5);
  const Explanation all = world.explain_instants("inf gap(bus, post) <= 1 and gap(bus, post) >= 3", Point{0, 0});
  EXPECT_EQ(all.conflict, (std::vector<std::string>{"inf gap(bus, post) <= 1"}));
  EXPECT_EQ(all.relax.at(0).to, 2);
}

TEST(PublicExplanation, DegreesAndLengthsDoNotMoveTogether) {
  const World world({{"room", Shape::box({-4, -4}, {4, 4})}, {"bar", Shape::box({-3, -1}, {3, 1})}}, "bar");
  const std::string turns = "eta1(bar, room, rotating=(1.5, 0)) >= 100";
  const Explanation both = world.explain_angles(turns + " and gap(bar, room) <= -2", Point{1.5, 0});
  EXPECT_FALSE(both.feasible);
  EXPECT_FALSE(both.together.has_value());
  const Explanation alone = world.explain_angles(turns, Point{1.5, 0});
  ASSERT_TRUE(alone.together.has_value());
  EXPECT_NE(alone.text.find("°"), std::string::npos);
  EXPECT_THROW(world.explain_angles(turns, Point{0, 0}), Error);  // about another point than the shape turns about
}

}  // namespace io_public_scenes
