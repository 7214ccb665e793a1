// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The map of a scene of space whose shape moves along one line: the lengths at which its formula holds, the best ones
// where it has an objective. Guarantee: exact, or on one side where distances are found by search (docs/results.md).
// Cost: a section of each pair of shapes, and linear in the intervals. Keywords: degrees of freedom, ray.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "distance/answer/optimum.h"
#include "formula/solid/solve_space.h"
#include "io/question/asked_scene.h"
#include "plane/query/locate_line.h"

namespace findspace::io {

struct SpaceLineMap {
  /// Lengths from where the line goes through, in grid steps: where the formula holds, and the best of these where
  /// there is an objective.
  std::vector<plane::LineInterval> feasible{}, intervals{};
  std::vector<plane::LineInterval> undecided{};  // wide pieces of which a search does not tell whether they belong
  formula::Side side = formula::Side::kExact;    // on which `feasible` lies
  std::optional<distance::OptimalValue> extreme{};

  /// What certainly belongs, and what possibly does.
  std::vector<plane::LineInterval> certain() const;
  std::vector<plane::LineInterval> possible() const;
};

SpaceLineMap space_line_map(const AskedScene& asked, const formula::SpaceSolver& solver,
                            const formula::Formula& formula);
/// As `map --json` prints it.
std::string space_line_json(const AskedScene& asked, const SpaceLineMap& map);

}  // namespace findspace::io
