// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What lines tell of a set of space, as a public value.
#pragma once

#include "findspace/line_map.h"
#include "space/rays/ray_map.h"
#include "space/rays/ray_sources.h"

namespace findspace::api {

/// Of a set that has signs of at most 0; `step`: of the grid in the unit. Whether it is exact and unbounded is left to
/// say.
LineMap line_map(const space::RaySource& rays, double step);

}  // namespace findspace::api
