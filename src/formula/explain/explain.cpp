// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/explain.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "formula/explain/common_relaxation.h"
#include "formula/language/text.h"
#include "formula/planar/regions.h"
#include "formula/planar/solve_region.h"
#include "plane/base/parallel.h"
#include "plane/complex/overlay.h"
#include "plane/query/summary.h"

namespace findspace::formula {
namespace {

using distance::Sense;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using Kind = LevelChange::Kind;

constexpr int kPartsOfAStep = 1000;  // what written_at rounds to

/// The formula's sign maps, overlaid as often as wanted.
class Cells {
 public:
  Cells(const PreparedWorld& world, const Demands& demands) : demands_(demands) {
    const Formula& formula = demands.formula();
    maps_.resize(formula.sign_maps().size());
    plane::parallel_for(maps_.size(), [&](std::size_t k) { maps_[k] = sign_map(world, formula.sign_maps()[k]); });
  }

  std::int8_t sign(std::size_t atom, std::span<const Mark> signs) const {
    return signs[demands_.formula().sign_map_of(atom)];
  }
  MetDemands met(std::span<const Mark> signs) const {
    MetDemands out(demands_.size());
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = demands_.holds(k, sign(k, signs));
    return out;
  }
  /// {p : rule(signs at p)}
  template <class Rule>
  plane::Region region(const Rule& rule) const {
    std::vector<const plane::CellComplex*> operands;
    for (const plane::SignMap& m : maps_) operands.push_back(&m);
    if (operands.empty()) return plane::CellComplex::uniform(rule({}) ? 1 : 0);
    return plane::overlay(operands, [&](std::span<const Mark> signs) { return Mark(rule(signs) ? 1 : 0); });
  }
  /// The distinct ones.
  std::vector<MetDemands> all() const {
    std::set<MetDemands> distinct;
    region([&](std::span<const Mark> signs) {
      distinct.insert(met(signs));
      return true;
    });
    return {distinct.begin(), distinct.end()};
  }

 private:
  const Demands& demands_;
  std::vector<plane::SignMap> maps_;
};

class Explainer {
 public:
  Explainer(const Solver& solver, const Formula& formula)
      : solver_(solver), demands_(formula), cells_(solver.prepared(), demands_), met_(cells_.all()) {}

  Explanation run() const {
    Explanation out;
    out.feasible = std::any_of(met_.begin(), met_.end(), [&](const MetDemands& met) { return demands_.truth(met); });
    std::vector<LevelChange>& changes = out.feasible ? out.slack : out.relax;
    for (std::size_t k = 0; k < demands_.size(); ++k)
      if (demands_.has_level(k)) changes.push_back(out.feasible ? slack(k) : relax(k));
    if (out.feasible) return out;
    out.conflict = find_conflict(demands_, met_);
    if (!out.relax.empty()) out.together = common_relaxation(solver_, demands_, enough(out.relax));
    return out;
  }

 private:
  /// In some cell, if demand k were met there or not.
  bool room_where(std::size_t k, bool met_there) const {
    return std::any_of(met_.begin(), met_.end(), [&](MetDemands met) {
      met[k] = met_there;
      return demands_.truth(met);
    });
  }
  /// The positions that the formula has without demand k, of those where its distance minus the level has `sign`;
  /// 0 for all.
  plane::Region without(std::size_t k, int sign) const {
    return cells_.region([&](std::span<const Mark> signs) {
      if (sign != 0 && cells_.sign(k, signs) != sign) return false;
      MetDemands met = cells_.met(signs);
      met[k] = true;
      return demands_.truth(met);
    });
  }

  /// To the best value that the demand's distance has in the region.
  LevelChange to_best(std::size_t k, const plane::Region& region, Sense sense) const {
    LevelChange out;
    out.atom = k;
    const Objective objective{Objective::Kind::kDistance, demands_.formula().atoms()[k].distance, false, {}, {}};
    const Optimum best = exact_optimum(solver_, region, {objective, sense});
    if (!best.value()) {
      out.kind = best.unbounded ? Kind::kFree : Kind::kNone;
      return out;
    }
    const Relation relation = demands_.relation(k);
    const bool strict = relation == Relation::kLess || relation == Relation::kGreater;
    out.kind = Kind::kTo;
    out.level = best;
    out.reached = best.attained && best.proven() && !strict;
    const plane::Summary summary = plane::summarize(best.at, solver_.world().step);
    if (!summary.empty) {
      const RealPoint& p = summary.components.front().sample_point;
      out.at = RealPoint{p.x * solver_.world().step, p.y * solver_.world().step};
    }
    return out;
  }

  LevelChange relax(std::size_t k) const {
    LevelChange none;
    none.atom = k;
    if (!room_where(k, true)) return none;
    const Relation relation = demands_.relation(k);
    if (relation == Relation::kEqual) return relax_equal(k);
    const bool upper = relation == Relation::kLess || relation == Relation::kLessEqual;
    return to_best(k, without(k, 0), upper ? Sense::kMinimum : Sense::kMaximum);
  }
  /// The nearer of the levels above and below.
  LevelChange relax_equal(std::size_t k) const {
    const Real& level = demands_.formula().atoms()[k].level;
    const LevelChange above = to_best(k, without(k, 1), Sense::kMinimum);
    const LevelChange below = to_best(k, without(k, -1), Sense::kMaximum);
    if (above.kind != Kind::kTo || below.kind != Kind::kTo) return below.kind == Kind::kTo ? below : above;
    return above.to() - level <= level - below.to() ? above : below;
  }
  /// `=` cannot be tighter than it is.
  LevelChange slack(std::size_t k) const {
    LevelChange out;
    out.atom = k;
    out.kind = Kind::kFree;
    if (room_where(k, false)) return out;
    if (demands_.relation(k) != Relation::kEqual) return relax(k);
    out.kind = Kind::kTo;
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

  const Solver& solver_;
  Demands demands_;
  Cells cells_;
  std::vector<MetDemands> met_;
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

Explanation explain(const Solver& solver, const Formula& formula) {
  refuse_sums(formula);
  if (solver.known_between_bounds(formula))
    throw Error(ErrorCode::kUnsupported,
                "an explanation where shapes rotate, or of distances in rotation, is not computed by this version");
  return Explainer(solver, formula).run();
}

PositionExplanation explain_at(const Solver& solver, const Formula& formula, const RealPoint& p) {
  PositionExplanation out;
  refuse_sums(formula);
  out.check = solver.check(formula, p);
  if (out.check.holds) return out;
  const Demands demands(formula);
  MetDemands met(demands.size());
  for (std::size_t k = 0; k < met.size(); ++k) {
    const bool plain = demands.relation(k) == formula.atoms()[k].relation;
    met[k] = out.check.atoms[k].holds == plain;
  }
  out.change = find_correction(demands, met);
  out.nearest = solver.nearest_feasible(formula, p);
  return out;
}

std::string written_at(const Demands& demands, const LevelChange& change, const Real& step) {
  Atom atom = demands.formula().atoms()[change.atom];
  const Relation relation = demands.relation(change.atom);
  const bool up = relation == Relation::kEqual ? change.to() > atom.level
                                               : relation == Relation::kLess || relation == Relation::kLessEqual;
  const Real unit = step / Real(kPartsOfAStep);
  atom.level = rounded(change.to(), unit, up);
  if (!change.reached && relation != Relation::kEqual) atom.level += up ? unit : -unit;
  atom.written.clear();
  if (atom.predicate != nullptr && atom.predicate->level == PredicateName::Level::kNone && atom.level.sign() != 0)
    atom.predicate = nullptr;
  return written(atom);
}

}  // namespace findspace::formula
