// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A region along a line: the intervals of {through + t * direction / |direction|} that belong to it, t the signed
// length from `through`. Guarantee: exact, end points with their membership; a single point is an interval of length 0.
// Cost: that of the section (section.h). Keywords: ray, chord, cross section, one-dimensional slice.
#pragma once

#include <optional>
#include <vector>

#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"
#include "plane/query/section.h"

namespace findspace::plane {

/// Open to infinity where an end is missing; then its `_in` is false.
struct LineInterval {
  std::optional<exact::Real> from, to;
  bool from_in = false, to_in = false;
};

/// Where the marks of a section are not 0; parameters times `scale`.
std::vector<LineInterval> intervals(const Section& line, const exact::Real& scale);

/// Disjoint, from small to large t, in grid steps; no two could be joined. `direction` is not (0, 0).
std::vector<LineInterval> along_line(const Region& region, const GridPoint& through, const GridPoint& direction);

}  // namespace findspace::plane
