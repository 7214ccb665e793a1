// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A set of the plane by its boundary, exactly, as JSON that reads back as the same set (read_cells.h): the
// supporting curves of its edges, its vertices, its edges, and for every cell whether it belongs. Guarantee: nothing is
// lost: open ends, slots, cracks and isolated points, arcs of any radius, vertices that are not decimals. Cost: linear.
// The format is described in docs/scene.md. Keywords: boundary representation, B-rep, serialisation.
#pragma once

#include <string>
#include <string_view>

#include "plane/complex/cell_complex.h"

namespace findspace::io {

/// `step`: a grid step in the unit, which may be empty.
std::string cells_json(const plane::Region& region, const exact::Real& step, std::string_view unit);

}  // namespace findspace::io
