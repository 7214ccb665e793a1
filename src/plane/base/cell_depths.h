// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep each cell of a lattice lies among marked cells: the chessboard distance to a cell that is not marked, up to
// 255. Cost: two passes over the cells, 16 at a time. Keywords: distance transform.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/base/bitmap.h"

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
  bool empty() const { return depth_.empty(); }
  /// One of the deepest cells; there are some.
  CellPlace deepest() const;

 private:
  /// Rows are whole vectors, with a 0 at least after each; a row of 0 lies before the first and after the last.
  std::size_t place(std::int64_t row, std::int64_t column) const {
    return std::size_t(kBefore + (row + 1) * stride_ + column);
  }

  static constexpr std::int64_t kBefore = 16;
  std::int64_t column0_ = 0, row0_ = 0, columns_ = 0, rows_ = 0, stride_ = 0;
  std::vector<std::uint8_t> depth_;
};

}  // namespace findspace::plane
