// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public SpaceRegion: boxes or a convex set, what they add up to, and the query that they answer.
#pragma once

#include "api/query/world_data.h"
#include "findspace/space_region.h"
#include "formula/solid/solve_region.h"

namespace findspace {

struct SpaceRegion::Data {
  formula::SpaceRegion region;
  exact::Real step;
  std::string unit;
  space::SpaceSummary summary;
  Query query;
};

}  // namespace findspace
