// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <set>
#include <span>

#include "formula/explain/common_relaxation.h"
#include "formula/explain/ground.h"
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

class PlanarGround : public Ground {
 public:
  PlanarGround(const Solver& solver, const Demands& demands)
      : solver_(solver), demands_(demands), cells_(solver.prepared(), demands), met_(cells_.all()) {}

  exact::Tried<bool> room(const std::optional<AssumedDemand>& assumed) override {
    return std::any_of(met_.begin(), met_.end(), [&](MetDemands met) {
      if (assumed) met[assumed->atom] = assumed->met;
      return demands_.truth(met);
    });
  }
  Conflict conflict() override { return find_conflict(demands_, met_); }
  LevelChange best(std::size_t k, int sign, Sense sense) override {
    const Objective objective{Objective::Kind::kDistance, demands_.formula().atoms()[k].distance, false, {}, {}};
    const Optimum best = exact_optimum(solver_, without(k, sign), {objective, sense});
    LevelChange out = changed(demands_, k, best, best.attained && best.proven());
    const plane::Summary summary = plane::summarize(best.at, solver_.world().step);
    if (out.kind == Kind::kTo && !summary.empty)
      out.at = distance::coordinates(
          distance::times(solver_.world().step, RealPoint(summary.components.front().sample_point)));
    return out;
  }
  CommonRelaxation together(const std::optional<Real>& enough) override {
    return common_relaxation(solver_, demands_, enough);
  }

 private:
  /// The positions that the formula has without demand k, of those where its distance minus the level has `sign`.
  plane::Region without(std::size_t k, int sign) const {
    return cells_.region([&](std::span<const Mark> signs) {
      if (sign != 0 && cells_.sign(k, signs) != sign) return false;
      MetDemands met = cells_.met(signs);
      met[k] = true;
      return demands_.truth(met);
    });
  }

  const Solver& solver_;
  const Demands& demands_;
  Cells cells_;
  std::vector<MetDemands> met_;
};

}  // namespace

std::unique_ptr<Ground> planar_ground(const Solver& solver, const Demands& demands) {
  return std::make_unique<PlanarGround>(solver, demands);
}

}  // namespace findspace::formula
