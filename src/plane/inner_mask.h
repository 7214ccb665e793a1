// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Square cells that certainly lie inside an open Minkowski sum: cells of a lattice that lie inside A and inside B add
// up to squares of twice the side inside A (+) B, each of which has one cell of the half-shifted lattice strictly
// inside. What lies in such a cell cannot be boundary, so it need not be arranged. Guarantee: every marked cell,
// closed, lies in the open sum; cells may be missing. Only conservative double arithmetic; no sign is decided. Cost:
// edges * rows + (runs of A) * (runs of B), capped. Keywords: bitmap Minkowski sum, conservative rasterisation,
// pruning.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace findspace::plane {

struct LatticeEdge {
  double x0, y0, x1, y1;
};

/// The edges of a closed set's boundary, even-odd.
using Outline = std::vector<LatticeEdge>;

class InnerMask {
 public:
  /// For the union of the sums of the pairs; `side` is an even number of grid steps.
  struct Pair {
    const Outline* a;
    const Outline* b;
  };
  InnerMask(std::span<const Pair> pairs, std::int64_t side);

  /// Lattice column and row of a coordinate; column c covers [border(c), border(c + 1)].
  std::int64_t line_of(double v) const;
  std::int64_t border(std::int64_t line) const { return line * side_ + side_ / 2; }
  bool covers(std::int64_t column, std::int64_t row) const {
    std::int64_t c = column - column0_, r = row - row0_;
    return c >= 0 && r >= 0 && c < columns_ && r < rows_ && in_[std::size_t(r * columns_ + c)] > 0;
  }

 private:
  std::int64_t side_, column0_ = 0, row0_ = 0, columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> in_;  // while filling: differences along each row
};

}  // namespace findspace::plane
