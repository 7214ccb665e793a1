// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances while both shapes are translated in time: B(t) + p against A(t). Only the relative path w(t) = b(t) - a(t)
// matters, f(p, t) = f(p + w(t)), so with the sign map s of f at a level
//     inf over t of f: at p the least mark of s along the path p + w;   sup: the greatest one;
// which is the union over t of the sets of each instant (for levels below 0 of the eroded ones, which is not the
// erosion of the union), and their intersection (distances.md 7.3). Guarantee: sign maps exact, for paths of straight
// legs with rational way points; values exact where `extremum` proves them (extremum.h). Cost: a sign map: one sweep
// for each leg. Keywords: dynamic collision detection, moving obstacles, swept volume, space-time.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "distance/planar_features/t_distance.h"
#include "distance/planar_least/extremum.h"
#include "plane/build/path_region.h"

namespace findspace::distance {

/// w at its way points, in grid steps; at least one.
using RelativePath = std::vector<exact::RealPoint>;

/// inf (kMinimum) or sup (kMaximum) of f over the time of the path.
PositionFunctionPointer over_time(TDistancePointer f, RelativePath path, Sense sense);

/// The same of a distance that jumps (along a direction), of the values that it takes: its inf is at most a level where
/// f is at some instant, its sup where f is at every instant. Values are found by bisection, to about 1e-14.
PositionFunctionPointer jumping_over_time(PositionFunctionPointer f, RelativePath path, Sense sense);

/// The inf or sup of f on pieces of a way, of which there is one at least; where it is not proven, a place takes the
/// value. Nothing where f has none.
std::optional<PlanarAnswer> best_on_pieces(const TDistance& f, std::span<const plane::PathPiece> pieces, Sense sense);

/// The number of which the sign minus every level is known, by bisection to about 1e-14; a whole one exactly. Nothing
/// above all levels.
std::optional<PlanarAnswer> bisected(const std::function<plane::Mark(const exact::Real&)>& sign);

/// p -> f(p + by): f at an instant.
PositionFunctionPointer at_instant(PositionFunctionPointer f, const exact::RealPoint& by);

}  // namespace findspace::distance
