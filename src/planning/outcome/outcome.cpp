// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/outcome/outcome.h"

#include <fmt/format.h>

#include <algorithm>

namespace findspace::planning {
namespace {

using exact::Real;

std::vector<Real> coordinates(const exact::RealPoint& p) { return {p.x, p.y}; }
std::vector<Real> coordinates(const space::RealVector& p) { return {p.begin(), p.end()}; }
const Chosen& best_of(const Step& step) { return step.chosen; }
const SpaceBest& best_of(const SpaceStep& step) { return step.best; }

template <class V>
BodyOutcome stands(const Body& body, const std::optional<PoseOf<V>>& pose) {
  BodyOutcome out;
  out.shape = body.name;
  out.copy = body.copy;
  if (!pose) return out;
  out.at = coordinates(pose->at);
  if (may_turn(body)) out.angle = body.angles[pose->angle];
  return out;
}

template <class Step, class V>
Outcome in_order(const Demands& demands, const SequenceOf<Step, V>& found) {
  Outcome out;
  out.method = "sequential";
  for (std::size_t b = 0; b < demands.bodies.size(); ++b) {
    BodyOutcome& placed = out.placed.emplace_back(stands(demands.bodies[b], found.poses[b]));
    if (b >= found.steps.size()) continue;
    const auto& best = best_of(found.steps[b]);
    placed.attained = best.attained;
    if (placed.attained) continue;
    placed.infimum = best.values;
    out.attained = false;
  }
  if (found.limit_reached) out.unproven = "the time limit came before all shapes were placed";
  return out;
}

template <class Positions, class V>
Outcome all_together(const Demands& demands, const TogetherOf<Positions, V>& found) {
  Outcome out;
  out.method = "simultaneous";
  out.unproven = found.unproven;
  for (std::size_t b = 0; b < demands.bodies.size(); ++b) {
    BodyOutcome& placed = out.placed.emplace_back(stands(demands.bodies[b], found.witness[b]));
    placed.attained = !found.witness[b] || found.attained[b] != 0;
    out.attained = out.attained && placed.attained;
  }
  return out;
}

}  // namespace

bool Outcome::complete() const {
  return std::none_of(placed.begin(), placed.end(), [](const BodyOutcome& b) { return b.at.empty(); });
}

bool may_turn(const Body& body) { return body.angles.size() > 1 || !body.angles[0].none(); }

Outcome outcome(const Problem& problem, const SequentialPlacement& found) { return in_order(problem, found); }
Outcome outcome(const Problem& problem, const SimultaneousPlacement& found) { return all_together(problem, found); }
Outcome outcome(const SpaceProblem& problem, const SpaceSimultaneous& found) { return all_together(problem, found); }

Outcome outcome(const SpaceProblem& problem, const SpacePlacement& found) {
  Outcome out = in_order(problem, found);
  for (std::size_t b = 0; b < found.steps.size() && !out.unproven; ++b)
    if (found.steps[b].best.on_lines)
      out.unproven = fmt::format("'{}' was placed on {} x {} lines: between them there may be better positions",
                                 problem.bodies[b].name, problem.lines, problem.lines);
  return out;
}

}  // namespace findspace::planning
