// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of the distances between a body and a solid that round ones are cut out of (csg_pair.h): gamma1, d1
// and penetration by searches for the nearest places of complete stretches (near_rays.h), by values (value_rays.h)
// gamma2, eta1, eta2, the distance by which a cut solid protrudes from a convex body. For levels of gamma1 from 0 on
// how deep a place of the solid is in the body takes the place of the depth inside: it has the same sign and changes no
// faster. Guarantee: as value_rays.h. Cost: some dozen searches a line, else some hundred values. Keywords: ray map.
#pragma once

#include <memory>

#include "distance/csg/csg_pair.h"

namespace findspace::distance {

/// With B moving; the level in steps of the scale of both. Rows are refused where values do not say the sign.
std::unique_ptr<space::RaySource> cut_map(Which which, const exact::Real& level, std::shared_ptr<const CsgSide> side,
                                          std::int64_t scale, const space::RayGrid& grid);

}  // namespace findspace::distance
