// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <fmt/format.h>

#include "common/asked_numbers.h"
#include "common/commands.h"
#include "common/session.h"
#include "in_plane/board_check.h"
#include "in_plane/orientation_command.h"
#include "in_plane/rotation_command.h"
#include "in_space/space_commands.h"
#include "io/report/position_report.h"
#include "io/write/write_position.h"
#include "io/write/write_witness.h"
#include "report/measured_rows.h"
#include "report/position_picture.h"

namespace findspace::app {
Outcome run_check(const Options& options, Reporter& reporter) {
  if (is_board(options.scene)) refuse_orientation(options);
  if (is_board(options.scene) && options.move.empty()) return check_board(options, reporter);
  if (!options.at && !options.angle && !options.orientation)
    throw Error(ErrorCode::kUsage, "check wants a position: --at x,y (or x,y,z)");
  const Session session(options, reporter);
  if (session.in_space()) {
    session.require_positions_in_space(true, true);
    return at_orientations(session, check_space);
  }
  refuse_orientation(options);
  check_outputs(options, {".svg", ".json"});
  if (asks_for_angle(session)) return check_at_angle(session);
  session.require_positions(true);
  const exact::RealPoint at = asked_position(session);
  if (session.scene().free.kind == io::Free::Kind::kTime && !options.time)
    throw Error(ErrorCode::kUsage, "with \"free\": \"time\" check wants the instant too: --time t");
  const formula::Formula formula = session.where();
  const formula::Solver solver(session.world_of(formula));
  reporter.stage("checking");
  const formula::Check check = solver.check(formula, at);
  formula::AskedNearest nearest;
  if (!check.holds) {
    reporter.stage("looking for the nearest feasible position");
    nearest = solver.nearest_feasible(formula, at);
  }
  const auto json = [&] {
    return io::check_json(check, distance::coordinates(at), session.unit(), std::nullopt, nearest, options.explain);
  };
  const auto svg = [&] { return check_picture(session, solver.world(), formula, at, check, formula::found(nearest)); };
  write_outputs(options, {{".json", json}, {".svg", svg}});
  return {options.json ? json()
                       : io::check_text(check, io::shown_point(distance::coordinates(at)), distance::coordinates(at),
                                        session.unit(), nearest, options.explain),
          check.holds ? kDone : kEmpty};
}

Outcome run_measure(const Options& options, Reporter& reporter) {
  const Session session(options, reporter);
  if (session.in_space()) {
    session.require_positions_in_space(true, true);
    return at_orientations(session, measure_space);
  }
  refuse_orientation(options);
  check_outputs(options, {".svg", ".json"});
  if (asks_for_angle(session)) return measure_at_angle(session);
  session.require_positions(true);
  const exact::RealPoint at = asked_position(session);
  const formula::Formula formula = session.where();
  const formula::Solver solver(session.world());
  reporter.stage("measuring");
  const std::vector<formula::DistanceAt> distances = only_wanted(solver.measure(at, formula), options);
  const auto json = [&] { return io::measure_json(distances, distance::coordinates(at), session.unit()); };
  const auto svg = [&] { return measure_picture(session, solver.world(), at, distances); };
  write_outputs(options, {{".json", json}, {".svg", svg}});
  return {options.json ? json()
                       : io::measure_text(distances, io::shown_point(distance::coordinates(at)),
                                          distance::coordinates(at), session.unit(), shows_all(options)),
          kDone};
}

}  // namespace findspace::app
