// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over a world of shapes, answered for all positions at once and for single ones: the entry to this street.
// Each question is answered by the functions of one of its headers, over the same prepared world; here positions are in
// the scene's unit. Guarantees and costs: there. Threads: safe. Keywords: feasible region, configuration space,
// formula.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "distance/planar_least/extremum.h"
#include "formula/language/position_answers.h"
#include "formula/planar/prepared_world.h"
#include "formula/planar/region_bounds.h"

namespace findspace::formula {

class Solver {
 public:
  explicit Solver(World world) : prepared_(std::move(world)) {}
  /// The same but for some shapes (PreparedWorld).
  Solver(const Solver& before, ShapeChanges changes) : prepared_(before.prepared_, std::move(changes)) {}

  const World& world() const { return prepared_.world(); }
  const PreparedWorld& prepared() const { return prepared_; }

  /// Regions of positions, in grid steps (regions.h).
  plane::Region feasible(const Formula& formula) const;
  RegionBounds feasible_bounds(const Formula& formula) const;
  /// feasible() is refused, feasible_bounds() is not (rotation_values.h, sums.h).
  bool known_between_bounds(const Formula& formula) const;

  /// One position (position_check.h, measure.h, nearest_feasible.h); of distances in rotation at rest with the moving
  /// shape upright (solve_rotation.h).
  Check check(const Formula& formula, const exact::RealPoint& p) const;
  bool holds(const Formula& formula, const exact::RealPoint& p) const;
  DistanceAt distance_at(const Distance& wanted, const exact::RealPoint& p) const;
  std::vector<DistanceAt> measure(const exact::RealPoint& p, const Formula& formula = {},
                                  const WantedText& wanted = {}) const;
  TriedNearest nearest_feasible(const Formula& formula, const exact::RealPoint& p) const;

  /// One position over the time of a motion (instants.h, swing.h).
  plane::Section instants(const Formula& formula, const exact::RealPoint& p) const;
  InstantBounds instant_bounds(const Formula& formula, const exact::RealPoint& p) const;
  std::optional<plane::Section> swing(const Formula& formula, const exact::RealPoint& p) const;
  /// By whichever of the three can: exactly, else between bounds.
  SolvedInstants solve_instants(const Formula& formula, const exact::RealPoint& p) const;

 private:
  /// A RotationSolver answers, at the angle 0.
  bool upright(const Formula& formula) const;

  PreparedWorld prepared_;
};

}  // namespace findspace::formula
