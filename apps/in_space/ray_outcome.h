// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A set on the lines of a grid as the answer of a verb: numbers, lines and surface.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/line_choice.h"
#include "common/session.h"
#include "formula/solid/ray_minima.h"
#include "formula/solid/solve_rays.h"
#include "io/write/write_json_rays.h"
#include "space/rays/ray_extreme.h"

namespace findspace::app {

/// A distance that is to be least (or greatest) over a set on lines.
struct RayObjective {
  bool greatest = false;
  double sign = 1;                                            // -1: the objective is minus the distance
  std::function<double(const std::array<double, 3>&)> value;  // at a position, all in grid steps
};

struct RaySet {
  std::string title, subtitle, meaning;  // of the picture; what the set consists of
  LineChoice lines;
  std::vector<plane::ShapePtr> fixed;              // for the picture
  space::Point low, high;                          // a box that holds the frontier
  bool unbounded = false;                          // the set goes on beyond it
  std::optional<space::RayAim> aim;                // what is looked for in the set
  std::optional<RayObjective> objective;           // or this
  bool somewhere = false;                          // it is known not to be empty
  formula::Side on_lines = formula::Side::kExact;  // of the set on the lines, whatever its source says
  formula::Side side = formula::Side::kNone;       // of the cells about the lines
  std::optional<distance::OptimalValue> least;     // of a formula with `-> min`
  std::function<formula::RegionOnLines(const space::RayGrid&)> source;  // at most 0 in the set
};

/// What --side asks for.
void take_side(const Session& session, RaySet& set);
/// How far a place of a line's cell may be from the line, rounded up; in grid steps.
exact::Real cell_radius(const RaySet& set);

Outcome rays_outcome(const Session& session, const RaySet& set);

/// The map of a formula on the lines of all three axes as a picture: its JSON without the lines, and its surface.
struct RaysDrawn {
  std::string json;
  io::Surface surface;
};
RaysDrawn draw_rays(const Session& session, const LineChoice& lines, const formula::Formula& where);
/// The surface of a shape as `count` lines each way give it.
io::Surface shape_on_lines(const Session& session, const plane::Shape& shape, int count);

}  // namespace findspace::app
