// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Square cells of a lattice that certainly lie inside an open Minkowski sum: a cell inside int A, moved by a lattice
// point of B, is one, and so is a cell inside int B moved by a point of A. Points find what is thinner than a cell.
// What lies in such a cell cannot be boundary, so it need not be arranged. Guarantee: every marked cell, closed, lies
// in the open sum; cells may be missing. Only conservative double arithmetic; no sign is decided. Cost: that of
// lattice_runs.h and lattice_sum.h, capped, and the cells. Keywords: bitmap Minkowski sum, pruning, chessboard distance
// transform.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plane/base/cell_depths.h"
#include "plane/base/lattice_runs.h"

namespace findspace::plane {

class InnerMask {
 public:
  struct Pair {
    const Outline* a;
    const Outline* b;
    bool a_round = false, b_round = false;  // the outline is not exact: it stands for arcs that touch no other cells
  };
  /// For the union of the sums of the pairs; `side` is a number of grid steps above 2, `effort` about how many words to
  /// work on.
  InnerMask(std::span<const Pair> pairs, std::int64_t side, double effort);

  /// Lattice column and row of a coordinate; column c covers [border(c), border(c + 1)].
  std::int64_t line_of(double v) const { return floor_of(v * scale_); }
  std::int64_t border(std::int64_t line) const { return line * side_; }
  /// All cells less than so many columns and rows away are marked; 0 where the cell itself is not.
  std::int64_t depth(std::int64_t column, std::int64_t row) const {
    const std::int64_t depth = depths_.depth(column, row);
    return depth > 0 || !within_ ? depth : depth_beyond(column, row);
  }
  /// Marks all cells beyond the box: they are known to lie inside.
  void mark_beyond(const LatticeBox& within) { within_ = within; }
  const std::optional<LatticeBox>& within() const { return within_; }

 private:
  /// Of a cell beyond the box.
  std::int64_t depth_beyond(std::int64_t column, std::int64_t row) const {
    return std::max({within_->column0 - column, column - within_->column1, within_->row0 - row, row - within_->row1,
                     std::int64_t(0)});
  }

  std::int64_t side_;
  double scale_;
  CellDepths depths_;
  std::optional<LatticeBox> within_;
};

}  // namespace findspace::plane
