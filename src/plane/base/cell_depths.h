// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep each cell of a lattice lies among marked cells: the chessboard distance to a cell that is not marked, up to
// 255. Cost: two passes over the cells, 16 at a time; of many cells, blocks of rows at once, and then what lies beyond
// their borders is looked at. Keywords: distance transform.
#pragma once

#include <cstdint>
#include <memory>

#include "plane/base/bitmap.h"
#include "plane/base/parallel.h"

namespace findspace::plane {

struct CellPlace {
  std::int64_t column, row;
};

class CellDepths {
 public:
  /// No cell is marked.
  CellDepths() = default;
  explicit CellDepths(const Bitmap& cells);

  /// All cells less than so many columns and rows away are marked; 0 where the cell itself is not.
  std::int64_t depth(std::int64_t column, std::int64_t row) const {
    const std::int64_t c = column - column0_, r = row - row0_;
    return c >= 0 && r >= 0 && c < columns_ && r < rows_ ? depth_[place(r, c)] : 0;
  }
  bool empty() const { return depth_ == nullptr; }
  /// One of the deepest cells; there are some.
  CellPlace deepest() const;

 private:
  /// Rows are whole vectors, with one of 0 before and after each; a row of 0 lies before the first and after the last.
  std::size_t place(std::int64_t row, std::int64_t column) const {
    return std::size_t((row + 1) * stride_ + kBeside + column);
  }
  std::uint8_t* row(std::size_t row) { return &depth_[place(std::int64_t(row), 0)]; }
  /// Of the cells of a block as if all rows before and after it were marked. `deep`: a row of cells that are.
  void find(const Bitmap& cells, IndexRange block, const std::uint8_t* deep);
  void limit_blocks(std::size_t blocks);
  /// Takes the rows just before and after the block into account; null: there is none.
  void limit(IndexRange block, const std::uint8_t* above, const std::uint8_t* below);
  /// No cell is deeper than one more than those beside it in another row; whether one was.
  bool limit(std::uint8_t* row, const std::uint8_t* by) const;

  static constexpr std::int64_t kBeside = 16;
  std::int64_t column0_ = 0, row0_ = 0, columns_ = 0, rows_ = 0, stride_ = 0;
  std::unique_ptr<std::uint8_t[]> depth_;  // written first where it is worked on
};

}  // namespace findspace::plane
