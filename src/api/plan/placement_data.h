// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public Placement: the problem, in the plane or in space, and what was found by one method. One
// that was told has no problem: its texts are there.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "findspace/placement.h"
#include "planning/outcome/outcome.h"

namespace findspace {

struct Placement::Data {
  using Planar = std::variant<planning::SequentialPlacement, planning::SimultaneousPlacement>;
  using Solid = std::variant<planning::SpacePlacement, planning::SpaceSimultaneous>;

  std::string unit;
  std::vector<std::string> names;  // of all shapes
  planning::Problem planar{};      // one of these two
  planning::SpaceProblem solid{};
  std::optional<Planar> in_plane{};
  std::optional<Solid> in_space{};

  Told told{};  // without texts where they can be made
};

}  // namespace findspace
