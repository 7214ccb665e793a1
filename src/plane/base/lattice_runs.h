// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A polygon seen through a square lattice: per row the runs of cells that lie strictly inside it, and of lattice points
// that belong to it. Guarantee: every cell, closed, lies in the open polygon, every point in the closed one; cells and
// points near an edge may be missing. Only conservative double arithmetic on coordinates below 2^43 steps; no sign is
// decided. Cost: rows crossed by the edges, and a sort in each. Keywords: scan conversion, conservative rasterisation.
#pragma once

#include <cstdint>
#include <vector>

namespace findspace::plane {

/// The whole number at or below one that fits.
inline std::int64_t floor_of(double v) {
  const auto whole = std::int64_t(v);
  return whole - (double(whole) > v);
}

struct LatticeEdge {
  double x0, y0, x1, y1;
};

/// The edges of a closed set's boundary, even-odd.
using Outline = std::vector<LatticeEdge>;

/// Columns [first, last] of a row.
struct LatticeRun {
  std::int64_t row, first, last;
};

/// Cell (column, row) is [column, column + 1] x [row, row + 1] in units of `side`, a whole number above 2.
std::vector<LatticeRun> cell_runs(const Outline& outline, double side);

/// Point (column, row) is (column, row) in units of `side`.
std::vector<LatticeRun> point_runs(const Outline& outline, double side);

}  // namespace findspace::plane
