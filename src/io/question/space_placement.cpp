// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb place for 3D scenes: bodies one after another (planning/solid/space_sequence.h) or all at once
// (planning/solid/space_simultaneous.h), the positions each had, and the placed shapes as one mesh.
#include <fmt/format.h>

#include <algorithm>

#include "api/plan/placement_data.h"
#include "io/draw/draw_layout.h"
#include "io/mesh/space_surface.h"
#include "io/mesh/write_mesh.h"
#include "io/question/placement_answer.h"
#include "io/question/placement_demands.h"
#include "io/question/space_shapes.h"
#include "io/write/write_placement.h"
#include "planning/solid/space_sequence.h"
#include "planning/solid/space_simultaneous.h"
#include "space/shape/rotated_shape.h"

namespace findspace::io {
namespace {

using exact::Real;
using planning::SpaceProblem;

plane::ShapePtr turned_solid(const AskedScene& asked, const planning::RotatedShape& t) {
  plane::Rounding rounding;
  plane::Shape out = *space::rotated(*asked.scene().shape(t.shape), t.turn.in_space(), rounding);
  out.name = t.name;
  if (rounding.points > 0)
    asked.note(fmt::format("shape '{}': {} points were put on the grid, moved by at most {:.2g}{}{}", t.name,
                           rounding.points, rounding.largest * asked.scene().grid.step_size(),
                           asked.unit().empty() ? "" : " ", asked.unit()));
  return std::make_shared<const plane::Shape>(std::move(out));
}

SpaceProblem problem_of(const AskedScene& asked, int lines) {
  planning::AskedDemands wanted = placement_demands(asked);
  SpaceProblem problem;
  static_cast<planning::Demands&>(problem) = std::move(wanted.demands);
  std::vector<plane::ShapePtr> shapes = asked.scene().shapes;
  for (const planning::RotatedShape& t : wanted.rotated) shapes.push_back(turned_solid(asked, t));
  for (const plane::ShapePtr& s : shapes) problem.shapes.emplace(s->name, s);
  problem.built = space_shapes(asked, shapes);
  problem.step = asked.step();
  if (lines > 0) problem.lines = lines;
  return problem;
}

/// What is placed, as one mesh whose faces are labelled by shape.
Surface placed_surface(const SpaceProblem& problem, const planning::SpacePoses& poses, std::string& lost) {
  Surface out;
  const auto add = [&](const std::string& name, const space::RealVector& at) {
    SolidSurface found = solid_surface(*problem.shapes.at(name), problem.step);
    if (lost.empty()) lost = std::move(found.lost);
    const Surface one = std::move(found.surface);
    const auto first = static_cast<int>(out.vertices.size());
    for (auto v : one.vertices) {
      for (std::size_t k = 0; k < 3; ++k) v[k] += (at[k] * problem.step).to_double();
      out.vertices.push_back(v);
    }
    for (auto face : one.faces) {
      for (int& v : face) v += first;
      out.faces.push_back(std::move(face));
      out.labels.push_back(name);
    }
  };
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    if (!poses[b]) continue;
    for (const std::string& name : problem.bodies[b].variants[poses[b]->angle]) add(name, poses[b]->at);
  }
  return out;
}

/// A line a body: where it is placed.
std::vector<std::string> placed_lines(const PlacementResult& result, const AskedScene& asked) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> lines;
  for (const planning::BodyOutcome& p : result.placed) {
    if (lines.size() == kMost) {
      lines.push_back(fmt::format("and {} more", result.placed.size() - kMost));
      break;
    }
    std::string line = p.copy > 0 ? fmt::format("{} {}", p.shape, p.copy) : p.shape;
    if (p.at.empty()) {
      lines.push_back(line + ": no free position");
      continue;
    }
    std::vector<std::string> at;
    for (const Real& x : p.at) at.push_back(shown((x * asked.step()).to_double()));
    line += fmt::format(" at ({})", fmt::join(at, ", "));
    if (p.angle && !p.angle->none()) line += fmt::format(", rotated by {}", orientation_text(*p.angle));
    lines.push_back(std::move(line));
  }
  return lines;
}

/// What stands still, and in blue what is placed.
std::string picture_of_placed(const AskedScene& asked, const SpaceProblem& problem, const planning::SpacePoses& poses,
                              const PlacementResult& result) {
  const bool together = result.method == "simultaneous";
  std::vector<std::string> names;
  for (const plane::ShapePtr& s : asked.scene().shapes) names.push_back(s->name);
  return placement_svg(problem, poses,
                       {together ? "Placement, all at once" : "Placement, one after another",
                        {},
                        placed_lines(result, asked),
                        asked.unit(),
                        standing_still(problem, names)});
}

struct PlacedSolids {
  PlacementResult result;
  planning::SpacePoses poses;
  Answer::Found found = Answer::Found::kYes;
};

PlacedSolids solids_together(const SpaceProblem& problem, const planning::Limit& limit) {
  const planning::SpaceSimultaneous found = planning::place_together_in_space(problem, limit);
  PlacementResult result = placement_result(problem, found);
  const Answer::Found done = result.complete() ? Answer::Found::kYes
                             : found.unproven  ? Answer::Found::kUndecided
                                               : Answer::Found::kNo;
  return {std::move(result), found.witness, done};
}

PlacedSolids solids_one_by_one(const SpaceProblem& problem, const planning::Limit& limit) {
  const planning::SpacePlacement found = planning::place_in_space(problem, limit);
  // A shape without a position found on lines may have one between them.
  Answer::Found done = found.limit_reached ? Answer::Found::kUndecided : Answer::Found::kYes;
  for (const planning::SpaceStep& step : found.steps)
    if (!step.pose && done != Answer::Found::kUndecided)
      done = step.best.on_lines ? Answer::Found::kUndecided : Answer::Found::kNo;
  return {placement_result(problem, found), found.poses, done};
}

struct SpacePlacementQuestion {
  AskedScene asked;
  SpaceProblem problem;
  PlacedSolids placed{};

  SpacePlacementQuestion(AskedScene given, int lines) : asked(std::move(given)), problem(problem_of(asked, lines)) {}
};

}  // namespace

Answer::Data place_in_space(AskedScene given, const PlacementQuestion& question) {
  const auto q = std::make_shared<SpacePlacementQuestion>(std::move(given), question.lines);
  q->asked.stage("placing");
  const bool all_at_once = q->asked.scene().place.method == Placement::Method::kSimultaneous;
  q->placed = all_at_once ? solids_together(q->problem, question.limit) : solids_one_by_one(q->problem, question.limit);
  Answer::Data out;
  out.found = q->placed.found;
  out.json = [q](const Telling&) { return placement_json(q->placed.result, q->asked.step(), q->asked.unit()); };
  out.text = [q](const Telling&) { return placement_text(q->placed.result, q->asked.step(), q->asked.unit()); };
  for (const char* ending : kSurfaceEndings)
    out.files[ending] = [q, ending](const Telling&) {
      std::string lost;
      std::string text =
          surface_text(placed_surface(q->problem, q->placed.poses, lost), "placement", ending, q->asked.unit());
      return Region::Drawn{std::move(text), std::move(lost)};
    };
  out.files[".svg"] = [q](const Telling&) {
    return Region::Drawn{picture_of_placed(q->asked, q->problem, q->placed.poses, q->placed.result), {}};
  };
  out.placement = [q, json = out.json, svg = out.files[".svg"]] {
    findspace::Placement::Told told = api::told(q->placed.result, q->asked.step());
    told.json = json({});
    told.svg = svg({}).text;
    return findspace::Placement(std::move(told));
  };
  return out;
}

}  // namespace findspace::io
