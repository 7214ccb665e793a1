// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public SpaceRegion: boxes or a convex set, what they add up to, and the query that they answer.
#pragma once

#include <string_view>

#include "api/query/world_data.h"
#include "findspace/space_region.h"
#include "formula/solid/solve_region.h"

namespace findspace {

struct SpaceRegion::Data {
  formula::SpaceRegion region;  // of boxes, or convex
  exact::Real step;             // one unit of its coordinates in the world's
  std::string unit;
  space::SpaceSummary summary;
  Query query;
  SpaceQuestion question{};

  /// `step`: one step of the grid.
  Data(formula::SpaceRegion found, const exact::Real& step, std::string unit, Query query, SpaceQuestion question);
  /// At a position in the world's unit.
  bool contains(const distance::Coordinates& p) const;
};

namespace api {

/// Such positions of a formula as they are shown, or none of both forms. kBadValue for another operation.
formula::SpaceRegion solved_in_space(const formula::SpaceSolver& solver, const formula::Formula& formula,
                                     const formula::RegionQuery& query, std::string_view apply);
space::SpaceSummary summary_of(const formula::SpaceRegion& region, const exact::Real& step);

}  // namespace api

}  // namespace findspace
