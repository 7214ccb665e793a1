// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Signs on lines of what takes long, by values between ends: no step changes a distance by more than its length, so one
// at a place tells the sign about it. Guarantee: signs are right; they are 0 where the ends do not tell them, to a
// quarter of how far these are apart, or where the work goes that a line may take. Cost: some ten values a line.
// Keywords: Lipschitz, bisection.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "distance/answer/answer.h"
#include "distance/csg/csg_work.h"
#include "space/polytope/extent.h"
#include "space/polytope/real_vector.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

using ValueBetween = std::function<TriedAnswer(const space::RealVector&, Cells)>;
/// `box`: out of it a position has at least the distance that it is from there; in steps of the scale.
std::unique_ptr<space::RaySource> rays_by_ends(ValueBetween value, const exact::Real& level, const space::Extent& box,
                                               std::int64_t scale, const space::RayGrid& grid);

}  // namespace findspace::distance
