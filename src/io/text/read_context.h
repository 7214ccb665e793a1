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

#include "findspace/files.h"
#include "io/text/units.h"
#include "plane/base/work_budget.h"
#include "space/mesh/mesh_repair.h"

namespace findspace::io {

/// The rules of drawings in grid steps.
struct DrawingUse {
  CurveRule curves = CurveRule::kNear;
  double tolerance = 1000, join = 0;
  std::optional<double> mend{};  // the widest crossing that is mended, where it is stated
  bool open_lines = false;
  std::optional<PartRule> parts{};  // where it is stated
  space::MeshRepair repair{};
};

/// What curves have become.
struct CurveLog {
  std::int64_t curves = 0, arcs = 0, caps = 0;
  double bound = 0;     // the largest tolerance, in grid steps
  std::string sides{};  // "near", "inside", "outside" or several of them
};

struct ReadContext {
  ReadContext() = default;
  explicit ReadContext(const ReadOptions& o) : options(o), work(o.work_limit), bytes_left(o.input_limit) {}

  ReadOptions options;
  plane::WorkBudget work;                  // of reading
  std::uint64_t bytes_left = kUsualInput;  // of all files
  std::filesystem::path folder;            // where relative file names start
  std::optional<Unit> unit;                // the scene's
  Grid grid;

  DrawingRules scene_rules;  // as the scene states them
  DrawingUse drawing;        // of the shape that is read
  bool quantities = false;   // unless stated, outlines whose names say how many are parts, of any drawing
  CurveLog curves;

  RoundingLog rounding;
  std::int64_t repeated_points = 0;  // dropped
  std::int64_t reversed_rings = 0;   // outer rings given clockwise
  std::int64_t grown_arcs = 0;       // whose ends were further apart than twice their radius
  std::vector<std::string> notes;    // anything else

  /// The bytes of a file of shapes; they count. Throws Error (read_text.h), kUnsupported where files are switched off.
  std::string take_file(const std::filesystem::path& path);
  /// Counts bytes that were packed in a file. Throws Error(kLimit).
  void take_bytes(std::uint64_t bytes, const std::string& what);

  /// Makes these rules those of what is read from here on; throws Error. Needs the unit and the grid.
  void use(const DrawingRules& rules);

  /// Grid steps in the scene's unit, as messages say them.
  std::string length_text(double steps) const;
  std::string point_text(double x, double y) const;

  /// All of it in words, e.g. "12 points rounded to the grid, largest move 3.1e-07 mm".
  std::vector<std::string> summary() const;
};

}  // namespace findspace::io
