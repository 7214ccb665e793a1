// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The exact map of a scene in space: as boxes or as one convex set, the best positions where it has an objective, made
// into what --apply asks for. Guarantee: exact; where it has neither form `way` is kLines, and lines have to give it
// (ray_outcome.h). Keywords: feasible region, answer.
#pragma once

#include <optional>
#include <string>

#include "common/session.h"
#include "formula/solid/solve_region.h"
#include "io/write/write_json.h"

namespace findspace::app {

struct SpaceMap {
  distance::Way way = distance::Way::kLines;  // kBoxes, kConvex, or lines have to give it
  space::BoxComplex boxes;                    // in grid steps
  std::optional<space::ConvexSet> convex;
  exact::Real step;  // one unit of the coordinates of `convex` in the scene's unit
  std::optional<distance::OptimalValue> extreme;
};

/// `flat`: the boundary is wanted as flat faces.
SpaceMap space_map(const Session& session, const formula::SpaceSolver& solver, const formula::Formula& formula,
                   bool flat);
/// As `map --json` prints it; not of kLines.
std::string space_map_json(const Session& session, const SpaceMap& map);

}  // namespace findspace::app
