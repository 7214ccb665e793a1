// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Packing problems in space and their layouts as files: the JSON of ESICUP's data sets (a container with a floor, kinds
// of items from mesh files), with shapes of a scene besides (docs/packing.md). Numbers are read exactly: the grid has
// as many digits as they need, up to nine. Keywords: three-dimensional strip packing, ESICUP.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findspace/files.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/stated_conditions.h"
#include "packing/solid_problem/solid_problem.h"

namespace findspace::io {

/// Whether a text is a problem in space: it has "container" and "item-types". Throws Error where it is no JSON.
bool is_solid_problem(const std::string& text, const std::string& name);

struct SolidProblemRead {
  packing::SolidProblem problem;
  std::vector<std::string> notes;                      // what was changed in meshes
  std::vector<plane::ShapePtr> shapes;                 // of the parts, on the problem's grid
  std::vector<plane::ShapePtr> container_shapes = {};  // null of boxes
  StatedConditions stated;
};

/// In a container none is larger than its sides together; nothing where the height is sought.
std::optional<packing::Fraction> farthest_gap(const packing::SolidProblem& problem);

/// Throws Error where more copies are fixed than are wanted, or fixed solids overlap or lie outside.
void check_fixed(const packing::SolidProblem& problem, const std::string& place);

/// Of the text of the file `name`; paths begin at its folder. Throws Error.
SolidProblemRead read_solids(const std::string& text, const std::string& name, const NestingOptions& asked,
                             const ReadOptions& options);

/// A layout of this problem.
packing::SolidLayout read_solid_layout(const std::string& text, const std::string& name,
                                       const packing::SolidProblem& problem);

}  // namespace findspace::io
