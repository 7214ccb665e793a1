// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Why a formula holds nowhere, and what would change that; where it holds, how far each level can move before it holds
// nowhere (World::explain, at some angles World::explain_poses, over all angles World::explain_angles, over the time
// of a motion World::explain_instants). Guarantee:
// whether there is room, and which conditions contradict each other, is exact; levels say their bounds. Source:
// docs/results.md, "explain". Keywords: infeasibility, conflict, slack, relaxation, sensitivity.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findspace/number.h"
#include "findspace/values.h"

namespace findspace {

/// How the level of one condition can move while all others stay.
struct LevelChange {
  /// To another level; none leaves room; as tight as you like; or not decided.
  enum class Kind { kTo, kNone, kFree, kUnknown };
  /// Of the change.
  Kind kind = Kind::kNone;
  /// The condition as it is written, and at the other level where there is room for certain: "gap(B, A) >= 1.5".
  std::string text, becomes;
  double to = 0, by = 0;                  // of kTo: the level, and how far it moves
  bool exact = false;                     // the level is known exactly
  double lower = 0, upper = 0;            // what it lies between
  bool reached = false;                   // there is room at this very level; else only beyond it, as near as you like
  std::optional<std::vector<double>> at;  // the last position that remains: x, y, in space z
  std::optional<double> angle;            // of some or all angles: in degrees from 0 on and below 360, there
  std::optional<double> time;             // of the instants of a motion: the last that remains
  std::string refused;                    // of kUnknown: why
};

/// What an explanation says.
struct Explanation {
  /// Whether the formula holds somewhere.
  bool feasible = false;
  std::vector<std::string> conflict;  // where not: conditions that contradict each other
  bool smallest = false;              // no conflict has fewer
  std::vector<LevelChange> relax;     // where not: the least change of each level alone that leaves a position
  std::vector<LevelChange> slack;     // where it does: how far each level can be tightened

  /// All levels move by one amount: there is no room for `lower` and room for `upper`.
  struct Together {
    /// Less is not enough.
    double lower = 0;
    std::optional<double> upper;            // nothing: no amount that was tried leaves a position
    std::optional<std::vector<double>> at;  // a position for it
    std::optional<double> angle;            // of some or all angles: in degrees, there
    std::optional<double> time;             // of the instants of a motion: one for it
  };
  std::optional<Together> together;  // where it holds nowhere and a condition has a level, all of one unit

  std::optional<Check> here;        // at the position that was given
  std::vector<std::string> change;  // conditions without which the formula holds there; no proper part of them will do

  /// All of it in words, and as `findspace explain --json` writes it (docs/results.md).
  std::string text, json;
};

}  // namespace findspace
