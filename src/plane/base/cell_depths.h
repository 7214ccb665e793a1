// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How deep each cell of a lattice lies among marked cells: the chessboard distance to a cell that is not marked, up to
// 255. Cost: two passes over the cells. Keywords: distance transform.
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
    return c >= 0 && r >= 0 && c < columns_ && r < rows_ ? depth_[std::size_t(r * columns_ + c)] : 0;
  }
  bool empty() const { return depth_.empty(); }
  /// One of the deepest cells; there are some.
  CellPlace deepest() const;

 private:
  std::int64_t column0_ = 0, row0_ = 0, columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> depth_;
};

}  // namespace findspace::plane
