// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Height fields: ground, terrain, a measured surface. Heights stand over the meetings of columns (lines of equal x) and
// rows (lines of equal y), evenly spaced. The solid is the closed set from a flat floor up to them. A square between
// two columns and two rows is two triangles; the diagonal goes from its corner of least x and y to that of greatest.
// Over a square with a corner without a height there is nothing. Guarantee: a closed surface that does not cross
// itself, exact on the grid; two parts may touch in an upright edge. Cost: linear in the heights; two triangles a
// square above, few below. Keywords: heightfield, heightmap, digital elevation model, relief, terrain, raster.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "exact/number/real.h"
#include "plane/contour/decimal_grid.h"
#include "space/polytope/solid.h"

namespace findspace::space {

/// What a height field is stated by, but for its heights; in the unit of the grid.
struct FieldFrame {
  std::size_t columns = 0, rows = 0;
  std::array<exact::Real, 2> at, step;  // the first column and row; from each to the next
  exact::Real floor;
};

class HeightField {
 public:
  static constexpr std::size_t kMostHeights = std::size_t{1} << 28;

  /// Puts columns, rows and floor on the grid. Throws Error for fewer than two of them, more than kMostHeights heights,
  /// steps that are not above 0, and lines that the grid does not tell apart.
  HeightField(const FieldFrame& frame, const plane::Grid& grid);

  /// A height in grid steps, and how far it was moved to get there. Columns and rows count from 0. Those that are not
  /// put are missing. Throws Error where it is not above the floor.
  void put(std::size_t column, std::size_t row, std::int64_t height, double moved);

  /// The solid; what was rounded, and a note about squares that are missing. Throws Error where all of them are.
  Solid solid(plane::RoundingLog& log, std::vector<std::string>& notes) const;

 private:
  friend class FieldSurface;
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::min();

  /// Lines in one direction.
  struct Lines {
    std::vector<std::int64_t> at;
    std::vector<double> moved;
    Lines(const exact::Real& first, const exact::Real& step, std::size_t count, const plane::Grid& grid,
          const char* what);
  };

  static const FieldFrame& checked(const FieldFrame& frame);
  std::size_t node(std::size_t column, std::size_t row) const { return row * x_.at.size() + column; }
  /// Whether the square that begins there has a height at each corner; false beyond the last one, and before the first.
  bool stands(std::size_t column, std::size_t row) const;

  Lines x_, y_;
  double step_size_, floor_moved_ = 0;
  std::int64_t floor_;
  std::vector<std::int64_t> heights_;  // row by row
  plane::RoundingLog rounding_;
};

}  // namespace findspace::space
