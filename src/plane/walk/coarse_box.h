// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes with their sides rounded to the lines of one fine grid, two sides a word, so that a few integer operations tell
// whether two of them meet. Guarantee: rounding keeps the order of coordinates, so boxes that meet still do; boxes may
// meet that did not. No sign is decided. Cost: four words' operations a pair. Keywords: quantised bounding box, SWAR.
#pragma once

#include <algorithm>
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
  /// `all`: a box of finite width and height that holds what there is.
  explicit CoarseGrid(const PieceBox& all)
      : all_(all), columns_(kLines / (all.x1 - all.x0)), rows_(kLines / (all.y1 - all.y0)) {}

  /// Of one inside the box of all.
  CoarseBox box(const PieceBox& b) const { return {word(b.x0, b.y0), word(b.x1, b.y1)}; }
  /// Of any one, where it is nearest to what there is.
  CoarseBox nearest_box(const PieceBox& b) const {
    return {word(std::clamp(b.x0, all_.x0, all_.x1), std::clamp(b.y0, all_.y0, all_.y1)),
            word(std::clamp(b.x1, all_.x0, all_.x1), std::clamp(b.y1, all_.y0, all_.y1))};
  }

 private:
  static constexpr double kLines = 1 << 30;

  std::uint64_t word(double x, double y) const {
    return std::uint64_t(std::int64_t((x - all_.x0) * columns_)) << 32 |
           std::uint64_t(std::int64_t((y - all_.y0) * rows_));
  }

  PieceBox all_{0, 0, 1, 1};
  double columns_ = kLines, rows_ = kLines;
};

}  // namespace findspace::plane
