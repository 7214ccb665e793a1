// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a placement came to, body by body, in one form for the plane and for space, for both methods. Guarantee: that of
// what was found. Cost: a copy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planning/planar/sequential.h"
#include "planning/planar/simultaneous.h"
#include "planning/solid/space_sequence.h"
#include "planning/solid/space_simultaneous.h"

namespace findspace::planning {

/// Of one body, in the plane or in space; lengths in grid steps, values in the scene's unit.
struct BodyOutcome {
  std::string shape;
  int copy = 0;                                     // 0: the only one
  std::optional<Orientation> angle;                 // where other angles than 0 are allowed
  std::vector<exact::Real> at;                      // none: it has no position
  bool attained = true;                             // false with a position: all at once, where none is best
  std::vector<std::optional<exact::Real>> infimum;  // of the objectives, where it has no position for that
};

struct Outcome {
  std::string method;
  std::vector<BodyOutcome> placed;
  bool attained = true;
  /// None: the search ended with a proof. Otherwise why it did not: then there may be other positions.
  std::optional<std::string> unproven;

  /// Every body has a position.
  bool complete() const;
};

/// Whether a body may turn: then results say its angle.
bool may_turn(const Body& body);

Outcome outcome(const Problem& problem, const SequentialPlacement& found);
Outcome outcome(const Problem& problem, const SimultaneousPlacement& found);
Outcome outcome(const SpaceProblem& problem, const SpacePlacement& found);
Outcome outcome(const SpaceProblem& problem, const SpaceSimultaneous& found);

}  // namespace findspace::planning
