// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of space all of whose faces are parallel to the axes, as exact point sets in grid steps: boxes, prisms over
// rectilinear polygons, meshes and polytopes with such faces, and every constructive node over them that stays in the
// class: union, intersection, difference, complement, interior, closure, boundary, regularize (the plain, not
// regularised operations), translate, mirror, minkowski_sum, minkowski_difference, hull and negative offset where the
// result is a box. Guarantee: exact; nothing where the shape is not of this kind. Cost: that of the grid
// (box_complex.h).
#pragma once

#include <optional>

#include "space/body/body.h"
#include "space/box/box_complex.h"

namespace findspace::space {

std::optional<BoxComplex> box_complex(const plane::Shape& shape);

/// The closure of its interior as a body of boxes, which may overlap; nothing if the set is not the same but for its
/// boundary (sheets, lines, points), unbounded, or off the grid.
std::optional<Body> body_of(const BoxComplex& set);

}  // namespace findspace::space
