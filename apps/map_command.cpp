// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "asked_numbers.h"
#include "commands.h"
#include "formula/planar/feasible_near.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_drawing.h"
#include "io/write/write_json.h"
#include "io/write/write_wkt.h"
#include "line_choice.h"
#include "plane/build/path_region.h"
#include "plane/complex/overlay.h"
#include "plane/query/in_order.h"
#include "plane/query/locate.h"
#include "plane/query/topology.h"
#include "report.h"
#include "rotation_command.h"
#include "scenery.h"
#include "session.h"
#include "space_commands.h"

namespace findspace::app {
namespace {

plane::Region applied(plane::Region region, const std::string& operation) {
  if (operation == "interior") return plane::interior(std::move(region));
  if (operation == "closure") return plane::closure(std::move(region));
  if (operation == "boundary") return plane::boundary(std::move(region));
  if (operation == "regularize") return plane::regularize(std::move(region));
  if (operation == "complement") return plane::complement(std::move(region));
  return region;
}

/// The answer to a scene's question.
struct Map {
  plane::Region region;
  std::optional<plane::Region> feasible;  // where the region is a part of it: the best positions
  std::optional<io::ExtremeValue> extreme;
  std::optional<plane::Region> outer;  // where the region is certainly feasible, and only this possibly
};

constexpr const char* kNoRoots =
    "the optimum is no number that square roots express: given to 13 digits, with one position each";
constexpr const char* kBetweenBounds = "the optimum is known between the value, which some position has, and \"bound\"";

/// `bounded`: where shapes rotate.
io::ExtremeValue value_of(const formula::Optimum& optimum, bool maximum, Reporter& reporter, bool bounded = false) {
  if (optimum.value && !optimum.proven) reporter.note(bounded ? kBetweenBounds : kNoRoots);
  io::ExtremeValue out = io::extreme_value(optimum, maximum);
  out.proven = out.proven || optimum.unbounded || (!bounded && !optimum.value);
  if (out.proven || optimum.unbounded) return out;
  if (bounded || optimum.within != 0) out.bound = optimum.bound;
  if (optimum.within != 0 && std::isfinite(optimum.within)) out.within = optimum.within;
  return out;
}

/// Two points of the line, about 2^36 steps either way from where it goes through: beyond them nothing is looked for.
std::array<exact::RealPoint, 2> ends_of_line(const io::Free& free) {
  const std::int64_t most = std::max({std::abs(free.direction[0]), std::abs(free.direction[1]), std::int64_t(1)});
  const std::int64_t times = std::max<std::int64_t>(1, (std::int64_t(1) << 36) / most);
  const auto end = [&](std::int64_t way) {
    return exact::RealPoint{exact::Real(free.through[0] + way * free.direction[0]),
                            exact::Real(free.through[1] + way * free.direction[1])};
  };
  return {end(-times), end(times)};
}

plane::Region on_line(const plane::Region& region, const io::Free& free) {
  const plane::Region line = plane::region_of_path(ends_of_line(free));
  const std::array<const plane::Region*, 2> both{&region, &line};
  return plane::intersect(both);
}

/// An optimum at an end of the line is none: it goes on.
formula::Optimum within_line(formula::Optimum best, const io::Free& free) {
  for (const exact::RealPoint& end : ends_of_line(free)) {
    if (!best.value || mark_of(best.at, plane::locate(best.at, end)) == 0) continue;
    best.value.reset();
    best.unbounded = true;
    best.attained = false;
    best.at = plane::Region::uniform(0);
  }
  return best;
}

/// Of shapes that rotate: regions, and what is best in them, between bounds.
Map solve_between_bounds(const Session& session, const formula::Solver& solver, const formula::Formula& formula) {
  Reporter& reporter = session.reporter();
  const std::optional<Session::Goal> goal = session.goal();
  if (!session.options().apply.empty())
    throw Error(ErrorCode::kUnsupported, "--apply: of shapes that rotate only bounds of the region are known",
                session.scene().file);
  formula::RegionBounds bounds = solver.feasible_bounds(formula);
  if (!goal) {
    reporter.note(
        "shapes rotate, or distances are in rotation: certainly feasible positions, and in \"outer\" the possible "
        "ones");
    std::optional<io::ExtremeValue> extreme;
    if (const auto least = formula::minimum_of(formula, solver)) extreme = value_of(*least, false, reporter, true);
    return {plane::in_order(bounds.inner), std::nullopt, extreme, plane::in_order(bounds.outer)};
  }
  reporter.stage("optimizing");
  if (session.scene().free.kind == io::Free::Kind::kLine) {
    bounds.inner = on_line(bounds.inner, session.scene().free);
    bounds.outer = on_line(bounds.outer, session.scene().free);
  }
  formula::Optimum best = formula::optimize(bounds, goal->objective, goal->sense, solver);
  const io::ExtremeValue extreme = value_of(best, goal->sense == distance::Sense::kMaximum, reporter, true);
  return {plane::in_order(best.at), plane::in_order(bounds.outer), extreme, std::nullopt};
}

Map solve(const Session& session, const formula::Solver& solver, const formula::Formula& formula) {
  Reporter& reporter = session.reporter();
  const std::optional<Session::Goal> goal = session.goal();
  reporter.stage("solving");
  if (solver.rotations_in(formula) || (goal && formula::is_bounded(goal->objective, solver)))
    return solve_between_bounds(session, solver, formula);
  Map map{formula::feasible_near(solver, formula), std::nullopt, std::nullopt, std::nullopt};
  if (goal) {
    reporter.stage("optimizing");
    const bool line = session.scene().free.kind == io::Free::Kind::kLine;
    if (line) map.region = on_line(map.region, session.scene().free);
    formula::Optimum best = formula::optimize(map.region, goal->objective, goal->sense, solver);
    if (line) best = within_line(std::move(best), session.scene().free);
    map.extreme = value_of(best, goal->sense == distance::Sense::kMaximum, reporter);
    map.feasible = plane::in_order(std::exchange(map.region, std::move(best.at)));
  } else if (const auto least = formula::minimum_of(formula, solver)) {
    map.extreme = value_of(*least, false, reporter);
  }
  map.region = plane::in_order(applied(std::move(map.region), session.options().apply));
  return map;
}

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

Outcome map_of_line(const Session& session, const Map& map) {
  const plane::Region& region = map.region;
  const io::ExtremeValue* extreme = map.extreme ? &*map.extreme : nullptr;
  const io::Free& free = session.scene().free;
  const auto on_it = [&](const plane::Region& set) {
    return plane::along_line(set, {free.through[0], free.through[1]}, {free.direction[0], free.direction[1]});
  };
  const auto intervals = on_it(region);
  const auto outer = map.outer ? on_it(*map.outer) : std::vector<plane::LineInterval>{};
  const auto json = [&] {
    std::string text = io::intervals_json(intervals, session.step(), session.unit(), extreme);
    return map.outer ? bounded_json(std::move(text), io::intervals_json(outer, session.step(), session.unit())) : text;
  };
  write_outputs(session.options(), {{".json", json}});
  std::string text = intervals_text(title(session) + " on the line", intervals, session.step(), session.unit());
  if (extreme != nullptr && extreme->value)
    text += fmt::format("{} {}\n", extreme->maximum ? "maximum" : "minimum", io::shown(*extreme->value));
  return {session.options().json ? json() : text, !intervals.empty() ? kDone : outer.empty() ? kEmpty : kLimit};
}

Outcome map_of_time(const Session& session, const formula::Solver& solver, const formula::Formula& formula) {
  const exact::RealPoint at = asked_position(session);
  session.reporter().stage("solving");
  const auto in_time = [](const plane::Section& line) { return plane::intervals(line, exact::Real(1)); };
  std::vector<plane::LineInterval> intervals, outer;
  const bool rotating = solver.rotations_in(formula);
  const std::optional<plane::Section> swing = rotating ? solver.swing(formula, at) : std::nullopt;
  const bool bounded = rotating && !swing;
  if (bounded) {
    session.reporter().note(
        "shapes rotate, or distances are in rotation: instants that certainly belong, and in \"outer\" the possible "
        "ones");
    const formula::InstantBounds bounds = solver.instant_bounds(formula, at);
    intervals = in_time(bounds.inner);
    outer = in_time(bounds.outer);
  } else {
    intervals = in_time(swing ? *swing : solver.instants(formula, at));
  }
  const auto json = [&] {
    std::string text = io::intervals_json(intervals, exact::Real(1), "");
    return bounded ? bounded_json(std::move(text), io::intervals_json(outer, exact::Real(1), "")) : text;
  };
  write_outputs(session.options(), {{".json", json}});
  const std::string text = intervals_text(
      fmt::format("Instants with {} at {}", session.scene().moving_text(), session.options().at.value_or("0,0")),
      intervals, exact::Real(1), "");
  return {session.options().json ? json() : text, !intervals.empty() ? kDone : outer.empty() ? kEmpty : kLimit};
}

Outcome map_of_plane(const Session& session, const Map& map, const formula::World& world,
                     const formula::Formula& formula) {
  const plane::Summary summary = plane::summarize(map.region, session.step());
  const io::ExtremeValue* extreme = map.extreme ? &*map.extreme : nullptr;
  const auto json = [&] {
    std::string text =
        io::region_json(map.region, summary, session.step(), session.unit(), extreme, session.options().exact);
    if (!map.outer) return text;
    const plane::Summary outer = plane::summarize(*map.outer, session.step());
    return bounded_json(std::move(text), io::region_json(*map.outer, outer, session.step(), session.unit()));
  };
  const auto svg = [&] {
    io::Picture picture;
    picture.title = title(session) + (summary.empty ? ": none" : "");
    picture.subtitle = session.scene().where.text;
    picture.region = &map.region;
    picture.summary = &summary;
    picture.around = map.feasible ? &*map.feasible : map.outer ? &*map.outer : nullptr;
    add_scenery(session, picture, world, &formula);
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
    io::DrawingText text = io::shapes_dxf({&named, 1}, session.step(), session.scene().unit);
    if (!text.lost.empty()) session.reporter().note(text.lost);
    return std::move(text.text);
  };
  write_outputs(session.options(), {{".json", json}, {".svg", svg}, {".wkt", wkt}, {".dxf", dxf}});
  return {session.options().json ? json() : summary_text(title(session), summary, session.unit(), extreme),
          !summary.empty                              ? kDone
          : !map.outer || plane::is_empty(*map.outer) ? kEmpty
                                                      : kLimit};
}

}  // namespace

Outcome run_map(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  const io::Free::Kind free = session.scene().free.kind;
  const bool at_place = free == io::Free::Kind::kTime || free == io::Free::Kind::kAngle;
  if (options.at && !at_place)
    throw Error(ErrorCode::kUsage, "--at is for a map of time or of angles: a map of positions has all of them");
  if (free == io::Free::Kind::kPose) return map_of_poses(session);
  if (free == io::Free::Kind::kAngle) return map_of_angles(session);
  if (session.in_space()) {
    const bool line = free == io::Free::Kind::kLine;
    session.require_positions_in_space(line);
    require_question(session);
    if (line) {
      refuse_lines(options, "for maps of space, not of a line");
      return map_space_line(session);
    }
    const auto lines = asked_lines(session);
    return lines ? map_rays(session, *lines) : map_space(session);
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
  const formula::Solver solver(session.world_of(formula));
  if (time) return map_of_time(session, solver, formula);
  const Map map = solve(session, solver, formula);
  return line ? map_of_line(session, map) : map_of_plane(session, map, solver.world(), formula);
}

}  // namespace findspace::app
