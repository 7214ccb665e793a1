// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the boundary of the open Minkowski sum of two sets of grid polygons can lie: in the sum of their boxes, or, if
// one of them holds everything outside a box, where the other fits into that box; outside, everything is in the sum
// then. Guarantee: exact. Cost: linear. Keywords: bounding box.
#pragma once

#include <optional>
#include <span>

#include "plane/grid/grid_faces.h"

namespace findspace::plane {

/// Grid coordinates, lower bounds below upper ones.
struct GridBox {
  std::int64_t x0, y0, x1, y1;
};

bool has_unbounded(std::span<const GridFace> faces);

/// Of all finite corners; of no faces nothing sensible.
GridBox box_of(std::span<const GridFace> faces);

/// A step more than needed on every side; nothing where the sum is empty or everything.
std::optional<GridBox> boundary_box(std::span<const GridFace> a, std::span<const GridFace> b);

}  // namespace findspace::plane
