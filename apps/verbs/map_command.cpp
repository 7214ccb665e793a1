// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/line_choice.h"
#include "common/session.h"
#include "in_plane/orientation_command.h"
#include "in_plane/planar_map.h"
#include "in_plane/rotation_command.h"
#include "in_space/space_commands.h"
#include "io/draw/draw_layout.h"
#include "io/export/write_drawing.h"
#include "io/export/write_wkt.h"
#include "io/write/write_summary.h"
#include "plane/query/topology.h"
#include "report/scenery.h"

namespace findspace::app {
namespace {

std::string title(const Session& session) {
  std::string out = fmt::format("Positions of {}", session.scene().moving_text());
  if (const auto goal = session.goal()) {
    out += fmt::format(" with the {} {}", goal->sense == distance::Sense::kMinimum ? "least" : "greatest", goal->text);
  }
  const std::string& apply = session.options().apply;
  return apply.empty() ? out : fmt::format("{}, {}", out, apply);
}

void require_question(const Session& session) {
  if (!session.scene().where.empty() || session.goal()) return;
  throw Error(ErrorCode::kBadValue, "the scene has no \"where\": nothing says what must hold", session.scene().file);
}

Outcome map_of_line(const Session& session, const PlanarMap& map) {
  const io::Free& free = session.scene().free;
  const auto intervals = intervals_on_line(map.region, free);
  const auto json = [&] { return planar_map_json(session, map); };
  write_outputs(session.options(), {{".json", json}});
  std::string text = io::intervals_text(title(session) + " on the line", intervals, session.step(), session.unit());
  if (map.extreme) text += io::optimum_text(*map.extreme, session.unit());
  const bool possible = map.outer && !intervals_on_line(*map.outer, free).empty();
  return {session.options().json ? json() : text, !intervals.empty() ? kDone : possible ? kLimit : kEmpty};
}

Outcome map_of_time(const Session& session, const formula::Solver& solver, const formula::Formula& formula) {
  const exact::RealPoint at = asked_position(session);
  session.reporter().stage("solving");
  const Instants found = planar_instants(solver, formula, at);
  if (found.outer)
    session.reporter().note(
        "shapes rotate, or distances are in rotation: instants that certainly belong, and in \"outer\" the possible "
        "ones");
  const auto json = [&] { return found.json(); };
  write_outputs(session.options(), {{".json", json}});
  const std::string text = io::intervals_text(
      fmt::format("Instants with {} at {}", session.scene().moving_text(), session.options().at.value_or("0,0")),
      found.intervals, exact::Real(1), "");
  const bool possible = found.outer && !found.outer->empty();
  return {session.options().json ? json() : text, !found.intervals.empty() ? kDone : possible ? kLimit : kEmpty};
}

/// `world`: for a picture.
Outcome map_of_plane(const Session& session, const PlanarMap& map, const formula::World* world,
                     const formula::Formula& formula) {
  const plane::Summary summary = plane::summarize(map.region, session.step());
  const distance::OptimalValue* extreme = map.extreme ? &*map.extreme : nullptr;
  const auto json = [&] { return planar_map_json(session, map, &summary); };
  const auto svg = [&] {
    io::Picture picture;
    picture.title = title(session) + (summary.empty ? ": none" : "");
    picture.subtitle = session.scene().where.text;
    picture.region = &map.region;
    picture.summary = &summary;
    picture.around = map.feasible ? &*map.feasible : map.outer ? &*map.outer : nullptr;
    if (map.outer && !map.feasible) picture.around_text = "positions not excluded";
    add_scenery(session, picture, *world, &formula);
    return io::picture_svg(picture);
  };
  const auto wkt = [&] {
    io::WktText text = io::region_wkt(map.region, session.step());
    if (!text.lost.empty()) session.reporter().note(text.lost);
    return text.text;
  };
  session.reporter().stage("writing");
  const auto dxf = [&] {
    const io::NamedRegion named{"region", &map.region};
    io::DrawingText text = io::shapes_dxf({&named, 1}, session.step(), session.scene().unit, session.options().dxf);
    if (!text.lost.empty()) session.reporter().note(text.lost);
    return std::move(text.text);
  };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}, {".wkt", wkt}, {".dxf", dxf}});
  return {session.options().json ? json() : io::summary_text(title(session), summary, session.unit(), extreme),
          !summary.empty                              ? kDone
          : !map.outer || plane::is_empty(*map.outer) ? kEmpty
                                                      : kLimit};
}

}  // namespace

Outcome run_map(const Options& options, Reporter& reporter) {
  Session session(options, reporter);
  const io::Free::Kind free = session.scene().free.kind;
  if (!session.in_space()) refuse_orientation(options);
  const bool at_place = free == io::Free::Kind::kTime || free == io::Free::Kind::kAngle;
  if (options.at && !at_place)
    throw Error(ErrorCode::kUsage, "--at is for a map of time or of angles: a map of positions has all of them");
  if (asks_for_poses(session)) return map_of_poses(session);
  if (free == io::Free::Kind::kAngle) return map_of_angles(session);
  if (session.in_space()) {
    const bool line = free == io::Free::Kind::kLine;
    session.require_positions_in_space(line, true);
    require_question(session);
    if (line) {
      refuse_lines(options, "for maps of space, not of a line");
      if (options.orientation)
        throw Error(ErrorCode::kUsage, "--orientation is for maps of positions and of poses, not of a line");
      return map_space_line(session);
    }
    return at_orientations(session, [](const Session& s) {
      const auto lines = asked_lines(s);
      return lines ? map_rays(s, *lines) : map_space(s);
    });
  }
  refuse_lines(options, "for maps of 3D scenes");
  const io::Scene& scene = session.scene();
  const bool line = free == io::Free::Kind::kLine, time = free == io::Free::Kind::kTime;
  check_outputs(options, line || time ? std::vector<std::string>{".json"}
                                      : std::vector<std::string>{".svg", ".dxf", ".wkt", ".json"});
  if ((line || time) && !options.apply.empty())
    throw Error(ErrorCode::kUsage, "--apply is for maps of the plane, not of a line or of time");
  session.require_positions(true);
  if (time && session.goal()) throw Error(ErrorCode::kUnsupported, "an objective in time is not computed", scene.file);
  require_question(session);
  const formula::Formula formula = session.where();
  const bool drawn = std::any_of(options.outputs.begin(), options.outputs.end(),
                                 [](const auto& path) { return path.extension() == ".svg"; });
  std::optional<const formula::Solver> solver(session.world_of(formula, drawn));
  if (!drawn) session.forget_shapes();
  if (time) return map_of_time(session, *solver, formula);
  const PlanarMap map = planar_map(session, *solver, formula);
  if (line) return map_of_line(session, map);
  if (drawn) return map_of_plane(session, map, &solver->world(), formula);
  solver.reset();  // most of the memory, of which only a picture has need
  return map_of_plane(session, map, nullptr, formula);
}

}  // namespace findspace::app
