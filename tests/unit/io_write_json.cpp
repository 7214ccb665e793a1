// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/write/write_json.h"
#include "io/write/write_summary.h"
#include "plane_topology_sets.h"

namespace findspace::io {
namespace io_write_json {

using exact::Real;
using nlohmann::json;
using plane::Region;

const Real kMicro = Real::ratio(1, 1000000);

json of(const Region& s, const Real& step = Real(1), std::string_view unit = "") {
  return json::parse(region_json(s, plane::summarize(s, step), step, unit));
}

TEST(Json, Numbers) {
  EXPECT_EQ(json_number(3), "3");
  EXPECT_EQ(json_number(-0.0), "0");
  EXPECT_EQ(json_number(0.1), "0.1");
  EXPECT_EQ(json_number(-HUGE_VAL), "\"-inf\"");
  EXPECT_EQ(json_number(HUGE_VAL), "null");
  EXPECT_EQ(std::stod(json_number(1.0 / 3)), 1.0 / 3);
  EXPECT_EQ(json::parse(json_number(1e300)), 1e300);
}

TEST(Json, Strings) {
  EXPECT_EQ(json_string("a\"b\\c\n"), "\"a\\\"b\\\\c\\u000a\"");
  EXPECT_EQ(json::parse(json_string("γ1 \x01")), "γ1 \x01");
}

TEST(Json, EmptyAndPlane) {
  json none = of(Region::uniform(0)), all = of(Region::uniform(1));
  EXPECT_EQ(none["empty"], true);
  EXPECT_EQ(none["area"], 0);
  EXPECT_EQ(none["bbox"], nullptr);
  EXPECT_EQ(none["cells"]["faces"], json::parse(R"([{"holes": [], "in": false}])"));
  EXPECT_EQ(all["whole"], true);
  EXPECT_EQ(all["area"], nullptr);
  EXPECT_FALSE(all.contains("unit"));
}

TEST(Json, BoxInMillimetres) {
  json r = of(plane::box(0, 0, 3000000, 1100000), kMicro, "mm");
  EXPECT_EQ(r["unit"], "mm");
  EXPECT_EQ(r["bbox"].dump(), "[[0,0],[3,1.1]]");
  EXPECT_EQ(r["area"], 3.3);
  EXPECT_EQ(r["cells"]["vertices"].size(), 4u);
  EXPECT_EQ(r["cells"]["faces"][1]["outer"].size(), 4u);
  EXPECT_EQ(r["cells"]["faces"][0]["holes"].size(), 1u);
  EXPECT_FALSE(r["cells"]["faces"][0].contains("outer"));
}

TEST(Json, WholeCircleIsOneEdge) {
  json cells = of(plane::disc(10, 20, Real(5)))["cells"];
  EXPECT_EQ(cells["edges"], json::parse(R"([{"from": 0, "to": 0, "in": true,
                                             "arc": {"center": [10, 20], "radius": 5, "ccw": true}}])"));
  EXPECT_EQ(cells["vertices"], json::parse(R"([{"at": [5, 20], "in": true}])"));
  EXPECT_EQ(cells["faces"][1]["outer"], json::parse("[0]"));
}

TEST(Json, ArcOverTheTopIsOneEdge) {
  // Three quarters of a disc: the arc goes from (5, 0) by the top and the left to (0, -5).
  Region s = plane::disc(0, 0, Real(5)) - interior(plane::box(0, -9, 9, 0));
  json cells = of(s)["cells"];
  EXPECT_EQ(cells["edges"].size(), 3u);
  EXPECT_EQ(cells["vertices"].size(), 3u);
  int arcs = 0;
  for (const json& e : cells["edges"]) {
    if (!e.contains("arc")) continue;
    ++arcs;
    EXPECT_EQ(cells["vertices"][int(e["from"])]["at"].dump(), "[5,0]");
    EXPECT_EQ(cells["vertices"][int(e["to"])]["at"].dump(), "[0,-5]");
  }
  EXPECT_EQ(arcs, 1);
}

TEST(Json, PointOnACircleKeepsItsVertex) {
  Region s = plane::disc(0, 0, Real(5)) - plane::point(5, 0);
  json cells = of(s)["cells"];
  EXPECT_EQ(cells["vertices"], json::parse(R"([{"at": [5, 0], "in": false}])"));
  EXPECT_EQ(cells["edges"][0]["from"], 0);
  EXPECT_EQ(cells["edges"][0]["to"], 0);
}

TEST(Json, WhiskerIsTravelledTwiceAndPointsAreListed) {
  Region s = plane::segment({0, 0}, {4, 0}) + plane::point(9, 9);
  json cells = of(s)["cells"];
  EXPECT_EQ(cells["faces"][0]["holes"], json::parse("[[0, 0]]"));
  EXPECT_EQ(cells["faces"][0]["points"].size(), 1u);
}

TEST(Json, Intervals) {
  auto text = [](const Region& s) {
    return json::parse(intervals_json(plane::along_line(s, {0, 2}, {1, 0}), Real(1), ""));
  };
  EXPECT_EQ(text(plane::box(0, 0, 3, 3))["intervals"],
            json::parse(R"([{"from": 0, "to": 3, "from_in": true, "to_in": true}])"));
  EXPECT_EQ(text(Region::uniform(0)), json::parse(R"({"empty": true, "intervals": []})"));
  EXPECT_EQ(text(Region::uniform(1))["intervals"][0]["from"], nullptr);
}

/// Another end may have the value that an open end has: an enclosed one does not tell.
TEST(OptimumText, SaysNotAttainedWhereThatIsKnown) {
  distance::OptimalValue best;
  best.set_exact(Real(3), distance::Way::kAngles);
  EXPECT_NE(optimum_text(best, "").find(", not attained: these are the positions on the closure"), std::string::npos);
  best.set_enclosed(Real(3), Real(2), distance::Way::kAngles);
  EXPECT_NE(optimum_text(best, "").find(", perhaps not attained"), std::string::npos);
  best.attained = true;
  EXPECT_EQ(optimum_text(best, "").find("attained"), std::string::npos);
}

}  // namespace io_write_json
}  // namespace findspace::io
