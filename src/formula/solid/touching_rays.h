// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of two polyhedra of many faces from the positions at which they touch (space/surface/touch_rays.h):
// gamma1 below 0, eta1 and delta1 above 0, eta2 and delta2. Where very many facets of
// two large solids meet, values are searched instead (contact_rays.h). Guarantee: exact on every line, but for the
// latter. Cost: as there.
#pragma once

#include <functional>

#include "distance/planar/shape_pair.h"
#include "space/convolution/ray_solids.h"
#include "space/rays/ray_sources.h"

namespace findspace::formula {

/// `zero`: makes the sign map of gamma1, eta1 or delta1 at level 0. The level in grid steps. Null where this does not
/// answer or is not the quick way.
space::RaySourcePointer touching_rays(distance::Which which, const std::vector<space::RaySolid>& b,
                                      const std::vector<space::RaySolid>& a, const exact::Real& level,
                                      const space::RayGrid& grid, const std::function<space::RaySourcePointer()>& zero);

}  // namespace findspace::formula
