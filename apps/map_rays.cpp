// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Maps of 3D scenes on N x N lines along z, for solids of any shape: with --resolution N, or where no exact map is to
// be had.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/draw_slices.h"
#include "io/write_json_rays.h"
#include "io/write_mesh.h"
#include "ray_outcome.h"
#include "situation/solve_rays.h"
#include "space/ray_axes.h"
#include "space_commands.h"

namespace findspace::app {
namespace {

/// Of the picture in slices.
constexpr int kLayers = 16;

std::string summary_text(const RaySet& set, const space::RaySummary& summary, double step, const std::string& unit) {
  if (summary.empty && !set.unbounded)
    return set.title + ": no line meets the region (smaller parts may lie between the lines)\n";
  std::string out = fmt::format("{}: on {} lines, {} intervals\n", set.title, summary.lines, summary.intervals);
  if (set.unbounded) return out + "  the region is unbounded\n";
  const auto certified = std::count_if(summary.components.begin(), summary.components.end(),
                                       [](const space::RayComponent& c) { return c.certified; });
  return out + fmt::format("  volume about {} {}3, {} components by {}\n", summary.volume * step * step * step, unit,
                           summary.components.size(),
                           set.axes ? fmt::format("crossing lines ({} certified)", certified)
                                    : "overlap of neighbouring lines");
}

bool in_region(std::int8_t sign) { return sign <= 0; }

/// What the lines tell.
struct Cast {
  space::RayGrid grid;
  space::RaySummary summary;
  std::string lines;
  space::RaySurface surface;  // of three axes only
  std::optional<space::RayExtreme::Found> extreme;
};

Cast cast_lines(const RaySet& set, double step) {
  Cast out;
  out.grid = space::ray_grid(set.low, set.high, 2, set.resolution);
  space::RaySummarizer summarizer(out.grid);
  io::RayLines lines(out.grid, step);
  space::RayExtreme extreme(set.aim.value_or(space::RayAim{}));
  space::each_row(*set.source(out.grid), [&](int j, space::RayRow&& row) {
    summarizer.add(j, row);
    lines.add(j, row);
    extreme.add(out.grid, j, row);
  });
  out.summary = summarizer.finish();
  out.extreme = extreme.found();
  out.lines = lines.text();
  return out;
}

Cast cast_axes(const RaySet& set, double step) {
  Cast out;
  const space::RayLattice lattice = space::ray_lattice(set.low, set.high, set.resolution);
  out.grid = lattice.grid(2);
  io::RayLines lines(out.grid, step);
  space::RayExtreme extreme(set.aim.value_or(space::RayAim{}));
  std::array<int, 3> rows{};
  space::RayAxes axes = space::ray_axes(
      lattice, [&](int axis) { return set.source(lattice.grid(axis)); }, in_region,
      [&](const space::RayGrid& grid, const space::RayRow& row) {
        const int j = rows[static_cast<std::size_t>(grid.axis)]++;
        if (grid.axis == 2) lines.add(j, row);
        extreme.add(grid, j, row);
      });
  out.summary = std::move(axes.summary);
  out.extreme = extreme.found();
  out.surface = std::move(axes.surface);
  out.lines = lines.text();
  return out;
}

space::RayAim aim_of(const Session& session, const Session::Goal& goal) {
  using Kind = situation::Objective::Kind;
  space::RayAim aim;
  aim.greatest = goal.sense == distance::Sense::kMaximum;
  const Kind kind = goal.objective.kind;
  if (kind == Kind::kX || kind == Kind::kY || kind == Kind::kZ) {
    aim.axis = kind == Kind::kX ? 0 : kind == Kind::kY ? 1 : 2;
  } else if (kind == Kind::kDistanceToPoint && !aim.greatest) {
    for (std::size_t k = 0; k < 3; ++k) aim.point[k] = (goal.objective.point.at(k) / session.step()).to_double();
  } else {
    throw Error(ErrorCode::kUnsupported, "in 3D the objectives are x, y, z and the distance to a point (minimised)",
                session.scene().file);
  }
  return aim;
}

io::RayOptimum optimum_of(const RaySet& set, const Cast& cast, double step) {
  io::RayOptimum out;
  out.maximum = set.aim->greatest;
  // Of a coordinate there is no bound where the region goes on for ever.
  if (!cast.extreme || (set.unbounded && set.aim->axis >= 0)) return out;
  out.attained = cast.extreme->attained;
  out.value = cast.extreme->value * step;
  for (std::size_t k = 0; k < 3; ++k) out.at[k] = cast.extreme->at[k] * step;
  return out;
}

/// What the slices show: the region with a little around it, within the box of the lines.
std::pair<space::Point, space::Point> shown_box(const RaySet& set, const space::RaySummary& summary) {
  space::Point low = set.low, high = set.high;
  if (summary.empty) return {low, high};
  constexpr double kAround = 0.05;
  const auto shrink = [&](std::int64_t space::Point::*axis, std::size_t k) {
    const double room = std::max(1.0, (summary.high[k] - summary.low[k]) * kAround);
    low.*axis = std::max(low.*axis, static_cast<std::int64_t>(std::floor(summary.low[k] - room)));
    high.*axis = std::min(high.*axis, static_cast<std::int64_t>(std::ceil(summary.high[k] + room)));
  };
  shrink(&space::Point::x, 0);
  shrink(&space::Point::y, 1);
  shrink(&space::Point::z, 2);
  return {low, high};
}

}  // namespace

situation::RayWorld ray_world(const Session& session) {
  situation::RayWorld world;
  for (const auto& shape : session.scene().shapes) world.shapes.emplace(shape->name, situation::RayShape(*shape));
  world.moving = session.scene().moving;
  world.step = session.step();
  return world;
}

Outcome rays_outcome(const Session& session, const RaySet& set) {
  const Options& options = session.options();
  std::vector<std::string> formats{".json"};
  formats.insert(formats.end(), io::kSurfaceEndings.begin(), io::kSurfaceEndings.end());
  check_outputs(options, formats);
  if (!options.apply.empty()) throw Error(ErrorCode::kUsage, "--apply needs an exact map, not one on rays");
  const double step = session.step().to_double();
  session.talk().stage("casting rays");
  const Cast cast = set.axes ? cast_axes(set, step) : cast_lines(set, step);
  const auto optimum = set.aim ? std::optional(optimum_of(set, cast, step)) : std::nullopt;
  const auto json = [&] {
    return io::rays_json(cast.summary, cast.grid, set.unbounded, step, session.unit(), cast.lines, set.axes,
                         optimum ? &*optimum : nullptr);
  };
  const auto surface = [&] {
    if (set.axes) return io::ray_surface_mesh(cast.surface, step);
    const space::RayLattice lattice = space::ray_lattice(set.low, set.high, set.resolution);
    return io::ray_surface_mesh(space::ray_surface(
                                    lattice, [&](int axis) { return set.source(lattice.grid(axis)); }, in_region),
                                step);
  };
  session.talk().stage("writing");
  Writers writers{{".json", json}};
  for (const char* ending : io::kSurfaceEndings)
    writers.emplace(ending, [=] { return io::surface_text(surface(), set.title, ending, session.unit()); });
  writers[".svg"] = [&] {
    const auto [low, high] = shown_box(set, cast.summary);
    const space::RayGrid slices = io::slice_grid(low, high, kLayers, set.resolution);
    return io::slices_svg(space::all_rows(*set.source(slices)), slices, low, high, step, set.title, session.unit());
  };
  write_outputs(options, writers);
  std::string text = options.json ? json() : summary_text(set, cast.summary, step, session.unit());
  if (!options.json && optimum && optimum->value)
    text += fmt::format("  {} on the lines: {} at ({}, {}, {})\n", optimum->maximum ? "greatest" : "least",
                        *optimum->value, optimum->at[0], optimum->at[1], optimum->at[2]);
  return {std::move(text), kDone};
}

Outcome map_rays(const Session& session, int resolution, bool axes) {
  const situation::Formula formula = session.where();
  session.talk().stage("building the shapes");
  const situation::RayWorld world = ray_world(session);
  const situation::RayWindow window = situation::window(world, formula);
  RaySet set;
  set.title = fmt::format("Positions of {}", fmt::join(session.scene().moving, ", "));
  set.resolution = resolution;
  set.axes = axes;
  set.low = window.low, set.high = window.high;
  set.unbounded = situation::holds_far_away(world, formula);
  if (const auto goal = session.goal()) set.aim = aim_of(session, *goal);
  set.source = [&](const space::RayGrid& grid) { return situation::ray_region(world, formula, grid); };
  return rays_outcome(session, set);
}

}  // namespace findspace::app
