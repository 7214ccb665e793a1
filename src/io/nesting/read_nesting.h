// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems and layouts as files: the common nesting JSON (items, demand, allowed_orientations, strip_height,
// and here sheets, zones, values, gaps of pairs, and shapes of the scene language), layouts as JSON (docs/nesting.md),
// and the SVG of sparrow, which holds shapes and transforms both. Numbers are read exactly. Keywords: ESICUP, jagua-rs,
// sparrow.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "findspace/files.h"
#include "io/nesting/unscaled_problem.h"
#include "packing/problem/problem.h"

namespace findspace::io {

/// What a command line adds: a height instead of the file's, the least distance of parts, and of parts to the strip's
/// sides.
struct NestingOptions {
  std::optional<packing::Fraction> height;
  packing::Fraction gap, edge;
  ReadOptions read = {};              // of shapes in files,
  std::filesystem::path folder = {};  // which are looked for here, or beside the problem
};

/// Throws Error. Without `allowed_orientations` a part is not turned.
packing::Problem read_nesting(const std::string& text, const std::string& name, const NestingOptions& asked = {});
/// The same as the file states it.
UnscaledProblem read_unscaled(const std::string& text, const std::string& name, const NestingOptions& asked = {});

/// A layout of this problem.
packing::Layout read_layout(const std::string& text, const std::string& name, const packing::Problem& problem);

struct ProblemAndLayout {
  packing::Problem problem;
  packing::Layout layout;
};

/// The drawing of a layout that sparrow writes. Its parts may stand at the angles at which they stand.
ProblemAndLayout read_sparrow_svg(const std::string& text, const std::string& name);

}  // namespace findspace::io
