// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The facets of a convolution, ready to be met by the lines of a grid. Lines run along z here (the bodies were turned).
// A line stands for itself and for the line displaced by infinitesimals, to the right and, less, upward (d, d^2): the
// displaced one meets every facet inside or not at all, so its winding numbers are those of the open cells that the
// line runs through. Which columns a facet's section covers is decided exactly, and all facets that share an edge
// decide alike. Guarantee: exact; heights are doubles with a bound. Cost: a few nanoseconds a facet and row, and a line
// met.
#pragma once

#include <span>
#include <vector>

#include "space/convolution/ray_convolution.h"
#include "space/rays/ray_map.h"

namespace findspace::space {

/// A facet with its plane in doubles.
struct Sheet {
  RayFacet facet;
  std::int64_t low = 0, high = 0;   // in y
  double slope_x = 0, slope_y = 0;  // of z
  double slack = 0;                 // bound of the error of height() at lines that meet it
  std::int32_t jump = 0;            // of the winding number upward; 0: parallel to the lines

  double height(std::int64_t x, std::int64_t y) const {
    const Point& p = facet.corner[0];
    return static_cast<double>(p.z) + (slope_x * static_cast<double>(x - p.x) + slope_y * static_cast<double>(y - p.y));
  }
  /// Exactly; not for facets parallel to the lines.
  exact::Fraction height_exactly(std::int64_t x, std::int64_t y) const;
  /// Whether the displaced line at (x, y) meets the facet.
  bool meets_displaced(std::int64_t x, std::int64_t y) const;
};

/// The section of a facet with a displaced row: it runs between two of the facet's edges.
struct Section {
  double x[2], z[2];  // its ends, left and right
  int column[2];      // the first column at or right of each end: the lines met are column[0] to column[1] - 1
  int tie[2];         // a column that passes exactly through the end, or -1
  double x_error, z_error;
};

class Sheets {
 public:
  Sheets(std::vector<RayFacet> facets, const RayGrid& grid);

  const RayGrid& grid() const { return grid_; }
  const Sheet& operator[](int k) const { return sheets_[k]; }
  /// The facets whose closed projection meets row j.
  std::span<const int> row(int j) const { return {of_row_.data() + first_[j], first_[j + 1] - first_[j]}; }
  /// False if the displaced row j misses the facet.
  bool section(int sheet, int j, Section& section) const;
  /// Calls dirty(column) for lines of row j that pass through a corner of the facet or along one of its edges, where
  /// these lie in the row.
  template <class Dirty>
  void mark_row_contacts(int sheet, int j, Dirty dirty) const;

  /// The first column at or right of x.
  int column_from(std::int64_t x) const {
    const std::int64_t steps = x - grid_.u;
    return clamp_column(steps <= 0 ? 0 : (steps + grid_.du - 1) / grid_.du);
  }

 private:
  int clamp_column(std::int64_t c) const { return static_cast<int>(c < 0 ? 0 : c > grid_.nu ? grid_.nu : c); }
  void sort_into_rows();

  RayGrid grid_;
  std::vector<Sheet> sheets_;
  std::vector<std::size_t> first_;
  std::vector<int> of_row_;
};

template <class Dirty>
void Sheets::mark_row_contacts(int sheet, int j, Dirty dirty) const {
  const RayFacet& f = sheets_[sheet].facet;
  const std::int64_t y = grid_.v_at(j);
  for (int k = 0; k < f.corners; ++k) {
    const Point &p = f.corner[k], &q = f.corner[k + 1 == f.corners ? 0 : k + 1];
    if (p.y != y) continue;
    const std::int64_t low = q.y == y ? std::min(p.x, q.x) : p.x, high = q.y == y ? std::max(p.x, q.x) : p.x;
    for (int c = column_from(low); c < grid_.nu && grid_.u_at(c) <= high; ++c) {
      if (grid_.u_at(c) >= low) dirty(c);
    }
  }
}

}  // namespace findspace::space
