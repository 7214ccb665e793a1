// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of solids that are taken by their surfaces as far as these answer: at level 0, clearances and
// margins (surface_rays.h), depths and how far one is from fitting (touching_rays.h), how far one of few corners
// protrudes from the other (by search where that is not convex, distance/rays/protrusion_rays.h), and the distances
// made of these (d1, penetration, dstar, h, hausdorff). Guarantee: exact on every line, but for the search. Cost: as
// there.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "formula/solid/surface_rays.h"
#include "formula/solid/touching_rays.h"
#include "space/body/body.h"

namespace findspace::formula {

/// The union of solids.
struct TouchingSolid {
  const std::vector<space::RaySolid>& solids;
  std::function<exact::Tried<space::Body>()> body;  // makes its convex parts
};

/// The level in grid steps. No sources: surfaces do not answer, or are not the quick way.
exact::Tried<SurfaceRays> solid_rays(distance::Which which, const TouchingSolid& b, const TouchingSolid& a,
                                     const exact::Real& level, const space::RayGrid& grid);

/// All in one; not of no sources.
space::RaySourcePointer as_source(SurfaceRays rays);

}  // namespace findspace::formula
