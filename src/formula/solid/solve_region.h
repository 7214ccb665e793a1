// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The exact forms of a region of positions, and of a shape: as boxes, as one convex set, or none; then lines give it.
// Each question tries its ways in one place and says which one answered. Guarantee: exact. Keywords: feasible region,
// boundary representation.
#pragma once

#include <optional>
#include <variant>

#include "distance/answer/way.h"
#include "formula/language/formula.h"
#include "formula/solid/solve_space.h"
#include "space/convolution/ray_body.h"

namespace findspace::formula {

struct RegionQuery {
  std::optional<Objective> objective;
  distance::Sense sense = distance::Sense::kMinimum;
  bool flat = false;  // the boundary is wanted as flat faces
};

struct SpaceRegion {
  distance::Way way = distance::Way::kLines;  // kBoxes, kConvex, or lines have to give it
  space::BoxComplex boxes;                    // in grid steps
  std::optional<SpaceSolver::ConvexMap> convex;
  std::optional<distance::OptimalValue> extreme;  // of the objective, or of the formula's `-> min`
};

/// The positions of the formula, the best ones of an objective.
SpaceRegion solve_region(const SpaceSolver& solver, const Formula& formula, const RegionQuery& query);

/// A shape as boxes (kBoxes) or as one convex body (kConvex); kLines: neither, though `shape` may have a body.
struct ExactShape {
  distance::Way way = distance::Way::kLines;
  SpaceShape shape;
};
/// `flat`: a round body does not do.
ExactShape exact_shape(const plane::Shape& shape, bool flat);

/// The boundary of a shape: one closed surface, the faces of boxes, or those of a convex polytope.
using ShapeBoundary = std::variant<space::Triangles, space::BoxComplex, LazyBody::Pointer>;
/// Nothing for other shapes.
std::optional<ShapeBoundary> shape_boundary(const plane::Shape& shape);

}  // namespace findspace::formula
