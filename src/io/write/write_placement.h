// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Placements as JSON and as text for people, as docs/results.md describes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/number/real.h"

namespace findspace::io {

/// Of one body, in the plane or in space; lengths in grid steps, values in the scene's unit.
struct PlacedResult {
  std::string shape;
  int copy = 0;                      // 0: the only one
  std::optional<exact::Real> angle;  // where the scene allows other angles than 0
  std::vector<exact::Real> at;       // none: it has no position
  bool attained = true;
  std::vector<std::optional<exact::Real>> infimum;  // of the objectives, where it is not attained
};

/// All positions of a body (at one angle, if it may turn), as `map` writes them.
struct PositionsResult {
  std::string shape;
  std::optional<exact::Real> angle;
  std::string region;
};

struct PlacementResult {
  std::string method;
  std::vector<PlacedResult> placed;
  std::vector<PositionsResult> regions;  // those of one shape one after another
  bool attained = true;
  /// None: the search ended with a proof. Otherwise why it did not: then regions hold some of the positions only.
  std::optional<std::string> unproven;
};

std::string placement_json(const PlacementResult& result, const exact::Real& step, std::string_view unit);
std::string placement_text(const PlacementResult& result, const exact::Real& step, std::string_view unit);

}  // namespace findspace::io
