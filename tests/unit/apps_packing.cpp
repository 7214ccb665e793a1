// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing as users of the program meet it: drawings on the command line, how many of each, and what is refused.
#include <map>

#include "apps_program.h"

namespace apps_program {

TEST_F(Program, PacksDrawingsWithCounts) {
  std::ofstream(folder_ / "lid.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg"><circle cx="4" cy="4" r="2"/></svg>)";
  std::ofstream(folder_ / "plate.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H8V8H0Z M2 4A2 2 0 0 0 6 4A2 2 0 0 0 2 4Z"/></svg>)";
  const std::string drawings = "plate.svg lid.svg x5 ";
  const Result strip = run("pack " + drawings + "--height 8 --work 2 --threads 1 -o layout.json -o cut.dxf");
  EXPECT_EQ(strip.status, 0) << strip.err;
  EXPECT_TRUE(contains(strip.out, "length 16, ")) << strip.out;  // a lid in the plate, four beside it
  EXPECT_TRUE(contains(strip.err, "states no unit: read as mm")) << strip.err;
  EXPECT_EQ(run("verify layout.json " + drawings + "--height 8").status, 0);
  EXPECT_EQ(run("verify layout.json " + drawings + "--height 7").status, 1);
  // Arcs stay arcs. A drawing whose rings touch could not be read back.
  EXPECT_TRUE(contains(read("cut.dxf"), "\n 42\n"));
  run("pack plate.svg lid.svg --gap 0.5 --height 8 --work 2 --threads 1 -o cut.dxf");
  const Result back = run("convert cut.dxf --layer cut -o back.svg");
  EXPECT_EQ(back.status, 0) << back.err;
  EXPECT_TRUE(contains(read("back.svg"), "A 2 2") || contains(read("back.svg"), "A2 2")) << read("back.svg");
  const Result sheets = run("pack " + drawings + "--sheet 16,8 --work 2 --threads 1 --json");
  EXPECT_EQ(json::parse(sheets.out)["layout"]["container"]["sheets"].size(), 1u);
  EXPECT_EQ(run("pack " + drawings).status, 2);  // neither a strip nor sheets
  EXPECT_EQ(run("pack x5 lid.svg --height 8").status, 2);
  EXPECT_EQ(run("pack lid.svg 5 --height 8").status, 2);  // a count is x5
  EXPECT_EQ(run("pack lid.svg x5 x6 --height 8").status, 2);
  EXPECT_EQ(run("pack scene.json --angles 0,90").status, 2);  // a problem says them itself
}

/// A drawing that is named twice is one part; an element within another is a hole.
/// As browsers call what is fetched again.
TEST_F(Program, FaultsOfADrawingWithBracketsInItsName) {
  std::ofstream(folder_ / "lid (1).svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg"><polygon points="0,0 9,9 9,0 0,9"/></svg>)";
  const Result r = run("pack 'lid (1).svg' --height 20");
  EXPECT_EQ(r.status, 3);
  EXPECT_TRUE(contains(r.err, "item 'lid (1)': ") && contains(r.err, "touches or crosses itself")) << r.err;
}

TEST_F(Program, PacksOneDrawingNamedTwice) {
  std::ofstream(folder_ / "a.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"><rect width="8" height="4"/>)"
                                      R"(<rect x="2" y="1" width="4" height="2"/></svg>)";
  const std::string drawings = "a.svg x2 ./a.svg ";
  const Result strip = run("pack " + drawings + "--height 4 --work 1 --threads 1 -o layout.json");
  EXPECT_TRUE(contains(strip.out, "length 24, density 75.0000 %, 3 parts")) << strip.out << strip.err;
  EXPECT_EQ(run("verify layout.json " + drawings + "--height 4").status, 0);
  EXPECT_EQ(run("verify layout.json a.svg x3 --height 4").status, 0);
}

/// The time limit ends the process wherever it is: the best layout is the answer.
TEST_F(Program, PackAnswersWhenItsTimeIsOver) {
  std::ofstream(folder_ / "a.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"><circle r="4"/></svg>)";
  const std::string command =
      "cd '" + folder_.string() +
      "' || exit 1; '" FINDSPACE_PROGRAM
      "' pack a.svg x9 --height 20 --threads 1 --time-limit 300 -o layout.json > out.txt 2> err.txt & search=$!; "
      "for k in $(seq 100); do test -s layout.json && break; sleep 0.1; done; sleep 0.5; kill -ALRM $search; wait "
      "$search";
  EXPECT_EQ(std::system(command.c_str()), 0) << read("err.txt");
  EXPECT_TRUE(contains(read("out.txt"), "9 parts, proved free of overlaps")) << read("out.txt") << read("err.txt");
}

/// How many copies of each part the layout has.
std::map<std::string, int> copies(const json& layout) {
  std::map<std::string, int> result;
  for (const json& item : layout["layout"]["items"]) ++result[item["part"]];
  return result;
}

TEST_F(Program, PacksAsManyAsNamesSay) {
  using Copies = std::map<std::string, int>;
  std::ofstream(folder_ / "kit.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="i" width="9cm" height="9cm" viewBox="0 0 90 90">)"
         R"(<g id="bracket_x4"><path d="M0 0H8V6H0Z"/><circle cx="4" cy="3" r="2"/></g>)"
         R"(<g inkscape:label="lid x2" id="g7"><path d="M10 0H14V4H10Z"/></g><path id="foot" d="M20 0H22V2H20Z"/>)"
         R"(<path d="M30 0H31V1H30Z"/></svg>)";
  std::ofstream(folder_ / "kit.geojson")
      << R"({"type": "Feature", "id": "rail-x3", "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [5, 0], [5, 1],
             [0, 1], [0, 0]]]}})";
  const auto packed = [&](const std::string& words) {
    const Result result = run("pack " + words + " --sheet 20,10 --work 1 --threads 1 -o layout.json");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(run("verify layout.json " + words + " --sheet 20,10").status, 0);
    return copies(json::parse(read("layout.json")));
  };
  EXPECT_EQ(packed("kit.svg"), (Copies{{"bracket", 4}, {"lid", 2}, {"foot", 1}, {"kit", 1}}));
  EXPECT_EQ(packed("kit.svg x2 kit.geojson"),
            (Copies{{"bracket", 8}, {"lid", 4}, {"foot", 2}, {"kit.svg", 2}, {"rail", 3}}));
  EXPECT_EQ(run("pack kit.svg --parts one --height 10 --work 1 -o layout.json").status, 0);
  EXPECT_EQ(copies(json::parse(read("layout.json"))), (Copies{{"kit", 1}}));
}

TEST_F(Program, PacksTheOutlinesOfADrawingApart) {
  std::ofstream(folder_ / "two.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H8V6H0Z"/>)"
                                        R"(<path d="M2 2H4V4H2Z"/><circle cx="20" cy="3" r="2"/></svg>)";
  const auto packed = [&](const std::string& words) {
    EXPECT_EQ(run("pack " + words + " --height 10 --work 1 -o layout.json").status, 0) << words;
    return copies(json::parse(read("layout.json")));
  };
  using Copies = std::map<std::string, int>;
  EXPECT_EQ(packed("two.svg x3"), (Copies{{"two 1", 3}, {"two 2", 3}}));
  EXPECT_EQ(packed("two.svg x3 --parts one"), (Copies{{"two", 3}}));
  std::ofstream(folder_ / "one.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg"><path id="p7" d="M0 0H8V6H0Z"/></svg>)";
  EXPECT_EQ(packed("one.svg"), (Copies{{"one", 1}}));
  std::ofstream(folder_ / "two.json") << R"({"name": "two", "strip_height": 10, "items": [{"id": "both", "demand": 1,
      "allowed_orientations": [0], "shape": {"file": "two.svg"}}]})";
  const Result rigid = run("pack two.json --work 1 -o layout.json");
  EXPECT_TRUE(contains(rigid.err, "its 2 outlines side by side are one part")) << rigid.err;
  EXPECT_EQ(copies(json::parse(read("layout.json"))), (Copies{{"both", 1}}));
  EXPECT_EQ(run("pack two.svg --parts each --height 10").status, 2);
  std::ofstream(folder_ / "bolts.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg"><circle cx="2" cy="2" r="2"/><circle cx="9" cy="2" r="2"/>)"
         R"(<circle cx="9" cy="9" r="3"/><path d="M20 0H23V2H20Z"/><path d="M33 2H30V0H33Z"/><path d="M40 0H42V3H40Z"/>)"
         R"(<path id="lid x2" d="M50 0H53V2H50Z"/></svg>)";
  EXPECT_EQ(packed("bolts.svg x2"),
            (Copies{{"bolts 1", 4}, {"bolts 2", 2}, {"bolts 3", 4}, {"bolts 4", 2}, {"lid", 4}}));
  EXPECT_EQ(run("verify layout.json bolts.svg x2 --height 10").status, 0);
  std::ofstream(folder_ / "lines.svg")
      << R"(<svg xmlns="http://www.w3.org/2000/svg" fill="none">)"
         R"(<path d="M0 0H8V6H0Z"/><path d="M1 1H7"/><path d="M20 0H28V6H20Z"/></svg>)";
  EXPECT_EQ(packed("lines.svg --open-lines"), (Copies{{"lines 1", 1}, {"lines 2", 1}}));  // the line lies in the first
  std::ofstream(folder_ / "cross.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0H8V6H0Z"/>)"
                                          R"(<path d="M4 3H12V9H4Z"/></svg>)";
  const Result crossing = run("pack cross.svg --height 10 --work 1");
  EXPECT_EQ(crossing.status, 3);
  EXPECT_TRUE(contains(crossing.err, "touches or crosses")) << crossing.err;
}

TEST_F(Program, RefusesDrawingsOfSparrowThatAreBroken) {
  const auto said = [&](const std::string& use) {
    std::ofstream(folder_ / "layout.svg") << R"(<svg><g id="bin_0"><path d="M0,0 L4,0 L4,4 L0,4 z"/></g><g id="items">)"
                                             R"(<defs><g id="item_0"><path d="M0,0 L2,0 L2,3 z"/></g></defs><use )"
                                          << use << "/></g></svg>";
    const Result result = run("verify layout.svg");
    EXPECT_LE(result.status, 4) << use;
    return result.status == 0 ? result.out : result.err;
  };
  EXPECT_TRUE(contains(said(R"x(transform="translate(0,0), rotate(=)" href="#item_0")x"), "not one angle"));
  EXPECT_TRUE(contains(said(R"x(transform="translate(0,0), rotate(1, 2)" href="#item_0")x"), "not one angle"));
  EXPECT_FALSE(contains(said(R"x(transform="translate(0,0), rotate(0)" href="")x"), "substr"));
  EXPECT_TRUE(contains(said(R"x(transform="translate(0,0), rotate(0)" href="#item_0")x"), "feasible"));
  EXPECT_EQ(run("verify layout.svg --gap 2").status, 2);
  const auto* kit = R"({"strip_height":4,"items":[{"id":"0","demand":1,"shape":{"box":{"min":[0,0],"max":[2,3]}}}]})";
  EXPECT_EQ(run("verify layout.svg scene.json --height 3", kit).status, 0);
  EXPECT_EQ(run("verify layout.svg scene.json --edge 1", kit).status, 1);
}

TEST_F(Program, SaysWhatIsWrongWithPackedDrawings) {
  std::ofstream(folder_ / "a.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"><circle r="4"/></svg>)";
  const auto expect_usage = [&](const std::string& words, const std::string& said) {
    const Result result = run("pack " + words);
    EXPECT_EQ(result.status, 2) << words;
    EXPECT_TRUE(contains(result.err, said)) << words << ": " << result.err;
  };
  expect_usage("a.svg --height 9 --angles foo", "--angles: angles in degrees are meant");
  expect_usage("a.svg --height 9 --angles 0,,90", "--angles: angles in degrees are meant");
  for (const char* tilt : {"181", "-1", "3deg"})
    expect_usage(std::string("a.svg --height 9 --tilt=") + tilt, "--tilt: a tilt is from 0 to 180 degrees");
  for (const char* seed : {"-1", "1.5", "99999999999999999999"})
    expect_usage(std::string("a.svg --height 9 --seed=") + seed, "--seed: a whole number from 0 on is meant");
  for (const char* size : {"100,100,100", "60mm,60mm", "0,0", "100", ","})
    expect_usage(std::string("a.svg --sheet ") + size, "--sheet: a width and a height above 0 are meant");
  expect_usage("a.svg --height 9 --unit furlong", "--unit: unknown unit 'furlong'");
  expect_usage("a.svg --height 9 --gap 2mm", "--gap: a number from 0 on is meant");
  expect_usage("a.svg --height 60mm", "--height: a number from 0 on is meant");
  expect_usage("a.svg x1234567 --height 9", "from 0 to 1000000");
  std::ofstream(folder_ / "many.geojson") << R"({"type": "Feature", "id": "m x900000", "geometry": {"type": "Polygon",
      "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}})";
  EXPECT_TRUE(contains(run("pack many.geojson x2 --height 9").err, "its counts together are above 1000000"));
  expect_usage("a.svg x900000 a.svg x900000 --height 9", "together are above 1000000");
  for (const char* other : {"kit.json x2", "bracket.step x2", "bracket.step", "c.pdf x2"})
    expect_usage(std::string(other) + " --height 9", "(.svg .dxf .wkt .geojson)");
  expect_usage("a.svg --height 9 -o foo.pdf", "one of .json .svg .dxf ");  // and of solids: nothing is read yet
  expect_usage("a.svg --height 9 -o foo.obj", "one of .json .svg .dxf\n");
  expect_usage("$(printf '\\377').svg --height 9", "not UTF-8");
}

}  // namespace apps_program
