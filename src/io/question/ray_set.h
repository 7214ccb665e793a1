// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A set of positions, or a shape, that is taken on parallel lines of space: what is asked, what the lines tell, and
// what `minimize`, `maximize` and `-> min` come to on them.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "formula/solid/ray_minima.h"
#include "formula/solid/solve_rays.h"
#include "io/question/asked_scene.h"
#include "io/team/row_team.h"
#include "io/write/write_json_rays.h"
#include "space/rays/ray_extreme.h"
#include "space/rays/ray_intervals.h"
#include "space/rays/ray_summary.h"
#include "space/rays/ray_surface.h"

namespace findspace::io {

/// How many lines or how far apart, along which axis, or along all three.
struct LineChoice {
  int count = 0;           // lines each way; 0: by `apart`
  std::int64_t apart = 0;  // grid steps from line to line; 0: by `count`
  int axis = 2;
  bool axes = false;  // along all three

  space::RayGrid grid(const space::Point& low, const space::Point& high) const;
  space::RayLattice lattice(const space::Point& low, const space::Point& high) const;
};

/// A distance that is to be least (or greatest) over a set on lines.
struct RayObjective {
  bool greatest = false;
  double sign = 1;                                            // -1: the objective is minus the distance
  std::function<double(const std::array<double, 3>&)> value;  // at a position, all in grid steps
};

struct RaySet {
  std::string title, subtitle, meaning;  // of the picture; what the set consists of
  LineChoice lines;
  struct Fixed {
    std::string name;
    plane::ShapePtr shape;
  };
  std::vector<Fixed> fixed;                        // for the picture
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

/// How far a place of a line's cell may be from the line, rounded up; in grid steps.
exact::Real cell_radius(const RaySet& set);

/// What the lines tell.
struct Cast {
  space::RayGrid grid;
  formula::Side on_lines = formula::Side::kExact;  // how they stand to the region
  space::RaySummary summary;
  Spool lines;                // as JSON, where that is written
  space::RaySurface surface;  // of three axes only
  std::optional<space::RayExtreme::Found> extreme;
  std::vector<space::RayInterval> intervals;  // where an objective wants them
};
/// `written`: with the lines as JSON; `step`: of the grid in the scene's unit.
Cast cast_lines(const RaySet& set, double step, bool written);
/// On the lines of all three axes.
Cast cast_axes(const RaySet& set, double step, bool written);
/// Whether a sign says that it belongs to the set.
bool in_ray_set(std::int8_t sign);
/// Of rows of such a set.
RowDigester row_digester(double step);

/// Of a coordinate or the distance to a point.
space::RayAim aim_of(const AskedScene& asked, const AskedScene::Goal& goal);
distance::OptimalValue optimum_of(const RaySet& set, const Cast& cast, double step);
/// Of a distance. Refers to the solver.
RayObjective objective_of(const formula::SpaceSolver& solver, const AskedScene::Goal& goal);
distance::OptimalValue best_of(const RaySet& set, Cast& cast, double step);
/// Of an atom with `-> min`.
distance::OptimalValue least_of(const formula::LeastOf& found);
std::string ray_optimum_text(const distance::OptimalValue& found);

}  // namespace findspace::io
