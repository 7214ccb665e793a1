// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What every reader of shapes shares: the grid it puts points on, and the account of what that changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/text/units.h"

namespace findspace::io {

struct ReadContext {
  std::filesystem::path folder;  // where relative file names start
  bool files = true;             // whether other files may be read
  std::optional<Unit> unit;      // the scene's
  Grid grid;

  RoundingLog rounding;
  std::int64_t repeated_points = 0;  // dropped
  std::int64_t turned_rings = 0;     // outer rings given clockwise
  std::int64_t grown_arcs = 0;       // whose ends were further apart than twice their radius
  std::vector<std::string> notes;    // anything else

  /// All of it in words, e.g. "12 points rounded to the grid, largest move 3.1e-07 mm".
  std::vector<std::string> summary() const;
};

}  // namespace findspace::io
