// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sets of angles as JSON (docs/results.md): intervals in degrees, `from` in [0, 360), `to` beyond 360 where one goes
// across 0.
#pragma once

#include <string>
#include <vector>

#include "io/write/write_json.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::io {

struct DegreeInterval {
  double from = 0, to = 0;  // from in [0, 360), to in [from, from + 360]
  bool from_in = false, to_in = false;
  bool round = false;  // `from` and `to` are one angle, and all others lie between

  bool single() const { return from == to && from_in; }
  bool whole() const { return round && from_in; }
};

/// The whole circle is [0, 360), a circle without one angle (a, a + 360).
std::vector<DegreeInterval> degree_intervals(const plane::RotationMap& set);
std::string rotations_json(const plane::RotationMap& set, const distance::OptimalValue* best = nullptr);

}  // namespace findspace::io
