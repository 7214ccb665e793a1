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
#include "plane/base/work_budget.h"
#include "plane/complex/refinement.h"
#include "plane/query/summary.h"

namespace findspace::formula {
namespace {

using distance::Sense;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using Kind = LevelChange::Kind;

constexpr std::uint64_t kEdgesAUnit = 8;     // of the overlay, for a region
constexpr std::uint64_t kEdgeOfRegion = 16;  // units, for what is best in it

plane::Refinement refinement(const PreparedWorld& world, const Formula& formula, plane::WorkBudget& work) {
  const std::vector<plane::SignMap> maps = sign_maps(world, formula);
  std::vector<const plane::CellComplex*> operands;
  for (const plane::SignMap& m : maps) operands.push_back(&m);
  return {operands, work, kManyDemands};
}

/// The cells of the overlay of the formula's sign maps. What it does with them is counted as work.
class Cells {
 public:
  Cells(const PreparedWorld& world, const Demands& demands, plane::WorkBudget& work)
      : demands_(demands),
        work_(work),
        refinement_(refinement(world, demands.formula(), work)),
        failing_(demands, met(refinement_, demands)) {}

  /// What is met in them; distinct.
  std::set<MetDemands> all() const {
    const std::vector<MetDemands> all = met(refinement_, demands_);
    return {all.begin(), all.end()};
  }
  /// The positions that the formula has without demand k, of those where its distance minus the level has `sign`; 0:
  /// any.
  plane::Region without(std::size_t k, int sign) {
    work_.charge(1 + refinement_.edge_count() / kEdgesAUnit, kManyDemands);
    const std::vector<bool> holds = failing_.where([k](std::size_t other) { return other != k; });
    const std::size_t map = demands_.formula().sign_map_of(k);
    std::vector<Mark> in(holds.size());
    for (std::size_t kind = 0; kind < in.size(); ++kind)
      in[kind] = holds[kind] && (sign == 0 || refinement_.marks(kind)[map] == sign) ? 1 : 0;
    plane::Region out = refinement_.complex(in);
    work_.charge(kEdgeOfRegion * out.edges.size(), kManyDemands);
    return out;
  }

 private:
  /// By cells of each kind.
  static std::vector<MetDemands> met(const plane::Refinement& refinement, const Demands& demands) {
    std::vector<MetDemands> out;
    for (std::size_t kind = 0; kind < refinement.kinds(); ++kind)
      out.push_back(met_at(demands, refinement.marks(kind)));
    return out;
  }

  const Demands& demands_;
  plane::WorkBudget& work_;
  plane::Refinement refinement_;
  FailingCells failing_;  // of each kind
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
    for (const auto& pose : poses) distinct.merge(cells_.emplace_back(pose->prepared(), demands, work_).all());
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
  LevelChange best_at(std::size_t pose, std::size_t k, int sign, Sense sense) {
    const Objective objective{Objective::Kind::kDistance, demands().formula().atoms()[k].distance, false, {}, {}};
    const Optimum best = exact_optimum(*poses_[pose], cells_[pose].without(k, sign), {objective, sense});
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

  Poses poses_;
  plane::WorkBudget work_ = plane::allowed_work();
  std::vector<Cells> cells_;  // at each pose
};

}  // namespace

std::unique_ptr<Ground> planar_ground(Poses poses, const Demands& demands) {
  return std::make_unique<PlanarGround>(poses, demands);
}

}  // namespace findspace::formula
