// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All positions at which B + p touches the surface of a solid A from outside, or from inside: the frontiers of U = {p :
// the interiors meet} and of E = {p : B + p lies in A}, as closed convex polygons, segments and points. Neither solid
// is cut into convex parts. A facet of the convolution is cut by the others (touch_facets.h), and of each cell one
// position tells whether the interiors meet (real_overlap.h). Where they meet in a cell, its edges and corners are
// asked as well: there slits and single positions are found. A pair of triangles that crosses at all corners of a cell
// crosses in all of it. Guarantee: exact; pieces may overlap; the same for any number of threads. Cost: some
// microseconds a corner that a cut makes, some ten to a hundred for a cell. Source: Lien 2008, "A simple method for
// computing Minkowski sum boundary in 3D using collision detection"; docs/decisions/0025. Keywords: boundary of a
// Minkowski sum, contact surface, configuration space obstacle.
#pragma once

#include <functional>
#include <optional>

#include "space/surface/real_overlap.h"
#include "space/surface/touch_facets.h"

namespace findspace::space {

/// The pieces point to the planes.
struct TouchFrontier {
  std::vector<FlatPiece> pieces;
  std::shared_ptr<const TouchFacets> facets;
  std::vector<TouchFacets::Planes> planes;
};

/// Whether pieces in a box are wanted.
using BoxQuery = std::function<bool(const Vector& low, const Vector& high)>;

/// Pieces that lie in no wanted box may be missing. Nothing where the boxes of more pairs of facets meet than are
/// allowed; a pair costs some ten microseconds and up to a kilobyte.
std::optional<TouchFrontier> touch_frontier(const RaySheet& a, const RaySheet& b, TouchSide side,
                                            const BoxQuery& wanted, std::size_t most_pairs);

}  // namespace findspace::space
