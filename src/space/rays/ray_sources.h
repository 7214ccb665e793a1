// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays made from others: everywhere one sign, a function of the signs of several, the greatest or the
// least of them. Guarantee: as the sources'. Cost: that of the sources, and of merging their events; of the least only
// the sources that are not known to be apart on a row (ray_map.h).
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "space/rays/ray_map.h"

namespace findspace::space {

using RaySourcePointer = std::unique_ptr<RaySource>;

RaySourcePointer constant_rays(const RayGrid& grid, int sign);
RayRow constant_row(const RayGrid& grid, int sign);
/// All on the same grid; at least one.
RaySourcePointer combined_rays(std::vector<RaySourcePointer> sources,
                               std::function<std::int8_t(std::span<const std::int8_t>)> combine);
RaySourcePointer mapped_rays(RaySourcePointer source, std::function<int(int)> to);
RaySourcePointer negated_rays(RaySourcePointer source);
RaySourcePointer greatest_rays(std::vector<RaySourcePointer> sources);
RaySourcePointer least_rays(std::vector<RaySourcePointer> sources);
/// One row of either.
exact::Tried<RayRow> extreme_row(std::span<const RaySourcePointer> sources, bool least, int j);
/// max(0, f) or max(0, -f) less a level that is not negative, from f less the level (or less its negative).
RaySourcePointer cut_off_rays(RaySourcePointer source, bool negated, const exact::Real& level);

}  // namespace findspace::space
