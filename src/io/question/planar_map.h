// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The map of a scene of the plane: the region of its formula, on the scene's line where it has one, the best positions
// where it has an objective, made into what is asked for; and the instants of a motion. Guarantee: exact, or
// between bounds where shapes rotate in time (docs/results.md). Keywords: feasible region, answer.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "formula/planar/solve_region.h"
#include "io/question/asked_scene.h"
#include "io/write/write_json.h"
#include "plane/query/locate_line.h"
#include "plane/query/summary.h"

namespace findspace::io {

/// The answer to a scene's question.
struct PlanarMap {
  plane::Region region;
  std::optional<plane::Region> feasible;  // where the region is a part of it: the best positions
  std::optional<distance::OptimalValue> extreme;
  std::optional<plane::Region> outer;         // where the region is certainly feasible, and only this possibly
  std::optional<formula::PlanarLine> line{};  // to whose ends the region goes: the scene's, where there is an objective
};

/// What is made of a region.
struct Applied {
  std::string operation{};  // interior closure boundary regularize complement, or nothing
  std::string before{};     // what messages put before "apply"
};

/// `known`: the region of the formula where it has been made already, its cells in order. Where the caller had the last
/// pointer to the solver, its shapes go as soon as nothing needs them.
PlanarMap planar_map(const AskedScene& asked, std::shared_ptr<const formula::Solver> solver,
                     const formula::Formula& formula, const Applied& apply = {},
                     const formula::SolvedRegion* known = nullptr);
/// The region of the scene's formula; kept where the scene is prepared, but not of an instant. `solver`: where there is
/// one already.
std::shared_ptr<const KeptRegion> region_of(const AskedScene& asked, const formula::Formula& formula,
                                            const std::shared_ptr<const formula::Solver>& solver = nullptr);
formula::SolvedRegion solved_region(const KeptRegion& kept);
/// The part of it on the scene's line where it has one, as far as any position of the grid needs it; likewise.
std::shared_ptr<const KeptRegion> positions_of(const AskedScene& asked, const formula::Formula& formula,
                                               const std::shared_ptr<const formula::Solver>& solver = nullptr);
/// As `map --json` prints it, perhaps with exact cells. `known`: the summary of the map's region, where it has been
/// made already.
std::string planar_map_json(const AskedScene& asked, const PlanarMap& map, bool exact,
                            const plane::Summary* known = nullptr);
/// The same, piece by piece where there is one region of positions.
void planar_map_json(const AskedScene& asked, const PlanarMap& map, bool exact, const plane::Summary* known,
                     const Sink& sink);
/// The part of a map on the scene's line.
formula::SolvedRegion on_line(const formula::SolvedRegion& region, const Free& free);
/// The lengths along the scene's line that belong to a region of its map.
std::vector<plane::LineInterval> intervals_on_line(const PlanarMap& map, const plane::Region& region, const Free& free);

/// The instants at which a formula holds at a position.
struct PlanarInstants {
  std::vector<plane::LineInterval> intervals;
  std::optional<std::vector<plane::LineInterval>> outer;  // where the intervals are certain, and these possible

  std::string json() const;
};
/// `at` in the scene's unit.
PlanarInstants planar_instants(const formula::Solver& solver, const formula::Formula& formula,
                               const exact::RealPoint& at);

}  // namespace findspace::io
