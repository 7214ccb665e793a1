// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "formula/explain/common_relaxation.h"
#include "formula/explain/ground.h"
#include "formula/planar/feasible_near.h"
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

/// The formula's sign maps, overlaid as often as wanted.
class Cells {
 public:
  Cells(const PreparedWorld& world, const Demands& demands) : demands_(demands) {
    const Formula& formula = demands.formula();
    maps_.resize(formula.sign_maps().size());
    plane::parallel_for(maps_.size(), [&](std::size_t k) { maps_[k] = sign_map(world, formula.sign_maps()[k]); });
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
      distinct.insert(met_at(demands_, signs));
      return true;
    });
    return {distinct.begin(), distinct.end()};
  }

 private:
  const Demands& demands_;
  std::vector<plane::SignMap> maps_;
};

/// The better value of two, and a bound for the values of both places. Of equal ones the first.
distance::OptimalValue best_of(const distance::OptimalValue& a, const distance::OptimalValue& b) {
  if (a.unbounded || !b.value()) return a;
  if (b.unbounded || !a.value()) return b;
  const auto better = [&](const Real& x, const Real& y) { return a.maximum() ? x > y : x < y; };
  const bool second = better(*b.value(), *a.value());
  distance::OptimalValue out = second ? b : a;
  const distance::OptimalValue& other = second ? a : b;
  if (other.proven()) return out;
  const std::optional<Real> far = other.bound(), near = out.proven() ? out.value() : out.bound();
  if (!near || (far && !better(*far, *near))) return out;
  const distance::Way way = out.answer->way;
  const Real value = *out.value();
  if (out.answer->side == distance::Side::kNone)
    out.set_nearby(value, far, way);
  else
    out.set_enclosed(value, far, way);
  return out;
}

class PlanarGround : public KnownCells {
 public:
  PlanarGround(Poses poses, const Demands& demands) : KnownCells(demands), poses_(poses) {
    std::set<MetDemands> distinct;
    for (const auto& pose : poses) {
      const std::vector<MetDemands> here = cells_.emplace_back(pose->prepared(), demands).all();
      distinct.insert(here.begin(), here.end());
    }
    know(distinct);
  }

  LevelChange best(std::size_t k, int sign, Sense sense) override {
    LevelChange out = best_at(0, k, sign, sense);
    for (std::size_t pose = 1; pose < poses_.size(); ++pose) {
      const LevelChange other = best_at(pose, k, sign, sense);
      const distance::OptimalValue level = best_of(out.level, other.level);
      if (is_better(other, out)) out = other;
      out.level = level;
    }
    return out;
  }
  CommonRelaxation together(const std::optional<Real>& enough) override {
    const FindPlace find = [this](const Formula& near) { return place_of(near); };
    return common_relaxation(find, poses_.front()->world().step, demands(), enough);
  }

 private:
  LevelChange best_at(std::size_t pose, std::size_t k, int sign, Sense sense) const {
    const Objective objective{Objective::Kind::kDistance, demands().formula().atoms()[k].distance, false, {}, {}};
    const Optimum best = exact_optimum(*poses_[pose], without(cells_[pose], k, sign), {objective, sense});
    LevelChange out = changed(demands(), k, best, best.attained && best.proven());
    if (out.kind == Kind::kTo) out.place = place_in(best.at, pose).value_or(RemainingPlace());
    return out;
  }
  std::optional<RemainingPlace> place_in(const plane::Region& region, std::size_t pose) const {
    const Real& step = poses_[pose]->world().step;
    const plane::Summary summary = plane::summarize(region, step);
    if (summary.empty) return std::nullopt;
    RemainingPlace out;
    out.at = distance::coordinates(distance::times(step, RealPoint(summary.components.front().sample_point)));
    out.pose = pose;
    return out;
  }
  std::optional<RemainingPlace> place_of(const Formula& near) const {
    for (std::size_t pose = 0; pose < poses_.size(); ++pose)
      if (auto place = place_in(feasible_near(*poses_[pose], near), pose)) return place;
    return std::nullopt;
  }
  /// Of two with a level, at an equal one the change that reaches it.
  static bool is_better(const LevelChange& a, const LevelChange& b) {
    if (a.kind == Kind::kFree || b.kind == Kind::kFree) return b.kind != Kind::kFree;
    if (a.kind != Kind::kTo || b.kind != Kind::kTo) return a.kind == Kind::kTo && b.kind != Kind::kTo;
    const int order = compare(a.to(), b.to());
    return order == 0 ? a.reached && !b.reached : (order > 0) == a.level.maximum();
  }
  /// The positions that the formula has without demand k, of those where its distance minus the level has `sign`.
  plane::Region without(const Cells& cells, std::size_t k, int sign) const {
    return cells.region([&](std::span<const Mark> signs) { return holds_without(demands(), signs, k, sign); });
  }

  Poses poses_;
  std::vector<Cells> cells_;  // at each pose
};

}  // namespace

std::unique_ptr<Ground> planar_ground(Poses poses, const Demands& demands) {
  return std::make_unique<PlanarGround>(poses, demands);
}

}  // namespace findspace::formula
