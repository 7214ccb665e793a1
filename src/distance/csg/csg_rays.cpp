// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_rays.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "space/rays/ray_sources.h"

namespace findspace::distance {

using exact::Real;

std::unique_ptr<space::RaySource> cut_map(Which which, const Real& level, std::shared_ptr<const CsgSide> side,
                                          std::int64_t scale, const space::RayGrid& grid) {
  if (const auto cut = cut_off_of(which); cut && cut->base == Which::kGamma1) {
    if (level.sign() < 0) return space::constant_rays(grid, 1);
    return space::cut_off_rays(cut_map(cut->base, cut->negated ? -level : level, std::move(side), scale, grid),
                               cut->negated, level);
  }
  // About all positions at which the two can meet.
  const space::Bounds3 box = space::meeting(bounds(side->complete()), bounds(side->cut()));
  const space::Vector low = space::rounded(box.low), high = space::rounded(box.high);
  const double size = space::length(high - low) + std::fabs(level.to_double()) + 1;
  const NearRange range{space::scaled(0.5, space::plus(low, high)), size};
  if (auto near = CsgSide::nearness(side, which, level.to_double(), line_direction(grid), range)) {
    const bool deep = which == Which::kGamma1 && level.sign() < 0;
    auto rays = std::make_unique<NearRays>(std::move(near), range, deep ? -1 : 1, scale, grid);
    if (deep) return space::negated_rays(std::move(rays));
    return rays;
  }
  const RayRule rule = [side, which, level](const space::RealVector& p) { return between(side, which, level, p); };
  return std::make_unique<ValueRays>(rule, range.middle, size, scale, grid);
}

}  // namespace findspace::distance
