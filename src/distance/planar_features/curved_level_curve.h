// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Level curves (level_curve.h) of an edge of B at the corner of two parts of A, the place of A's plane that is `level`
// away from both: {p : the edge, moved by p, passes through the corner}. The corner is c0 + level * c1 + sqrt(T(level))
// * c2 with T of degree 2, without the root between two lines. So a straight edge's level curve is a line of bent
// offset, an arc's a circle about a centre that moves. Levels at which such level curves meet others are roots of
// polynomials, by elimination: the level curves' equations at a level give one in the level and the square roots of the
// corners, whose norm is one in the level alone. Degree: 2 or 4 for a bent line with lines or a circle, 8 for most
// others, 16 at most: what needs more is left out. Guarantee: exact numbers; a root of the norm that belongs to other
// signs of the square roots is left out as far as numbers show. Cost: microseconds for degree 2, milliseconds for
// degree 8. Source: elimination. Keywords: bisector, Voronoi edge, Hausdorff distance, resultant, norm.
#pragma once

#include <span>

#include "distance/planar_features/level_curve.h"

namespace findspace::distance {

/// The positions p at which the place between two level curves f and g of A, the one on the side of (near_x, near_y),
/// lies on `edge`, a line or circle that keeps still, moved by p. Nothing where f and g are parallel or concentric.
std::optional<LevelCurve> corner_level_curve(const LevelCurve& edge, const LevelCurve& f, const LevelCurve& g,
                                             double near_x, double near_y);

/// The levels in [low, high] at which the level curves, two or three, some of them bent, meet. Those of more than
/// degree 4 only where the interval is narrow.
std::vector<exact::Real> curved_levels(std::span<const LevelCurve* const> level_curves, double low, double high);

}  // namespace findspace::distance
