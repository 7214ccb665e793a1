// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Maps of 3D scenes on N x N lines along z, for solids of any shape: with --resolution N, or where no exact map is to
// be had.
#include <fmt/format.h>

#include "io/draw_slices.h"
#include "io/write_json_rays.h"
#include "io/write_mesh.h"
#include "plane/parallel.h"
#include "ray_outcome.h"
#include "situation/solve_rays.h"
#include "space_commands.h"

namespace findspace::app {
namespace {

/// Of the picture in slices.
constexpr int kLayers = 16;

situation::RayWorld ray_world(const Session& session) {
  situation::RayWorld world;
  for (const auto& shape : session.scene().shapes) world.shapes.emplace(shape->name, situation::RayShape(*shape));
  world.moving = session.scene().moving;
  world.step = session.step();
  return world;
}

std::string summary_text(const std::string& title, const space::RaySummary& summary, bool unbounded, double step,
                         const std::string& unit) {
  if (summary.empty && !unbounded)
    return title + ": no line meets the region (smaller parts may lie between the lines)\n";
  std::string out = fmt::format("{}: on {} lines, {} intervals\n", title, summary.lines, summary.intervals);
  if (unbounded) return out + "  the region is unbounded\n";
  return out + fmt::format("  volume about {} {}3, {} components by overlap of neighbouring lines\n",
                           summary.volume * step * step * step, unit, summary.components.size());
}

}  // namespace

Outcome rays_outcome(const Session& session, const RaySet& set) {
  const Options& options = session.options();
  std::vector<std::string> formats{".json"};
  formats.insert(formats.end(), io::kSurfaceEndings.begin(), io::kSurfaceEndings.end());
  check_outputs(options, formats);
  if (!options.apply.empty()) throw Error(ErrorCode::kUsage, "--apply needs an exact map, not one on rays");
  const double step = session.step().to_double();
  session.talk().stage("casting rays");
  const space::RayGrid grid = space::ray_grid(set.low, set.high, 2, set.resolution);
  const auto rays = set.source(grid);
  space::RaySummarizer summarizer(grid);
  io::RayLines lines(grid, step);
  space::each_row(*rays, [&](int j, space::RayRow&& row) {
    summarizer.add(j, row);
    lines.add(j, row);
  });
  const space::RaySummary summary = summarizer.finish();
  const auto json = [&] { return io::rays_json(summary, grid, set.unbounded, step, session.unit(), lines.text()); };
  const auto surface = [&] {
    const space::RayLattice lattice = space::ray_lattice(set.low, set.high, set.resolution);
    return io::ray_surface_mesh(space::ray_surface(
                                    lattice, [&](int axis) { return set.source(lattice.grid(axis)); },
                                    [](std::int8_t sign) { return sign <= 0; }),
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
  return {options.json ? json() : summary_text(set.title, summary, set.unbounded, step, std::string(session.unit())),
          kDone};
}

Outcome map_rays(const Session& session, int resolution) {
  if (session.goal())
    throw Error(ErrorCode::kUnsupported, "an objective is not computed on rays", session.scene().file);
  const situation::Formula formula = session.where();
  session.talk().stage("building the shapes");
  const situation::RayWorld world = ray_world(session);
  const situation::RayWindow window = situation::window(world, formula);
  RaySet set;
  set.title = fmt::format("Positions of {}", fmt::join(session.scene().moving, ", "));
  set.resolution = resolution;
  set.low = window.low, set.high = window.high;
  set.unbounded = situation::holds_far_away(world, formula);
  set.source = [&](const space::RayGrid& grid) { return situation::ray_region(world, formula, grid); };
  return rays_outcome(session, set);
}

}  // namespace findspace::app
