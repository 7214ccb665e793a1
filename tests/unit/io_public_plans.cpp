// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Placements, motions, poses and maps of space on lines, through the public headers alone.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "findspace/findspace.h"

namespace io_public_plans {

using namespace findspace;
using namespace findspace::words;

constexpr double kPi = std::numbers::pi;

std::map<std::string, Shape> parts() {
  return {{"sheet", Shape::box({0, 0}, {30, 20})},
          {"A1", Shape::box({0, 0}, {8, 8})},
          {"A2", Shape::disc({0, 0}, 4)},
          {"bar", Shape::box({0, 0}, {2, 25})}};
}

Demands bottom_left(std::vector<Body> bodies) {
  return {std::move(bodies), inside("self", "sheet"), clear("self", "other", 1), {}, {"y", "x"}};
}

TEST(PublicPlacement, OneAfterAnother) {
  const Placement found = place(parts(), bottom_left({"A1", "A2"}), {.unit = "mm"});
  ASSERT_EQ(found.placed().size(), 2u);
  EXPECT_TRUE(found.complete());
  EXPECT_EQ(found.unproven(), "");
  EXPECT_EQ(*found.placed()[0].at, (Place{0, 0}));
  EXPECT_EQ(*found.placed()[1].at, (Place{13, 4}));
  EXPECT_EQ(found.placed()[1].exact_at[0].text(), "13");
  ASSERT_EQ(found.positions().size(), 2u);
  EXPECT_EQ(*found.positions()[0].region.area(), 22 * 12);
  EXPECT_NE(found.json().find("\"method\": \"sequential\", \"unit\": \"mm\""), std::string::npos);
  EXPECT_NE(found.svg().find("<svg"), std::string::npos);
}

TEST(PublicPlacement, WhatItSaysIsAValue) {
  const Placement found = place(parts(), bottom_left({"A1", "A2"}), {.unit = "mm"});
  const Placement same(found.told());
  EXPECT_EQ(same.json(), found.json());
  EXPECT_EQ(same.svg(), found.svg());
  EXPECT_EQ(same.complete(), found.complete());
  EXPECT_EQ(same.placed()[1].exact_at[0], found.placed()[1].exact_at[0]);
  EXPECT_EQ(*same.positions()[0].region.area(), 22 * 12);
}

TEST(PublicPlacement, AnglesAndCopies) {
  const Placement found = place(parts(), bottom_left({Body({"bar"}, {0, 90}, 2), Body({"A1"}, {0, 360})}));
  ASSERT_EQ(found.placed().size(), 3u);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(found.placed()[std::size_t(k)].degrees, 90);
    EXPECT_EQ(found.placed()[std::size_t(k)].copy, k + 1);
    EXPECT_EQ(*found.placed()[std::size_t(k)].at, (Place{25, 3.0 * k}));
  }
  EXPECT_EQ(*found.placed()[2].at, (Place{0, 6}));
}

TEST(PublicPlacement, SaysWhatHasNoPosition) {
  const Placement none = place(parts(), bottom_left({"bar", "A1"}));
  EXPECT_FALSE(none.complete());
  EXPECT_FALSE(none.placed()[0].at);
  EXPECT_TRUE(none.placed()[0].attained);
  EXPECT_TRUE(none.placed()[1].at);
  Demands strict = bottom_left({"A1"});
  strict.each = words::margin("self", "sheet") > 1;
  const Placement open = place(parts(), strict);
  EXPECT_FALSE(open.complete());
  EXPECT_FALSE(open.placed()[0].attained);
}

TEST(PublicPlacement, AllAtOnce) {
  Demands demands = bottom_left({"A1", "A2"});
  demands.together = true;
  demands.constraints = {gap("A1", "A2") <= 2};
  const Placement found = place(parts(), demands);
  EXPECT_TRUE(found.complete());
  EXPECT_EQ(*found.placed()[0].at, (Place{0, 0}));
  EXPECT_NE(found.json().find("simultaneous"), std::string::npos);
}

/// One copy of B comes before A and the other one after it.
TEST(PublicPlacement, CopiesOnEitherSideOfAShape) {
  for (const std::string method : {"sequential", "simultaneous"}) {
    const Scene scene = Scene::json(R"json({"findspace": 1, "shapes": {"A": {"box": {"min": [0, 0], "max": [10, 10]}},
      "B": {"box": {"min": [0, 0], "max": [2, 2]}}, "C": {"box": {"min": [0, 0], "max": [40, 40]}}},
      "place": {"shapes": ["A", "B"], "count": {"B": 2}, "each": "inside(self, C)", "pairs": "clear(self, other)",
      "minimize": ["y", "x"], "method": ")json" +
                                    method + R"json("}})json");
    const Placement found = *scene.place({{{"B", 2, {20, 20}, {}}}}).placement();
    ASSERT_TRUE(found.complete()) << method;
    EXPECT_EQ(*found.placed()[0].at, (Place{20, 20})) << method;
    EXPECT_EQ(*found.placed()[1].at, (Place{0, 0})) << method;
    EXPECT_EQ(*found.placed()[2].at, (Place{10, 0})) << method;
  }
}

TEST(PublicPlacement, InSpace) {
  const std::map<std::string, Shape> shapes{{"hold", Shape::box({0, 0, 0}, {10, 10, 10})},
                                            {"crate", Shape::box({0, 0, 0}, {6, 6, 4})}};
  Demands demands{{Body({"crate"}, {0}, 3)}, inside("self", "hold"), clear("self", "other"), {}, {"z", "y", "x"}};
  const Placement found = place(shapes, demands);
  EXPECT_EQ(*found.placed()[1].at, (Place{0, 0, 4}));
  EXPECT_FALSE(found.placed()[2].at);
  EXPECT_NE(found.svg().find("<svg"), std::string::npos);
  EXPECT_NE(found.json().find("\"copy\": 2"), std::string::npos);
}

TEST(PublicPlacement, RegionsInSpaceSayHowTheyAreKnown) {
  const auto placed = [](const std::string& a, const std::string& b, const std::string& each) {
    PlaceQuestion question;
    question.lines = 8;
    const std::string shapes = R"({"findspace": 1, "shapes": {"A": )" + a + R"(, "B": )" + b + "}, ";
    return Scene::json(shapes + R"("place": {"shapes": ["B"], "each": ")" + each + "\"}}").place(question).json();
  };
  const std::string two = R"({"union": [{"polytope": [[0, 0, 0], [9, 0, 0], [0, 9, 0], [0, 0, 9]]},
                                        {"polytope": [[0, 0, 0], [-9, 0, 0], [0, -9, 0], [0, 0, -9]]}]})";
  const std::string cube = R"({"box": {"min": [0, 0, 0], "max": [1, 1, 1]}})";
  const std::string by_search = placed(two, cube, "protrusion(self, A) <= 1");
  EXPECT_NE(by_search.find(R"("on_lines": "outer")"), std::string::npos);
  const std::string prism = R"({"prism": {"polygon": [[0, 0], [7, 1], [2, 6]], "z": [0, 3]}})";
  const std::string fit = placed(prism, prism, "inside(self, A)");
  EXPECT_NE(fit.find(R"("empty": false)"), std::string::npos);  // a point that no line meets
  EXPECT_NE(fit.find(R"("on_lines": "exact")"), std::string::npos);
}

std::string place_of_error(const Demands& demands) {
  try {
    place(parts(), demands);
  } catch (const Error& e) {
    return e.place();
  }
  return "no error";
}

TEST(PublicPlacement, MistakesHaveAPlace) {
  EXPECT_EQ(place_of_error(bottom_left({"A9"})), "body 'A9'");
  EXPECT_EQ(place_of_error(bottom_left({"A1", "A1"})), "body 'A1'");
  EXPECT_EQ(place_of_error(bottom_left({Body({"A1"}, {0}, 0)})), "body 'A1'");
  Demands demands = bottom_left({"A1", "A2"});
  demands.constraints = {"gap(A1, A2) >= 2 mn"};
  EXPECT_EQ(place_of_error(demands).substr(0, 12), "constraint 0");
  demands.constraints = {};
  demands.each = "inside(self, shet)";
  EXPECT_EQ(place_of_error(demands).substr(0, 4), "each");
  EXPECT_THROW(place({}, demands), Error);
  EXPECT_THROW(place(parts(), Demands{{}}), Error);
}

TEST(PublicPlacement, MeetsItsLimits) {
  Options late;
  late.seconds = 1e-9;
  const Placement some = place(parts(), bottom_left({"A1", "A2"}), {}, late);
  EXPECT_FALSE(some.complete());
  EXPECT_NE(some.unproven(), "");
  Options ended;
  ended.cancel.request();
  EXPECT_THROW(place(parts(), bottom_left({"A1", "A2"}), {}, ended), Stopped);
}

/// A post that goes from (-5, 0) to (5, 0) past a disc.
World passing(const Number& turn = 0) {
  const World world({{"cart", Shape::disc({0, 0}, 1)}, {"post", Shape::disc({0, 0}, 1)}}, "cart");
  Motion motion;
  motion.paths["post"] = {{0, {-5, 0}}, {1, {5, 0}, turn}};
  return world.with(motion);
}

TEST(PublicMotion, LeastDistanceOverTime) {
  const World world = passing();
  EXPECT_EQ(*world.distance("inf gap(cart, post)", {0, 3}).value, 1);
  EXPECT_EQ(*world.distance("inf gap(cart, post)", {9, 3}).value, 3);
  EXPECT_EQ(*world.distance("sup gap(cart, post)", {5, 0}).value, 8);
  const Region free = world.solve("inf gap(cart, post) >= 0");
  EXPECT_NEAR(*free.complement().area(), 40 + 4 * kPi, 1e-9);
  EXPECT_EQ(world.solve_bounds("inf gap(cart, post) >= 0").inner, free);
  ASSERT_TRUE(world.motion());
  EXPECT_EQ(world.motion()->paths.at("post").size(), 2u);
}

TEST(PublicMotion, ValuesOfManyPositions) {
  const World world = passing();
  const std::vector<Position> at{{0, 3}, {9, 3}};
  const auto values = [&at](const World& of, const char* distance) {
    std::vector<double> out(at.size());
    of.query(distance).values(at, out);
    return out;
  };
  EXPECT_EQ(values(world, "inf gap(cart, post)"), (std::vector<double>{1, 3}));
  EXPECT_EQ(values(world, "gap(cart, post)"), (std::vector<double>{1, 3}));
  EXPECT_EQ(values(world.at_time("0.9"), "gap(cart, post)")[0], 3);
}

TEST(PublicMotion, InstantsAndOneOfThem) {
  const World world = passing();
  const Instants grazing = world.instants("gap(cart, post) <= 1", {0, 3});
  EXPECT_TRUE(grazing.exact);
  ASSERT_EQ(grazing.certain.size(), 1u);
  EXPECT_EQ(*grazing.certain[0].from, 0.5);
  EXPECT_EQ(*grazing.certain[0].to, 0.5);
  EXPECT_TRUE(world.instants("gap(cart, post) < 1", {0, 3}).certain.empty());
  EXPECT_EQ(*world.at_time("0.9").distance("gap(cart, post)", {4, 3}).value, 1);
  EXPECT_EQ(*world.at_time("0.5").solve("gap(cart, post) <= 0").area(), 4 * kPi);
}

TEST(PublicMotion, MistakesAreRefused) {
  const World world = passing();
  EXPECT_THROW(world.angles("gap(cart, post) >= 0", {0, 3}), Error);
  EXPECT_THROW(world.check_rotated("gap(cart, post) >= 0", {0, 3}, 90), Error);
  EXPECT_THROW(world.at_time(2), Error);
  EXPECT_THROW(World(world).remove("post"), Error);
  Motion wrong;
  EXPECT_THROW(world.with(wrong), Error);
  wrong.paths["pots"] = {{0, {0, 0}}};
  EXPECT_THROW(world.with(wrong), Error);
  wrong.paths = {{"post", {{1, {0, 0}}, {0, {1, 0}}}}};
  try {
    world.with(wrong);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.place(), "the path of 'post'");
  }
  const World still({{"a", Shape::disc({0, 0}, 1)}, {"b", Shape::disc({0, 0}, 1)}}, "a");
  EXPECT_THROW(still.at_time(0), Error);
  EXPECT_THROW(still.instants("gap(a, b) >= 0", {0, 0}), Error);
}

TEST(PublicMotion, ShapesThatTurnAreBounded) {
  World world({{"door", Shape::box({-3, -1}, {3, 1})}, {"ball", Shape::disc({0, 0}, 1)}}, "ball");
  Motion motion;
  motion.paths["door"] = {{0, {0, 0}}, {1, {0, 0}, 90}};
  world = world.with(motion);
  const RegionBounds hit = world.solve_bounds("inf gap(ball, door) < 0");
  EXPECT_TRUE((hit.inner - hit.outer).empty());
  EXPECT_TRUE(hit.inner.contains(Point{3, 0}));
  EXPECT_FALSE(hit.outer.contains(Point{5, 0}));
  // Between the wings the ball touches both: its centre is (-2, 2).
  const Optimum best = world.minimize("distance to [0, 0]", "inf gap(ball, door) >= 0");
  EXPECT_EQ(best.side, "inner");
  EXPECT_LE(best.lower, std::sqrt(8.0));
  EXPECT_GE(best.upper, std::sqrt(8.0));
  EXPECT_LT(best.upper - best.lower, 0.2);
  EXPECT_THROW(world.solve("inf gap(ball, door) >= 0"), Error);
  const Instants near = world.instants("gap(ball, door) < 0", {0, 3});
  ASSERT_FALSE(near.possible.empty());
  EXPECT_EQ(*near.possible.back().to, 1);
}

TEST(PublicMotion, WorldsChangeOnTheirPaths) {
  World world = passing();
  world.set("wall", Shape::box({20, 0}, {21, 1}));
  EXPECT_EQ(*world.distance("gap(cart, wall)", {15, 0.5}).value, 4);
  EXPECT_EQ(*world.distance("inf gap(cart, post)", {0, 3}).value, 1);
  world.set("fine", Shape::box({30, 0}, {31, 1}, {"0.0000001"}));  // all are on a finer grid now
  EXPECT_EQ(*world.distance("inf gap(cart, post)", {0, 3}).value, 1);
}

TEST(PublicPoses, SlicesAndSectors) {
  const World world({{"room", Shape::box({0, 0}, {5, 3})}, {"bar", Shape::box({-2, -1}, {2, 1})}}, "bar");
  const PoseMap map = world.poses("inside(bar, room)", std::vector<Number>{0, 5, 90});
  ASSERT_EQ(map.slices.size(), 3u);
  EXPECT_EQ(*map.slices[0].region.area(), 1);
  EXPECT_TRUE(map.slices[2].region.empty());
  ASSERT_FALSE(map.sectors.empty());
  EXPECT_EQ(map.sectors[0].to, 5);
  EXPECT_TRUE((map.sectors[0].inner - map.slices[0].region).empty());
  EXPECT_TRUE((map.slices[1].region - map.sectors[0].outer).empty());
  EXPECT_EQ(world.poses("inside(bar, room)", 4).slices[1].degrees, 90);
  EXPECT_THROW(world.poses("inside(bar, room)", 0), Error);
  EXPECT_THROW(passing().poses("gap(cart, post) >= 0", 4), Error);
}

TEST(PublicPoses, ComparedDistancesAreKnownAtTheAnglesAlone) {
  const World world({{"P", Shape::points({{-3, 0}})},
                     {"Q", Shape::points({{3, 0}})},
                     {"room", Shape::box({-12, -12}, {12, 12})},
                     {"B", Shape::points({{0, 0}})}},
                    "B");
  const PoseMap map = world.poses("gap(B, P) <= gap(B, Q) and inside(B, room)", std::vector<Number>{0, 90});
  EXPECT_NEAR(*map.slices[0].region.area(), 12 * 24, 1e-9);
  ASSERT_EQ(map.sectors.size(), 1u);
  EXPECT_TRUE(map.sectors[0].inner.empty());
  EXPECT_TRUE((map.slices[0].region - map.sectors[0].outer).empty());
  EXPECT_TRUE(map.sectors[0].outer.contains(Point{-6, 5}));
}

/// A ball in a room with another ball in it.
World room_with_ball() {
  return World({{"room", Shape::box({0, 0, 0}, {10, 10, 10})},
                {"ball", Shape::ball({0, 0, 0}, 1)},
                {"other", Shape::ball({5, 5, 5}, 2)}},
               "ball");
}

TEST(PublicLines, RegionsOfSpace) {
  const World world = room_with_ball();
  const LineMap cube = world.on_lines("inside(ball, room)", {16});
  ASSERT_FALSE(cube.lines.empty());
  EXPECT_TRUE(cube.exact);
  EXPECT_FALSE(cube.unbounded);
  EXPECT_EQ(cube.components, 1u);
  for (const LineMap::Line& line : cube.lines) {
    EXPECT_EQ(line.through[2], 0);
    ASSERT_EQ(line.intervals.size(), 1u);
    EXPECT_EQ(*line.intervals[0].from, 1);
    EXPECT_EQ(*line.intervals[0].to, 9);
    EXPECT_TRUE(line.intervals[0].from_belongs);
  }
  EXPECT_TRUE(world.on_lines("clear(ball, other)", {8, Shape::Axis::kX}).unbounded);
  EXPECT_TRUE(world.on_lines("inside(ball, other, 5)", {8}).lines.empty());
  EXPECT_THROW(world.on_lines("inside(ball, room)", {0}), Error);
  EXPECT_THROW(passing().on_lines("gap(cart, post) >= 0"), Error);
}

TEST(PublicLines, VolumesBetweenBounds) {
  const World world = room_with_ball();
  const double true_volume = 512 - 4.0 / 3 * kPi * 27;
  double width = 1e9;
  for (const int count : {16, 64}) {
    const VolumeBounds v = world.volume("inside(ball, room) and clear(ball, other)", {count});
    EXPECT_LE(v.lower, true_volume);
    EXPECT_GE(v.upper, true_volume);
    EXPECT_LT(v.upper - v.lower, width / 2);
    width = v.upper - v.lower;
  }
  EXPECT_TRUE(std::isinf(world.volume("clear(ball, other)").lower));
}

TEST(PublicLines, SurfacesAreClosed) {
  const Surface surface = room_with_ball().surface("inside(ball, room) and clear(ball, other)", 16);
  ASSERT_FALSE(surface.faces.empty());
  std::map<std::pair<int, int>, int> sides;
  double volume = 0;
  for (const auto& face : surface.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) ++sides[{face[k], face[(k + 1) % face.size()]}];
    const auto corner = [&](std::size_t k) { return surface.vertices[std::size_t(face[k])]; };
    const Position3 a = corner(0), b = corner(1), c = corner(2);
    volume +=
        (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6;
  }
  for (const auto& [side, count] : sides) EXPECT_EQ(count, (sides[{side.second, side.first}]));
  EXPECT_NEAR(volume, 512 - 4.0 / 3 * kPi * 27, 20);
}

}  // namespace io_public_plans
