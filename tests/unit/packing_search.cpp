// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Depths of overlaps, linear programs, and searches that must find what is known.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <random>
#include <thread>

#include "packing/compaction/finish.h"
#include "packing/proof/verify.h"
#include "packing/search/hidden_room.h"
#include "packing/search/island_team.h"
#include "packing/search/strip_search.h"

namespace findspace::packing {
namespace packing_search {

Polygon box(int w, int h) { return make_polygon({{{0, 0}, {w, 0}, {w, h}, {0, h}}}, "box"); }

Problem problem_of(int height, std::vector<Part> parts) {
  Problem problem;
  problem.height = height;
  problem.parts = std::move(parts);
  return problem;
}

Layout found(const Problem& problem, std::uint64_t seed, unsigned threads, double work) {
  const std::atomic<bool> stop = false;
  SearchOptions options;
  options.seed = seed;
  options.threads = threads;
  options.work = work;
  return *search_strip(problem, options, {}, stop);
}

TEST(Polygon, ManyDegreesAreTheirRemainder) {
  const Polygon square = box(2'000'000, 2'000'000);
  for (const std::int64_t by : {30, -30, 359})
    EXPECT_EQ(rotated(square, Fraction(360 * power_of_ten(15) + by, 1), false).rings, rotated(square, by, false).rings);
}

TEST(DepthField, OfTwoSquares) {
  const SearchShape square = search_shape(Problem{}, box(2, 2));
  const DepthField field(no_fit_polygon(square, square, 0));
  EXPECT_DOUBLE_EQ(field.depth({0, 0}), 2);
  EXPECT_DOUBLE_EQ(field.depth({1.5, 0.25}), 0.5);
  EXPECT_EQ(field.depth({2.5, 0}), 0);
  EXPECT_EQ(field.depth({50, 0}), 0);
}

TEST(DepthField, IsTheDistanceToTheBoundary) {
  const Polygon angle = make_polygon({{{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}}}, "angle");
  const SearchShape a = search_shape(Problem{}, angle), b = search_shape(Problem{}, rotated(angle, 180, false));
  const DepthField field(no_fit_polygon(a, b, 0));
  const Vec shift{3, -2};
  const DepthGlance glance = field.glance(1, {}), turned = field.glance(-1, shift);
  for (int i = -60; i < 120; ++i)
    for (int j = -60; j < 120; ++j) {
      const Vec at{0.1 * i + 0.013, 0.1 * j + 0.017};
      double nearest = 1e9;
      for (const NoFitEdge& e : field.polygon().edges) {
        const Vec way = e.to - e.from, off = at - e.from;
        const double along = std::clamp(dot(off, way) / dot(way, way), 0.0, 1.0);
        const Vec rest = off - along * way;
        nearest = std::min(nearest, std::sqrt(dot(rest, rest)));
      }
      const double depth = field.depth(at);
      if (depth > 0) {
        EXPECT_NEAR(depth, nearest, 1e-9);
      }
      const int cell = glance.cell_at(at);
      EXPECT_EQ(turned.cell_at(shift - at), cell);
      EXPECT_LE(cell == DepthGlance::kNone ? 0 : glance.least(cell), depth + 1e-9);
    }
}

TEST(DepthField, KeepsASlit) {
  const Polygon frame = make_polygon({{{0, 0}, {6, 0}, {6, 9}, {0, 9}}, {{2, 2}, {4, 2}, {4, 7}, {2, 7}}}, "frame");
  const DepthField field(no_fit_polygon(search_shape(Problem{}, frame), search_shape(Problem{}, box(2, 2)), 0));
  EXPECT_NEAR(field.depth({2, 3}), 0, 1e-12);
  EXPECT_NEAR(field.depth({2.25, 3}), 0.25, 1e-12);
  EXPECT_NEAR(field.depth({2, 1.5}), 0.5, 1e-12);
}

TEST(LinearMoves, PushBoxesTogether) {
  const Problem problem = problem_of(3, {{"box", 3, box(2, 3), {0}}});
  const FieldTable table(problem);
  const Row row(problem, table, {});
  std::vector<Pose> poses{{0, {0.3, 0}}, {0, {2.5, 0}}, {0, {4.9, 0}}};
  EXPECT_NEAR(LinearMoves(table, row).shorten(poses, 7), 6, 1e-6);
  EXPECT_TRUE(finished(problem, table, row, poses, 6).has_value());
}

TEST(LinearMoves, SeparateAnOverlap) {
  const Problem problem = problem_of(3, {{"box", 2, box(2, 3), {0}}});
  const FieldTable table(problem);
  const Row row(problem, table, {});
  std::vector<Pose> poses{{0, {0, 0}}, {0, {1.97, 0}}};
  double length = 4;
  EXPECT_TRUE(LinearMoves(table, row).separate(poses, length, 4));
  EXPECT_LE(table.depth(poses[0], poses[1]), 1e-8);
  std::vector<Pose> tight{{0, {0, 0}}, {0, {1.9, 0}}};
  length = 3.9;
  EXPECT_FALSE(LinearMoves(table, row).separate(tight, length, 3.95));
  EXPECT_TRUE(LinearMoves(table, row).separate(tight, length, 4.5));
  EXPECT_NEAR(length, 4, 1e-6);
}

TEST(Search, BoxesWithoutClearance) {
  const Problem problem = problem_of(4, {{"domino", 8, box(1, 2), {0, 90}}, {"square", 2, box(2, 2), {0}}});
  const Layout layout = found(problem, 1, 1, 3e7);
  EXPECT_EQ(layout.length, Fraction(6));
  EXPECT_TRUE(verify(problem, layout).feasible());
}

TEST(Search, APartInAHoleWithoutClearance) {
  const Polygon frame = make_polygon({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}}, "frame");
  const Problem problem = problem_of(6, {{"frame", 2, frame, {0}}, {"plug", 2, box(2, 2), {0}}});
  const Layout layout = found(problem, 1, 1, 3e7);
  EXPECT_EQ(layout.length, Fraction(12));
}

TEST(Search, IsRepeated) {
  const Polygon triangle = make_polygon({{{0, 0}, {5, 0}, {1, 4}}}, "triangle");
  const Problem problem = problem_of(9, {{"triangle", 7, triangle, {0, 180}}, {"box", 3, box(3, 2), {0, 90}}});
  for (const unsigned threads : {1u, 2u}) {
    const Layout once = found(problem, 7, threads, 7e6), again = found(problem, 7, threads, 7e6);
    EXPECT_EQ(once.length, again.length);
    for (std::size_t i = 0; i < once.items.size(); ++i) EXPECT_EQ(once.items[i].x, again.items[i].x);
  }
}

TEST(Search, WhatCannotBePacked) {
  const std::atomic<bool> stop = false;
  EXPECT_FALSE(search_strip(problem_of(3, {{"box", 0, box(1, 1), {0}}}), {}, {}, stop).has_value());
  EXPECT_THROW(search_strip(problem_of(3, {{"tall", 1, box(1, 4), {0, 180}}}), {}, {}, stop), Error);
}

/// Where nothing limits it, it would wait for half a minute.
TEST(Search, EndsWhereNoLayoutIsShorter) {
  Problem problem;
  problem.height = 4;
  problem.parts = {{"post", 2, make_polygon({{{0, 0}, {2, 0}, {2, 4}, {0, 4}}}, "post"), {90}}};
  const std::atomic<bool> stop = false;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(search_strip(problem, {}, {}, stop).value().length, Fraction(4));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(Search, WithoutLimitsProgressIsTheWaiting) {
  const std::atomic<bool> stop = false;
  SearchLimits limits(0, 0, stop);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const double waited = limits.progress(1e9);
  EXPECT_GT(waited, 0.0016);
  EXPECT_FALSE(limits.is_over(1e9));
  limits.note_better();
  EXPECT_LT(limits.progress(1e9), waited);
}

TEST(Search, StopsAtOnceWithALayout) {
  const std::atomic<bool> stop = true;
  const Problem problem = problem_of(5, {{"box", 6, box(2, 3), {0, 90}}});
  const auto layout = search_strip(problem, {}, {}, stop);
  ASSERT_TRUE(layout.has_value());
  EXPECT_TRUE(verify(problem, *layout).feasible());
}

/// Poses of the first variant of each part.
std::vector<Pose> standing(const FieldTable& table, const std::vector<Vec>& at) {
  std::vector<Pose> poses;
  for (std::size_t part = 0; part < at.size(); ++part) poses.push_back({table.variants_of(part)[0], at[part]});
  return poses;
}

TEST(HiddenRoom, InHolesAndClosedPockets) {
  const Polygon frame = make_polygon({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{2, 1}, {5, 1}, {5, 5}, {2, 5}}}, "frame");
  const Polygon hook = make_polygon({{{0, 0}, {4, 0}, {4, 6}, {0, 6}, {0, 4}, {3, 4}, {3, 1}, {0, 1}}}, "hook");
  const Problem problem = problem_of(6, {{"frame", 1, frame, {0}},
                                         {"hook", 1, hook, {0}},
                                         {"plug", 1, box(3, 4), {0, 90}},
                                         {"dot", 1, box(3, 3), {0}},
                                         {"wide", 1, box(4, 4), {0}}});
  const FieldTable table(problem);
  const Row row(problem, table, {});
  const Arrangement arrangement(table, row, standing(table, {{0, 0}, {6, 0}, {10, 0}, {13, 0}, {16, 0}}), 20);
  HiddenRoom room(row);
  const auto plug = room.find(arrangement, 2), dot = room.find(arrangement, 3), wide = room.find(arrangement, 4);
  ASSERT_TRUE(plug && dot);
  EXPECT_NEAR(plug->at.x, 2, 1e-9);  // into the hole of the frame, without any room
  EXPECT_NEAR(plug->at.y, 1, 1e-9);
  EXPECT_EQ(plug->variant, table.variants_of(2)[0]);
  EXPECT_NEAR(dot->at.x, 2, 1e-9);
  EXPECT_GT(room.looked_at(), 0u);
  EXPECT_FALSE(wide.has_value());
  const Arrangement filled(table, row, standing(table, {{0, 0}, {6, 0}, {2, 1}, {13, 0}, {16, 0}}), 20);
  const auto pocket = room.find(filled, 3);
  ASSERT_TRUE(pocket);
  EXPECT_NEAR(pocket->at.x, 6, 1e-9);  // between the frame and the hook
  EXPECT_NEAR(pocket->at.y, 1, 1e-9);
  EXPECT_FALSE(room.find(arrangement, 0).has_value());
}

/// The place found is free, and none of many random ones that are free ends farther back.
TEST(HiddenRoom, NothingFreeEndsFartherBack) {
  std::mt19937_64 random(11);
  const auto below = [&](int n) { return std::int64_t(random() % std::uint64_t(n)); };
  int hidden = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Part> parts;
    std::vector<Vec> at;
    for (int k = 0; k < 5; ++k) {
      const std::int64_t w = 4 + below(5), h = 6 + below(6), x = 1 + below(int(w) - 2), y = 1 + below(int(h) - 2);
      parts.push_back({"L", 1, make_polygon({{{0, 0}, {w, 0}, {w, y}, {x, y}, {x, h}, {0, h}}}, "L"), {0}});
      at.push_back({9.0 * k + double(below(2)), double(below(3))});
    }
    parts.push_back({"small", 1, make_polygon({{{0, 0}, {3, 1}, {2, 3}}}, "small"), {0, 90, 180}});
    at.push_back({50, 0});
    const Problem problem = problem_of(14, std::move(parts));
    const FieldTable table(problem);
    const Row row(problem, table, {});
    Arrangement arrangement(table, row, standing(table, at), 60);
    ASSERT_EQ(arrangement.loss(), 0);
    const auto found = HiddenRoom(row).find(arrangement, 5);
    const auto end = [&](const Pose& pose) { return pose.at.x + table.variants()[pose.variant].high.x; };
    if (found) EXPECT_LT(arrangement.cost(5, *found, 1), 1e-9);
    for (int k = 0; k < 2000; ++k) {
      const std::size_t v = table.variants_of(5)[std::size_t(below(3))];
      const Variant& shape = table.variants()[v];
      const Pose pose{v, {0.01 * double(below(5000)) - shape.low.x, 0.01 * double(below(1400)) - shape.low.y}};
      if (pose.at.y + shape.high.y > 14 || end(pose) > 50 || arrangement.cost(5, pose, 1) > 0) continue;
      ASSERT_TRUE(found);
      EXPECT_LE(end(*found), end(pose) + 1e-9);
    }
    hidden += found.has_value();
  }
  EXPECT_GT(hidden, 50);
}

}  // namespace packing_search
}  // namespace findspace::packing
