// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes with their sides rounded to the lines of one fine grid, two sides a word, so that a few integer operations tell
// whether two of them meet. Guarantee: rounding keeps the order of coordinates, so boxes that meet still do; boxes may
// meet that did not. No sign is decided. Cost: four words' operations a pair. Keywords: quantised bounding box, SWAR.
#pragma once

#include <cstdint>

#include "plane/complex/broad_phase.h"

namespace findspace::plane {

/// Each word holds a number for x and one for y below 2^31, and above each a guard bit.
class CoarseBox {
 public:
  CoarseBox() = default;
  CoarseBox(std::uint64_t low, std::uint64_t high) : low_(low), high_(high | kGuards) {}

  bool meets(const CoarseBox& o) const { return ((high_ - o.low_) & (o.high_ - low_) & kGuards) == kGuards; }
  /// Does it reach into the strip of the other box and what is below?
  bool meets_strip_below(const CoarseBox& o) const {
    return ((o.high_ - low_) & ((high_ - o.low_) | kGuardOfY) & kGuards) == kGuards;
  }
  bool is_below(const CoarseBox& o) const { return ((high_ - o.low_) & kGuardOfY) == 0; }

 private:
  static constexpr std::uint64_t kGuardOfY = std::uint64_t(1) << 31, kGuards = kGuardOfY << 32 | kGuardOfY;

  // A guard is left after a subtraction where the number below it was not less than what was taken away.
  std::uint64_t low_ = 0, high_ = kGuards;
};

class CoarseGrid {
 public:
  CoarseGrid() = default;
  /// Fine inside this box.
  explicit CoarseGrid(const PieceBox& all)
      : x_(all.x0), y_(all.y0), columns_(kMost / (all.x1 - all.x0)), rows_(kMost / (all.y1 - all.y0)) {}

  CoarseBox box(const PieceBox& b) const { return {word(b.x0, b.y0), word(b.x1, b.y1)}; }

 private:
  static constexpr double kMost = 1 << 30;

  /// 0 as well for what is no number.
  static std::uint64_t line(double v) {
    v = v > 0 ? v : 0;
    return std::uint64_t(std::int64_t(v < kMost ? v : kMost));
  }
  std::uint64_t word(double x, double y) const { return line((x - x_) * columns_) << 32 | line((y - y_) * rows_); }

  double x_ = 0, y_ = 0, columns_ = 0, rows_ = 0;
};

}  // namespace findspace::plane
