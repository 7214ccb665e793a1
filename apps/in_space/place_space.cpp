// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verb place for 3D scenes: bodies one after another (planning/solid/space_sequence.h) or all at once
// (planning/solid/space_simultaneous.h), the positions each had, and the placed shapes as one mesh.
#include <fmt/format.h>

#include <algorithm>

#include "common/placement_demands.h"
#include "findspace/error.h"
#include "in_space/space_commands.h"
#include "io/draw/draw_layout.h"
#include "io/write/write_placement.h"
#include "planning/solid/space_sequence.h"
#include "planning/solid/space_simultaneous.h"
#include "space/shape/rotated_shape.h"

namespace findspace::app {
namespace {

using exact::Real;
using planning::SpaceProblem;

plane::ShapePtr rotated(const Session& session, const planning::RotatedShape& t) {
  plane::Rounding rounding;
  plane::Shape out = *space::rotated(*session.scene().shape(t.shape), t.turn.in_space(), rounding);
  out.name = t.name;
  if (rounding.points > 0)
    session.reporter().note(fmt::format("shape '{}': {} points were put on the grid, moved by at most {:.2g} {}",
                                        t.name, rounding.points, rounding.largest * session.scene().grid.step_size(),
                                        session.unit()));
  return std::make_shared<const plane::Shape>(std::move(out));
}

SpaceProblem problem_of(const Session& session) {
  planning::AskedDemands asked = placement_demands(session);
  SpaceProblem problem;
  static_cast<planning::Demands&>(problem) = std::move(asked.demands);
  std::vector<plane::ShapePtr> shapes = session.scene().shapes;
  for (const planning::RotatedShape& t : asked.rotated) shapes.push_back(rotated(session, t));
  for (const plane::ShapePtr& s : shapes) problem.shapes.emplace(s->name, s);
  problem.built = space_shapes(session, shapes);
  problem.step = session.step();
  if (session.options().resolution > 0) problem.lines = session.options().resolution;
  return problem;
}

/// What is placed, as one mesh whose faces are labelled by shape.
io::Surface scenery(const Session& session, const SpaceProblem& problem, const planning::SpacePoses& poses) {
  io::Surface out;
  const auto add = [&](const std::string& name, const space::RealVector& at) {
    const io::Surface one = boundary_of(session, *problem.shapes.at(name));
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
std::vector<std::string> placed_lines(const io::PlacementResult& result, const Session& session) {
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
    for (const Real& x : p.at) at.push_back(io::shown((x * session.step()).to_double()));
    line += fmt::format(" at ({})", fmt::join(at, ", "));
    if (p.angle && !p.angle->none()) line += fmt::format(", rotated by {}", io::orientation_text(*p.angle));
    lines.push_back(std::move(line));
  }
  return lines;
}

/// What stands still, and in blue what is placed.
std::string picture(const Session& session, const SpaceProblem& problem, const planning::SpacePoses& poses,
                    const io::PlacementResult& result) {
  const bool together = result.method == "simultaneous";
  std::vector<std::string> names;
  for (const plane::ShapePtr& s : session.scene().shapes) names.push_back(s->name);
  return io::placement_svg(problem, poses,
                           {together ? "Placement, all at once" : "Placement, one after another",
                            {},
                            placed_lines(result, session),
                            session.unit(),
                            io::standing_still(problem, names)});
}

struct Answer {
  io::PlacementResult result;
  planning::SpacePoses poses;
  ExitStatus status = kDone;
};

Answer together(const SpaceProblem& problem, const planning::Limit& limit) {
  const planning::SpaceSimultaneous found = planning::place_together_in_space(problem, limit);
  io::PlacementResult result = io::placement_result(problem, found);
  const ExitStatus status = result.complete() ? kDone : found.unproven ? kLimit : kEmpty;
  return {std::move(result), found.witness, status};
}

Answer one_after_another(const SpaceProblem& problem, const planning::Limit& limit) {
  const planning::SpacePlacement found = planning::place_in_space(problem, limit);
  // A shape without a position found on lines may have one between them.
  ExitStatus status = found.limit_reached ? kLimit : kDone;
  for (const planning::SpaceStep& step : found.steps)
    if (!step.pose && status != kLimit) status = step.best.on_lines ? kLimit : kEmpty;
  return {io::placement_result(problem, found), found.poses, status};
}

}  // namespace

Outcome place_space(const Session& session, const planning::Limit& limit) {
  const Options& options = session.options();
  std::vector<std::string> endings{".json"};
  endings.insert(endings.end(), io::kSurfaceEndings.begin(), io::kSurfaceEndings.end());
  check_outputs(options, endings);
  const SpaceProblem problem = problem_of(session);
  session.reporter().stage("placing");
  const bool all_at_once = session.scene().place.method == io::Placement::Method::kSimultaneous;
  const Answer answer = all_at_once ? together(problem, limit) : one_after_another(problem, limit);
  const io::PlacementResult& result = answer.result;
  session.reporter().stage("writing");
  const auto json = [&] { return io::placement_json(result, session.step(), session.unit()); };
  Writers writers{{".json", json}};
  for (const char* ending : io::kSurfaceEndings)
    writers.emplace(ending, [&, ending] {
      return io::surface_text(scenery(session, problem, answer.poses), "placement", ending, session.unit());
    });
  writers[".svg"] = [&] { return picture(session, problem, answer.poses, result); };
  write_outputs(options, writers);
  return {options.json ? json() : io::placement_text(result, session.step(), session.unit()), answer.status};
}

}  // namespace findspace::app
