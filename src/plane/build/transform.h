// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rigid motions of marked complexes, any marks. The reflection through the origin is `mirrored` in minkowski.h.
//
// Guarantee: translations, the reflection in the y axis and rotations by multiples of 90 degrees are exact. Other
// rotations put every point once on the grid: vertices, also computed ones, are rounded to the nearest grid point;
// segments join them; an arc keeps its radius (and is cut at its extremes where it is longer than a quarter, so that
// rounded ends cannot shift it far); a whole circle keeps its radius about the rounded centre. What was one set must
// stay one: vertices may fall together only along a short edge whose ends agree with it, and no curve may meet another
// where it did not, else Error(kGeometry). Cost: linear for translations; one arrangement for the others. Keywords:
// rigid transformation, snap rounding (not used).
#pragma once

#include <algorithm>
#include <cstdint>

#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// Points that had to be put on the grid, and the largest distance any of them moved, in grid steps.
struct Rounding {
  std::int64_t points = 0;
  double largest = 0;

  void note(double move) {
    points += move > 0;
    largest = std::max(largest, move);
  }
};

/// {s + by}. Throws Error(kOutOfRange) where a vertex leaves the grid (2^40 steps).
CellComplex translated(CellComplex complex, const GridPoint& by);

/// {(-x, y)}.
CellComplex mirrored_in_y_axis(const CellComplex& complex);

/// The set rotated counter-clockwise about a point. `step`: size of a grid step, for the geometry of errors. Throws
/// Error(kGeometry) where the rounded curves cross or fall together, Error(kOutOfRange) as translated() does.
CellComplex rotated(const CellComplex& complex, const GridPoint& about, const exact::Real& degrees, double step,
                    Rounding& rounding);

}  // namespace findspace::plane
