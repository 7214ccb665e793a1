// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// check and measure in space: at one position.
#include <fmt/format.h>

#include <algorithm>

#include "common/asked_numbers.h"
#include "formula/language/text.h"
#include "in_space/space_commands.h"
#include "in_space/space_outcome.h"
#include "io/draw/draw_bodies.h"
#include "io/report/position_report.h"
#include "io/write/write_position.h"
#include "report/measured_rows.h"

namespace findspace::app {

namespace {

/// Of bodies that were made only when a distance asked for them.
void note_late_rounding(const Session& session, const formula::SpaceSolver& solver) {
  for (const auto& [name, shape] : solver.world().shapes) {
    if (shape.surfaces && !shape.convex) note_rounding(session, name, shape);
  }
}

std::string where_text(const space::RealVector& at) {
  return fmt::format("({}, {}, {})", at[0].to_double(), at[1].to_double(), at[2].to_double());
}

std::array<double, 3> place(const distance::Coordinates& p) {
  return {p[0].to_double(), p[1].to_double(), p[2].to_double()};
}

/// What is drawn of a shape: its body, or all sets that a cut solid is made of and that are cut out of it.
std::shared_ptr<const space::Body> drawn_body(const formula::SpaceShape& shape) {
  if (!shape.cut) return shape.body.pointer();
  space::Body all;
  all.scale = shape.cut->scale;
  for (const space::CsgPart& part : shape.cut->parts) {
    all.parts.insert(all.parts.end(), part.within.begin(), part.within.end());
    all.parts.insert(all.parts.end(), part.without.begin(), part.without.end());
  }
  return std::make_shared<const space::Body>(std::move(all));
}

/// The bodies with the moving ones at `at`, and pairs of points that take a distance.
std::string picture_at(const Session& session, const formula::SpaceSolver& solver, const space::RealVector& at,
                       std::string title, std::vector<std::string> lines,
                       const std::vector<formula::DistanceAt>& distances) {
  const formula::SpaceWorld& world = solver.world();
  io::BodiesPicture picture{std::move(title), session.unit(), std::move(lines), {}, {}, world.step.to_double()};
  std::vector<std::shared_ptr<const space::Body>> drawn;
  for (const bool moving : {false, true}) {
    for (const auto& [name, shape] : world.shapes) {
      const bool moves = std::find(world.moving.begin(), world.moving.end(), name) != world.moving.end();
      if (moves != moving || (!shape.body && !shape.cut)) continue;
      drawn.push_back(drawn_body(shape));
      picture.bodies.push_back({drawn.back().get(), {}, moving});
      if (moving) picture.bodies.back().by = {at[0].to_double(), at[1].to_double(), at[2].to_double()};
    }
  }
  for (const auto& d : distances) {
    if (!d.answer) continue;
    const auto& points = d.answer->witness;
    if (points.size() == 2) picture.pairs.push_back({place(points[0].at), place(points[1].at)});
    if (d.answer->nearest) picture.pairs.push_back({place(distance::coordinates(at)), place(*d.answer->nearest)});
  }
  return io::bodies_svg(picture);
}

}  // namespace

Outcome check_space(const Session& session) {
  const Options& options = session.options();
  check_outputs(options, {".json", ".svg"});
  const space::RealVector at = asked_position_in_space(session);
  const formula::Formula formula = session.where();
  const formula::SpaceSolver solver(space_world(session));
  session.reporter().stage("checking");
  const formula::Check check = solver.check(formula, at);
  formula::AskedNearest nearest;
  if (!check.holds) nearest = formula::nearest_feasible(solver, formula, at);
  note_late_rounding(session, solver);
  const auto json = [&] {
    return io::check_json(check, distance::coordinates(at), session.unit(), std::nullopt, nearest, options.explain);
  };
  const auto svg = [&] {
    std::vector<std::string> lines;
    std::vector<formula::DistanceAt> distances;
    for (const formula::AtomAt& a : check.atoms) {
      lines.push_back(fmt::format("{}: {}", formula::written(a.atom), a.holds ? "true" : "false"));
      distances.push_back(a.distance);
    }
    return picture_at(session, solver, at,
                      fmt::format("{} at {}: {}", fmt::join(session.scene().moving, ", "), where_text(at),
                                  check.holds ? "feasible" : "not feasible"),
                      std::move(lines), distances);
  };
  write_outputs(options, {{".json", json}, {".svg", svg}});
  return {options.json ? json()
                       : io::check_text(check, where_text(at), distance::coordinates(at), session.unit(), nearest,
                                        options.explain),
          check.holds ? kDone : kEmpty};
}

namespace {

/// A line for each reason, with the distances that it is the reason for.
void note_refused(const Session& session, const std::vector<formula::DistanceAt>& distances) {
  std::vector<std::pair<std::string, std::vector<std::string>>> reasons;
  for (const auto& d : distances) {
    if (d.refused.empty()) continue;
    const auto known =
        std::find_if(reasons.begin(), reasons.end(), [&](const auto& r) { return r.first == d.refused; });
    auto& reason = known == reasons.end() ? reasons.emplace_back(d.refused, std::vector<std::string>{}) : *known;
    reason.second.push_back(formula::plain(d.text).text);
  }
  for (const auto& [reason, texts] : reasons)
    session.reporter().note(fmt::format("{}: {}", fmt::join(texts, ", "), reason));
}

}  // namespace

Outcome measure_space(const Session& session) {
  const Options& options = session.options();
  check_outputs(options, {".json", ".svg"});
  const space::RealVector at = asked_position_in_space(session);
  const formula::SpaceSolver solver(space_world(session));
  session.reporter().stage("measuring");
  const std::vector<formula::DistanceAt> distances = solver.measure(at, wanted_kinds(options));
  note_late_rounding(session, solver);
  note_refused(session, distances);
  const auto json = [&] { return io::measure_json(distances, distance::coordinates(at), session.unit()); };
  const auto svg = [&] {
    return picture_at(session, solver, at,
                      fmt::format("{} at {}", fmt::join(session.scene().moving, ", "), where_text(at)), {}, {});
  };
  write_outputs(options, {{".json", json}, {".svg", svg}});
  return {options.json ? json()
                       : io::measure_text(distances, where_text(at), distance::coordinates(at), session.unit(),
                                          shows_all(options)),
          kDone};
}

}  // namespace findspace::app
