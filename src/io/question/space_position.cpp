// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// check and measure in space: at one position.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formula/language/text.h"
#include "io/draw/draw_bodies.h"
#include "io/draw/draw_layout.h"
#include "io/question/position_answer.h"
#include "io/question/space_shapes.h"
#include "io/report/position_report.h"
#include "io/write/write_position.h"

namespace findspace::io {

namespace {

/// Of bodies that were made only when a distance asked for them.
void note_late_rounding(const AskedScene& asked, const formula::SpaceSolver& solver) {
  for (const auto& [name, shape] : solver.world().shapes) {
    if (shape.surfaces && !shape.convex) note_rounding(asked, name, shape);
  }
}

std::string where_text(const space::RealVector& at) {
  return fmt::format("({}, {}, {})", at[0].to_double(), at[1].to_double(), at[2].to_double());
}

std::array<double, 3> space_place(const distance::Coordinates& p) {
  return {p[0].to_double(), p[1].to_double(), p[2].to_double()};
}

/// A distance that the picture shows.
struct ShownDistance {
  const formula::DistanceAt* distance;
  bool fails;
};

/// The middle of the box about what moves, at its position; the position itself where nothing of it is drawn.
space::Place3 middle_of_moving(const BodiesPicture& picture, const space::Place3& at) {
  space::Place3 middle = at;
  for (const auto& drawn : picture.bodies)
    if (drawn.role == BodiesPicture::Role::kMoving) middle = middle_of(drawn, picture.step);
  return middle;
}

/// The points that take a distance and its value, or the way to a touching where there are none.
void add_distance(BodiesPicture& picture, const space::RealVector& at, const ShownDistance& shown_distance,
                  std::string_view unit) {
  const formula::DistanceAt& d = *shown_distance.distance;
  if (!d.answer) return;
  const auto text = [&](double value) { return shown(value) + (unit.empty() ? "" : fmt::format(" {}", unit)); };
  if (const auto& points = d.answer->witness; points.size() == 2) {
    picture.pairs.push_back({{space_place(points[0].at), space_place(points[1].at)},
                             d.value() ? text(*d.value()) : "",
                             shown_distance.fails});
  } else if (d.answer->nearest) {
    const space::Place3 from = middle_of_moving(picture, space_place(distance::coordinates(at)));
    space::Place3 to = from;
    const space::Place3 there = space_place(*d.answer->nearest), here = space_place(distance::coordinates(at));
    for (std::size_t k = 0; k < 3; ++k) to[k] += there[k] - here[k];
    const double far = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    picture.pairs.push_back({{from, to}, text(far), shown_distance.fails, true});
  }
}

/// The bodies with the moving ones at `at`, and what takes distances.
std::string picture_at(const AskedScene& asked, const formula::SpaceSolver& solver, const space::RealVector& at,
                       std::string title, std::vector<std::string> lines, const std::vector<ShownDistance>& distances) {
  BodiesPicture picture{std::move(title), asked.unit(), std::move(lines), {}, {}, solver.world().step.to_double()};
  const KeptBodies kept = add_bodies(picture, asked, solver.world(), space_place(distance::coordinates(at)));
  for (const ShownDistance& d : distances) add_distance(picture, at, d, asked.unit());
  return bodies_svg(picture);
}

/// A line for each reason, with the distances that it is the reason for.
void note_refused(const AskedScene& asked, const std::vector<formula::DistanceAt>& distances) {
  std::vector<std::pair<std::string, std::vector<std::string>>> reasons;
  for (const auto& d : distances) {
    if (d.refused.empty()) continue;
    const auto known =
        std::find_if(reasons.begin(), reasons.end(), [&](const auto& r) { return r.first == d.refused; });
    auto& reason = known == reasons.end() ? reasons.emplace_back(d.refused, std::vector<std::string>{}) : *known;
    reason.second.push_back(formula::plain(d.text).text);
  }
  for (const auto& [reason, texts] : reasons) asked.note(fmt::format("{}: {}", fmt::join(texts, ", "), reason));
}

/// What a question about one position of space needs for its texts and pictures.
struct SpaceQuestion {
  AskedScene asked;
  space::RealVector at;
  formula::Formula formula{};
  std::shared_ptr<const formula::SpaceSolver> solver{};
  formula::AskedNearest nearest{};
  std::shared_ptr<const formula::Check> check{};
  std::shared_ptr<const std::vector<formula::DistanceAt>> distances{};

  SpaceQuestion(AskedScene given, const space::RealVector& place) : asked(std::move(given)), at(place) {}

  distance::Coordinates place() const { return distance::coordinates(at); }
  std::string moving() const { return fmt::format("{}", fmt::join(asked.scene().moving, ", ")); }
  std::string picture_of_check() const {
    std::vector<std::string> lines;
    std::vector<ShownDistance> shown;
    for (const formula::AtomAt& a : check->atoms) {
      lines.push_back(fmt::format("{}: {}", formula::written(a.atom), a.holds ? "true" : "false"));
      shown.push_back({&a.distance, !a.holds});
    }
    return picture_at(asked, *solver, at,
                      fmt::format("{} at {}: {}", moving(), where_text(at), check->holds ? "feasible" : "not feasible"),
                      std::move(lines), shown);
  }
  std::string picture_of_measurement() const {
    return picture_at(asked, *solver, at, fmt::format("{} at {}", moving(), where_text(at)), {}, {});
  }
};

std::shared_ptr<SpaceQuestion> space_question(AskedScene given, const space::RealVector& at, bool of_formula) {
  given.require_positions_in_space(true, true);
  auto out = std::make_shared<SpaceQuestion>(std::move(given), at);
  if (of_formula) out->formula = out->asked.where();
  out->solver = space_solver(out->asked);
  return out;
}

}  // namespace

namespace {

formula::TriedNearest nearest_of(const SpaceQuestion& q) {
  if (q.asked.scene().free.kind == Free::Kind::kLine) return exact::Refusal("positions are free on a line only");
  return formula::nearest_feasible(*q.solver, q.formula, q.at);
}

}  // namespace

Answer::Data nearest_in_space(AskedScene given, const space::RealVector& at) {
  const auto q = space_question(std::move(given), at, true);
  q->asked.stage("looking for the nearest feasible position");
  return nearest_answer(q->asked, nearest_of(*q), q->place());
}

Answer::Data check_in_space(AskedScene given, const space::RealVector& at, const CheckWishes& wishes) {
  const auto q = space_question(std::move(given), at, true);
  q->asked.stage("checking");
  q->check = std::make_shared<const formula::Check>(q->solver->check(q->formula, at));
  if (!q->check->holds && (wishes.nearest || wishes.snap.sign() > 0)) q->nearest = nearest_of(*q);
  const formula::NearestFeasible* there = formula::found(q->nearest);
  if (there != nullptr && there->attained && there->distance <= wishes.snap) {
    q->at = {there->at[0], there->at[1], there->at[2]};
    q->check = std::make_shared<const formula::Check>(q->solver->check(q->formula, q->at));
    q->nearest.reset();
  }
  if (!wishes.nearest) q->nearest.reset();
  note_late_rounding(q->asked, *q->solver);
  Answer::Data out;
  out.found = q->check->holds ? Answer::Found::kYes : Answer::Found::kNo;
  out.json = [q](const Telling& telling) {
    return check_json(*q->check, q->place(), q->asked.unit(), std::nullopt, q->nearest, telling.explain);
  };
  out.text = [q](const Telling& telling) {
    return check_text(*q->check, where_text(q->at), q->place(), q->asked.unit(), q->nearest, telling.explain);
  };
  out.files[".svg"] = [q](const Telling&) { return Region::Drawn{q->picture_of_check(), {}}; };
  out.at = q->place();
  show_check(out, q->check, q->nearest);
  return out;
}

Answer::Data measure_in_space(AskedScene given, const space::RealVector& at, const WantedDistances& wanted) {
  const auto q = space_question(std::move(given), at, false);
  q->asked.stage("measuring");
  q->distances = std::make_shared<const std::vector<formula::DistanceAt>>(q->solver->measure(at, wanted.kinds));
  note_late_rounding(q->asked, *q->solver);
  note_refused(q->asked, *q->distances);
  Answer::Data out;
  out.json = [q](const Telling&) { return measure_json(*q->distances, q->place(), q->asked.unit()); };
  out.text = [q, told = wanted.told](const Telling& telling) {
    return measure_text(*q->distances, where_text(q->at), q->place(), q->asked.unit(), telling.all || told);
  };
  out.files[".svg"] = [q](const Telling&) { return Region::Drawn{q->picture_of_measurement(), {}}; };
  out.at = q->place();
  show_measured(out, q->distances);
  return out;
}

}  // namespace findspace::io
