// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/space_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "api/query/space_region_data.h"
#include "api/values/region_data.h"
#include "io/draw/draw_bodies.h"
#include "io/draw/draw_space.h"
#include "io/mesh/space_surface.h"
#include "io/question/map_answer.h"
#include "io/question/space_shapes.h"
#include "io/write/write_json_space.h"
#include "io/write/write_summary.h"
#include "space/box/box_operations.h"

namespace findspace::io {
namespace {

using exact::Real;

/// What a map of space needs for its texts and pictures.
struct SpaceMapQuestion {
  AskedScene asked;
  formula::Formula formula;
  std::shared_ptr<const formula::SpaceSolver> solver;
  std::string apply;
  WorldOfScene world_of;
  formula::SpaceRegion map;
  space::SpaceSummary summary{};

  SpaceMapQuestion(AskedScene given, std::string operation, WorldOfScene maker)
      : asked(std::move(given)),
        formula(asked.where()),
        solver(space_solver(asked)),
        apply(std::move(operation)),
        world_of(std::move(maker)) {}

  std::string title() const { return fmt::format("Positions of {}", fmt::join(asked.scene().moving, ", ")); }
  const distance::OptimalValue* extreme() const { return map.extreme ? &*map.extreme : nullptr; }
  std::string json() const {
    if (map.convex) return space_json(map.convex->set, summary, map.convex->step, asked.unit(), extreme());
    return space_json(map.boxes, summary, asked.step(), asked.unit(), extreme());
  }
  Surface surface() const {
    const auto& convex = map.convex;
    return convex ? convex_surface(convex->set, convex->step) : box_surface(map.boxes, asked.step());
  }
  /// A convex region among the shapes, the moving ones at a sample position.
  std::string picture_of_convex() const {
    const formula::SpaceWorld& world = solver->world();
    BodiesPicture p{title(), asked.unit(), {}, {}, {}, world.step.to_double()};
    if (const std::string& where = asked.scene().where.text; !where.empty()) p.lines.push_back(where);
    std::optional<space::Place3> at;
    if (!summary.components.empty()) at = summary.components[0].sample;
    const KeptBodies kept = add_bodies(p, asked, world, at);
    const Surface region = surface();
    const DrawnSurface drawn{region.vertices, region.faces};
    auto& added = p.bodies.emplace_back(BodiesPicture::Drawn{"positions"});
    added.surface = &drawn;
    added.role = BodiesPicture::Role::kRegion;
    return bodies_svg(p);
  }
  /// The region among the shapes that have boxes; the moving ones stand at a sample position.
  std::string picture() const {
    if (map.convex) return picture_of_convex();
    const formula::SpaceWorld& world = solver->world();
    SpacePicture p{title(), asked.scene().where.text, asked.unit(), &map.boxes, {}, {}, asked.step()};
    for (const auto& [name, shape] : world.shapes) {
      if (!shape.boxes || drawn_by_members(asked, name)) continue;
      if (std::find(world.moving.begin(), world.moving.end(), name) == world.moving.end()) {
        p.fixed.push_back({name, *shape.boxes});
      } else if (!summary.components.empty()) {
        space::RealVector by;
        for (std::size_t k = 0; k < 3; ++k) by[k] = Real::from_double(summary.components[0].sample[k]) / asked.step();
        p.moving.push_back({name, space::translated(*shape.boxes, by)});
      }
    }
    return space_svg(p);
  }
  SpaceRegion region() const {
    const std::string& where = asked.scene().where.text;
    const World world = world_of(asked.scene(), solver);
    return SpaceRegion(std::make_shared<const SpaceRegion::Data>(
        map, asked.step(), asked.unit(), world.query(where.empty() ? findspace::Formula("true") : where),
        SpaceQuestion{apply, asked.scene().minimize.text, asked.scene().maximize.text}));
  }
};

formula::SpaceRegion space_map(const AskedScene& asked, const formula::SpaceSolver& solver,
                               const formula::Formula& formula, const Applied& apply, bool flat) {
  formula::RegionQuery query{{}, {}, flat};
  if (const auto goal = asked.goal()) {
    query.objective = goal->objective;
    query.sense = goal->sense;
  }
  return api::solved_in_space(solver, formula, query, apply.operation);
}

}  // namespace

std::optional<Answer::Data> map_of_space(AskedScene given, const Applied& apply, bool flat,
                                         const WorldOfScene& world_of) {
  given.require_positions_in_space();
  given.require_question();
  const auto q = std::make_shared<SpaceMapQuestion>(std::move(given), apply.operation, world_of);
  q->asked.stage("solving");
  const auto solve = [&] { return space_map(q->asked, *q->solver, q->formula, apply, flat); };
  const bool plain = flat && apply.operation.empty() && !q->asked.goal();  // what a prepared scene keeps
  q->map = plain && q->asked.kept() ? q->asked.kept()->space_region.get(solve) : solve();
  if (q->map.way == distance::Way::kLines) return std::nullopt;
  q->summary = api::summary_of(q->map, q->asked.step());
  Answer::Data out;
  out.found = found_in(!q->summary.empty, false);
  out.json = [q](const Telling&) { return q->json(); };
  out.text = [q](const Telling&) { return summary_text(q->title(), q->summary, q->asked.unit(), q->extreme()); };
  for (const char* ending : kSurfaceEndings)
    out.files[ending] = [q, ending](const Telling&) {
      return Region::Drawn{surface_text(q->surface(), q->title(), ending, q->asked.unit()), {}};
    };
  out.surface = [q] {
    Surface made = q->surface();
    return findspace::Surface{std::move(made.vertices), std::move(made.faces)};
  };
  out.files[".svg"] = [q](const Telling&) { return Region::Drawn{q->picture(), {}}; };
  out.space_region = [q] { return q->region(); };
  if (q->map.extreme)
    out.best = [q] {
      return api::public_optimum(*q->map.extreme, api::make_region(plane::Region::uniform(0), q->asked.scene().grid));
    };
  return out;
}

}  // namespace findspace::io
