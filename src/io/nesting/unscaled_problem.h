// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A packing problem as its file states it, before all its coordinates stand on one grid.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/nesting/stated_conditions.h"
#include "packing/problem/problem.h"
#include "plane/complex/shared_region.h"

namespace findspace::io {

using UnscaledRing = std::vector<std::pair<packing::Fraction, packing::Fraction>>;

/// Any closed bounded set, on a grid of its own.
struct UnscaledShape {
  plane::SharedRegion region;
  packing::Fraction step;
};

struct UnscaledPart {
  std::string name;
  int demand = 1;
  std::vector<UnscaledRing> rings;  // or `shape`
  std::vector<packing::Fraction> angles;
  bool mirrored = false;
  std::optional<packing::Fraction> value = {};
  std::optional<UnscaledShape> shape = {};
  packing::Fraction tilt = {};  // degrees, from 0 to 180
};

struct UnscaledZone {
  std::vector<UnscaledRing> rings;  // or `shape`
  std::vector<std::size_t> parts;
  bool holds = false;
  std::optional<UnscaledShape> shape = {};
};

struct UnscaledSheet {
  std::string name;
  int count = 1;
  std::optional<packing::Fraction> cost;
  std::vector<UnscaledRing> rings;  // or `shape`
  std::vector<UnscaledZone> zones;
  std::optional<UnscaledShape> shape = {};
};

struct UnscaledProblem : StatedConditions {
  std::string name;
  packing::Fraction height, gap, edge;
  bool box = false;  // of the least area, instead of a strip
  std::vector<UnscaledPart> parts;
  std::vector<UnscaledSheet> sheets;
  std::vector<packing::FixedPart> fixed;
  std::vector<std::string> notes;  // what the reader of the result should know

  /// Groups and what holds for all pairs become conditions of pairs; fixed parts are checked. Throws Error.
  /// On the decimal grid of its coordinates, six digits finer where parts turn by angles that are not of 90 degrees,
  /// or fewer where conditions hold for large parts or holes overlap.
  /// With shapes beside polygons that grid has seven digits at most, unless the numbers have more.
  packing::Problem on_grid(const std::string& place) &&;
};

}  // namespace findspace::io
