// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Proofs that no layout of a few solids is lower: programs that grow against CLP, boxes against all places on a
// lattice, parts that interlock, and the same for any number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>

#include "packing/compaction/linear_program.h"
#include "packing/solid_proof/growing_program.h"
#include "packing/solid_proof/least_height.h"
#include "packing/solid_search/proved_search.h"
#include "packing_solid_parts.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace packing_least_height {

SolidProblem problem_of(int width, int depth, std::vector<SolidPart> parts) {
  SolidProblem problem;
  problem.width = width;
  problem.depth = depth;
  problem.parts = std::move(parts);
  return problem;
}

std::optional<SolidLayout> packed(const SolidProblem& problem, double work = 2e7) {
  SolidSearchOptions options;
  options.work = work;
  const std::atomic<bool> stop = false;
  return search_solids_to_proof(problem, options, {}, stop);
}

/// The height that a proof comes down to from a greater one, finding layouts itself; below it by a ten millionth.
double least_height(const SolidProblem& problem, double from) {
  const SolidTable table(problem);
  LeastHeight proof(problem, table, from);
  while (!proof.is_over()) {
    const auto found = proof.search();
    if (!found) continue;
    double top = 0;
    for (const SolidPose& pose : *found) top = std::max(top, pose.at.z + table.variants()[pose.variant].high.z);
    proof.set_height(top);
  }
  return proof.bound();
}

/// A program of a few columns from 0 to 10, the last of which is sought, and rows of six whole factors.
struct RandomProgram {
  CertainRows rows;
  std::vector<std::size_t> added;
  double least = 0;
  bool has_solution;

  explicit RandomProgram(std::mt19937& random, std::size_t columns, int count)
      : rows(std::vector<exact::Interval>(columns, {0, 10}), 10) {
    std::uniform_int_distribution<int> factor(-5, 5), right(-20, 20);
    LinearProgram program(1);
    for (std::size_t k = 0; k < columns; ++k) program.add_column(0, 10, k + 1 == columns ? 1 : 0);
    for (int r = 0; r < count; ++r) {
      CertainRow row;
      const int least_of_row = right(random);
      program.begin_row(least_of_row);
      for (std::size_t k = 0; k < columns; ++k) {
        const double by = factor(random);
        row.add(k, {by, by});
        program.add(int(k), by);
      }
      row.set_right({double(least_of_row), double(least_of_row)});
      added.push_back(rows.add(row));
    }
    has_solution = program.solve();
    if (has_solution) least = program.value(int(columns) - 1);
  }
};

TEST(PackingLeastHeight, GrowingProgramsAgreeWithClp) {
  std::mt19937 random(7);
  int solved = 0, empty = 0;
  for (int k = 0; k < 300; ++k) {
    const RandomProgram sought(random, 2 + std::size_t(k) % 5, 1 + k % 12);
    GrowingProgram program(sought.rows);
    bool has_solution = true;
    for (const std::size_t row : sought.added) {  // one after another, as branches add them
      program.add(row);
      has_solution = has_solution && program.solve(100);
    }
    ASSERT_EQ(has_solution, sought.has_solution) << k;
    ++(has_solution ? solved : empty);
    if (!has_solution) {
      EXPECT_GE(program.bound(), 100) << k;
      continue;
    }
    EXPECT_NEAR(program.bound(), sought.least, 1e-6) << k;
    EXPECT_LE(program.bound(), sought.least + 1e-8) << k;
    EXPECT_NEAR(program.vertex().back(), sought.least, 1e-6) << k;
  }
  EXPECT_GT(solved, 50);
  EXPECT_GT(empty, 50);
}

TEST(PackingLeastHeight, ABoundThatIsEnoughEndsTheProgram) {
  CertainRows rows({{0, 10}, {0, 10}}, 10);
  CertainRow row;
  row.add(0, {-1, -1});
  row.add(1, {1, 1});
  row.set_right({3, 3});
  const std::size_t added = rows.add(row);
  GrowingProgram program(rows);
  EXPECT_TRUE(program.solve(3));
  program.add(added);
  EXPECT_FALSE(program.solve(3 - 1e-7));
  EXPECT_GE(program.bound(), 3 - 1e-7);
  EXPECT_LE(program.bound(), 3);
}

struct Brick {
  int w, d, h;
};

/// Whether the bricks from `next` on have places on the lattice beside those that stand.
bool has_places(const std::vector<Brick>& bricks, std::vector<std::array<int, 3>>& places, int width, int depth,
                int height) {
  if (places.size() == bricks.size()) return true;
  const Brick& mine = bricks[places.size()];
  for (int x = 0; x + mine.w <= width; ++x)
    for (int y = 0; y + mine.d <= depth; ++y)
      for (int z = 0; z + mine.h <= height; ++z) {
        bool is_free = true;
        for (std::size_t k = 0; k < places.size() && is_free; ++k) {
          const auto& [u, v, w] = places[k];
          const Brick& other = bricks[k];
          is_free = x + mine.w <= u || u + other.w <= x || y + mine.d <= v || v + other.d <= y || z + mine.h <= w ||
                    w + other.h <= z;
        }
        if (!is_free) continue;
        places.push_back({x, y, z});
        if (has_places(bricks, places, width, depth, height)) return true;
        places.pop_back();
      }
  return false;
}

TEST(PackingLeastHeight, BricksAgainstAllPlacesOfALattice) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> side(1, 3), count(3, 5);
  for (int k = 0; k < 40; ++k) {
    std::vector<Brick> bricks;
    std::vector<SolidPart> parts;
    for (int i = count(random); i > 0; --i) bricks.push_back({side(random), side(random), side(random)});
    for (const Brick& b : bricks)
      parts.push_back(box(("brick" + std::to_string(parts.size())).c_str(), 1, b.w, b.d, b.h));
    int least = 1;
    std::vector<std::array<int, 3>> places;
    while (!has_places(bricks, places, 4, 3, least)) ++least;
    const double bound = least_height(problem_of(4, 3, parts), least + 2);
    EXPECT_GT(bound, least - 1e-6) << k;
    EXPECT_LE(bound, least) << k;
  }
}

/// The least height in all ways in which the bricks from `next` on can stand.
int least_turned(std::vector<Brick> bricks, std::size_t next, int width, int depth, int most) {
  if (next == bricks.size()) {
    int least = 1;
    std::vector<std::array<int, 3>> places;
    while (least < most && !has_places(bricks, places, width, depth, least)) ++least;
    return least;
  }
  std::array<int, 3> sides{bricks[next].w, bricks[next].d, bricks[next].h};
  std::sort(sides.begin(), sides.end());
  do {
    bricks[next] = {sides[0], sides[1], sides[2]};
    most = least_turned(bricks, next + 1, width, depth, most);
  } while (std::next_permutation(sides.begin(), sides.end()));
  return most;
}

TEST(PackingLeastHeight, TurnedBricksAgainstAllPlacesOfALattice) {
  std::mt19937 random(13);
  std::uniform_int_distribution<int> side(1, 3), count(2, 3), copies(1, 2);
  for (int k = 0; k < 12; ++k) {
    std::vector<Brick> bricks;
    std::vector<SolidPart> parts;
    for (int i = count(random); i > 0; --i) {
      const Brick b{side(random), side(random), side(random)};
      const int demand = bricks.empty() ? copies(random) : 1;
      bricks.insert(bricks.end(), std::size_t(demand), b);
      parts.push_back(with_turns(box(("brick" + std::to_string(i)).c_str(), demand, b.w, b.d, b.h)));
    }
    const SolidProblem problem = problem_of(3, 3, parts);
    ASSERT_TRUE(is_provable(problem, SolidTable(problem))) << k;
    const int least = least_turned(bricks, 0, 3, 3, 9);
    const double bound = least_height(problem, least + 1);
    EXPECT_GT(bound, least - 1e-6) << k;
    EXPECT_LE(bound, least) << k;
  }
}

/// Lying they are 2 high, as they are given 3: the search finds what the proof asks for.
TEST(PackingLeastHeight, TurnedPartsLieDown) {
  const auto layout =
      packed(problem_of(3, 2, {with_turns(box("brick", 3, 1, 2, 3)), with_turns(box("rod", 1, 1, 1, 3))}));
  ASSERT_TRUE(layout);
  EXPECT_GT(layout->lower_bound.to_double(), layout->height.to_double() - 1e-6);
}

TEST(PackingLeastHeight, EqualPartsThatCannotStandSideBySide) {
  const auto layout = packed(problem_of(3, 3, {box("slab", 4, 2, 2, 1)}));
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->height, Fraction(4));
  EXPECT_GT(layout->lower_bound.to_double(), 4 - 1e-6);
}

/// Unions of convex parts: two angles lie in one another, 3 wide and 4 high; boxes of 3 x 3 would be 6 high.
TEST(PackingLeastHeight, PartsThatInterlock) {
  SolidPart angle = part_of("angle", 1, {block({0, 0, 0}, {3, 1, 1}), block({0, 0, 1}, {1, 1, 3})});
  SolidPart turned = part_of("turned", 1, {block({0, 0, 2}, {3, 1, 3}), block({2, 0, 0}, {3, 1, 2})});
  const auto layout = packed(problem_of(3, 1, {angle, turned}));
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->height, Fraction(4));
  EXPECT_GT(layout->lower_bound.to_double(), 4 - 1e-6);
}

/// A wedge of length 1 over the triangle from y = 0: its base at that height, its edge at the other.
space::BodyPart wedge(int base, int edge) {
  const std::vector<space::Point> corners{{0, 0, base}, {2, 0, base}, {1, 0, edge},
                                          {0, 1, base}, {2, 1, base}, {1, 1, edge}};
  return space::part_of(corners, {});
}

/// An hourglass that is turned on its side has the same corners, but its notch holds the wedge.
TEST(PackingLeastHeight, TurnsWhatHasTheSameCorners) {
  SolidPart hourglass = part_of("hourglass", 1, {wedge(0, 1), wedge(2, 1)});
  hourglass.forms.push_back(turned(hourglass.forms[0], {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}));
  const SolidProblem problem = problem_of(2, 1, {hourglass, part_of("wedge", 1, {wedge(1, 0)})});
  EXPECT_EQ(SolidTable(problem).variants_of(0).size(), 2U);
  const auto layout = packed(problem);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->height, Fraction(2));
  EXPECT_GT(layout->lower_bound.to_double(), 2 - 1e-6);
}

TEST(PackingLeastHeight, WhatIsNotTriedKeepsTheBoundOfVolumes) {
  const SolidProblem turns = problem_of(3, 3, {with_turns(box("brick", 4, 3, 2, 1))});
  EXPECT_TRUE(is_provable(turns, SolidTable(turns)));
  // Six forms of each: 252 ways of the first, 252 of the second.
  const SolidProblem ways =
      problem_of(3, 3, {with_turns(box("brick", 5, 3, 2, 1)), with_turns(box("rod", 5, 3, 2, 1))});
  EXPECT_FALSE(is_provable(ways, SolidTable(ways)));
  const SolidProblem many = problem_of(3, 3, {box("brick", 11, 3, 2, 1)});
  EXPECT_FALSE(is_provable(many, SolidTable(many)));
  const SolidProblem few = problem_of(3, 3, {box("brick", 10, 3, 2, 1)});
  EXPECT_TRUE(is_provable(few, SolidTable(few)));
}

/// What was found may keep no gap or condition: then it is no layout, and a higher one may be the lowest.
TEST(PackingLeastHeight, IsProvedWhereALayoutWasFound) {
  const SolidProblem problem = problem_of(3, 3, {box("slab", 2, 2, 2, 1)});
  const SolidTable table(problem);
  for (const bool is_layout : {true, false}) {
    LeastHeight proof(problem, table, 5);
    while (!proof.is_over())
      if (proof.search() && is_layout) proof.set_height(2);
    EXPECT_EQ(proof.is_proved(), is_layout);
    EXPECT_NEAR(proof.bound(), 2, 1e-6);
  }
}

/// Conditions that the first search does not come to keep have all the work that is left.
TEST(PackingLeastHeight, ConditionsThatAreHardToKeep) {
  SolidProblem problem = problem_of(6, 6, {box("a", 1, 3, 4, 1), box("b", 1, 3, 1, 1), box("c", 1, 3, 2, 4)});
  const char* const window = "gap(self, other) >= 1 and gap(self, other) <= 1.2";
  problem.conditions = {{2, 0, window}, {2, 1, window}};
  EXPECT_FALSE(packed(problem, 5e5));  // the share of the first search, below
  const auto layout = packed(problem, 5e6);
  ASSERT_TRUE(layout);
  EXPECT_NEAR(layout->height.to_double(), 6, 0.01);
}

/// As where the time is over before it begins.
TEST(PackingLeastHeight, IsAboveNothingBeforeItBegins) {
  const SolidProblem problem = problem_of(2, 2, {box("brick", 2, 1, 1, 1)});
  const SolidTable table(problem);
  EXPECT_EQ(LeastHeight(problem, table, 2).bound(), 0);
}

/// With a gap the bound is that without it; it stays below the layout.
TEST(PackingLeastHeight, GapsAreAboveTheBound) {
  SolidProblem problem = problem_of(3, 3, {box("slab", 3, 2, 2, 1)});
  problem.gap = 1;
  const auto layout = packed(problem);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->height, Fraction(5));
  EXPECT_GT(layout->lower_bound.to_double(), 3 - 1e-6);
  EXPECT_LE(layout->lower_bound, Fraction(3));
}

TEST(PackingLeastHeight, TheSameForAnyNumberOfThreads) {
  const SolidProblem problem =
      problem_of(4, 3, {box("a", 2, 3, 2, 1), box("b", 2, 1, 3, 2), box("c", 1, 2, 2, 3), box("d", 2, 2, 1, 1)});
  std::vector<SolidLayout> found;
  for (const unsigned threads : {1U, 2U}) {
    const plane::ThreadLimit limit(threads);
    found.push_back(*packed(problem));
  }
  EXPECT_EQ(found[0].height, found[1].height);
  EXPECT_EQ(found[0].lower_bound, found[1].lower_bound);
  for (std::size_t i = 0; i < found[0].items.size(); ++i) EXPECT_EQ(found[0].items[i].at, found[1].items[i].at);
}

}  // namespace packing_least_height
}  // namespace findspace::packing
