// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/cell_depths.h"

#include <algorithm>
#include <span>

namespace findspace::plane {

namespace {

/// Of each cell of a row the least of the three beside it in another row; cells outside count 0.
void least_of_three(std::span<const std::uint8_t> row, std::span<std::uint8_t> least) {
  const std::size_t last = row.size() - 1;
  least[0] = least[last] = 0;
  for (std::size_t c = 1; c < last; ++c) least[c] = std::min(std::min(row[c - 1], row[c]), row[c + 1]);
}

std::uint8_t grown(std::uint8_t least) { return std::uint8_t(least + (least < 255)); }

}  // namespace

CellDepths::CellDepths(const Bitmap& cells) {
  const LatticeBox& box = cells.box();
  row0_ = box.row0;
  rows_ = box.row1 - box.row0 + 1;
  column0_ = box.column0;
  columns_ = box.column1 - box.column0 + 1;
  depth_.resize(std::size_t(columns_ * rows_));
  const auto row = [&](std::int64_t r) {
    return std::span(depth_).subspan(std::size_t(r * columns_), std::size_t(columns_));
  };
  // The chessboard distance to a cell that is not marked, by one pass from each corner; cells outside are not marked.
  std::vector<std::uint8_t> least(std::size_t(columns_), 0);
  for (std::int64_t r = 0; r < rows_; ++r) {
    const auto now = row(r);
    const std::uint64_t* bits = cells.line(row0_ + r);
    std::uint8_t beside = 0;
    for (std::size_t c = 0; c < now.size(); ++c) {
      const bool marked = bits[c / 64] >> (c % 64) & 1u;
      beside = marked ? grown(std::min(least[c], beside)) : std::uint8_t(0);
      now[c] = beside;
    }
    least_of_three(now, least);
  }
  std::fill(least.begin(), least.end(), std::uint8_t(0));
  for (std::int64_t r = rows_; r-- > 0;) {
    const auto now = row(r);
    std::uint8_t beside = 0;
    for (std::size_t c = now.size(); c-- > 0;) {
      beside = std::min(now[c], grown(std::min(least[c], beside)));
      now[c] = beside;
    }
    least_of_three(now, least);
  }
}

CellPlace CellDepths::deepest() const {
  const auto at = std::max_element(depth_.begin(), depth_.end()) - depth_.begin();
  return {column0_ + at % columns_, row0_ + at / columns_};
}

}  // namespace findspace::plane
