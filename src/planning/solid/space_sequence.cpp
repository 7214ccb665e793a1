// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "planning/solid/space_sequence.h"

#include <algorithm>

#include "findspace/error.h"
#include "formula/solid/ray_minima.h"
#include "planning/solid/space_on_boxes.h"
#include "planning/solid/space_on_lines.h"
#include "space/body/lowest_in_complement.h"

namespace findspace::planning {

using exact::Real;
using space::RealVector;

namespace {

/// Whether a condition holds nowhere by itself, which one convex set tells.
bool one_fails(const SpaceStage& stage) {
  const formula::Formula& formula = stage.formula();
  if (formula.root().op != formula::Node::Op::kAnd && formula.root().op != formula::Node::Op::kAtom) return false;
  const formula::SpaceSolver solver(stage.world());
  const auto is_atom = [](const formula::Node& n) { return n.op == formula::Node::Op::kAtom; };
  std::vector<formula::Node> operands = formula.root().operands;
  if (operands.empty()) operands = {formula.root()};
  return std::any_of(operands.begin(), operands.end(), [&](const formula::Node& n) {
    if (!is_atom(n)) return false;
    const auto set = solver.feasible_convex(formula::Formula(formula.atoms()[n.atom]));
    return set && *set && space::summarize((*set)->set, (*set)->step).empty;
  });
}

/// On lines `-> min` is a level.
formula::Formula formula_on_lines(const SpaceStage& stage) {
  if (!formula::has_minima(stage.formula())) return stage.formula();
  formula::MinimaAsLevels levels = formula::minima_as_levels(formula::SpaceSolver(stage.world()), stage.formula());
  if (levels.side != distance::Side::kExact) {
    throw Error(ErrorCode::kUnsupported,
                levels.minima[0].text + ": a placement needs the exact least value, which is not known");
  }
  return std::move(levels.formula);
}

SpacePositions positions_of(const SpaceStage& stage, std::size_t angle) {
  SpacePositions out;
  out.angle = angle;
  out.formula = std::make_shared<const formula::Formula>(stage.formula());
  if (auto boxes = formula::SpaceSolver(stage.world()).try_feasible(stage.formula())) {
    out.boxes = *std::move(boxes);
    return out;
  }
  if (auto flat = flat_positions(stage)) {
    out.flat = std::make_shared<const FlatPositions>(std::move(*flat));
    return out;
  }
  out.rays = std::make_shared<const formula::RayWorld>(stage.rays());
  out.none = one_fails(stage);
  out.formula = std::make_shared<const formula::Formula>(formula_on_lines(stage));
  return out;
}

std::optional<SpaceBest> best_in_flat(const FlatPositions& flat, const SpaceGoals& goals, const Real& step) {
  const auto forms = goals.forms();
  if (!forms) return std::nullopt;
  SpaceBest out;
  if (flat.empty_box()) return out;
  space::ConvexRegion within(flat.low, flat.high);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!goals.fixed[k]) continue;
    RealVector up;
    up[k] = Real(1);
    const space::HalfSpace below(up, -*goals.fixed[k]);
    within.cut(below);
    within.cut(below.opposite());
    out.values.push_back(std::nullopt);
  }
  out.at = lowest_in_complement(flat.covered, within, *forms);
  for (std::size_t k = 0; out.at && k < goals.all.size(); ++k)
    out.values.push_back(space::dot((*forms)[k], *out.at) * step);
  return out;
}

SpaceBest best_in(const SpacePositions& positions, const SpaceGoals& goals, const SpaceProblem& problem) {
  if (positions.none || goals.none) return {};
  if (positions.boxes) {
    SpaceBest best = best_on_boxes(*positions.boxes, goals, problem.step);
    goals.put_on_grid(best.at, [&](const RealVector& q) { return positions.boxes->mark(q) != 0; });
    return best;
  }
  if (positions.flat) {
    if (auto best = best_in_flat(*positions.flat, goals, problem.step)) {
      goals.put_on_grid(best->at, [&](const RealVector& q) { return positions.flat->holds(q); });
      return *best;
    }
  }
  const formula::RayWindow box = positions.window();
  const LinesAsked lines{[&](const space::RayGrid& grid) { return positions.lines(grid).rays; }, box.low, box.high,
                         problem.lines};
  return best_on_lines(lines, goals);
}

/// The goals and the rule for ties at a position.
std::vector<Real> key(const RealVector& p, const SpaceGoals& goals) {
  std::vector<Real> out;
  for (const SpaceGoal& g : goals.all) {
    const RealVector off = g.point ? space::minus(p, *g.point) : RealVector{};
    out.push_back(g.point ? space::dot(off, off) : space::dot(g.form, p));
  }
  for (const RealVector& tie : tie_forms()) out.push_back(space::dot(tie, p));
  return out;
}

/// Of two angles: whether the first is better. One whose least value is not taken counts for what it has.
bool better(const SpaceBest& a, const SpaceBest& b, const SpaceGoals& goals) {
  if (a.unbounded != b.unbounded) return a.unbounded;
  if (a.at && b.at) return key(*a.at, goals) < key(*b.at, goals);
  for (std::size_t k = 0; k < std::min(a.values.size(), b.values.size()); ++k) {
    if (!a.values[k] || !b.values[k]) continue;
    if (const int order = compare(*a.values[k], *b.values[k]); order != 0) return order < 0;
  }
  return a.at.has_value() && !b.at.has_value();
}

SpaceStep place(const SpaceProblem& problem, const SpaceGoals& goals, const SpacePoses& poses, std::size_t body) {
  SpaceStep step;
  bool lines = false, any = false;
  for (std::size_t a = 0; a < problem.bodies[body].angles.size(); ++a) {
    step.positions.push_back(positions_of(SpaceStage(problem, poses, body, a), a));
    SpaceBest best = best_in(step.positions.back(), goals, problem);
    lines = lines || best.on_lines;
    if (!best.at && best.attained) continue;  // no position at this angle
    if (any && !better(best, step.best, goals)) continue;
    any = true;
    step.pose.reset();
    if (best.at) step.pose = SpacePose{a, *best.at};
    step.best = std::move(best);
  }
  step.best.on_lines = lines;
  return step;
}

}  // namespace

formula::RayWindow SpacePositions::window() const {
  if (!flat) return formula::window(*rays, *formula);
  const auto corner = [](const RealVector& p, const Real& up) {
    std::array<std::int64_t, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(exact::floor(p[k] + up));
    return space::Point{c[0], c[1], c[2]};
  };
  return {corner(flat->low, Real()), corner(flat->high, Real(1))};
}

formula::RegionOnLines SpacePositions::lines(const space::RayGrid& grid) const {
  return flat ? formula::RegionOnLines{flat->rays(grid)} : formula::ray_region(*rays, *formula, grid);
}

SpacePlacement place_in_space(const SpaceProblem& problem, const Limit& limit) {
  SpacePlacement out;
  out.place_each(problem.bodies.size(), limit, [&](std::size_t body) {
    SpaceStep step = place(problem, space_goals(problem, body), out.poses, body);
    out.poses[body] = step.pose;
    return step;
  });
  return out;
}

}  // namespace findspace::planning
