// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_rays.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "space/rays/ray_sources.h"

namespace findspace::distance {

using exact::Real;

namespace {

/// The box about all positions at which the two can meet.
space::Bounds3 positions(const CsgPair& pair) {
  const space::Bounds3 cut = bounds(pair.cut()), complete = bounds(pair.complete());
  const space::Bounds3 &fixed = pair.cut_moves() ? complete : cut, &moving = pair.cut_moves() ? cut : complete;
  return {space::minus(fixed.low, moving.high), space::minus(fixed.high, moving.low)};
}

}  // namespace

std::unique_ptr<space::RaySource> cut_map(Which which, const Real& level, std::shared_ptr<const CsgPair> pair,
                                          std::int64_t scale, const space::RayGrid& grid) {
  if (which == Which::kPenetration) {
    if (level.sign() < 0) return space::constant_rays(grid, 1);
    auto deeper = cut_map(Which::kGamma1, -level, std::move(pair), scale, grid);
    const bool any = level.sign() == 0;
    return space::mapped_rays(std::move(deeper), [any](int s) { return any ? std::max(0, -s) : -s; });
  }
  const bool cut_off = which == Which::kD1;
  if (cut_off && level.sign() < 0) return space::constant_rays(grid, 1);
  const Which base = cut_off ? Which::kGamma1 : which;
  const space::Bounds3 box = positions(*pair);
  const space::Vector low = space::rounded(box.low), high = space::rounded(box.high);
  const double size = space::length(high - low) + std::fabs(level.to_double()) + 1;
  const NearRange range{space::scaled(0.5, space::plus(low, high)), size};
  space::RaySourcePointer rays;
  if (auto near = CsgPair::nearness(pair, base, level.to_double(), line_direction(grid), range)) {
    const bool deep = base == Which::kGamma1 && level.sign() < 0;
    rays = std::make_unique<NearRays>(std::move(near), range, deep ? -1 : 1, scale, grid);
    if (deep) rays = space::negated_rays(std::move(rays));
  } else {
    const RayRule rule = [pair, base, level](const space::RealVector& p) { return pair->between(base, level, p); };
    rays = std::make_unique<ValueRays>(rule, range.middle, size, scale, grid);
  }
  if (!cut_off || level.sign() > 0) return rays;
  return space::mapped_rays(std::move(rays), [](int s) { return s > 0 ? 1 : 0; });
}

}  // namespace findspace::distance
