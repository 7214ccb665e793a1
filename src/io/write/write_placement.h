// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Placements as JSON, as text for people and as pictures, as docs/results.md describes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/write/write_svg.h"
#include "planning/outcome/outcome.h"

namespace findspace::io {

/// All positions of a body (at one angle, if it may turn), as `map` writes them.
struct PositionsResult {
  std::string shape;
  std::optional<planning::Orientation> angle;
  std::string region;
};

struct PlacementResult : planning::Outcome {
  std::vector<PositionsResult> regions;  // those of one shape one after another
};

/// With the regions of bodies that are placed once; of copies they would be many and alike.
PlacementResult placement_result(const planning::Problem& problem, const planning::SequentialPlacement& found);
PlacementResult placement_result(const planning::Problem& problem, const planning::SimultaneousPlacement& found);
PlacementResult placement_result(const planning::SpaceProblem& problem, const planning::SpacePlacement& found);
PlacementResult placement_result(const planning::SpaceProblem& problem, const planning::SpaceSimultaneous& found);

/// The rows of a rotation's matrix as JSON; a turn in words.
std::string matrix_json(const space::Rotation& rotation);
std::string orientation_text(const planning::Orientation& turn);

std::string placement_json(const PlacementResult& result, const exact::Real& step, std::string_view unit);
std::string placement_text(const PlacementResult& result, const exact::Real& step, std::string_view unit);

/// The shapes of all placed bodies where they were put, by name.
struct PlacedRegions {
  std::vector<plane::Region> regions;
  std::vector<std::string> names;
  /// Refers to the regions.
  std::vector<NamedRegion> named() const;
};
PlacedRegions placed_regions(const planning::Problem& problem, const planning::Poses& poses);

/// What a picture of a placement says besides the shapes.
struct PlacementPicture {
  std::string title;               // "Placement, sequential"
  std::string subtitle;            // in the plane
  std::vector<std::string> lines;  // in space
  std::string unit;
  std::vector<std::string> fixed;  // names of the shapes that stand still
  bool y_down = false;
  bool is_board = false;             // of circuits: its parts carry their names, its pads none
  std::vector<NamedRegion> parts{};  // of a board: those that stand still
  std::vector<CopperLayer> copper{};
};
std::string placement_svg(const planning::Problem& problem, const planning::Poses& poses,
                          const PlacementPicture& picture);
/// In blue what is placed.
std::string placement_svg(const planning::SpaceProblem& problem, const planning::SpacePoses& poses,
                          const PlacementPicture& picture);
/// The names that no body has, of those given.
std::vector<std::string> standing_still(const planning::Demands& demands, const std::vector<std::string>& names);

}  // namespace findspace::io
