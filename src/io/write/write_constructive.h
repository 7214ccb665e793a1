// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From cells back to a constructive shape: a set S of the plane as
//   (C minus M) union (L minus N) union P,    or the complement of such a set where S is unbounded,
// C the closed faces of S, M their missing cells (edges less the vertices that belong, and vertices), L the closed
// edges of S outside C, N their missing ends, P the single points. Leaves are polygons with holes, discs, segments and
// points where the grid's decimals say them exactly, else "cells" (write_cells.h). Guarantee: exact, for sets of any
// kind: open, half open, with cracks and whiskers. Cost: linear. Keywords: CSG, boundary to CSG conversion.
#pragma once

#include <string>
#include <string_view>

#include "plane/complex/cell_complex.h"
#include "plane/contour/decimal_grid.h"

namespace findspace::io {

/// The shape as the value of a scene's shape.
std::string constructive_json(const plane::Region& region, const exact::Real& step);

/// A scene with this one shape; `unit` may be empty.
std::string constructive_scene(const plane::Region& region, std::string_view name, const plane::Grid& grid,
                               std::string_view unit);

}  // namespace findspace::io
