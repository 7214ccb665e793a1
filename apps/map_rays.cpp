// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Maps of 3D scenes on N x N lines along z, for solids of any shape: with --resolution N, or where no exact map is to
// be had.
#include <fmt/format.h>

#include <algorithm>

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
};

Cast cast_lines(const RaySet& set, double step) {
  Cast out;
  out.grid = space::ray_grid(set.low, set.high, 2, set.resolution);
  space::RaySummarizer summarizer(out.grid);
  io::RayLines lines(out.grid, step);
  space::each_row(*set.source(out.grid), [&](int j, space::RayRow&& row) {
    summarizer.add(j, row);
    lines.add(j, row);
  });
  out.summary = summarizer.finish();
  out.lines = lines.text();
  return out;
}

Cast cast_axes(const RaySet& set, double step) {
  Cast out;
  const space::RayLattice lattice = space::ray_lattice(set.low, set.high, set.resolution);
  out.grid = lattice.grid(2);
  io::RayLines lines(out.grid, step);
  int row_number = 0;
  space::RayAxes axes = space::ray_axes(
      lattice, [&](int axis) { return set.source(lattice.grid(axis)); }, in_region,
      [&](const space::RayGrid& grid, const space::RayRow& row) {
        if (grid.axis == 2) lines.add(row_number++, row);
      });
  out.summary = std::move(axes.summary);
  out.surface = std::move(axes.surface);
  out.lines = lines.text();
  return out;
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
  const auto json = [&] {
    return io::rays_json(cast.summary, cast.grid, set.unbounded, step, session.unit(), cast.lines, set.axes);
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
    const space::RayGrid slices = io::slice_grid(set.low, set.high, kLayers, set.resolution);
    return io::slices_svg(space::all_rows(*set.source(slices)), slices, set.low, set.high, step, set.title,
                          session.unit());
  };
  write_outputs(options, writers);
  return {options.json ? json() : summary_text(set, cast.summary, step, session.unit()), kDone};
}

Outcome map_rays(const Session& session, int resolution, bool axes) {
  if (session.goal())
    throw Error(ErrorCode::kUnsupported, "an objective is not computed on rays", session.scene().file);
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
  set.source = [&](const space::RayGrid& grid) { return situation::ray_region(world, formula, grid); };
  return rays_outcome(session, set);
}

}  // namespace findspace::app
