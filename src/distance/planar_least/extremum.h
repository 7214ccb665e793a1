// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least or greatest value of a T-distance f over a set S of positions, and where it is taken: inf {f(p) : p in S}
// and the points of S (or, if none of them takes it, of the closure of S) at that value: points, curves or faces
// (distances.md 4.4). Method: bisection on the level with exact sign maps brackets the value; where the sublevel set
// has become small, the level curves that pass there are met in pairs and triples; each meeting is a candidate, and one
// is accepted only with the proof that no position of S lies beyond it and some position on it, by one more exact sign
// map. Guarantee: `proven` values and sets are exact. A value that square roots cannot express is enclosed by exact
// sign maps on both sides: at value() a position of the closure of S is as good, at bound(), within 1e-13 of the value
// or of the extent, none is; `at` has one such position for each component of those as good as value(), and all best
// positions lie `within` that distance of one of them. Cost: 20 to 50 sign maps, a handful where a bracket is known. Of
// many edges: a few thousand values first (level_cover.h), and maps of small windows (level_windows.h) where these can
// be made. Keywords: argmin, constrained minimum, largest inscribed circle, smallest enclosing circle, minimal
// Hausdorff distance.
#pragma once

#include "distance/answer/optimum.h"
#include "distance/planar_features/t_distance.h"

namespace findspace::distance {

/// In grid steps.
using Extremum = OptimumOf<plane::Region>;

/// Numbers that the extremum is known to lie between: `reached` is taken (to rounding) and probably it, none is better
/// than `bound`.
struct Bracket {
  double reached, bound;
  bool value_only = false;  // the positions are not asked for
};

/// A bracket that is known saves most of the search.
Extremum extremum(const TDistance& f, const plane::Region& s, Sense sense,
                  const std::optional<Bracket>& known = std::nullopt);
/// Over all positions.
Extremum least(const TDistance& f);

}  // namespace findspace::distance
