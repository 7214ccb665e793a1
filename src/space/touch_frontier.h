// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where B + p touches the surface of a solid A from outside, or from inside: the frontiers of U = {p : the interiors
// meet} and of E = {p : B + p lies in A}, as closed convex polygons, segments and points. No convex parts of A are
// needed. With S the convex parts of B, the interior of S + p meets the surface of A where p is in one of the open
// convex sets t - int S, t a triangle; elsewhere S + p is wholly outside A or inside. So both frontiers are the facets
// of these sets less the sets, told apart by the side of A on which a point of each S lies. Facets that a triangle next
// to their own covers are left out: where S is convex every touching position lies on another one, too. Guarantee:
// exact, slits and single positions included; the same for any number of threads; pieces may overlap. Cost: the sets,
// and for every facet those whose boxes meet its own: some hundred nanoseconds each, some microseconds for each corner
// of a piece that is made. Source: docs/decisions/0016. Keywords: boundary of a Minkowski sum, contact surface,
// configuration space obstacle.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "space/flat_piece.h"
#include "space/ray_body.h"

namespace findspace::space {

/// A triangle less a convex part, as an open set.
struct TouchSet {
  Polytope closed;
  std::vector<HalfSpace> planes;
};

struct TouchFrontier {
  std::vector<FlatPiece> pieces;
  std::shared_ptr<const std::vector<TouchSet>> sets;  // whose planes the pieces point to
};

enum class TouchSide { kOutside, kInside };

/// Whether pieces in a box are wanted.
using BoxWish = std::function<bool(const Vector& low, const Vector& high)>;

/// Coordinates of one scale, at most 2^38; B not empty. Pieces that lie in no wanted box may be missing.
TouchFrontier touch_frontier(const Triangles& a, std::span<const Polytope> b, TouchSide side, const BoxWish& wanted);

}  // namespace findspace::space
