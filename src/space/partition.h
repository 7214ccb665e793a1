// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The binary space partition behind convex_parts.h: cells as lists of half spaces.
#pragma once

#include <array>
#include <vector>

#include "exact/real.h"
#include "space/polytope.h"

namespace findspace::space {

/// A piece of a facet: its plane (outward) and its corners. Pieces may be degenerate along a cut.
struct FacetPiece {
  Plane plane;
  std::vector<std::array<exact::Real, 3>> corners;
};

/// The cells inside the surface `facets`, which is closed within the intersection of `bounds`, each as its half spaces.
std::vector<std::vector<Plane>> partition(std::vector<FacetPiece> facets, std::vector<Plane> bounds);

}  // namespace findspace::space
