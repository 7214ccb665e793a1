// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids that stand already: others go round them, containers with them are used, and proofs ask for them.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>

#include "packing/solid_depth/solid_column.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_proof/verify_solids.h"
#include "packing/solid_search/make_solid_room.h"
#include "packing/solid_search/proved_search.h"
#include "packing_solid_parts.h"

namespace findspace::packing {
namespace packing_fixed_solids {

SolidProblem on_floor(int width, int depth, std::vector<SolidPart> parts) {
  SolidProblem problem;
  problem.width = width;
  problem.depth = depth;
  problem.parts = std::move(parts);
  return problem;
}

FixedSolid fixed(std::size_t part, std::array<Fraction, 3> at, std::size_t form = 0) {
  return {.placed = {.part = part, .form = form, .at = at}};
}

std::optional<SolidLayout> search(const SolidProblem& problem, double work, const SolidLayout* start = nullptr) {
  const std::atomic<bool> stop = false;
  SolidSearchOptions options;
  options.work = work;
  options.start = start;
  return search_solids_to_proof(problem, options, {}, stop);
}

SolidLayout found(const SolidProblem& problem, double work, const SolidLayout* start = nullptr) {
  const auto layout = search(problem, work, start);
  EXPECT_TRUE(verify(problem, layout.value()).is_feasible());
  return *layout;
}

TEST(FixedSolids, OthersStandBesideThem) {
  SolidProblem problem = on_floor(3, 1, {box("cube", 3, 1, 1, 1)});
  problem.fixed = {fixed(0, {1, 0, 0})};
  const SolidLayout layout = found(problem, 4e6);
  EXPECT_EQ(layout.height, Fraction(1));
  EXPECT_EQ(layout.items.size(), 3U);
  EXPECT_TRUE(is_fixed_solid(layout, layout.items.back(), problem.fixed[0]));
  EXPECT_EQ(layout.items.back().copy, 3);
}

/// Half a unit to the left of the middle: one cube fits beside it, the other stands upon something.
TEST(FixedSolids, OthersDoNotMoveThem) {
  SolidProblem problem = on_floor(3, 1, {box("cube", 3, 1, 1, 1)});
  problem.fixed = {fixed(0, {Fraction(1, 2), 0, 0})};
  EXPECT_EQ(found(problem, 4e6).height, Fraction(2));
}

TEST(FixedSolids, OthersStandUnderThem) {
  SolidProblem problem = on_floor(2, 2, {box("lid", 1, 2, 2, 1), box("slab", 2, 2, 2, 1)});
  problem.fixed = {fixed(0, {0, 0, 1})};
  EXPECT_EQ(found(problem, 4e6).height, Fraction(3));
}

TEST(FixedSolids, NoLayoutIsLowerThanTheirTop) {
  SolidProblem problem = on_floor(3, 3, {box("post", 1, 1, 1, 2), box("cube", 4, 1, 1, 1)});
  problem.edge = Fraction(1, 2);
  problem.fixed = {fixed(0, {1, 1, 3})};
  EXPECT_EQ(lower_bound(problem), Fraction(11, 2));
  EXPECT_EQ(found(problem, 4e6).height, Fraction(11, 2));
}

TEST(FixedSolids, GapsHoldBesideThem) {
  SolidProblem problem = on_floor(4, 1, {box("cube", 2, 1, 1, 1)});
  problem.gap = 1;
  problem.fixed = {fixed(0, {1, 0, 0})};
  const SolidLayout layout = found(problem, 4e6);
  EXPECT_EQ(layout.height, Fraction(1));
  EXPECT_EQ(layout.items[0].at[0], Fraction(3));
}

TEST(FixedSolids, ConditionsHoldWithThem) {
  SolidProblem problem = on_floor(9, 1, {box("post", 1, 1, 1, 3), box("cube", 1, 1, 1, 1)});
  problem.conditions = {{0, 1, "gap(self, other) >= 2"}};
  problem.fixed = {fixed(0, {3, 0, 0})};
  const SolidLayout layout = found(problem, 10e6);
  EXPECT_EQ(layout.height, Fraction(3));
  const Fraction x = layout.items[0].at[0];
  EXPECT_TRUE(x == 0 || x >= 6) << x.text();
}

/// A cube looks the same however it is turned, about its corner: the form that is fixed is kept.
TEST(FixedSolids, StandInTheirOwnForm) {
  SolidProblem problem = on_floor(3, 1, {with_turns(box("cube", 3, 1, 1, 1))});
  std::size_t form = problem.parts[0].forms.size() - 1;
  const SolidBox turned = box_of(problem, problem.parts[0].forms[form]);
  problem.fixed = {fixed(0, {1 - turned.low[0], 0 - turned.low[1], 0 - turned.low[2]}, form)};
  const SolidLayout layout = found(problem, 4e6);
  EXPECT_EQ(layout.height, Fraction(1));
  EXPECT_EQ(layout.items.back().form, form);
}

TEST(FixedSolids, AloneAreALayout) {
  SolidProblem problem = on_floor(3, 3, {box("post", 1, 1, 1, 2)});
  problem.fixed = {fixed(0, {1, 1, 0})};
  const SolidLayout layout = found(problem, 1e6);
  EXPECT_EQ(layout.height, Fraction(2));
  EXPECT_EQ(layout.items.size(), 1U);
}

SolidProblem in_crates(std::vector<SolidPart> parts) {
  SolidProblem problem;
  problem.containers = {{"crate", 3, {}, 2, 2, 2}, {"pallet", 2, {}, 4, 4, 4}};
  problem.parts = std::move(parts);
  return problem;
}

/// The cubes would fit one crate, but the pallet is used anyway.
TEST(FixedSolids, TheirContainersAreUsed) {
  SolidProblem problem = in_crates({box("cube", 8, 1, 1, 1)});
  problem.fixed = {fixed(0, {3, 3, 0})};
  problem.fixed[0].kind = 1;
  const SolidLayout layout = found(problem, 10e6);
  EXPECT_EQ(layout.containers, std::vector<std::size_t>{1});
  EXPECT_EQ(layout.height, Fraction(1));
  EXPECT_EQ(containers_with_fixed(problem, 0), 0U);
  EXPECT_EQ(containers_with_fixed(problem, 1), 1U);
}

/// One stands in each of two crates: seven more cubes fit either.
TEST(FixedSolids, InSeveralContainers) {
  SolidProblem problem = in_crates({box("cube", 16, 1, 1, 1)});
  problem.fixed = {fixed(0, {0, 0, 0}), fixed(0, {1, 1, 1})};
  problem.fixed[1].placed.container = 1;
  const SolidLayout layout = found(problem, 20e6);
  EXPECT_EQ(layout.containers, (std::vector<std::size_t>{0, 0}));
  EXPECT_TRUE(layout.left_out.empty());
}

/// What stands in the way of the block cannot be taken out, though it is worth less.
TEST(FixedSolids, AreNotExchanged) {
  SolidProblem problem;
  problem.containers = {{"crate", 1, {}, 3, 3, 3}};
  problem.parts = {box("pin", 1, 1, 1, 1), box("block", 1, 3, 3, 3), box("slab", 1, 3, 3, 1)};
  problem.fixed = {fixed(0, {1, 1, 2})};
  const SolidLayout layout = found(problem, 4e6);
  ASSERT_EQ(layout.left_out.size(), 1U);
  EXPECT_EQ(layout.left_out[0].part, 1U);
  EXPECT_EQ(layout.items.size(), 2U);
}

TEST(FixedSolids, AreKeptFromALayoutToStartWith) {
  SolidProblem problem = on_floor(3, 1, {box("cube", 3, 1, 1, 1)});
  problem.fixed = {fixed(0, {1, 0, 0})};
  SolidLayout start;
  start.height = 3;
  start.items = {{0, 1, 0, {1, 0, 0}}, {0, 2, 0, {1, 0, 1}}, {0, 3, 0, {1, 0, 2}}};
  ASSERT_TRUE(verify(problem, start).is_feasible());
  EXPECT_EQ(found(problem, 4e6, &start).height, Fraction(1));
}

TEST(FixedSolids, AProofAsksForThem) {
  SolidProblem problem = on_floor(3, 1, {box("cube", 1, 1, 1, 1)});
  problem.fixed = {fixed(0, {1, 0, 0})};
  SolidLayout layout;
  layout.height = 1;
  layout.items = {{0, 1, 0, {2, 0, 0}}};
  const SolidVerdict verdict = verify(problem, layout);
  ASSERT_EQ(verdict.faults.size(), 1U);
  EXPECT_EQ(verdict.faults[0].kind, SolidFault::Kind::kFixed);
  EXPECT_EQ(verdict.faults[0].at, (std::array<double, 3>{1, 0, 0}));
  layout.items[0].at[0] = 1;
  EXPECT_TRUE(verify(problem, layout).is_feasible());
}

TEST(FixedSolids, MakeNoRoomByHand) {
  SolidProblem problem = on_floor(5, 1, {box("cube", 3, 1, 1, 1)});
  problem.fixed = {fixed(0, {2, 0, 0})};
  SolidLayout layout;
  layout.height = 1;
  layout.items = {{0, 1, 0, {2, 0, 0}}, {0, 2, 0, {0, 0, 0}}, {0, 3, 0, {4, 0, 0}}};
  ASSERT_TRUE(verify(problem, layout).is_feasible());
  EXPECT_FALSE(with_room(problem, layout, 0, {3, 0, 0}).has_value());
  EXPECT_EQ(with_room(problem, layout, 1, {1, 0, 0})->items[1].at[0], Fraction(1));
  const auto aside = with_room(problem, layout, 2, {Fraction(1, 4), 0, 0});  // upon the one that may move
  ASSERT_TRUE(aside.has_value());
  EXPECT_TRUE(verify(problem, *aside).is_feasible());
  EXPECT_TRUE(is_fixed_solid(problem, *aside, aside->items.back()));
}

TEST(FixedSolids, MakeNoRoomWithoutTheirContainer) {
  SolidProblem problem = in_crates({box("cube", 2, 1, 1, 1)});
  problem.fixed = {fixed(0, {0, 0, 0})};
  problem.fixed[0].kind = 1;
  SolidLayout layout;
  layout.height = 1;
  layout.containers = {0};
  layout.items = {{0, 1, 0, {0, 0, 0}}, {0, 2, 0, {1, 0, 0}}};
  EXPECT_FALSE(with_room(problem, layout, 1, {0, 0, 0}).has_value());
  const SolidTable table(problem);
  EXPECT_THROW(SolidColumn(problem, table, {0, 0}), Error);
  EXPECT_EQ(SolidColumn(problem, table, {0, 1}).fixed_rooms(), std::vector<std::size_t>{1});
}

/// Into the last container, above what is used of it: it stands where it was put.
TEST(MakeSolidRoom, InAnotherContainer) {
  SolidProblem problem = in_crates({box("cube", 3, 1, 1, 1)});
  SolidLayout layout;
  layout.height = Fraction(1);
  layout.containers = {0, 0};
  layout.items = {{0, 1, 0, {0, 0, 0}, 0}, {0, 2, 0, {0, 0, 1}, 0}, {0, 3, 0, {0, 0, 0}, 1}};
  ASSERT_TRUE(verify(problem, layout).is_feasible());
  layout.items[1].container = 1;
  const auto moved = with_room(problem, layout, 1, {Fraction(1, 3), 0, 1});
  ASSERT_TRUE(moved.has_value());
  EXPECT_EQ(moved->items[1].at, (std::array<Fraction, 3>{Fraction(1, 3), 0, 1}));
  EXPECT_EQ(moved->height, Fraction(2));
}

/// Around a column, the same for any number of threads.
TEST(FixedSolids, TheSameForAnyNumberOfThreads) {
  SolidProblem problem = on_floor(4, 4, {box("column", 1, 2, 2, 4), box("bar", 8, 1, 2, 1), box("cube", 9, 1, 1, 1)});
  problem.fixed = {fixed(0, {1, 1, 0})};
  std::vector<SolidLayout> layouts;
  for (const unsigned threads : {1U, 2U}) {
    const std::atomic<bool> stop = false;
    SolidSearchOptions options;
    options.work = 8e6;
    options.threads = threads;
    layouts.push_back(search_solids_to_proof(problem, options, {}, stop).value());
    EXPECT_TRUE(verify(problem, layouts.back()).is_feasible());
  }
  EXPECT_EQ(layouts[0].height, Fraction(4));
  ASSERT_EQ(layouts[0].items.size(), layouts[1].items.size());
  for (std::size_t i = 0; i < layouts[0].items.size(); ++i) EXPECT_EQ(layouts[0].items[i].at, layouts[1].items[i].at);
}

}  // namespace packing_fixed_solids
}  // namespace findspace::packing
