// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "in_space/space_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "in_space/ray_outcome.h"
#include "in_space/space_map.h"
#include "in_space/space_outcome.h"
#include "io/draw/draw_space.h"
#include "io/mesh/space_surface.h"
#include "io/write/write_summary.h"
#include "space/box/box_operations.h"

namespace findspace::app {
namespace {

using exact::Real;

/// The region among the shapes that have boxes; the moving ones stand at a sample position.
std::string picture(const Session& session, const formula::SpaceWorld& world, const space::BoxComplex& region,
                    const space::SpaceSummary& summary, std::string title) {
  io::SpacePicture p{std::move(title), session.scene().where.text, session.unit(), &region, {}, {}, session.step()};
  for (const auto& [name, shape] : world.shapes) {
    if (!shape.boxes) continue;
    if (std::find(world.moving.begin(), world.moving.end(), name) == world.moving.end()) {
      p.fixed.push_back(*shape.boxes);
    } else if (!summary.components.empty()) {
      space::RealVector by;
      for (std::size_t k = 0; k < 3; ++k) by[k] = Real::from_double(summary.components[0].sample[k]) / session.step();
      p.moving.push_back(space::translated(*shape.boxes, by));
    }
  }
  return io::space_svg(p);
}

std::string title_of(const Session& session) {
  return fmt::format("Positions of {}", fmt::join(session.scene().moving, ", "));
}

}  // namespace

Outcome map_space(const Session& session) {
  const Options& options = session.options();
  check_outputs(options, space_formats());
  const formula::Formula formula = session.where();
  const formula::SpaceSolver solver(space_world(session));
  session.reporter().stage("solving");
  SpaceMap map = space_map(session, solver, formula, wants_surface(session));
  if (map.way == distance::Way::kLines) return map_rays(session, lines_unasked(session, "map"));
  const distance::OptimalValue* shown = map.extreme ? &*map.extreme : nullptr;
  const std::string title = title_of(session);
  if (map.way == distance::Way::kConvex) return polytope_outcome(session, *map.convex, map.step, title, shown);
  const space::BoxComplex& region = map.boxes;
  const space::SpaceSummary summary = space::summarize(region, session.step());
  const auto json = [&] { return space_map_json(session, map); };
  session.reporter().stage("writing");
  Writers all = space_writers(
      json, [&] { return io::box_surface(region, session.step()); }, title, session.unit());
  all[".svg"] = [&] { return picture(session, solver.world(), region, summary, title); };
  write_outputs(session.options(), all);
  return {options.json ? json() : io::summary_text(title, summary, session.unit(), shown),
          summary.empty ? kEmpty : kDone};
}

}  // namespace findspace::app
