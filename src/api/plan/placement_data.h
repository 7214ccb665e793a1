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
#include "plane/contour/decimal_grid.h"
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

namespace api {

/// What planning says of each body, in the unit; without positions and texts.
Placement::Told told(const planning::Outcome& outcome, const exact::Real& step);
/// The positions that a body had, angle by angle.
void tell_positions(const planning::Body& body, std::size_t index, const std::vector<planning::AtAngle>& all,
                    const plane::Grid& grid, const std::string& unit, Placement::Told& out);

}  // namespace api
}  // namespace findspace
