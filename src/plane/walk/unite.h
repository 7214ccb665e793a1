// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The union of any number of sets. Of closed sets bounded by segments of grid lines it is bounded by closed walks along
// their outer sides (outer_walks.h), and nothing is arranged but walks that touch each other. All other sets are
// arranged (overlay.h). Of polygons only the lines that are left are reduced (unreduced_lines.h). Guarantee: exact, the
// same cells both ways. Cost: linear, and the pairs of edges whose boxes meet; else that of an arrangement. Keywords:
// Boolean union, merge, dissolve.
#pragma once

#include <optional>
#include <span>

#include "plane/complex/primitives.h"

namespace findspace::plane {

Region unite(std::span<const Region* const> regions);
/// Of valid rings, whose regions are not made where walks do.
Region unite_rings(Polygons polygons);

/// By walks; nothing where they do not do.
std::optional<Region> united_by_walks(std::span<const Region* const> regions);
std::optional<Region> united_by_walks(Polygons polygons);

}  // namespace findspace::plane
