// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where a ball of radius r lies wholly on one side of a closed surface: the places of its centre that are on that side
// and no nearer to a triangle than r, and of them the one nearest to x or farthest from it. So how deep a ball lies in
// a mesh, how far it is from fitting into one, and the farthest fit. A provider of position_set.h: in a small cell the
// functions are the distances to the few triangles that can be nearest there, a larger one is all in or out where the
// signed distance in its middle says so. Where the ball is pushed to from the nearest place of the surface bounds the
// search, and mostly is the answer. What is found is named exactly, and tested exactly, where planes alone, one feature
// or spheres alone hold it. Guarantee: exact where named, else to 2^-40 of the sizes, mostly (`proven` is false and
// `error` says how far off). Nothing is decided where that was not reached, so of fits of no play. Cost: some hundred
// cells of some microseconds to a tenth of a millisecond. Source: docs/decisions/0014, 0016. Keywords: offset surface,
// clearance of a sphere, morphological closing.
#pragma once

#include "distance/solid/solid_pair.h"
#include "space/surface/real_overlap.h"
#include "space/surface/surface_set.h"

namespace findspace::distance {

struct SurfaceBall {
  const space::SurfaceSet* surface;  // one sheet
  exact::Real radius;                // more than 0
  space::TouchSide side;
};

struct BallPlace {
  bool decided = false;
  std::optional<Answer> value;  // nothing: there is no such place; `nearest` is the place
};

BallPlace nearest_for_ball(const SurfaceBall& ball, const space::RealVector& x);
BallPlace farthest_for_ball(const SurfaceBall& ball, const space::RealVector& x);

}  // namespace findspace::distance
