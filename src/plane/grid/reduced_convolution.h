// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The curves of a convolution (convolution.h) of grid polygons that arise at convex corners. Curves at reflex corners
// lie inside the open sum, so these hold its boundary; each has the sum on its left, its inner side, for a little way.
// Guarantee: exact; equal directions are decided apart by turning B by an infinitesimal, as in the whole convolution.
// Cost: O(n log n + m log m + curves). Source: Behar & Lien 2011. Keywords: reduced convolution.
#pragma once

#include <optional>
#include <vector>

#include "plane/grid/boundary_box.h"
#include "plane/grid/covered_curves.h"
#include "plane/grid/grid_faces.h"
#include "plane/grid/inner_mask.h"
#include "plane/walk/directed_curves.h"

namespace findspace::plane {

struct ReducedConvolution : DirectedCurves {
  std::optional<InnerMask> mask;  // where it was known to pay (prune_inside.h): curves in its cells were not made
};

/// A set: its faces and the geometry of their supporting_curves.
struct GridOperand {
  const GridFaces& faces;
  const exact::Geometry& geometry;
};

/// Of all pairs of faces; without curves that miss the box, if there is one, and where looking for them pays, without
/// those that lie inside the sum for certain.
ReducedConvolution reduced_convolution(const GridOperand& a, const GridOperand& b,
                                       const std::optional<GridBox>& within = std::nullopt,
                                       CoveredCurves* covered = nullptr);

}  // namespace findspace::plane
