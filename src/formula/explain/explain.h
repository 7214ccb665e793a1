// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Why a formula holds nowhere, and what would change that; where it holds, how far each level can move before it holds
// nowhere. For a demand `d <= level` let R be the positions that the formula has without it. The least
// change that alone leaves a position is to inf {d : R}; the tightest level that does is the same number where R is the
// feasible region. For `>=` it is the supremum, for `=` the nearer of both.
//
// Guarantee: whether there is room, and which demands conflict, is exact. Levels are exact where `proven`, else
// enclosed. The common relaxation moves all levels by one amount t and is enclosed: `lower` leaves no position, `upper`
// does. In space a search decides where the positions are not made of boxes (space_ground.cpp): what it does not decide
// is said so, of the whole by Error(kLimit). Over angles the moving shape stays at a position, and an angle takes the
// place of a position (angle_ground.cpp), over time an instant (time_ground.cpp). Refused: over positions shapes that
// rotate in time and distances in rotation, whose regions are known between bounds, and over time the same; over angles
// distances in rotation about another point; in space distances along a direction, and `-> min`. Cost: in the plane one
// overlay, for each demand a look at its cells and one least value, some fifteen regions for the common relaxation; in
// space a search each. The cells and looks are counted against the work that the asker allows (failing_cells.h).
// Keywords: infeasibility analysis, irreducible infeasible subsystem, elastic relaxation, slack, sensitivity.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "distance/answer/optimum.h"
#include "formula/explain/conflict.h"
#include "formula/planar/rotation_maps.h"
#include "formula/planar/solve.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

class RotationSolver;

/// One that remains, or that is there then: a position, or over all angles an angle, over time an instant.
struct RemainingPlace {
  std::optional<distance::Coordinates> at;  // in the scene's unit
  std::size_t pose = 0;                     // of `at`: which of the poses that were asked about
  std::optional<double> degrees;            // from 0 on, below 360
  std::optional<double> time;               // an instant of the motion
};

/// How one demand's level can move while all others stay.
struct LevelChange {
  enum class Kind : std::uint8_t {
    kTo,    // to `level`
    kNone,  // no level leaves room: the others conflict without this one
    kFree,  // of slack: there is room without this demand's part of the formula, or beyond every level
    kUnknown
  };
  std::size_t atom = 0;
  Kind kind = Kind::kNone;
  distance::OptimalValue level;  // in the scene's unit, of the atom's canonical distance
  bool reached = false;          // there is room at this very level; else only beyond it, as near as you like
  RemainingPlace place;          // the last one
  std::string refused;           // of kUnknown: why

  /// Of kTo.
  const exact::Real& to() const { return level.answer->value; }
};

/// All levels move by one amount: there is none for `lower` and room for `upper`.
struct CommonRelaxation {
  exact::Real lower;
  std::optional<exact::Real> upper;  // nothing: no amount that was tried leaves a position
  RemainingPlace place;              // for `upper`
};

struct Explanation {
  bool feasible = false;
  std::optional<Conflict> conflict;          // where not feasible
  std::vector<LevelChange> relax;            // where not feasible, of the demands that have a level
  std::optional<CommonRelaxation> together;  // where not feasible and some demand has a level, all of one unit
  std::vector<LevelChange> slack;            // where feasible, of the demands that have a level
};

/// Throws Error(kUnsupported) for what is refused as a whole.
Explanation explain(const Solver& solver, const Formula& formula);
/// Worlds that differ in the pose of the moving shapes alone; one at least.
using Poses = std::span<const std::shared_ptr<const Solver>>;
/// Of some poses. There is room where there is in one of them; a conflict is one in all of them; a level is the best of
/// all of them.
Explanation explain(Poses poses, const Formula& formula);
Explanation explain(const SpaceSolver& solver, const Formula& formula);
/// Over all angles of the moving shape.
Explanation explain(const RotationMaps& maps, const Formula& formula);

/// Over all instants of the motion at a position in the scene's unit.
Explanation explain_instants(const Solver& solver, const Formula& formula, const exact::RealPoint& p);

/// What stands in the way at one position.
struct PositionExplanation {
  Check check;
  std::vector<std::size_t> change;  // a minimal set of demands without which the formula holds there
  AskedNearest nearest;             // where not feasible
};

/// At a position in the scene's unit.
PositionExplanation explain_at(const Solver& solver, const Formula& formula, const exact::RealPoint& p);
PositionExplanation explain_at(const SpaceSolver& solver, const Formula& formula, const space::RealVector& p);
/// At a pose: the check is exact, `rotated` has the shapes rotated, their vertices on the grid.
PositionExplanation explain_at(const RotationSolver& pose, const Solver& rotated, const Formula& formula,
                               const exact::RealPoint& p);

/// Where a position is feasible, though none is with vertices on the grid: how far levels can move is not known.
Explanation feasible_off_the_grid(const Formula& formula);

/// The atom as its writer would put it at another level. One that is not a short decimal is rounded to a thousandth of
/// `step`, to the side on which there is more room, and moved by one such part where the level itself is not `reached`.
std::string written_at(const Demands& demands, const LevelChange& change, const exact::Real& step);

}  // namespace findspace::formula
