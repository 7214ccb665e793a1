// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing of solids through the public headers alone.

#include <gtest/gtest.h>

#include <algorithm>

#include "findspace/error.h"
#include "findspace/solid_packing.h"

namespace io_public_solid_packing {

using namespace findspace;

Shape block(int x, int y, int z) { return Shape::box(Point3{0, 0, 0}, Point3{x, y, z}); }

/// Eight bricks on a floor of eight squares.
SolidPackProblem bricks() {
  SolidPackProblem problem;
  problem.name = "bricks";
  problem.width = 4;
  problem.depth = 2;
  problem.parts = {{"brick", block(2, 1, 1), 8, Orientation::right_angles()}};
  return problem;
}

TEST(PublicSolidPacking, TheHeightIsProved) {
  const SolidPackProblem problem = bricks();
  int told = 0;
  const auto layout = pack(problem, {.seconds = 20}, [&](const SolidPackLayout& l) {
    ++told;
    EXPECT_TRUE(layout_faults(problem, l).empty());
  });
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->height.text(), "2");
  EXPECT_EQ(layout->lower_bound.text(), "2");
  EXPECT_EQ(layout->density, 1);
  EXPECT_EQ(layout->items.size(), 8u);
  EXPECT_FALSE(layout->met.has_value());
  EXPECT_GT(told, 0);
}

TEST(PublicSolidPacking, ASolidIsMovedByHand) {
  const SolidPacking packing{bricks()};
  SolidPackLayout layout = *packing.search({.work = 2});
  ASSERT_EQ(layout.height.text(), "2");
  // Up into the air it stands exactly where it was put, and nothing else moves.
  const auto free = packing.moved(layout, 3, {"0.125", "0.5", "7.0000001"});
  ASSERT_TRUE(free.has_value());
  EXPECT_EQ(free->items[3].at.z.text(), "7.0000001");
  EXPECT_TRUE(packing.verdict(*free).feasible());
  for (const std::size_t k : {0, 1, 2, 4}) EXPECT_EQ(free->items[k].at.x.text(), layout.items[k].at.x.text());
  // Into others: they make room, at a greater height.
  const auto made = packing.moved(layout, 3, {layout.items[0].at.x, layout.items[0].at.y, "0.25"});
  ASSERT_TRUE(made.has_value());
  EXPECT_TRUE(packing.verdict(*made).feasible());
  EXPECT_EQ(made->items.size(), 8u);
  EXPECT_THROW(packing.moved(layout, 8, {0, 0, 0}), Error);
  EXPECT_THROW(packing.moved({}, 0, {0, 0, 0}), Error);
}

TEST(PublicSolidPacking, AnOutlineIsNotTurned) {
  SolidPackProblem problem = bricks();
  problem.parts[0].orientations = {Orientation::about(Shape::Axis::kZ, 90)};
  double widest = 0;
  for (const Position3& v : SolidPacking(problem).outline(0).vertices) widest = std::max(widest, v[0]);
  EXPECT_EQ(widest, 2);
}

TEST(PublicSolidPacking, FaultsAreNamed) {
  const SolidPackProblem problem = bricks();
  SolidPackLayout layout = *pack(problem, {.work = 2});
  const SolidPackLayout good = layout;
  layout.items[0].at.z = "-0.000001";
  EXPECT_FALSE(layout_faults(problem, layout).empty());
  layout = good;
  layout.items.pop_back();
  ASSERT_EQ(layout_faults(problem, layout).size(), 1u);
  layout = good;
  layout.items[0].orientation = Orientation::quaternion(2, 0, 0, 1);
  EXPECT_THROW(layout_faults(problem, layout), Error);
  layout = good;
  layout.items[0].container = 1;
  EXPECT_THROW(layout_faults(problem, layout), Error);
  layout = good;
  layout.items[0].part = "tile";
  EXPECT_THROW(layout_faults(problem, layout), Error);
}

TEST(PublicSolidPacking, ContainersAndWhatIsLeftOut) {
  SolidPackProblem problem = bricks();
  problem.containers = {{"carton", 2, 2, 1, 2}};
  EXPECT_THROW(SolidPacking{problem}, Error);  // there is a floor, too
  problem.width = problem.depth = 0;
  problem.parts[0].count = 5;
  problem.parts.push_back({"ball", Shape::ball({0, 0, 0}, 3)});
  const auto layout = pack(problem, {.work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->containers, (std::vector<std::string>{"carton", "carton"}));
  EXPECT_EQ(layout->items.size(), 4u);
  ASSERT_EQ(layout->left_out.size(), 2u);
  EXPECT_EQ(layout->left_out[1].part, "ball");
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  EXPECT_NE(layout_json(problem, *layout).find("\"containers\": [\"carton\", \"carton\"]"), std::string::npos);
  problem.containers.push_back({"crate", 2, 2, 1, 1, 3});
  EXPECT_THROW(layout_faults(problem, *layout), Error);  // one has a cost
  problem.containers[1].cost = {};
  problem.containers[1].name = "carton";
  EXPECT_THROW(layout_faults(problem, *layout), Error);
}

TEST(PublicSolidPacking, BallsTouchExactly) {
  SolidPackProblem problem;
  problem.width = 4;
  problem.depth = 2;
  problem.parts = {{"ball", Shape::ball({0, 0, 0}, 1), 2}};
  const auto layout = pack(problem, {.work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->height.text(), "2");
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  problem.gap = "0.000001";
  EXPECT_FALSE(layout_faults(problem, *layout).empty());
}

TEST(PublicSolidPacking, ConditionsAndGroups) {
  SolidPackProblem problem;
  problem.width = 9;
  problem.depth = 1;
  problem.parts = {{"plug", block(1, 1, 1), 2}, {"bar", block(5, 1, 1)}};
  problem.conditions = {{"plug", "plug", "gap(self, other) >= 5"}};
  const auto layout = pack(problem, {.work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_TRUE(layout_faults(problem, *layout).empty());
  problem.conditions.clear();
  problem.groups = {{{"plug"}, 0}};
  EXPECT_FALSE(layout_faults(problem, *layout).empty());
  problem.groups[0].within = {};
  EXPECT_THROW(layout_faults(problem, *layout), Error);  // on a floor it says how far
  problem.groups.clear();
  problem.gaps = {{"plug", "nobody", 1}};
  EXPECT_THROW(layout_faults(problem, *layout), Error);
  problem.gaps.clear();
  problem.where = "gap(self) >= 1";
  EXPECT_THROW(layout_faults(problem, *layout), Error);
}

TEST(PublicSolidPacking, FixedSolidsStand) {
  SolidPackProblem problem = bricks();
  problem.fixed = {{"brick", {1, 0, 0}}, {"brick", {1, 0, 1}, Orientation::about(Shape::Axis::kX, 180)}};
  EXPECT_THROW(SolidPacking{problem}, Error);  // turned, it reaches below y = 0
  problem.fixed[1].at = {1, 1, 2};
  const SolidPacking packing(problem);
  const auto layout = packing.search({.work = 8});
  ASSERT_TRUE(layout.has_value());
  EXPECT_TRUE(packing.verdict(*layout).faults.empty());
  SolidPackLayout moved = *layout;
  for (PlacedSolid& item : moved.items)
    if (item.at.x.text() == "1" && item.at.y.text() == "0" && item.at.z.text() == "0") item.at.z = "-1";
  const PackVerdict verdict = packing.verdict(moved);
  const auto is_fixed = [](const PackFault& fault) { return fault.kind == PackFault::Kind::kFixed; };
  const auto fault = std::find_if(verdict.faults.begin(), verdict.faults.end(), is_fixed);
  ASSERT_NE(fault, verdict.faults.end());
  EXPECT_EQ(fault->text, "a fixed brick does not stand at (1, 0, 0)");
  EXPECT_EQ(fault->of, std::vector<std::string>{"brick"});
}

TEST(PublicSolidPacking, FixedSolidsInContainersAreRead) {
  const SolidPackProblem problem = SolidPacking::json(R"({"containers": [{"id": "crate", "count": 2, "size-x": 4,
      "size-y": 4, "size-z": 4}], "fixed": [{"part": "b", "at": ["1/3", 0, 0], "container": "crate"}],
      "item-types": [{"id": "b", "demand": 2, "shape": {"box": {"min": [0,0,0], "max": [1,2,3]}}}]})")
                                       .problem();
  ASSERT_EQ(problem.fixed.size(), 1u);
  EXPECT_EQ(problem.fixed[0].at.x.text(), "1/3");
  EXPECT_EQ(problem.fixed[0].container, "crate");
  EXPECT_EQ(problem.fixed[0].number, 1);
  const auto refused = [&](const FixedSolid& fixed) {
    SolidPackProblem wrong = problem;
    wrong.fixed = {fixed};
    EXPECT_THROW(SolidPacking{wrong}, Error);
  };
  refused({"c", {0, 0, 0}, {}, "crate"});
  refused({"b", {0, 0, 0}, {}, "box"});
  refused({"b", {0, 0, 0}, {}, "crate", 3});
  refused({"b", {0, 0, 0}, {}, "crate", 2});
  refused({"b", {0, 0, 2}, {}, "crate"});
  refused({"b", {0, 0, 0}, Orientation::about(Shape::Axis::kX, 180), "crate"});
}

/// Cubes under the plane x + z = 3.
SolidPackProblem under_a_slope() {
  SolidPackProblem problem;
  problem.parts = {{"cube", block(1, 1, 1), 4}};
  PackContainer& ramp = problem.containers.emplace_back(PackContainer{"ramp"});
  ramp.shape =
      Shape::polytope(std::vector<Position3>{{5, 0, 0}, {8, 0, 0}, {5, 0, 3}, {5, 1, 0}, {8, 1, 0}, {5, 1, 3}});
  return problem;
}

TEST(PublicSolidPacking, AContainerHasAShape) {
  const SolidPacking packing{under_a_slope()};
  const auto layout = packing.search({.work = 2});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->items.size(), 3u);
  EXPECT_DOUBLE_EQ(layout->density, 3 / 4.);
  SolidPackLayout wrong = *layout;
  wrong.items[0].at = {1, 0, 1};
  EXPECT_EQ(packing.verdict(wrong).faults[0].kind, PackFault::Kind::kOutside);
  EXPECT_EQ(packing.inside(0).vertices.size(), 6u);
  EXPECT_THROW(packing.inside(1), Error);
  // It is drawn with its slope: nine edges.
  const std::string picture = packing.svg(*layout);
  std::size_t edges = 0;
  for (std::size_t at = picture.find("#999"); at != std::string::npos; at = picture.find("#999", at + 1)) ++edges;
  EXPECT_EQ(edges, 9u);
}

TEST(PublicSolidPacking, OrientationsAreExact) {
  EXPECT_EQ(Orientation::right_angles().size(), 24u);
  EXPECT_EQ(Orientation::upright().size(), 4u);
  EXPECT_EQ(Orientation::quaternion(2, 0, 0, 1).rows[0][1].text(), "-0.8");
  EXPECT_EQ(Orientation::about(Shape::Axis::kX, 90).rows[1][2].text(), "-1");
  EXPECT_THROW(Orientation::about(Shape::Axis::kX, 45), Error);
  SolidPackProblem problem = bricks();
  problem.parts[0].orientations = {{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}}}};
  EXPECT_THROW(pack(problem, {.work = 1}), Error);
}

TEST(PublicSolidPacking, WhatIsRefused) {
  const auto refused = [](const PackSolid& part) {
    SolidPackProblem problem;
    problem.width = 4;
    problem.depth = 4;
    problem.parts = {part};
    try {
      pack(problem, {.work = 1});
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find("'part'"), std::string::npos) << e.what();
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refused({"part", block(1, 1, 1)}));
  EXPECT_TRUE(refused({"part", Shape::box({0, 0}, {1, 1})}));
  const Shape half = Shape::polygon(Contour({-1, 0}).arc_through({0, -1}, {1, 0}));
  EXPECT_TRUE(refused({"part", Shape::prism(half, 0, 1)}));
  EXPECT_TRUE(refused({"part", Shape::complement(block(1, 1, 1))}));
  EXPECT_TRUE(refused({"part", block(5, 1, 1)}));
  EXPECT_TRUE(refused({"part", Shape::box(Point3{0, 0, 0}, Point3{1, 1, 1}, {"0.0000000001"})}));
}

TEST(PublicSolidPacking, FilesBothWays) {
  const SolidPackProblem problem = solid_pack_problem(R"({"name": "kit", "container": {"size-x": 4, "size-y": 2},
    "item-types": [{"id": "rod", "demand": 2, "shape": {"box": {"min": [0, 0, 0], "max": [1.5, 1, 1]}},
                    "allowed_orientations": "upright"}],
    "groups": [{"parts": ["rod"], "within": 1}]})");
  ASSERT_EQ(problem.parts.size(), 1u);
  EXPECT_EQ(problem.parts[0].orientations.size(), 4u);
  EXPECT_EQ(problem.groups[0].within->text(), "1");
  const auto layout = pack(problem, {.work = 1});
  ASSERT_TRUE(layout.has_value());
  EXPECT_EQ(layout->height.text(), "1");
  EXPECT_NE(layout_json(problem, *layout).find("\"instance\": \"kit\""), std::string::npos);
  EXPECT_NE(layout_svg(problem, *layout).find("<svg"), std::string::npos);
  EXPECT_NE(layout_file(problem, *layout, ".obj").find("g rod#2"), std::string::npos);
  EXPECT_THROW(layout_file(problem, *layout, ".doc"), Error);
  EXPECT_EQ(layout_surface(problem, *layout).vertices.size(), 16u);
}

TEST(PublicSolidPacking, AProblemIsPutOnItsGridOnce) {
  const char* const text = R"({"name": "kit", "container": {"size-x": 4, "size-y": 2},
    "item-types": [{"id": "rod", "demand": 2, "shape": {"box": {"min": [0, 0, 0], "max": [1.5, 1, 1]}}}]})";
  EXPECT_TRUE(SolidPacking::is_stated_in(text));
  EXPECT_FALSE(SolidPacking::is_stated_in("{}"));
  PackReading reading;
  reading.gap = "0.5";
  const SolidPacking packing = SolidPacking::json(text, reading);
  EXPECT_EQ(packing.problem().gap.text(), "0.5");
  EXPECT_EQ(packing.copies(), 2u);
  EXPECT_EQ(packing.lower_bound().text(), "1");
  PackSearch<SolidPackLayout> search;
  int better = 0;
  search.better = [&](const SolidPackLayout& layout, const PackProgress& state) {
    ++better;
    EXPECT_EQ(layout.height.value(), state.length);
  };
  const auto layout = packing.search({.seed = 5, .work = 1}, search);
  ASSERT_TRUE(layout.has_value());
  EXPECT_GE(better, 1);
  EXPECT_EQ(layout->height.text(), "1");
  EXPECT_EQ(layout->lower_bound.text(), "1");
  EXPECT_EQ(layout->seed, 5u);
  EXPECT_TRUE(packing.verdict(*layout).feasible());
  EXPECT_EQ(packing.layout(packing.json(*layout)).items[1].at.x.text(), layout->items[1].at.x.text());
  search.start = *layout;
  search.start->items[0].at = search.start->items[1].at;
  const PackVerdict verdict = packing.verdict(*search.start);
  ASSERT_EQ(verdict.faults.size(), 1u);
  EXPECT_EQ(verdict.faults[0].kind, PackFault::Kind::kOverlap);
  EXPECT_EQ(verdict.faults[0].of, (std::vector<std::string>{"rod#1", "rod#2"}));
  EXPECT_EQ(verdict.faults[0].near.size(), 3u);
  EXPECT_THROW(packing.search({.work = 1}, search), Error);
}

}  // namespace io_public_solid_packing
