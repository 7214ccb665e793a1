// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The signed directed Hausdorff distance of bodies: mu(B+p, A) = max over b in B + p of the signed distance of b to A.
//   A convex: at a vertex of B, exactly.
//   A a union, B + p not inside A: h = max over B of the distance to the nearest part of A. Branch and bound over
//   tetrahedra that fill B. Distances to convex parts are convex, so over a tetrahedron any weighted mean of them is
//   bounded by its values at the corners; the best weights are a matrix game, whose other side is a point of the
//   tetrahedron to try. On ridges between flat walls both agree at once.
// Guarantee: convex: exact. Else within 2^-40 of the value, or of the size of B where the limit of kMostCells cells is
// reached (`proven` is false then). Keywords: directed Hausdorff distance, branch and bound, matrix game.
#pragma once

#include "distance/solid_pair.h"

namespace findspace::distance {

inline constexpr int kMostCells = 200000;

/// A convex, of any radius.
SolidValue stick_out_of_convex(const space::Body& b, const space::BodyPart& a, const space::RealVector& p);
/// A without radii, B too; B + p is not inside A.
SolidValue stick_out_of_union(const space::Body& b, const space::Body& a, const space::RealVector& p);

}  // namespace findspace::distance
