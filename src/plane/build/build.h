// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the shape a scene states to the exact point set it stands for: every kind of node of shape.h, with plain set
// semantics (a difference of closed sets is half open).
//
// Guarantee: exact, but for rotations by other angles than multiples of 90 degrees, which put vertices on the grid and
// say so. Cost: a tree of Boolean nodes is one overlay of its leaves (more where it has many of them); a shape that
// occurs several times under one root is built once. Source: docs/scene.md; distances.md 1.3, 8.1. Keywords: CSG,
// Boolean operation.
#pragma once

#include <cstdint>

#include "plane/base/work_budget.h"
#include "plane/build/transform.h"
#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

struct BuildResult {
  Region region;
  Rounding rounding;  // what rotations had to put on the grid
};

/// The set of a 2D shape. Throws Error, its place that of the node: kUnsupported for a hull that is refused (hull.h),
/// kGeometry where a rotated shape no longer is one, kOutOfRange where a moved shape exceeds 2^40 grid steps or a sum,
/// a difference or an offset 2^42, kLimit where it costs more than `work` units. `step`: size of a grid step, for the
/// geometry of errors.
BuildResult build(const Shape& shape, double step = 1, std::uint64_t work = kUsualWorkBudget);

}  // namespace findspace::plane
