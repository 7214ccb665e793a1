// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What `minimize`, `maximize` and `-> min` come to on the lines of a map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "in_space/ray_outcome.h"
#include "io/write/write_json_rays.h"
#include "space/rays/ray_intervals.h"
#include "space/rays/ray_summary.h"
#include "space/rays/ray_surface.h"

namespace findspace::app {

/// What the lines tell.
struct Cast {
  space::RayGrid grid;
  formula::Side on_lines = formula::Side::kExact;  // how they stand to the region
  space::RaySummary summary;
  io::Spool lines;            // as JSON, where that is written
  space::RaySurface surface;  // of three axes only
  std::optional<space::RayExtreme::Found> extreme;
  std::vector<space::RayInterval> intervals;  // where an objective wants them
};

/// Of a coordinate or the distance to a point.
space::RayAim aim_of(const Session& session, const Session::Goal& goal);
distance::OptimalValue optimum_of(const RaySet& set, const Cast& cast, double step);
/// Of a distance. Refers to the solver.
RayObjective objective_of(const formula::SpaceSolver& solver, const Session::Goal& goal);
distance::OptimalValue best_of(const RaySet& set, Cast& cast, double step);
/// Of an atom with `-> min`.
distance::OptimalValue least_of(const formula::LeastOf& found);
std::string optimum_text(const distance::OptimalValue& found);

}  // namespace findspace::app
