// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The result of `explain` as JSON and as text, as docs/results.md describes it: the conflict, the least changes, the
// slack, and what stands in the way at one position. Levels are those of the words that the formula uses. Keywords:
// report, infeasibility, slack.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "formula/explain/explain.h"

namespace findspace::io {

/// What an explanation looks for: a position; or at one position an angle, or an instant.
enum class Sought : std::uint8_t { kPosition, kAngle, kInstant };

/// An explanation beside what it speaks of. `here` may be null.
struct ExplanationReport {
  const formula::Formula& formula;
  const formula::Explanation& explanation;
  const formula::PositionExplanation* here;
  distance::Coordinates at;  // of `here`, in the scene's unit
  exact::Real step;          // one grid step in the scene's unit
  std::string unit;
  std::vector<double> degrees = {};  // of the poses that were asked about; empty: as drawn alone
  Sought sought = Sought::kPosition;
  formula::Demands demands = formula::Demands(formula);
};

/// A change of a level in the words of the formula's writer.
struct SaidChange {
  std::string text, becomes;
  distance::OptimalValue level;
  exact::Real by;
};
SaidChange said(const ExplanationReport& report, const formula::LevelChange& change);

std::string explanation_json(const ExplanationReport& report);
std::string explanation_text(const ExplanationReport& report);

}  // namespace findspace::io
