// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep cells lie among marked ones, against a look at all cells around: rows shorter and longer than the vectors
// they are worked on in, holes, and depths that reach the most that is told. Also that two threads find the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <utility>

#include "plane/base/cell_depths.h"
#include "plane/base/parallel.h"

namespace findspace::plane {
namespace plane_cell_depths {

bool is_marked(const Bitmap& cells, std::int64_t column, std::int64_t row) {
  const LatticeBox& b = cells.box();
  return row >= b.row0 && row <= b.row1 && column >= b.column0 && column <= b.column1 && cells.holds(row, column);
}

/// By growing a square while its rim is marked.
std::int64_t depth(const Bitmap& cells, std::int64_t column, std::int64_t row) {
  for (std::int64_t d = 0; d < 255; ++d)
    for (std::int64_t k = -d; k <= d; ++k)
      if (!is_marked(cells, column + k, row - d) || !is_marked(cells, column + k, row + d) ||
          !is_marked(cells, column - d, row + k) || !is_marked(cells, column + d, row + k))
        return d;
  return 255;
}

void expect_depths(const Bitmap& cells) {
  const CellDepths depths(cells);
  const LatticeBox& b = cells.box();
  std::int64_t most = 0;
  for (std::int64_t r = b.row0 - 2; r <= b.row1 + 2; ++r)
    for (std::int64_t c = b.column0 - 2; c <= b.column1 + 20; ++c) {
      ASSERT_EQ(depths.depth(c, r), depth(cells, c, r)) << c << ' ' << r;
      most = std::max(most, depths.depth(c, r));
    }
  if (most == 0) return;
  const CellPlace deep = depths.deepest();
  EXPECT_EQ(depths.depth(deep.column, deep.row), most);
}

Bitmap full(std::int64_t columns, std::int64_t rows) {
  LatticeBox box;
  box.row0 = -3;
  box.row1 = rows - 4;
  box.column0 = 7;
  box.column1 = columns + 6;
  Bitmap cells(box);
  for (std::int64_t r = box.row0; r <= box.row1; ++r) cells.add({r, box.column0, box.column1});
  return cells;
}

TEST(CellDepths, None) {
  const CellDepths none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.depth(0, 0), 0);
}

TEST(CellDepths, AllMarked) {
  for (const std::int64_t columns : {1, 2, 15, 16, 17, 31, 32, 33, 63, 64, 65}) expect_depths(full(columns, 20));
}

TEST(CellDepths, TheMostThatIsTold) {
  const CellDepths depths(full(520, 530));
  EXPECT_EQ(depths.depth(7 + 259, 260), 255);
  EXPECT_EQ(depths.depth(7 + 253, 260), 254);
  EXPECT_EQ(depths.depth(7 + 254, 260), 255);
}

TEST(CellDepths, AtRandom) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 60; ++trial) {
    LatticeBox box;
    box.row0 = 5;
    box.row1 = 5 + std::int64_t(random() % 40);
    box.column0 = -4;
    box.column1 = -4 + std::int64_t(random() % 90);
    Bitmap cells(box);
    const auto columns = std::uint32_t(box.column1 - box.column0 + 1);
    for (std::int64_t r = box.row0; r <= box.row1; ++r)
      for (int k = 0; k < 3; ++k) {
        const std::int64_t p = box.column0 + random() % columns, q = box.column0 + random() % columns;
        if (random() % 8 != 0) cells.add({r, std::min(p, q), std::max(p, q)});
      }
    expect_depths(cells);
  }
}

/// Rows are divided into two blocks, and into more, where two threads are at work.
TEST(CellDepths, OfBlocksOfRows) {
  std::mt19937 random(2);
  const auto below = [&](int end) { return std::int64_t(random() % unsigned(end)); };
  for (const auto& [columns, rows] : {std::pair{170, 300}, {900, 101}, {64, 1100}, {700, 1700}}) {
    Bitmap cells = full(columns, rows);
    for (int round = 0; round < 4; ++round) {
      std::optional<ThreadLimit> threads(1);
      const CellDepths one(cells);
      threads.emplace(2);
      const CellDepths two(cells);
      for (std::int64_t r = 0; r < rows; ++r)
        for (std::int64_t c = 0; c < columns; ++c)
          ASSERT_EQ(one.depth(7 + c, r - 3), two.depth(7 + c, r - 3)) << columns << ": " << c << ' ' << r;
      for (int k = 0; k < 3; ++k) {
        const std::int64_t c = below(columns);
        cells.line(below(rows) - 3)[c / 64] &= ~(std::uint64_t(1) << (c % 64));
      }
    }
  }
}

}  // namespace plane_cell_depths
}  // namespace findspace::plane
