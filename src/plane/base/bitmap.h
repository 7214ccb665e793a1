// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A finite set of lattice cells as bits, row by row.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/base/lattice_runs.h"

namespace findspace::plane {

/// Rows [row0, row1], columns [column0, column1]; none where a first is above its last.
struct LatticeBox {
  std::int64_t row0 = INT64_MAX, row1 = INT64_MIN, column0 = INT64_MAX, column1 = INT64_MIN;

  static LatticeBox around(std::span<const LatticeRun> runs);
  bool empty() const { return row0 > row1; }
  void add(const LatticeBox& other);
  friend LatticeBox operator+(const LatticeBox& a, const LatticeBox& b) {
    return {a.row0 + b.row0, a.row1 + b.row1, a.column0 + b.column0, a.column1 + b.column1};
  }
};

class Bitmap {
 public:
  /// Empty, with space for the cells of the box, which is not.
  explicit Bitmap(const LatticeBox& box);

  void add(const LatticeRun& run);

  const LatticeBox& box() const { return box_; }
  /// Of a row, from the first column of the box on; the last of them is 0, and so is what lies before the first.
  std::int64_t words() const { return words_; }
  std::uint64_t* line(std::int64_t row) { return bits_.data() + 1 + (row - box_.row0) * words_; }
  const std::uint64_t* line(std::int64_t row) const { return bits_.data() + 1 + (row - box_.row0) * words_; }
  bool holds(std::int64_t row, std::int64_t column) const {
    std::int64_t c = column - box_.column0;
    return line(row)[c / 64] >> (c % 64) & 1u;
  }

 private:
  LatticeBox box_;
  std::int64_t words_;               // a row, the last of them always 0
  std::vector<std::uint64_t> bits_;  // a 0, then the rows
};

}  // namespace findspace::plane
