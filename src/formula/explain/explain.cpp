// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/explain.h"

#include <algorithm>

#include "formula/explain/ground.h"
#include "formula/language/text.h"
#include "formula/planar/solve_rotation.h"

namespace findspace::formula {
namespace {

using distance::Sense;
using exact::Real;
using exact::RealPoint;
using Kind = LevelChange::Kind;

constexpr int kPartsOfAStep = 1000;  // what written_at rounds to

bool strict(Relation relation) { return relation == Relation::kLess || relation == Relation::kGreater; }
bool bounded_above(Relation relation) { return relation == Relation::kLess || relation == Relation::kLessEqual; }

LevelChange change_of(std::size_t k, Kind kind, std::string refused = {}) {
  LevelChange out;
  out.atom = k;
  out.kind = kind;
  out.refused = std::move(refused);
  return out;
}

class Explainer {
 public:
  Explainer(Ground& ground, const Demands& demands) : ground_(ground), demands_(demands) {}

  Explanation run() {
    Explanation out;
    out.feasible = ground_.room({}).or_throw();
    std::vector<LevelChange>& changes = out.feasible ? out.slack : out.relax;
    for (std::size_t k = 0; k < demands_.size(); ++k)
      if (demands_.has_level(k)) changes.push_back(out.feasible ? slack(k) : relax(k));
    if (out.feasible) return out;
    out.conflict = ground_.conflict();
    if (!out.relax.empty() && of_one_unit(out.relax)) out.together = ground_.together(enough(out.relax));
    return out;
  }

 private:
  /// Lengths and degrees do not move by one amount.
  bool of_one_unit(const std::vector<LevelChange>& levels) const {
    const auto turns = [&](const LevelChange& c) { return demands_.in_degrees(c.atom); };
    return std::all_of(levels.begin(), levels.end(), turns) || std::none_of(levels.begin(), levels.end(), turns);
  }
  LevelChange relax(std::size_t k) {
    const exact::Tried<bool> room = ground_.room(AssumedDemand{k, true});
    if (!room) return change_of(k, Kind::kUnknown, room.refusal().error.message());
    if (!*room) return change_of(k, Kind::kNone);
    const Relation relation = demands_.relation(k);
    if (relation == Relation::kEqual) return relax_equal(k);
    return ground_.best(k, 0, bounded_above(relation) ? Sense::kMinimum : Sense::kMaximum);
  }
  /// The nearer of the levels above and below.
  LevelChange relax_equal(std::size_t k) {
    const Real& level = demands_.formula().atoms()[k].level;
    const LevelChange above = ground_.best(k, 1, Sense::kMinimum), below = ground_.best(k, -1, Sense::kMaximum);
    if (above.kind != Kind::kTo || below.kind != Kind::kTo) return below.kind == Kind::kTo ? below : above;
    return above.to() - level <= level - below.to() ? above : below;
  }
  /// `=` cannot be tighter than it is.
  LevelChange slack(std::size_t k) {
    const exact::Tried<bool> room = ground_.room(AssumedDemand{k, false});
    if (!room) return change_of(k, Kind::kUnknown, room.refusal().error.message());
    if (*room) return change_of(k, Kind::kFree);
    if (demands_.relation(k) != Relation::kEqual) return relax(k);
    LevelChange out = change_of(k, Kind::kTo);
    out.level.set_exact(demands_.formula().atoms()[k].level, distance::Way::kNone);
    out.reached = true;
    return out;
  }

  /// The least change of one level that leaves room.
  std::optional<Real> enough(const std::vector<LevelChange>& relax) const {
    std::optional<Real> out;
    for (const LevelChange& c : relax) {
      if (c.kind != Kind::kTo || !c.level.proven()) continue;
      const Real by = abs(c.to() - demands_.formula().atoms()[c.atom].level);
      if (!out || by < *out) out = by;
    }
    return out;
  }

  Ground& ground_;
  const Demands& demands_;
};

/// The nearest multiple of `unit` that is not below the value, or not above it.
Real rounded(const Real& value, const Real& unit, bool up) {
  return up ? -(Real(floor(-value / unit)) * unit) : Real(floor(value / unit)) * unit;
}

void refuse_sums(const Formula& formula) {
  if (has_sums(formula))
    throw Error(ErrorCode::kUnsupported, "an explanation where distances are compared with each other is not computed");
}

}  // namespace

MetDemands met_at(const Demands& demands, std::span<const plane::Mark> signs) {
  MetDemands out(demands.size());
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = demands.holds(k, signs[demands.formula().sign_map_of(k)]);
  return out;
}

bool holds_without(const Demands& demands, std::span<const plane::Mark> signs, std::size_t k, int sign) {
  if (sign != 0 && signs[demands.formula().sign_map_of(k)] != sign) return false;
  MetDemands met = met_at(demands, signs);
  met[k] = true;
  return demands.truth(met);
}

bool has_room(FailingCells& cells, const std::optional<AssumedDemand>& assumed) {
  const std::size_t other = assumed ? assumed->atom : FailingCells::kNoDemand;
  const std::size_t also = assumed && !assumed->met ? assumed->atom : FailingCells::kNoDemand;
  return cells.first([other](std::size_t k) { return k != other; }, also) < cells.size();
}

LevelChange changed(const Demands& demands, std::size_t k, const distance::OptimalValue& best, bool attained) {
  LevelChange out = change_of(k, best.unbounded ? LevelChange::Kind::kFree : LevelChange::Kind::kNone);
  if (!best.value()) return out;
  out.kind = LevelChange::Kind::kTo;
  out.level = best;
  out.reached = attained && !strict(demands.relation(k));
  return out;
}

Explanation explain(const Solver& solver, const Formula& formula) {
  const std::shared_ptr<const Solver> drawn(std::shared_ptr<const Solver>(), &solver);  // keeps nothing alive
  return explain(std::span(&drawn, 1), formula);
}

Explanation explain(Poses poses, const Formula& formula) {
  refuse_sums(formula);
  if (poses.front()->known_between_bounds(formula))
    throw Error(ErrorCode::kUnsupported,
                "an explanation where shapes rotate in time, or of distances in rotation, is not computed");
  const Demands demands(formula);
  return Explainer(*planar_ground(poses, demands), demands).run();
}

Explanation explain(const SpaceSolver& solver, const Formula& formula) {
  refuse_sums(formula);
  const Demands demands(formula);
  return Explainer(*space_ground(solver, demands), demands).run();
}

Explanation explain(const RotationMaps& maps, const Formula& formula) {
  refuse_sums(formula);
  const Demands demands(formula);
  return Explainer(*angle_ground(maps, demands), demands).run();
}

Explanation explain_instants(const Solver& solver, const Formula& formula, const RealPoint& p) {
  refuse_sums(formula);
  const Demands demands(formula);
  return Explainer(*time_ground(solver.prepared(), solver.prepared().steps(p), demands), demands).run();
}

namespace {

PositionExplanation explained(const Formula& formula, Check check) {
  PositionExplanation out;
  out.check = std::move(check);
  if (out.check.holds) return out;
  const Demands demands(formula);
  MetDemands met(demands.size());
  for (std::size_t k = 0; k < met.size(); ++k) {
    const bool plain = demands.relation(k) == formula.atoms()[k].relation;
    met[k] = out.check.atoms[k].holds == plain;
  }
  out.change = find_correction(demands, met);
  return out;
}

template <class S, class Place>
PositionExplanation explained_at(const S& solver, const Formula& formula, const Place& p) {
  refuse_sums(formula);
  return explained(formula, solver.check(formula, p));
}

}  // namespace

PositionExplanation explain_at(const Solver& solver, const Formula& formula, const RealPoint& p) {
  PositionExplanation out = explained_at(solver, formula, p);
  if (!out.check.holds) out.nearest = solver.nearest_feasible(formula, p);
  return out;
}

PositionExplanation explain_at(const SpaceSolver& solver, const Formula& formula, const space::RealVector& p) {
  PositionExplanation out = explained_at(solver, formula, p);
  if (!out.check.holds) out.nearest = nearest_feasible(solver, formula, p);
  return out;
}

PositionExplanation explain_at(const RotationSolver& pose, const Solver& rotated, const Formula& formula,
                               const RealPoint& p) {
  refuse_sums(formula);
  PositionExplanation out = explained(formula, pose.check(formula));
  if (out.check.holds) return out;
  out.nearest = rotated.nearest_feasible(formula, p);
  const NearestFeasible* near = found(out.nearest);
  if (near != nullptr && near->distance.sign() == 0) out.nearest.reset();  // on the grid it holds here
  return out;
}

Explanation feasible_off_the_grid(const Formula& formula) {
  const Demands demands(formula);
  Explanation out;
  out.feasible = true;
  for (std::size_t k = 0; k < demands.size(); ++k)
    if (demands.has_level(k))
      out.slack.push_back(
          change_of(k, LevelChange::Kind::kUnknown, "with its vertices on the grid no position is feasible"));
  return out;
}

std::string written_at(const Demands& demands, const LevelChange& change, const Real& step) {
  Atom atom = demands.formula().atoms()[change.atom];
  const Relation relation = demands.relation(change.atom);
  const bool up = relation == Relation::kEqual ? change.to() > atom.level : bounded_above(relation);
  const Real unit = step / Real(kPartsOfAStep);
  atom.level = rounded(change.to(), unit, up);
  if (!change.reached && relation != Relation::kEqual) atom.level += up ? unit : -unit;
  atom.written.clear();
  if (atom.predicate != nullptr && atom.predicate->level == PredicateName::Level::kNone && atom.level.sign() != 0)
    atom.predicate = nullptr;
  return written(atom);
}

}  // namespace findspace::formula
