// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Runs of lattice cells and points inside polygons, their sums as bits, and depths, against the definitions.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "plane/base/bitmap.h"
#include "plane/base/lattice_runs.h"
#include "plane/grid/inner_mask.h"
#include "plane/grid/lattice_sum.h"

namespace findspace::plane {
namespace plane_lattice {

using Place = std::pair<std::int64_t, std::int64_t>;  // row, column

/// A ring round the origin with its corners on the grid, and a hole when asked.
Outline ring(std::mt19937& rng, int corners, double radius, bool hole) {
  Outline out;
  std::uniform_real_distribution<double> reach(0.4, 1);
  auto add = [&](double scale) {
    std::vector<std::pair<double, double>> points;
    for (int k = 0; k < corners; ++k) {
      double angle = 2 * M_PI * k / corners, r = radius * scale * reach(rng);
      points.push_back({std::round(r * std::cos(angle)), std::round(r * std::sin(angle))});
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
      auto [x1, y1] = points[(k + 1) % points.size()];
      out.push_back({points[k].first, points[k].second, x1, y1});
    }
  };
  add(1);
  if (hole) add(0.3);
  return out;
}

/// Even-odd, just above the point.
bool inside(const Outline& outline, double x, double y) {
  bool in = false;
  for (const LatticeEdge& e : outline)
    if ((e.y0 <= y) != (e.y1 <= y) && e.x0 + (e.x1 - e.x0) * (y - e.y0) / (e.y1 - e.y0) < x) in = !in;
  return in;
}

double distance(const LatticeEdge& e, double x, double y) {
  double dx = e.x1 - e.x0, dy = e.y1 - e.y0, l2 = dx * dx + dy * dy;
  double t = l2 > 0 ? std::clamp(((x - e.x0) * dx + (y - e.y0) * dy) / l2, 0.0, 1.0) : 0;
  return std::hypot(e.x0 + t * dx - x, e.y0 + t * dy - y);
}

double clearance(const Outline& outline, double x, double y) {
  double least = INFINITY;
  for (const LatticeEdge& e : outline) least = std::min(least, distance(e, x, y));
  return least;
}

/// Does the edge come into the closed square?
bool touches(const LatticeEdge& e, double x, double y, double side) {
  double from = 0, to = 1, dx = e.x1 - e.x0, dy = e.y1 - e.y0;
  for (auto [start, step, low] : {std::tuple(e.x0, dx, x), std::tuple(e.y0, dy, y)}) {
    if (step == 0) {
      if (start < low || start > low + side) return false;
      continue;
    }
    double a = (low - start) / step, b = (low + side - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

std::set<Place> places(const std::vector<LatticeRun>& runs) {
  std::set<Place> out;
  for (const LatticeRun& r : runs)
    for (std::int64_t c = r.first; c <= r.last; ++c) EXPECT_TRUE(out.insert({r.row, c}).second) << "twice";
  return out;
}

TEST(LatticeRuns, CellsAreThoseNoEdgeTouches) {
  std::mt19937 rng(1);
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    Outline outline = ring(rng, 3 + round % 12, 1000, round % 2);
    double side = 40 + round;
    auto cells = places(cell_runs(outline, side));
    found += cells.size();
    std::int64_t most = std::int64_t(1000 / side) + 2;
    for (std::int64_t r = -most; r < most; ++r)
      for (std::int64_t c = -most; c < most; ++c) {
        double x = double(c) * side, y = double(r) * side;
        bool free = inside(outline, x + side / 2, y + side / 2), close = false;
        for (const LatticeEdge& e : outline) {
          free = free && !touches(e, x, y, side);
          close = close || touches(e, x - side / 30, y - side / 30, side * 16 / 15);
        }
        EXPECT_TRUE(free || !cells.count({r, c})) << r << " " << c;
        EXPECT_TRUE(cells.count({r, c}) || !free || close) << r << " " << c;
      }
  }
  EXPECT_GT(found, 5000u);
}

TEST(LatticeRuns, PointsBelongToThePolygon) {
  std::mt19937 rng(2);
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    Outline outline = ring(rng, 3 + round % 12, 1000, round % 2);
    double side = 40 + round;
    auto points = places(point_runs(outline, side));
    found += points.size();
    std::int64_t most = std::int64_t(1000 / side) + 2;
    for (std::int64_t r = -most; r < most; ++r)
      for (std::int64_t c = -most; c < most; ++c) {
        double x = double(c) * side, y = double(r) * side, room = clearance(outline, x, y);
        bool in = inside(outline, x, y) || room < 1e-9;
        EXPECT_TRUE(in || !points.count({r, c})) << r << " " << c;
        EXPECT_TRUE(!(in && room > side) || points.count({r, c})) << r << " " << c;
      }
  }
  EXPECT_GT(found, 5000u);
}

TEST(LatticeRuns, PointsOnHorizontalEdgesBelongToTheSetBelowOrAbove) {
  Outline square{{0, 0, 100, 0}, {100, 0, 100, 100}, {100, 100, 0, 100}, {0, 100, 0, 0}};
  auto points = places(point_runs(square, 10));
  EXPECT_TRUE(points.count({0, 5}));    // on the lower edge: the set is above
  EXPECT_FALSE(points.count({10, 5}));  // on the upper one: not found, as it may be
  EXPECT_TRUE(points.count({9, 5}));
  EXPECT_FALSE(points.count({11, 5}));
}

std::vector<LatticeRun> random_runs(std::mt19937& rng, int rows, int width) {
  std::vector<LatticeRun> runs;
  for (int r = 0; r < rows; ++r)
    for (std::int64_t c = -std::int64_t(rng() % 90); c < width; c += 2 + std::int64_t(rng() % 40)) {
      std::int64_t last = c + std::int64_t(rng() % 30);
      runs.push_back({r - 3, c, last});
      c = last;
    }
  return runs;
}

TEST(LatticeSum, IsTheSetOfSums) {
  std::mt19937 rng(3);
  for (int round = 0; round < 40; ++round) {
    auto points = random_runs(rng, 3, 70 + 20 * round), cells = random_runs(rng, 4, 300);
    LatticeBox box = LatticeBox::around(points) + LatticeBox::around(cells);
    Bitmap sums(box);
    const LatticeSum sum{points, cells};
    add_sums(std::span(&sum, 1), sums);
    std::set<Place> expected;
    for (const LatticeRun& p : points)
      for (const LatticeRun& c : cells)
        for (std::int64_t k = p.first + c.first; k <= p.last + c.last; ++k) expected.insert({p.row + c.row, k});
    for (std::int64_t r = box.row0; r <= box.row1; ++r)
      for (std::int64_t c = box.column0; c <= box.column1; ++c)
        ASSERT_EQ(sums.holds(r, c), expected.count({r, c}) == 1) << round << ": " << r << " " << c;
  }
}

TEST(LatticeSum, WithAFilledMiddle) {
  std::mt19937 rng(6);
  for (int round = 0; round < 8; ++round) {
    auto points = random_runs(rng, 50, 100 + 100 * round), cells = random_runs(rng, 40, 500);
    LatticeBox box = LatticeBox::around(points) + LatticeBox::around(cells);
    Bitmap sums(box);
    const LatticeSum sum{points, cells};
    add_sums(std::span(&sum, 1), sums);
    const std::int64_t columns = box.column1 - box.column0 + 1;
    std::vector<char> expected(std::size_t((box.row1 - box.row0 + 1) * columns));
    for (const LatticeRun& p : points)
      for (const LatticeRun& c : cells) {
        auto line = expected.begin() + (p.row + c.row - box.row0) * columns - box.column0;
        std::fill(line + p.first + c.first, line + p.last + c.last + 1, 1);
      }
    for (std::int64_t r = box.row0; r <= box.row1; ++r)
      for (std::int64_t c = box.column0; c <= box.column1; ++c)
        ASSERT_EQ(sums.holds(r, c), expected[std::size_t((r - box.row0) * columns + c - box.column0)] == 1)
            << round << ": " << r << " " << c;
  }
}

TEST(LatticeSum, OfRowsWithoutGapsAddedToOneMap) {
  std::mt19937 rng(8);
  const auto within = [&](int low, int high) { return std::int64_t(low + int(rng() % unsigned(high - low + 1))); };
  for (int round = 0; round < 200; ++round) {
    std::array<std::vector<LatticeRun>, 2> points, cells;
    LatticeBox box;
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::int64_t row = 0; row < 6; ++row) {
        points[k].push_back({row, within(-90, -40), within(-30, 60)});
        if (within(0, 1) == 0) points[k].push_back({row, within(70, 80), within(81, 300)});
        cells[k].push_back({row, within(0, 100), within(101, 101 + round)});
        if (within(0, 1) == 0) cells[k].push_back({row, within(310, 330), within(331, 400)});
      }
      box.add(LatticeBox::around(points[k]) + LatticeBox::around(cells[k]));
    }
    Bitmap sums(box), expected(box);
    add_sums(std::array<LatticeSum, 2>{{{points[0], cells[0]}, {points[1], cells[1]}}}, sums);
    for (std::size_t k = 0; k < 2; ++k) {
      for (const LatticeRun& p : points[k])
        for (const LatticeRun& c : cells[k]) expected.add({p.row + c.row, p.first + c.first, p.last + c.last});
    }
    for (std::int64_t r = box.row0; r <= box.row1; ++r)
      for (std::int64_t c = box.column0; c <= box.column1; ++c)
        ASSERT_EQ(sums.holds(r, c), expected.holds(r, c)) << round << ": " << r << " " << c;
  }
}

TEST(InnerMask, DepthIsTheDistanceToACellThatIsNotMarked) {
  std::mt19937 rng(4);
  Outline a = ring(rng, 7, 2000, true), b = ring(rng, 9, 700, false);
  InnerMask::Pair pair{&a, &b};
  InnerMask mask(std::span(&pair, 1), 50, 1e9);
  std::int64_t deepest = 0;
  for (std::int64_t r = -60; r < 60; ++r)
    for (std::int64_t c = -60; c < 60; ++c) {
      std::int64_t depth = mask.depth(c, r), least = 300;
      for (std::int64_t s = r - 60; s <= r + 60; ++s)
        for (std::int64_t d = c - 60; d <= c + 60; ++d)
          if (mask.depth(d, s) == 0) least = std::min(least, std::max(std::abs(s - r), std::abs(d - c)));
      deepest = std::max(deepest, depth);
      ASSERT_EQ(depth, least) << r << " " << c;
    }
  EXPECT_GT(deepest, 10);
}

TEST(InnerMask, MarkedCellsAreSumsOfPointsInside) {
  std::mt19937 rng(5);
  for (int round = 0; round < 10; ++round) {
    Outline a = ring(rng, 5 + round, 1500, round % 2), b = ring(rng, 4 + round, 600, round % 3 == 0);
    InnerMask::Pair pair{&a, &b};
    double side = 60;
    InnerMask mask(std::span(&pair, 1), 60, 1e9);
    auto in_sum = [&](double x, double y) {
      for (double u = -1500; u <= 1500; u += 10)
        for (double v = -1500; v <= 1500; v += 10)
          if (inside(a, u, v) && inside(b, x - u, y - v)) return true;
      return false;
    };
    std::uniform_int_distribution<std::int64_t> any(-36, 35);
    for (int k = 0; k < 60; ++k) {
      std::int64_t c = any(rng), r = any(rng);
      if (mask.depth(c, r) == 0) continue;
      for (auto [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)})
        EXPECT_TRUE(in_sum((double(c) + dx) * side, (double(r) + dy) * side)) << round << ": " << c << " " << r;
    }
  }
}

}  // namespace plane_lattice
}  // namespace findspace::plane
