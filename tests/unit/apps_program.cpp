// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The program as users meet it: exit status, what goes to which stream, and files written whole or not at all.
#include "apps_program.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>

namespace apps_program {

TEST_F(Program, HelpAndVersion) {
  Result help = run("--help");
  EXPECT_EQ(help.status, 0);
  EXPECT_TRUE(contains(help.out, "Examples:"));
  EXPECT_TRUE(contains(run("--version").out, "findspace 0."));
  EXPECT_EQ(run("map --help").status, 0);
}

TEST_F(Program, ExplainsSomeAngles) {
  const auto scene = [](const char* free) {
    return std::string(R"({"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0], "max": [3, 5]}},)"
                       R"("bar": {"box": {"min": [-2, -1], "max": [2, 1]}}}, "moving": "bar", "free": )") +
           free + R"x(, "where": "inside(bar, room)"})x";
  };
  const std::string some = scene(R"({"pose": {"angles": [0, 90]}})");
  const Result found = run("explain scene.json", some);
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_TRUE(contains(found.out, "slack 0.5, to 0.5; the last position is (1.5, 2.5) at 90°")) << found.out;
  EXPECT_EQ(json::parse(run("explain scene.json --json", some).out)["slack"][0]["angle"], 90);
  EXPECT_EQ(run("explain scene.json", scene(R"({"pose": {"angles": [0, 180]}})")).status, 1);
  EXPECT_TRUE(contains(run("explain scene.json --at 1,1", some).err, "--angle says which"));
  EXPECT_EQ(run("explain scene.json --angle 0", some).status, 1);
  EXPECT_TRUE(contains(run("explain scene.json --at 1.5,2.5 --angle 90", some).out, "(1.5, 2.5) is feasible"));
  const json there = json::parse(run("explain scene.json --at 1,1 --angle 90 --json", some).out);
  EXPECT_EQ(there["change"][0], "inside(bar, room)");
  const std::string all = scene(R"("angle")");
  EXPECT_TRUE(contains(run("explain scene.json --at 1.5,2.5", all).out, "slack 0.5, to 0.5; the last angle is 90°"));
  const Result none = run("explain scene.json", all);
  EXPECT_EQ(none.status, 1);
  EXPECT_TRUE(contains(none.out, "no angle is feasible")) << none.out << none.err;
}

TEST_F(Program, ExplainsOrientations) {
  const std::string shapes = R"x({"findspace": 1, "shapes": {"room": {"box": {"min": [0, 0, 0], "max": [3, 5, 2]}},
      "bar": {"box": {"min": [-2, -1, -1], "max": [2, 1, 1]}}}, "moving": "bar", "where": "inside(bar, room)")x";
  EXPECT_EQ(run("explain scene.json", shapes + "}").status, 1);
  const Result upright = run("explain scene.json --orientation z:90 --json", shapes + "}");
  EXPECT_EQ(upright.status, 0) << upright.err;
  EXPECT_EQ(json::parse(upright.out)["slack"][0]["to"], 0);
  const Result both = run("explain scene.json --json", shapes + R"(, "free": {"pose": {"angles": [0, 90]}}})");
  EXPECT_EQ(both.status, 0) << both.err;
  const json answers = json::parse(both.out)["orientations"];
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0]["answer"]["feasible"], false);
  EXPECT_EQ(answers[1]["answer"]["feasible"], true);
  EXPECT_EQ(run("explain scene.json --orientation z:90").status, 2);  // in the plane
}

/// The longest line, in letters.
std::size_t columns(const std::string& text) {
  std::size_t most = 0, column = 0;
  for (const char c : text) {
    column = c == '\n' ? 0 : column + ((c & 0xc0) != 0x80 ? 1 : 0);
    most = std::max(most, column);
  }
  return most;
}

TEST_F(Program, HelpOfVerbsIsGroupedAndFitsTheTerminal) {
  for (const std::string verb : {"map", "check", "measure", "describe", "convert", "place", "phi", "help"}) {
    const Result help = run(verb + " --help");
    EXPECT_EQ(help.status, 0) << verb;
    EXPECT_EQ(help.out.find("Answers "), 0u) << verb;
    EXPECT_TRUE(contains(help.out, "\nCommon:\n")) << verb;
    EXPECT_LE(columns(help.out), 100u) << verb;
    EXPECT_EQ(run("help " + verb).status, verb == "help" ? 2 : 0) << verb;
  }
  const std::string map = run("map --help").out;
  EXPECT_LT(map.find("\nCommon:\n"), map.find("\nIn the plane:\n"));
  EXPECT_LT(map.find("\nIn the plane:\n"), map.find("\nIn space:\n"));
  EXPECT_TRUE(contains(map, "default 0"));
}

TEST_F(Program, HelpHasPages) {
  const Result topics = run("help");
  EXPECT_EQ(topics.status, 0);
  for (const std::string topic : {"formula", "scene", "support", "debugging"}) {
    EXPECT_TRUE(contains(topics.out, "  " + topic + " ")) << topic;
    const Result page = run("help " + topic);
    EXPECT_EQ(page.status, 0) << topic;
    EXPECT_LE(columns(page.out), 100u) << topic;
  }
  const std::string formula = run("help formula").out;
  for (const char* line : {"gap gamma1 γ₁ ", "minus eta1", "gap(B, A) >= c; c is 0", "um, mm, cm, m, in or mil"})
    EXPECT_TRUE(contains(formula, line)) << line;
  const Result unknown = run("help formla");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown.err, "did you mean 'formula'?")) << unknown.err;
  EXPECT_EQ(run("help scene --markdown").status, 2);
  EXPECT_TRUE(contains(run("help support --markdown").out, "# The support table"));
}

TEST_F(Program, PicturesNameAllMembersOfAList) {
  const std::string scene = R"json({"findspace": 1, "shapes": {"post": {"box": {"min": [5, 0], "max": [6, 1]}},
    "posts": ["post", {"translate": [4, 0], "of": "post"}, {"translate": [8, 0], "of": "post"}],
    "B": {"box": {"min": [-1, -1], "max": [1, 1]}}}, "moving": "B", "where": "gap(B, posts) >= 1"})json";
  EXPECT_EQ(run("map scene.json -o x.svg", scene).status, 0);
  const std::string picture = read("x.svg");
  EXPECT_TRUE(contains(picture, ">post<"));
  EXPECT_TRUE(contains(picture, ">posts<"));
  EXPECT_EQ(picture.find(">posts<"), picture.rfind(">posts<"));
}

TEST_F(Program, PicturesOfAPositionHaveItsDistances) {
  EXPECT_EQ(run("check scene.json --at 12,3 -o c.svg").status, 1);
  const std::string apart = read("c.svg");
  EXPECT_TRUE(contains(apart, "class=\"dimension fails\""));
  EXPECT_TRUE(contains(apart, "nearest feasible position, 3 away"));
  EXPECT_EQ(run("check scene.json --at 12,3 --angle 90 -o c.svg").status, 1);
  EXPECT_TRUE(contains(read("c.svg"), "class=\"dimension fails\""));
  EXPECT_EQ(run("check scene.json --at 5,3 -o c.svg").status, 0);
  EXPECT_FALSE(contains(read("c.svg"), "class=\"dimension fails\""));
  EXPECT_EQ(run("measure scene.json --at 14,3 -o m.svg").status, 0);
  EXPECT_TRUE(contains(read("m.svg"), "class=\"dimension\""));
}

TEST_F(Program, DistancesInRotationAreInDegrees) {
  const std::string scene = scene_where("gamma1(B, A, turning=(0, 0)) >= 0");
  const Result at =
      run("check scene.json --at 0,12 --quiet", scene);  // the nearest corner meets the side at 90 degrees
  EXPECT_TRUE(contains(at.out, "°")) << at.out;
  EXPECT_FALSE(contains(at.out, " mm")) << at.out;
}

/// As in all other directions: how much is missing.
TEST_F(Program, DistancesInRotationSayWhatTheyLack) {
  const std::string scene = R"json({"findspace": 1, "unit": "mm", "shapes": {
    "A": {"disc": {"center": [10, 0], "radius": 1}}, "B": {"disc": {"center": [0, 0], "radius": 1}}}, "moving": "B",
    "free": "angle", "where": "gap(B, A, rotating=(0, 0)) >= 40 and gap(B, A) >= 4"})json";
  const json atoms = json::parse(run("check scene.json --at 9,5 --angle 10 --json", scene).out)["atoms"];
  for (const auto& [atom, level] : {std::pair(atoms[0], 40), std::pair(atoms[1], 4)})
    EXPECT_NEAR(atom["lacks"].get<double>(), level - atom["value"].get<double>(), 1e-9) << atom;
  EXPECT_TRUE(contains(run("check scene.json --at 9,5 --angle 10", scene).out, ", off by 22.1325°"));
}

/// No upper bound is known of the farthest fit while a shape turns.
TEST_F(Program, SaysWhereOneEndOfAValueIsKnown) {
  const std::string scene = R"json({"findspace": 1, "unit": "mm", "shapes": {
    "A": {"box": {"min": [0, 0], "max": [10, 10]}}, "B": {"box": {"min": [-1, -1], "max": [1, 1]}}}, "moving": "B",
    "motion": {"time": [0, 1], "B": {"path": [[0, 0], [1, 0]], "angles": [0, 30]}},
    "where": "sup eta2(B, A) <= 1"})json";
  EXPECT_TRUE(
      contains(run("check scene.json --at 5,5", scene).out, "  at least 5.88893 mm, off by at least 4.88893 mm"));
  EXPECT_TRUE(contains(run("measure scene.json --at 5,5 --all", scene).out, "at most -5.65685 mm"));
}

TEST_F(Program, WrongUsage) {
  for (const char* arguments :
       {"", "mpa scene.json", "map", "map scene.json --aply closure", "map scene.json --apply close",
        "map scene.json -o x.png", "check scene.json", "check scene.json --at 1", "check scene.json --at 1,b",
        "check scene.json --at 1e30,0", "describe scene.json", "map scene.json --threads x",
        "convert scene.json A --layer cut", "convert scene.json A --constructive -o x.svg"}) {
    Result r = run(arguments);
    EXPECT_EQ(r.status, 2) << arguments;
    EXPECT_TRUE(contains(r.err, "findspace:")) << arguments;
    EXPECT_EQ(r.out, "") << arguments;
  }
  EXPECT_TRUE(contains(run("mpa scene.json").err, "did you mean 'map'?"));
}

TEST_F(Program, WitnessPointsStandInTheOrderOfTheArguments) {
  const std::string scene = R"json({"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}},
    "B": {"box": {"min": [0, 0, 0], "max": [2, 1, 1]}}}, "moving": "B", "where": "true"})json";
  const json found = json::parse(run("measure scene.json --at 3,0,0 --json", scene).out).at("witnesses");
  EXPECT_EQ(found.at("mu(B, A)").at("points")[0][0], 5);  // of B, the farthest from A
  EXPECT_EQ(found.at("mu(B, A)").at("points")[1][0], 1);
  EXPECT_EQ(found.at("mu(A, B)").at("points")[0][0], 0);  // of A
  EXPECT_EQ(found.at("mu(A, B)").at("points")[1][0], 3);
}

TEST_F(Program, CheckInSpaceSaysWhatLacksAndWhereItWouldHold) {
  const auto check = [&](const std::string& container, const std::string& arguments) {
    const std::string scene = R"json({"findspace": 1, "shapes": {"A": )json" + container +
                              R"json(, "B": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}},
      "moving": "B", "where": "eta1(B, A) < 0"})json";
    return json::parse(run("check scene.json --json --at " + arguments, scene).out);
  };
  const json box = check(R"({"box": {"min": [0, 0, 0], "max": [4, 4, 4]}})", "5,1,1");
  EXPECT_EQ(box.at("atoms")[0].at("lacks"), 2);
  EXPECT_EQ(box.at("nearest_feasible"), json::parse(R"({"at": [3, 1, 1], "distance": 2, "attained": false})"));
  const json corner = check(R"({"polytope": [[0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6]]})", "2,2,2");
  EXPECT_EQ(corner.at("nearest_feasible").at("at"), json::parse("[1, 1, 1]"));
  const json none = check(R"({"box": {"min": [0, 0, 0], "max": [1, 1, 1]}})", "0,0,0");
  EXPECT_TRUE(none.at("nearest_feasible").is_null());
  EXPECT_FALSE(none.contains("not_computed"));
}

// The set of positions nearer than the level is a polytope grown by a ball: the way out of the polytope goes on.
TEST_F(Program, CheckInSpaceKnowsTheNearestWithAGap) {
  const auto nearest = [&](const std::string& b, const std::string& where) {
    const std::string scene =
        R"json({"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [17, 17, 17]}}, "B": )json" + b +
        R"json(}, "moving": "B", "where": ")json" + where + "\"}";
    return json::parse(run("check scene.json --json --at 1,2,3", scene).out).at("nearest_feasible");
  };
  const json expected = json::parse(R"({"at": [-3, 2, 3], "distance": 4, "attained": true})");
  EXPECT_EQ(nearest(R"({"box": {"min": [-2, -2, -2], "max": [2, 2, 2]}})", "gap(B, A) >= 1"), expected);
  EXPECT_EQ(nearest(R"({"ball": {"center": [0, 0, 0], "radius": 2}})", "gap(B, A) >= 1"), expected);
  EXPECT_EQ(nearest(R"({"ball": {"center": [0, 0, 0], "radius": 2}})", "gap(B, A) > 1").at("attained"), false);
  EXPECT_EQ(nearest(R"({"ball": {"center": [0, 0, 0], "radius": 2}})", "distance(B, A) >= 1"), expected);
  EXPECT_EQ(nearest(R"({"box": {"min": [-2, -2, -2], "max": [2, 2, 2]}})", "depth(B, A) <= 1"),
            json::parse(R"({"at": [-1, 2, 3], "distance": 2, "attained": true})"));
}

TEST_F(Program, CheckInSpaceTellsNoneFromNotComputed) {
  const std::string scene = R"json({"findspace": 1, "shapes": {"A": {"ball": {"center": [0, 0, 0], "radius": 3}},
    "B": {"ball": {"center": [0, 0, 0], "radius": 1}}}, "moving": "B", "where": "gap(B, A) >= 1 or gap(B, A) = 0.5"})json";
  const json round = json::parse(run("check scene.json --at 2,0,0 --json", scene).out);
  EXPECT_FALSE(round.contains("nearest_feasible"));
  EXPECT_FALSE(round.at("not_computed").at("nearest_feasible").get<std::string>().empty());
  EXPECT_TRUE(contains(run("check scene.json --at 2,0,0", scene).out, "nearest feasible position: not computed"));
  const std::string empty = R"json({"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}},
    "B": {"box": {"min": [0, 0, 0], "max": [2, 2, 2]}}}, "moving": "B", "where": "inside(B, A)"})json";
  EXPECT_TRUE(contains(run("check scene.json --at 2,0,0", empty).out, "no position is feasible"));
}

TEST_F(Program, MeasureTellsUndefinedFromNotComputed) {
  // A large lens does not fit into a ball. Of two shapes that round ones are cut out of ends are known.
  const std::string lens =
      R"json({"intersection": [{"ball": {"center": [0, 0, 0], "radius": 9}}, {"ball": {"center": [2, 0, 0], "radius": 9}}]})json";
  const auto measure = [&](const std::string& a) {
    const std::string scene = R"json({"findspace": 1, "moving": "B", "where": "true", "shapes": {"A": )json" + a;
    return json::parse(
        run("measure scene.json --at 1,0,0 --only margin --json", scene + ", \"B\": " + lens + "}}").out);
  };
  const json ball = measure(R"json({"ball": {"center": [0, 0, 0], "radius": 3}})json"), two = measure(lens);
  EXPECT_TRUE(ball.at("distances").at("eta1(B, A)").is_null() && two.at("distances").at("eta1(B, A)").is_number());
  EXPECT_EQ(ball.at("distances").at("margin(B, A)"), "-inf");
  EXPECT_FALSE(ball.contains("not_computed") && ball.at("not_computed").contains("eta1(B, A)"));
  EXPECT_FALSE(two.contains("not_computed")) << two;
}

TEST_F(Program, BadInputHasAPlaceAndWritesNothing) {
  Result r = run("map scene.json -o x.svg", "{\"findspace\": 1,\n  \"shapes\": {},}");
  EXPECT_EQ(r.status, 3);
  EXPECT_TRUE(contains(r.err, "scene.json:2:"));
  EXPECT_FALSE(exists("x.svg"));
  EXPECT_EQ(run("map nowhere.json").status, 3);
  Result formula = run("map scene.json", scene_where("insde(B, A)"));
  EXPECT_EQ(formula.status, 3);
  EXPECT_TRUE(contains(formula.err, "scene.json:3:"));
  EXPECT_TRUE(contains(formula.err, "inside"));
  EXPECT_EQ(run("describe scene.json C").status, 3);
}

TEST_F(Program, MapAsTextJsonAndFiles) {
  Result text = run("map scene.json");
  EXPECT_EQ(text.status, 0);
  EXPECT_TRUE(contains(text.out, "area    32 mm²"));
  EXPECT_EQ(text.err, "");
  Result r = run("map scene.json --json -o x.svg -o x.wkt -o x.json");
  EXPECT_EQ(json::parse(r.out)["area"], 32);
  EXPECT_EQ(read("x.json"), r.out);
  EXPECT_TRUE(contains(read("x.svg"), "</svg>"));
  EXPECT_EQ(read("x.wkt"), "POLYGON ((1 1, 9 1, 9 5, 1 5, 1 1))\n");
}

TEST_F(Program, EmptyIsOne) {
  Result r = run("map scene.json --json", scene_where("inside(B, A, 5mm)"));
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(json::parse(r.out)["empty"], true);
}

TEST_F(Program, FilesAreAllOrNone) {
  // WKT cannot hold the unbounded region: the picture is not written either.
  Result r = run("map scene.json -o x.svg -o x.wkt", scene_where("not inside(B, A)"));
  EXPECT_EQ(r.status, 3);
  EXPECT_FALSE(exists("x.svg") || exists("x.wkt"));
}

TEST_F(Program, Apply) {
  EXPECT_EQ(json::parse(run("map scene.json --json --apply boundary").out)["dangling_length"], 24);
  EXPECT_EQ(json::parse(run("map scene.json --json --apply complement").out)["bounded"], false);
  EXPECT_EQ(json::parse(run("map scene.json --json --apply interior").out)["open"], true);
}

TEST_F(Program, Check) {
  Result yes = run("check scene.json --at 1,1 --json"), no = run("check scene.json --at 0.9999999999,1 --json");
  EXPECT_EQ(yes.status, 0);
  EXPECT_EQ(json::parse(yes.out)["true"], true);
  EXPECT_EQ(json::parse(yes.out)["distances"]["eta1(B, A)"], 0);
  EXPECT_EQ(no.status, 1);
  EXPECT_EQ(json::parse(no.out)["true"], false);
  EXPECT_TRUE(contains(run("check scene.json --at -3,4").out, "is not feasible"));
}

TEST_F(Program, CheckExplainsItself) {
  const std::string scene = scene_where("gap(B, A) >= 1 and inside(B, A)");
  const json with = json::parse(run("check scene.json --at 20,3 --json --explain", scene).out);
  // Far from its level the value decides; on it the map does.
  EXPECT_EQ(with["atoms"][0]["way"], "features");
  EXPECT_GT(with["atoms"][0]["milliseconds"], 0);
  EXPECT_EQ(json::parse(run("check scene.json --at 1,3 --json --explain", scene).out)["atoms"][1]["way"], "map");
  const json without = json::parse(run("check scene.json --at 20,3 --json", scene).out);
  EXPECT_FALSE(without["atoms"][0].contains("way") || without["atoms"][0].contains("milliseconds"));
  EXPECT_TRUE(contains(run("check scene.json --at 20,3 --explain", scene).out, ", by features in "));
  EXPECT_FALSE(contains(run("check scene.json --at 20,3", scene).out, " ms"));
  EXPECT_EQ(run("measure scene.json --at 20,3 --explain").status, 2);

  const std::string solids = R"json({"findspace": 1, "shapes": {
    "A": {"box": {"min": [0, 0, 0], "max": [4, 4, 4]}}, "ball": {"ball": {"center": [0, 0, 0], "radius": 1}}},
    "moving": "ball", "where": "gap(ball, A) >= 1"})json";
  EXPECT_EQ(json::parse(run("check scene.json --at 9,2,2 --json --explain", solids).out)["atoms"][0]["way"], "parts");
  EXPECT_TRUE(contains(run("check scene.json --at 9,2,2 --explain", solids).out, ", by parts in "));
}

TEST_F(Program, Measure) {
  json r = json::parse(run("measure scene.json --at 5,3 --json").out);
  EXPECT_EQ(r["at"], json::parse("[5, 3]"));
  EXPECT_EQ(r["distances"]["eta1(B, A)"], -2);
}

TEST_F(Program, DescribeAndConvert) {
  EXPECT_EQ(json::parse(run("describe scene.json A --json").out)["area"], 60);
  EXPECT_EQ(run("convert scene.json A").out, "POLYGON ((0 0, 10 0, 10 6, 0 6, 0 0))\n");
  EXPECT_EQ(run("convert scene.json A -o a.svg -q").status, 0);
  EXPECT_EQ(run("convert a.svg").out, "POLYGON ((0 0, 10 0, 10 6, 0 6, 0 0))\n");
}

TEST_F(Program, DrawingsReadBack) {
  const std::string
      flat = R"({"polyline": [[0, 1], [5, 1]]})",
      circle = R"({"boundary": {"disc": {"center": [0, 0], "radius": 2}}})",
      touching = R"({"union": [{"box": {"min": [0, 0], "max": [1, 1]}}, {"box": {"min": [1, 1], "max": [2, 2]}}]})";
  for (const std::string& shape : {flat, circle, touching}) {
    const std::string scene = R"({"findspace": 1, "unit": "mm", "shapes": {"S": )" + shape + "}}";
    ASSERT_EQ(run("convert scene.json -o s.svg", scene).status, 0);
    const json stated = json::parse(run("describe scene.json --json", scene).out);
    const json drawn =
        json::parse(run("describe scene.json --json",
                        R"({"findspace": 1, "unit": "mm", "open_lines": true, "shapes": {"S": {"file": "s.svg"}}})")
                        .out);
    for (const char* key : {"area", "dangling_length", "bbox"}) EXPECT_EQ(drawn[key], stated[key]) << shape;
  }
}

TEST_F(Program, MeshesReadBack) {
  const std::string scene = R"({"findspace": 1, "unit": "mm", "shapes": {
    "tent": {"polytope": [[0, 0, 0.5], [4, 0, 0.5], [4, 4, 0.5], [0, 4, 0.5], [2, 2, 3]]},
    "channel": {"prism": {"polygon": [[0,0],[4,0],[4,4],[3,4],[3,1],[1,1],[1,4],[0,4]], "z": [0.5, 2]}},
    "ball": {"ball": {"center": [0, 0, 0], "radius": 2}}}})";
  for (const std::string shape : {"tent", "channel"}) {
    ASSERT_EQ(run("convert scene.json " + shape + " -o c.obj -o c.stl -o c.3mf", scene).status, 0);
    const json stated = json::parse(run("describe scene.json " + shape + " --json", scene).out);
    for (const std::string file : {"c.obj", "c.stl", "c.3mf"}) {
      const json drawn = json::parse(run("describe scene.json --json", run("convert --unit mm " + file).out).out);
      const double lines = shape == "tent" ? 1e-12 : 0.01;  // what is not convex is described on lines
      EXPECT_NEAR(drawn["volume"], stated["volume"], lines) << file;
    }
  }
  const Result ball = run("convert scene.json ball -o b.obj", scene);
  EXPECT_EQ(ball.status, 3);
  EXPECT_TRUE(contains(ball.err, "flat faces"));
  EXPECT_FALSE(exists("b.obj"));
}

TEST_F(Program, SceneFromStandardInput) { EXPECT_EQ(run("map - < scene.json").out, run("map scene.json").out); }

TEST_F(Program, QuietSaysNothingWhereFilesAreWritten) {
  Result r = run("map scene.json -q -o x.svg");
  EXPECT_EQ(r.out + r.err, "");
  EXPECT_TRUE(exists("x.svg"));
}

TEST_F(Program, ThreadsGiveTheSameBytes) {
  const std::string scene = scene_where("inside(B, A) and gamma1(B, A) <= -1.5 or gap(B, A) = 2");
  EXPECT_EQ(run("map scene.json --json --threads 1", scene).out, run("map scene.json --json --threads 2", scene).out);
}

TEST_F(Program, FullDiskIsNotSilent) {
  Result r = run("map scene.json --json -o /dev/full");
  EXPECT_EQ(r.status, 2);  // no ending
  EXPECT_NE(run("map scene.json --json > /dev/full; exit $? #").status, 0);
}

/// A picture at an instant is that of the shapes where they are then.
TEST_F(Program, PictureAtAnInstant) {
  const std::string rest = R"json(, "moving": "B", "where": "clear(B, A)")json";
  const std::string moving = R"({"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [4, 2]}},
    "B": {"box": {"min": [-1, -1], "max": [1, 1]}}}, "motion": {"time": [0, 2],
    "A": {"path": [[0, 0], [6, 2]], "angles": [0, 180]}, "B": {"path": [[0, 0], [0, 4]]}})";
  const std::string there = R"({"findspace": 1, "shapes": {"A": {"box": {"min": [1, 1], "max": [3, 5]}},
    "B": {"box": {"min": [-1, 1], "max": [1, 3]}}})";  // A rotated by 90 degrees and moved by (3, 1), B by (0, 2)
  run("check scene.json --at 9,1 --time 1 -o moving.svg", moving + rest + "}");
  run("check scene.json --at 9,1 -o there.svg", there + rest + "}");
  std::string at_instant = read("moving.svg"), standing = read("there.svg");
  for (std::size_t at; (at = at_instant.find(", at time 1")) != std::string::npos;) at_instant.erase(at, 11);
  const auto words = [](std::string text) {  // rotating may leave edges in another order, rings another beginning
    for (char& c : text) c = std::string_view("MLZ\"").find(c) != std::string_view::npos ? ' ' : c;
    std::istringstream in(text);
    return std::set<std::string>{std::istream_iterator<std::string>(in), {}};
  };
  EXPECT_TRUE(words(standing).contains("463.456"));                               // a corner of A
  const std::set<std::string> whole = words(standing), same = words(at_instant);  // that has no dimension lines
  EXPECT_TRUE(std::includes(whole.begin(), whole.end(), same.begin(), same.end())) << at_instant << standing;
}

/// A bowl as it is, by a mesh, and not as a block and the ball that is cut out of it.
TEST_F(Program, CutSolidsAreDrawnByTheirSurface) {
  const Result r = run("check scene.json --at 20,20,11 -o bowl.svg", R"json({"findspace": 1, "shapes": {
    "bowl": {"difference": [{"box": {"min": [0, 0, 0], "max": [40, 40, 20]}},
                            {"interior": {"ball": {"center": [20, 20, 22], "radius": 15}}}]},
    "cube": {"box": {"min": [-2, -2, 0], "max": [2, 2, 4]}}}, "moving": "cube", "where": "gap(cube, bowl) >= 1"})json");
  EXPECT_EQ(r.status, 0) << r.err;
  const std::string svg = read("bowl.svg");
  std::size_t faces = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++faces;
  EXPECT_GT(faces, 1000u);  // six of the block
  EXPECT_TRUE(contains(svg, ">cube<"));
}

/// What is placed in space is drawn among what stands, round shapes too, with a line for each.
TEST_F(Program, PlacementInSpaceIsDrawn) {
  const Result r = run("place scene.json --resolution 8 -o placed.svg", R"json({"findspace": 1, "shapes": {
    "bin": {"box": {"min": [0, 0, 0], "max": [4, 4, 2]}}, "ball": {"ball": {"center": [0, 0, 0], "radius": 1}},
    "slab": {"box": {"min": [0, 0, 0], "max": [9, 9, 9]}}},
    "place": {"shapes": ["ball", "slab"], "each": "inside(self, bin)", "minimize": ["x", "y"]}})json");
  EXPECT_LE(r.status, 4) << r.err;
  const std::string svg = read("placed.svg");
  EXPECT_TRUE(contains(svg, ">ball at (1, 1, 1)<")) << svg.substr(0, 600);
  EXPECT_TRUE(contains(svg, ">slab: no free position<"));
  EXPECT_TRUE(contains(svg, "stroke=\"#555\""));  // the bin's edges
}

}  // namespace apps_program
