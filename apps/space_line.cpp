// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// map of a 3D scene whose shape moves along one line.
#include <fmt/format.h>

#include "formula/solid/optimize_line.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_json.h"
#include "report.h"
#include "space_commands.h"

namespace findspace::app {

Outcome map_space_line(const Session& session) {
  const Options& options = session.options();
  check_outputs(options, {".json"});
  if (!options.apply.empty()) throw Error(ErrorCode::kUsage, "--apply is for maps of space, not of a line");
  const io::Free& free = session.scene().free;
  formula::SpaceLine line;
  for (std::size_t k = 0; k < 3; ++k) {
    line.through[k] = exact::Real(free.through[k]);
    line.direction[k] = exact::Real(free.direction[k]);
  }
  const formula::Formula formula = session.where();
  const formula::SpaceSolver solver(space_world(session));
  session.reporter().stage("solving");
  const formula::SpaceSolver::OnLine found = solver.feasible_on(formula, line);
  const formula::Side side = found.side;
  if (side != formula::Side::kExact)
    session.reporter().note("protrusions are found by search: ends may be off by 2^-30 of the sizes");
  auto set = plane::intervals(found.marks, exact::Real(1));
  std::optional<io::ExtremeValue> extreme;
  std::string title = fmt::format("Positions of {} on the line", fmt::join(session.scene().moving, ", "));
  if (const auto goal = session.goal()) {
    const bool greatest = goal->sense == distance::Sense::kMaximum;
    formula::LineOptimum best = formula::optimize(set, line, session.step(), goal->objective, goal->sense);
    extreme = io::extreme_value(best, greatest);
    set = std::move(best.at);
    title += fmt::format(" with the {} {}", greatest ? "greatest" : "least", goal->text);
  }
  const auto json = [&] {
    return io::intervals_json(set, session.step(), session.unit(), extreme ? &*extreme : nullptr,
                              side == formula::Side::kExact ? "" : formula::name(side));
  };
  write_outputs(options, {{".json", json}});
  std::string text = intervals_text(title, set, session.step(), session.unit());
  if (extreme && extreme->value)
    text += fmt::format("{} {}\n", extreme->maximum ? "maximum" : "minimum", io::shown(*extreme->value));
  return {options.json ? json() : text, set.empty() ? kEmpty : kDone};
}

}  // namespace findspace::app
