// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/space_line.h"

#include <fmt/format.h>

#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "formula/solid/optimize_line.h"
#include "io/draw/draw_layout.h"
#include "io/question/map_answer.h"
#include "io/question/space_shapes.h"
#include "io/write/write_json.h"
#include "io/write/write_summary.h"

namespace findspace::io {

std::vector<plane::LineInterval> SpaceLineMap::certain() const {
  const bool some = side == formula::Side::kExact || (side == formula::Side::kInner && !extreme);
  return some ? intervals : std::vector<plane::LineInterval>();
}

std::vector<plane::LineInterval> SpaceLineMap::possible() const {
  if (side == formula::Side::kExact) return intervals;
  return side == formula::Side::kOuter ? feasible : std::vector<plane::LineInterval>(1);  // the whole line
}

namespace {

/// Shorter pieces are what every search leaves about an end.
constexpr double kWide = 0x1p-20;  // no sign: of the length between the first change and the last

double extent(const plane::Section& line) {
  return line.stops.empty() ? 0 : (line.stops.back().t - line.stops.front().t).to_double();
}

}  // namespace

SpaceLineMap space_line_map(const AskedScene& asked, const formula::SpaceSolver& solver,
                            const formula::Formula& formula) {
  const Free& free = asked.scene().free;
  formula::SpaceLine line;
  for (std::size_t k = 0; k < 3; ++k) {
    line.through[k] = exact::Real(free.through[k]);
    line.direction[k] = exact::Real(free.direction[k]);
  }
  const formula::SpaceSolver::OnLine found = solver.feasible_on(formula, line);
  SpaceLineMap map;
  map.feasible = map.intervals = plane::intervals(found.marks, exact::Real(1));
  map.side = found.side;
  map.undecided = plane::intervals(found.undecided, exact::Real(1));
  const double least = kWide * (extent(found.marks) + extent(found.undecided));
  std::erase_if(map.undecided,
                [&](const plane::LineInterval& i) { return i.from && i.to && (*i.to - *i.from).to_double() < least; });
  const auto goal = asked.goal();
  if (!goal) return map;
  formula::LineOptimum best =
      formula::optimize(map.intervals, line, asked.step(), goal->objective, goal->sense, map.side);
  map.extreme = best;
  map.intervals = std::move(best.at);
  return map;
}

std::string space_line_json(const AskedScene& asked, const SpaceLineMap& map) {
  return intervals_json(map.intervals, asked.step(), asked.unit(), map.extreme ? &*map.extreme : nullptr,
                        map.side == formula::Side::kExact ? "" : formula::name(map.side), map.undecided);
}

Answer::Data map_of_space_line(AskedScene given) {
  given.require_positions_in_space(true);
  given.require_question();
  const formula::Formula formula = given.where();
  const std::shared_ptr<const formula::SpaceSolver> solver = space_solver(given);
  given.stage("solving");
  const auto map = std::make_shared<const SpaceLineMap>(space_line_map(given, *solver, formula));
  if (map->side != formula::Side::kExact)
    given.note("protrusions are found by search: ends may be off by 2^-30 of the sizes");
  if (!map->undecided.empty()) given.note("of the intervals \"undecided\" it is not known whether they belong");
  std::string title = fmt::format("Positions of {} on the line", fmt::join(given.scene().moving, ", "));
  if (const auto goal = given.goal())
    title += fmt::format(" with the {} {}", map->extreme->maximum() ? "greatest" : "least", goal->text);
  const auto asked = std::make_shared<const AskedScene>(std::move(given));
  Answer::Data out;
  const bool some = !map->intervals.empty();  // of the set that is given, on whichever side it lies
  out.found = found_in(some, some);
  out.json = [asked, map](const Telling&) { return space_line_json(*asked, *map); };
  out.text = [asked, map, title](const Telling&) {
    const std::string text = intervals_text(title, map->intervals, asked->step(), asked->unit());
    return map->extreme ? text + optimum_text(*map->extreme, asked->unit()) : text;
  };
  out.intervals = [asked, map] { return shown_intervals(map->certain(), asked->step()); };
  out.possible = [asked, map] { return shown_intervals(map->possible(), asked->step()); };
  if (map->extreme)
    out.best = [asked, map] {
      return api::public_optimum(*map->extreme, api::make_region(plane::Region::uniform(0), asked->scene().grid));
    };
  return out;
}

}  // namespace findspace::io
