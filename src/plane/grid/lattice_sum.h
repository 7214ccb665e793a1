// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sum of a set of lattice points and a set of lattice cells, as bits: {p + c}. 64 cells at a time, row by row of
// the sum; a run of points is two overlapping ones of a power of two. What adds only to words that are all ones already
// is passed over, so the middle of the sum costs little. Cost: rows of the sum * rows of points, and the words that
// reach over the filled middle. Keywords: bitmap Minkowski sum, morphological dilation by powers of two.
#pragma once

#include <span>

#include "plane/base/bitmap.h"

namespace findspace::plane {

/// Points and cells in order of their rows, the points also of their columns.
struct LatticeSum {
  std::span<const LatticeRun> points, cells;
};

/// Adds the sums to `to`, where they must fit.
void add_sums(std::span<const LatticeSum> sums, Bitmap& to);

}  // namespace findspace::plane
