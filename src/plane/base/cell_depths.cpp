// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/cell_depths.h"

#include <algorithm>

namespace findspace::plane {

CellDepths::CellDepths(const Bitmap& cells) {
  const LatticeBox& box = cells.box();
  row0_ = box.row0;
  rows_ = box.row1 - box.row0 + 1;
  column0_ = box.column0;
  columns_ = box.column1 - box.column0 + 1;
  depth_.resize(std::size_t(columns_ * rows_));
  auto at = [&](std::int64_t r, std::int64_t c) -> std::uint8_t& { return depth_[std::size_t(r * columns_ + c)]; };
  auto grown = [](int least) { return std::uint8_t(std::min(1 + least, 255)); };
  // The chessboard distance to a cell that is not marked, by one pass from each corner; cells outside are not marked.
  for (std::int64_t r = 0; r < rows_; ++r)
    for (std::int64_t c = 0; c < columns_; ++c) {
      if (!cells.holds(row0_ + r, column0_ + c)) continue;
      bool edge = r == 0 || r == rows_ - 1 || c == 0 || c == columns_ - 1;
      at(r, c) = edge ? 1 : grown(std::min({at(r - 1, c - 1), at(r - 1, c), at(r - 1, c + 1), at(r, c - 1)}));
    }
  for (std::int64_t r = rows_ - 1; r-- > 1;)
    for (std::int64_t c = columns_ - 1; c-- > 1;) {
      std::uint8_t& d = at(r, c);
      if (d > 1) d = std::min(d, grown(std::min({at(r + 1, c - 1), at(r + 1, c), at(r + 1, c + 1), at(r, c + 1)})));
    }
}

}  // namespace findspace::plane
