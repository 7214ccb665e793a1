// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sign of d(p, C) - r for a set C of grid polygons, the common case of an offset, from the curves that can be its
// boundary: D = {d < r} is bounded by the closed walks along outer sides of curves that turn to the outside at every
// crossing. Guarantee: the same cells and marks as by arranging the whole convolution with a disc. Cost: that of the
// curves (offset_curves.h) and of the pairs of boxes that meet. Source: docs/decisions/0012-offsets-by-outer-walks.md.
// Keywords: offset curve, buffer, trimmed parallel curve.
#pragma once

#include <functional>
#include <optional>

#include "plane/complex/ring_map.h"

namespace findspace::plane {

/// -1 where less than r away from the closure of the cells that are wanted, 0 on the boundary of that, +1 elsewhere; or
/// other marks.
/// Nothing where the set is not bounded by grid segments alone, or has faces on both sides of an edge or straight
/// corners.
/// `drop`: is called when the set is not read again, and then the offset is made.
std::optional<SignMap> grid_offset(const CellComplex& set, bool (*wanted)(Mark), const exact::Real& radius,
                                   RingMarks marks = kOpenSetSigns, const std::function<void()>& drop = {});

}  // namespace findspace::plane
