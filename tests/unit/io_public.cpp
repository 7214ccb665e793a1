// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The public headers alone: what a user of the library sees.

#include <gtest/gtest.h>

#include <cmath>

#include "findspace/findspace.h"

namespace io_public {

using namespace findspace;

World boxes() { return World({{"A", Shape::box({-4, -3}, {4, 3})}, {"B", Shape::box({-1, -1}, {1, 1})}}, "B"); }

TEST(Public, DistancesOfBoxes) {
  const World world = boxes();
  EXPECT_DOUBLE_EQ(*world.distance("gamma1(B, A)", {6, 0}).value, 1);
  EXPECT_DOUBLE_EQ(*world.distance("eta1(B, A)", {0, 0}).value, -2);
  EXPECT_DOUBLE_EQ(*world.distance("margin(B, A)", {0, 0}).value, 2);
  EXPECT_EQ(world.distance("delta1(B, A)", {0, 0}).value, std::nullopt);
  EXPECT_NE(world.distance("gamma1(B, A)", {6, 5}).witness().find("vertex (4, 3) of A"), std::string::npos);
}

TEST(Public, RegionsAreExact) {
  const World world = boxes();
  const Region clear = world.solve("disjoint(B, A) and gamma1(B, A) <= 1");
  EXPECT_NEAR(*clear.area(), 2 * 10 + 2 * 8 + M_PI, 1e-12);
  EXPECT_FALSE(clear.contains({5, 0}));
  EXPECT_TRUE(clear.contains({"5.000001", 0}));
  EXPECT_TRUE(clear.contains({6, 0}));
  EXPECT_EQ(clear.holes(), 1u);
  EXPECT_TRUE(world.holds("touches(B, A)", {5, 0}));
  EXPECT_EQ(world.shape("A").area(), 48);
}

TEST(Public, SignMaps) {
  const SignMap map = boxes().sign_map("gamma1(B, A)", 1);
  EXPECT_EQ(map.sign({0, 0}), -1);
  EXPECT_EQ(map.sign({6, 0}), 0);
  EXPECT_EQ(map.sign({6, "4.000001"}), 1);
  EXPECT_NEAR(*map.where(true, true, false).area(), 80 + 36 + M_PI, 1e-12);
}

TEST(Public, SignMapOfAMargin) {
  const World world({{"A", Shape::box({0, 0}, {10, 10})}, {"B", Shape::box({-1, -1}, {1, 1})}}, "B");
  const SignMap map = world.sign_map("margin(B, A)", 2);  // 2 to spare: p in [3, 7] x [3, 7]
  EXPECT_EQ(map.sign({5, 5}), 1);
  EXPECT_EQ(map.sign({3, 5}), 0);
  EXPECT_EQ(map.sign({2, 5}), -1);
  EXPECT_DOUBLE_EQ(*world.distance("margin(B, A)", {3, 5}).value, 2);
  const std::vector<Position> all{{5, 5}, {3, 5}, {2, 5}, {7, 7}};
  std::vector<std::int8_t> signs(4);
  map.signs(all, signs);
  EXPECT_EQ(signs, (std::vector<std::int8_t>{1, 0, -1, 0}));
  EXPECT_THROW(map.signs(all, std::span(signs).first(2)), Error);
  EXPECT_THROW(world.sign_map("x", 2), Error);
  EXPECT_THROW(world.sign_map("gamma1(B, A)", "2 mm"), Error);
}

TEST(Public, SignMapAlongADirection) {
  const World world = boxes();
  const SignMap along = world.sign_map("gamma1(B, A, along=(1, 0))", 1);
  EXPECT_EQ(along.sign({0, 0}), -1);
  EXPECT_EQ(along.sign({6, 0}), 0);
  EXPECT_EQ(along.sign({-6, 0}), 0);
  EXPECT_EQ(along.sign({7, 0}), 1);
  EXPECT_EQ(along.sign({0, "4.5"}), 1);  // met nowhere along x
  const SignMap toward = world.sign_map("gamma1(B, A, toward=(1, 0))", 1);
  EXPECT_EQ(toward.sign({-6, 0}), 0);
  EXPECT_EQ(toward.sign({6, 0}), 1);
}

TEST(Public, MistakesAreInWhatTheCallerWrote) {
  const auto place = [](auto make) {
    try {
      make();
    } catch (const Error& e) {
      return e.place();
    }
    return std::string("none");
  };
  EXPECT_EQ(place([] { Shape::json("{\"points\": [[0, 4]"); }), "shape:1:19");
  EXPECT_EQ(place([] { Shape::path("M 0 0 L 1"); }), "path");
  EXPECT_EQ(place([] { Shape::file("/nowhere/at/all.obj"); }), "/nowhere/at/all.obj");
}

TEST(Public, DistancesInRotationAreDegrees) {
  // A bar on the x axis above which a point of A stands: it meets it after a quarter turn.
  const World world(
      {{"A", Shape::json("{\"points\": [[0, 4]]}")}, {"B", Shape::json("{\"polyline\": [[0, 0], [5, 0]]}")}}, "B");
  EXPECT_DOUBLE_EQ(*world.distance("gamma1(B, A, turning=(0, 0))", {0, 0}).value, 90);
  EXPECT_FALSE(world.distance("gamma1(B, A, turning=(0, 0))", {0, 10}).value);  // never
  EXPECT_TRUE(world.holds("gamma1(B, A, turning=(0, 0)) >= 90", {0, 0}));
  EXPECT_FALSE(world.holds("gamma1(B, A, turning=(0, 0)) > 90", {0, 0}));
  EXPECT_THROW(world.sign_map("gamma1(B, A, turning=(0, 0))", 5), Error);
  const Distance rotating = Distance("gap", "B", "A").rotating({0, 0});
  EXPECT_EQ(rotating.text(), R"(gap("B", "A", rotating=(0, 0)))");
  EXPECT_DOUBLE_EQ(*world.distance(rotating.text(), {0, 0}).value, 90);
  EXPECT_TRUE(world.holds(rotating >= 90, {0, 0}));
}

TEST(Public, Minimum) {
  const Optimum best = boxes().minimize("distance to [20, 0]", "gamma1(B, A) < 1");
  EXPECT_DOUBLE_EQ(*best.value, 14);
  EXPECT_FALSE(best.attained);
  EXPECT_TRUE(best.at.contains({6, 0}));
  EXPECT_EQ(best.side, "exact");
}

TEST(Public, ShapesAreMadeOfShapes) {
  const Shape ring = Shape::subtract({Shape::disc({0, 0}, 3), Shape::disc({0, 0}, 2)});
  const World world({{"ring", ring.translated({10, 0})}, {"dot", Shape::points({{0, 0}})}}, "dot");
  EXPECT_NEAR(*world.shape("ring").area(), 5 * M_PI, 1e-12);
  EXPECT_FALSE(world.shape("ring").closed());
  EXPECT_DOUBLE_EQ(*world.distance("gamma1(dot, ring)", {10, 0}).value, 2);
}

TEST(Public, ErrorsSayWhere) {
  EXPECT_THROW(World({{"A", Shape::disc({0, 0}, -1)}, {"B", Shape::points({{0, 0}})}}, "B"), Error);
  EXPECT_THROW(boxes().solve("gama1(B, A) > 0"), Error);
  EXPECT_THROW(boxes().distance("x", {0, 0}), Error);
  EXPECT_THROW(Number(std::nan("")), Error);
}

}  // namespace io_public
