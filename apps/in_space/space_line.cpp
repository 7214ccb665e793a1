// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// map of a 3D scene whose shape moves along one line.
#include <fmt/format.h>

#include "formula/solid/optimize_line.h"
#include "in_space/space_commands.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_json.h"
#include "io/write/write_summary.h"

namespace findspace::app {

SpaceLineMap space_line_map(const Session& session, const formula::SpaceSolver& solver,
                            const formula::Formula& formula) {
  const io::Free& free = session.scene().free;
  formula::SpaceLine line;
  for (std::size_t k = 0; k < 3; ++k) {
    line.through[k] = exact::Real(free.through[k]);
    line.direction[k] = exact::Real(free.direction[k]);
  }
  const formula::SpaceSolver::OnLine found = solver.feasible_on(formula, line);
  SpaceLineMap map{plane::intervals(found.marks, exact::Real(1)), found.side, std::nullopt};
  const auto goal = session.goal();
  if (!goal) return map;
  formula::LineOptimum best =
      formula::optimize(map.intervals, line, session.step(), goal->objective, goal->sense, map.side);
  map.extreme = best;
  map.intervals = std::move(best.at);
  return map;
}

std::string space_line_json(const Session& session, const SpaceLineMap& map) {
  return io::intervals_json(map.intervals, session.step(), session.unit(), map.extreme ? &*map.extreme : nullptr,
                            map.side == formula::Side::kExact ? "" : formula::name(map.side));
}

Outcome map_space_line(const Session& session) {
  const Options& options = session.options();
  check_outputs(options, {".json"});
  if (!options.apply.empty()) throw Error(ErrorCode::kUsage, "--apply is for maps of space, not of a line");
  const formula::Formula formula = session.where();
  const formula::SpaceSolver solver(space_world(session));
  session.reporter().stage("solving");
  const SpaceLineMap map = space_line_map(session, solver, formula);
  if (map.side != formula::Side::kExact)
    session.reporter().note("protrusions are found by search: ends may be off by 2^-30 of the sizes");
  std::string title = fmt::format("Positions of {} on the line", fmt::join(session.scene().moving, ", "));
  if (const auto goal = session.goal())
    title += fmt::format(" with the {} {}", map.extreme->maximum() ? "greatest" : "least", goal->text);
  const auto json = [&] { return space_line_json(session, map); };
  write_outputs(options, {{".json", json}});
  std::string text = io::intervals_text(title, map.intervals, session.step(), session.unit());
  if (map.extreme) text += io::optimum_text(*map.extreme, session.unit());
  return {options.json ? json() : text, map.intervals.empty() ? kEmpty : kDone};
}

}  // namespace findspace::app
