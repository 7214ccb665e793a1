// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The packing problem that a command line names: a file, or drawings with how many of each, "bracket.dxf x12 lid.svg".
// Drawings become nesting JSON whose shapes are files, so there is one reader. Keywords: quantities.
#pragma once

#include <findspace/packing.h>
#include <findspace/solid_packing.h>

#include <string>
#include <vector>

#include "common/options.h"

namespace findspace::app {

struct StatedProblem {
  std::string text;  // JSON
  std::string name;  // as messages call it
  bool drawn = false;
};

/// Of the words of a command line those that name files, not counts.
std::vector<std::string> files_among(const std::vector<std::string>& words);

/// Throws Error(kUsage) where a count stands without a drawing, or drawings without a strip or a sheet.
StatedProblem stated_problem(const std::vector<std::string>& words, const Options& options);

/// In the plane, and in space.
Packing stated_packing(const StatedProblem& stated, const Options& options);
SolidPacking stated_solids(const StatedProblem& stated, const Options& options);

}  // namespace findspace::app
