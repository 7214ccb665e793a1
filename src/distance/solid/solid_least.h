// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value of a T-distance of bodies over all positions (distances.md 3.1 to 3.4), and a position that takes it.
//   gamma1, eta1, delta1   minus the radius of the largest ball in U, E, D: the max-min place of the distance to the
//   frontier
//                          of U, or to the open sets that cover the complement of E (solid_max_min.h); mu where B fits;
//   gamma2, eta2, delta2   the smallest ball about the vertices of X, E, D, exactly; d1, dstar, penetration: 0;
//   mu to a convex A, the Hausdorff distance of convex bodies, gamma2 and eta2 of round ones: by tangents
//   (least_in_box.h);
//   others                 cubes of positions, divided where the least is to be expected: a distance changes by no
//                          more than the length of a step, so none in a cube is less than that at its centre minus
//                          half the diagonal.
// Guarantee: `value` is taken at `at`; no position has less than `bound`. Proven values are exact (bound = value); of
// signed distances the two agree to 2^-40, by tangents to 2^-36, of others to 2^-30 of the size of the bodies, or as
// far as kMostValues values (kMostCells cells) go: minima along curves and faces are slower. Refused: distances that
// solid_pair.h does not compute, and those to complements, which have no least value. Keywords: argmin,
// largest inscribed ball, penetration depth, Lipschitz optimisation, branch and bound.
#pragma once

#include "distance/search/least_in_box.h"
#include "distance/solid/solid_pair.h"

namespace findspace::distance {

/// Both of one scale; nothing where the distance is undefined.
TriedAnswer solid_least(Which which, const space::Body& b, const space::Body& a);

/// By tangents if `convex`, where values tell them; else by cubes, of so many values.
struct LeastQuery {
  double floor = -exact::kInfinity;  // a bound that is known
  bool convex = false;
  int most = kMostValues;
};
/// The least value of any pair, whatever answers for it. `box`: the positions at which the boxes of both meet; beyond
/// them every distance grows.
TriedAnswer least_of_values(Which which, const PairDistances& pair, const space::Bounds3& box, const LeastQuery& query);
/// 0, at a position in the box that takes it, or for distances other than d1 at one beyond it.
Answer least_zero(Which which, const space::Bounds3& box, const space::RealVector& meeting);

}  // namespace findspace::distance
