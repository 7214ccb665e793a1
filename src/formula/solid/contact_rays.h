// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of two solids of many facets of touching (touching_rays.h), by values at positions (value_rays.h),
// which the positions tell at which their surfaces touch (surface_contact.h): gamma1 below 0, eta1 and delta1 above 0,
// eta2 and delta2. Guarantee: - and + where that is certain, 0 near the level. Cost: some dozen values a line, of some
// milliseconds once the boxes about the frontier are known.
#pragma once

#include "distance/planar/shape_pair.h"
#include "space/convolution/ray_solids.h"
#include "space/rays/ray_sources.h"

namespace findspace::formula {

/// Of one surface each; the level in grid steps.
space::RaySourcePointer contact_rays(distance::Which which, const space::RaySolid& b, const space::RaySolid& a,
                                     const exact::Real& level, const space::RayGrid& grid);

}  // namespace findspace::formula
