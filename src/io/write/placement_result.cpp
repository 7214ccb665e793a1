// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From what a placement found to what is written of it: the regions of its bodies as text.

#include "io/write/write_json.h"
#include "io/write/write_json_rays.h"
#include "io/write/write_json_space.h"
#include "io/write/write_placement.h"
#include "plane/query/summary.h"

namespace findspace::io {
namespace {

using planning::Body;

/// `stands`: the body does at one of them.
std::string positions_text(const planning::AtAngle& at, const planning::Problem& problem, bool) {
  const exact::Real& step = problem.world.step;
  return region_json(at.region, plane::summarize(at.region, step), step, "");
}

std::string positions_text(const planning::SpacePositions& positions, const planning::SpaceProblem& problem,
                           bool stands) {
  const double step = problem.step.to_double();
  if (positions.boxes) return space_json(*positions.boxes, summarize(*positions.boxes, problem.step), problem.step, "");
  const formula::RayWindow box = positions.window();
  const space::RayGrid grid = space::ray_grid(box.low, box.high, 2, problem.lines);
  space::RaySummarizer summarizer(grid, box.low, box.high);
  RayLines lines(grid, step);
  const formula::RegionOnLines set = positions.lines(grid);
  space::each_row(*set.rays, [&](int j, space::RayRow&& row) {
    summarizer.add(j, row);
    lines.add(j, row);
  });
  RaysText text;
  text.lines = &lines.text();
  text.unbounded = !positions.flat && formula::holds_far_away(*positions.rays, *positions.formula);
  text.on_lines = formula::name(set.side);
  text.somewhere = stands;
  return rays_json(summarizer.finish(), grid, step, text);
}

/// `at_angles(b)`: the positions of a body, angle by angle.
template <class Problem, class Poses, class AtAngles>
PlacementResult with_regions(planning::Outcome outcome, const Problem& problem, std::size_t bodies, const Poses& poses,
                             const AtAngles& at_angles) {
  PlacementResult out{std::move(outcome), {}};
  for (std::size_t b = 0; b < bodies; ++b) {
    const Body& body = problem.bodies[b];
    if (body.copy > 0) continue;
    for (const auto& at : at_angles(b))
      out.regions.push_back({body.name, may_turn(body) ? std::optional(body.angles[at.angle]) : std::nullopt,
                             positions_text(at, problem, poses[b] && poses[b]->angle == at.angle)});
  }
  return out;
}

}  // namespace

PlacementResult placement_result(const planning::Problem& problem, const planning::SequentialPlacement& found) {
  return with_regions(
      outcome(problem, found), problem, found.steps.size(),
      found.poses, [&](std::size_t b) -> const auto& { return found.steps[b].positions; });
}

PlacementResult placement_result(const planning::Problem& problem, const planning::SimultaneousPlacement& found) {
  return with_regions(
      outcome(problem, found), problem, found.positions.size(),
      found.witness, [&](std::size_t b) -> const auto& { return found.positions[b]; });
}

PlacementResult placement_result(const planning::SpaceProblem& problem, const planning::SpacePlacement& found) {
  return with_regions(
      outcome(problem, found), problem, found.steps.size(),
      found.poses, [&](std::size_t b) -> const auto& { return found.steps[b].positions; });
}

PlacementResult placement_result(const planning::SpaceProblem& problem, const planning::SpaceSimultaneous& found) {
  PlacementResult out{outcome(problem, found), {}};
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const Body& body = problem.bodies[b];
    const space::BoxComplex& set = found.positions[b];
    if (body.copy == 0)
      out.regions.push_back({body.name, may_turn(body) ? std::optional(body.angles[0]) : std::nullopt,
                             space_json(set, summarize(set, problem.step), problem.step, "")});
  }
  return out;
}

}  // namespace findspace::io
