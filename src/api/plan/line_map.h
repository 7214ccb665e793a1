// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What lines tell of a set of space, as a public value.
#pragma once

#include "findspace/line_map.h"
#include "formula/solid/solve_rays.h"
#include "space/rays/ray_map.h"
#include "space/rays/ray_sources.h"

namespace findspace::api {

/// Of a set that has signs of at most 0; beyond the window no sign changes; `step`: of the grid in the unit. Whether it
/// is exact and unbounded is left to say.
LineMap line_map(const space::RaySource& rays, const formula::RayWindow& window, double step);

}  // namespace findspace::api
