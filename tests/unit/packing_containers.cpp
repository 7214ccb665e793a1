// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Containers of given sizes: the fewest, lids and walls, costs, parts that are left out, the most valuable choice.
#include <gtest/gtest.h>

#include <array>
#include <atomic>

#include "packing/solid_depth/solid_column.h"
#include "packing/solid_proof/verify_solids.h"
#include "packing/solid_search/solid_search.h"
#include "packing_solid_parts.h"

namespace findspace::packing {
namespace packing_containers {

SolidContainer container(const char* name, int count, int w, int d, int h) { return {name, count, {}, w, d, h}; }

SolidProblem problem_of(std::vector<SolidContainer> containers, std::vector<SolidPart> parts) {
  SolidProblem problem;
  problem.containers = std::move(containers);
  problem.parts = std::move(parts);
  return problem;
}

SolidLayout found(const SolidProblem& problem, double work, const SolidLayout* start = nullptr) {
  const std::atomic<bool> stop = false;
  SolidSearchOptions options;
  options.work = work;
  options.start = start;
  const auto layout = search_solids(problem, options, {}, stop);
  EXPECT_TRUE(verify(problem, layout.value()).is_feasible());
  return *layout;
}

TEST(Containers, BoxesThatFillThem) {
  const SolidProblem problem = problem_of({container("crate", 9, 4, 4, 2)}, {box("cube", 8, 2, 2, 2)});
  const SolidLayout layout = found(problem, 20e6);
  EXPECT_EQ(layout.containers, (std::vector<std::size_t>{0, 0}));
  EXPECT_TRUE(layout.left_out.empty());
  EXPECT_DOUBLE_EQ(container_volume(problem, layout), volume(problem));
}

TEST(Containers, NoPartStandsThroughALid) {
  const SolidLayout layout = found(problem_of({container("crate", 3, 5, 5, 5)}, {box("big", 3, 3, 3, 3)}), 4e6);
  EXPECT_EQ(layout.containers.size(), 3U);
  EXPECT_EQ(layout.height, Fraction(3));
}

/// Only the second kind is high enough for the tower, and the cheap one is used first.
TEST(Containers, KindsAndCosts) {
  SolidProblem problem = problem_of({container("low", 5, 4, 4, 2), container("high", 5, 4, 4, 5)},
                                    {box("slab", 2, 4, 4, 1), box("tower", 1, 1, 1, 5)});
  problem.containers[0].cost = 1;
  problem.containers[1].cost = 9;
  const SolidLayout layout = found(problem, 10e6);
  EXPECT_EQ(layout.containers, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(cheapest_containers(problem).size(), 6U);  // no more of a kind than there are parts
  problem.containers[0].cost = 5;
  EXPECT_EQ(found(problem, 10e6).containers[0], 1U);
}

TEST(Containers, PartsTurnIntoThem) {
  const SolidLayout layout =
      found(problem_of({container("flat", 1, 6, 5, 2)}, {with_turns(box("board", 4, 1, 3, 5))}), 40e6);
  EXPECT_TRUE(layout.left_out.empty());
}

TEST(Containers, WhatIsTooLargeIsLeftOut) {
  SolidProblem problem =
      problem_of({container("crate", 1, 3, 3, 3)}, {box("cube", 1, 3, 3, 3), box("rod", 2, 1, 1, 4)});
  const SolidLayout layout = found(problem, 4e6);
  ASSERT_EQ(layout.left_out.size(), 1U);
  EXPECT_EQ(layout.left_out[0].copies, 2);
  EXPECT_EQ(layout.left_out[0].why, "it is larger than every container");
  problem.parts[0].demand = 0;
  const std::atomic<bool> stop = false;
  EXPECT_FALSE(search_solids(problem, {}, {}, stop).has_value());
}

TEST(Containers, TheMostValuableChoice) {
  SolidProblem problem = problem_of({container("crate", 1, 4, 4, 4)},
                                    {box("cheap", 1, 4, 4, 4), box("dear", 8, 2, 2, 2), box("huge", 1, 9, 9, 9)});
  problem.parts[0].value = 7;
  problem.parts[1].value = 1;
  const SolidLayout layout = found(problem, 40e6);
  ASSERT_EQ(layout.items.size(), 8U);
  for (const SolidPlaced& item : layout.items) EXPECT_EQ(item.part, 1U);
  EXPECT_EQ(layout.left_out.size(), 2U);
}

/// The first layout has the slab, as the largest; two rods are worth more together and need the whole of the crate.
TEST(Containers, OneIsExchangedForAnother) {
  SolidProblem problem =
      problem_of({container("crate", 1, 4, 4, 1)}, {box("slab", 1, 4, 3, 1), box("rod", 3, 4, 2, 1)});
  problem.parts[0].value = 3;
  problem.parts[1].value = 2;
  const SolidLayout layout = found(problem, 20e6);
  ASSERT_EQ(layout.items.size(), 2U);
  EXPECT_EQ(layout.items[0].part, 1U);
  EXPECT_EQ(layout.items[1].part, 1U);
}

TEST(Containers, EdgesAndGaps) {
  SolidProblem problem = problem_of({container("crate", 4, 7, 4, 4)}, {box("cube", 4, 2, 2, 2)});
  problem.edge = 1;
  problem.gap = 1;
  EXPECT_EQ(found(problem, 4e6).containers.size(), 2U);
  problem.containers[0].width = Fraction(699, 100);
  EXPECT_EQ(found(problem, 4e6).containers.size(), 4U);
}

TEST(Containers, WrongLayouts) {
  const SolidProblem problem = problem_of({container("crate", 1, 4, 4, 4)}, {box("cube", 2, 2, 2, 2)});
  using Kind = SolidFault::Kind;
  const auto fault = [&](const SolidLayout& layout) { return verify(problem, layout).faults.at(0).kind; };
  SolidLayout layout{2, {{0, 1, 0, {0, 0, 0}, 0}, {0, 2, 0, {0, 0, 0}, 1}}, {}, {0, 0}};
  EXPECT_EQ(fault(layout), Kind::kContainers);
  layout.containers = {0};
  EXPECT_EQ(fault(layout), Kind::kOutside);
  layout.items[1].container = 0;
  EXPECT_EQ(fault(layout), Kind::kOverlap);
  layout.items[1].at = {2, 2, 0};
  EXPECT_TRUE(verify(problem, layout).is_feasible());
  layout.items[1].at = {2, 2, 3};
  layout.height = 5;
  EXPECT_EQ(fault(layout), Kind::kOutside);
  layout.items.pop_back();
  EXPECT_EQ(fault(layout), Kind::kCount);
  layout.left_out = {{0, 1, "no container was found for it"}};
  EXPECT_TRUE(verify(problem, layout).is_feasible());
}

TEST(Containers, GoesOnFromALayout) {
  const SolidProblem problem = problem_of({container("crate", 3, 4, 4, 4)}, {box("cube", 4, 2, 2, 2)});
  const SolidLayout start{
      2,
      {{0, 1, 0, {0, 0, 0}, 0}, {0, 2, 0, {0, 2, 2}, 0}, {0, 3, 0, {0, 0, 0}, 1}, {0, 4, 0, {1, 1, 0}, 2}},
      {},
      {0, 0, 0}};
  ASSERT_TRUE(verify(problem, start).is_feasible());
  EXPECT_EQ(found(problem, 10e6, &start).containers.size(), 1U);
}

/// An item of a container whose height is sought stands in it.
TEST(Containers, ASoughtOneIsOne) {
  SolidProblem problem;
  problem.width = problem.depth = 4;
  problem.parts = {box("cube", 2, 2, 2, 2)};
  const SolidLayout layout{2, {{0, 1, 0, {0, 0, 0}, 0}, {0, 2, 0, {1, 1, 0}, 1}}};
  EXPECT_FALSE(verify(problem, layout).is_feasible());
}

}  // namespace packing_containers
}  // namespace findspace::packing
