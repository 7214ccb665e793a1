// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/order/choose.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "distance/planar_features/point_set.h"
#include "distance/planar_least/coordinate.h"
#include "exact/number/real_size.h"
#include "findspace/error.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/solve_region.h"
#include "formula/planar/sums.h"
#include "plane/query/locate.h"
#include "plane/query/moved.h"
#include "plane/query/summary.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "planning/order/near_grid.h"

namespace findspace::planning {

using distance::Sense;
using exact::Real;
using exact::RealPoint;
using formula::Goal;
using formula::Objective;
using plane::Region;

namespace {

constexpr int kGridSteps = 8, kMostDecimals = 12;
constexpr double kLongNumber = 4096;  // bits of a sign about a coordinate, from which on the grid is taken unasked
constexpr std::int64_t kLargestCoefficient = std::int64_t{1} << 40;

RealPoint opposite(const RealPoint& p) { return {-p.x, -p.y}; }

/// A form with primitive coefficients, and the factor before it.
struct ScaledForm {
  distance::LinearForm form;
  Real factor;
};

ScaledForm scaled(const std::array<Real, 3>& form) {
  // Decimals: a power of ten makes both whole.
  Real scale(1), a = form[0], b = form[1];
  for (int digits = 0; !a.integer() || !b.integer(); ++digits) {
    if (digits > kMostDecimals)
      throw Error(ErrorCode::kOutOfRange, "a linear form has a coefficient with more than 12 decimals");
    a = a * Real(10);
    b = b * Real(10);
    scale = scale * Real(10);
  }
  if (exact::abs(a) > Real(kLargestCoefficient) || exact::abs(b) > Real(kLargestCoefficient))
    throw Error(ErrorCode::kOutOfRange, "the coefficients of a linear form must be in a ratio of integers up to 2^40");
  std::int64_t p = std::int64_t(*a.integer()), q = std::int64_t(*b.integer());
  const std::int64_t factor = exact::make_primitive(p, q);
  return {{p, q}, Real(factor) / scale};
}

Region on_line_of(const Goal& condition, const Real& step, const Region& positions) {
  if (!plane::is_bounded(positions))
    throw Error(ErrorCode::kUnsupported, "a condition on coordinates needs a bounded set of positions");
  const ScaledForm f = scaled(*condition.form);
  return distance::on_line(positions, f.form, *condition.equals / (step * f.factor));
}

/// What a goal is at best over some positions, and where.
struct Best {
  std::optional<Real> value;  // none: no finite one
  bool unbounded = false, attained = false;
  Region at;
};

/// Goals over the positions of one body.
class Goals {
 public:
  Goals(const Relations& relations, std::size_t body, const Poses& poses)
      : relations_(relations), body_(body), poses_(poses) {
    roles_ = relations.problem().names;
    roles_["self"] = {body, std::nullopt};
  }

  /// Nothing: the goal says nothing about this body now.
  std::optional<Best> least(const Goal& goal, const AtAngle& at) const {
    if (goal.form) return of_form(scaled(*goal.form), at.region);
    if (goal.objective->kind == Objective::Kind::kSum) return of_sum(*goal.objective, at);
    if (goal.objective->kind != Objective::Kind::kDistance) return of_objective(goal, *goal.objective, at.region);
    Poses poses = poses_;
    poses[body_] = Pose{at.angle, {}};
    const auto found = bound(goal.objective->distance, poses);
    if (!found) return std::nullopt;
    Objective objective = *goal.objective;
    objective.distance = found->distance;
    if (!found->first || !found->second) return of_objective(goal, objective, at.region);
    return *found->first == body_ ? relative(goal, objective, at.region, poses[*found->second]->at)
                                  : relative_back(goal, objective, at.region, poses[*found->first]->at);
  }

 private:
  /// The distance as one between placed bodies and still shapes, if it depends on where this body is.
  std::optional<Relations::Bound> bound(const formula::Distance& wanted, const Poses& poses) const {
    for (const auto* names : {&wanted.first, &wanted.second}) {
      auto role = roles_.find(names->front());
      if (role != roles_.end() && !poses[role->second.body]) return std::nullopt;
    }
    Relations::Bound found = relations_.bind(wanted, roles_, poses);
    if (found.first == found.second || (found.first != body_ && found.second != body_)) return std::nullopt;
    return found;
  }

  /// The best position of a sum; distances to bodies that are placed later do not count yet.
  std::optional<Best> of_sum(const Objective& objective, const AtAngle& at) const {
    const formula::PreparedWorld& world = relations_.solver().prepared();
    Poses poses = poses_;
    poses[body_] = Pose{at.angle, {}};
    std::vector<distance::Summand> summands;
    std::vector<formula::SumTerm> terms;
    for (const formula::SumTerm& t : objective.terms) {
      const auto found = bound(t.distance, poses);
      if (!found) continue;
      terms.push_back({t.weight, found->distance});
      distance::Summand s{objective_distance(world, found->distance), t.weight};
      if (found->first && found->second) {
        s.reflected = *found->first != body_;
        const RealPoint& other = poses[s.reflected ? *found->first : *found->second]->at;
        s.by = s.reflected ? other : opposite(other);
      }
      summands.push_back(std::move(s));
    }
    if (summands.empty()) return std::nullopt;
    return best_of(distance::DistanceSum(std::move(summands)), at.region, reach_of(world, terms));
  }

  /// Of the places that a search found the one with the least value.
  Best best_of(const distance::DistanceSum& sum, const Region& region, double reach) const {
    const distance::Extremum e = best_position(sum, {region, region}, Sense::kMinimum, reach);
    Best out{std::nullopt, e.unbounded, e.exists(), Region::uniform(0)};
    std::optional<RealPoint> best;
    for (const auto& v : e.at.vertices) {
      if (v.mark <= 0) continue;
      const RealPoint p = e.at.geometry.exact(v.point);
      const auto value = sum.value(p);
      if (!value || (out.value && !(*value < *out.value))) continue;
      out.value = value;
      best = p;
    }
    if (best) out.at = distance::point_set({&*best, 1});
    if (out.value) out.value = *out.value * relations_.problem().world.step;
    return out;
  }

  Best of_form(const ScaledForm& f, const Region& region) const {
    distance::Extremum e =
        distance::linear_extremum(region, f.form, f.factor.sign() > 0 ? Sense::kMinimum : Sense::kMaximum);
    Best out{std::nullopt, e.unbounded, e.attained, std::move(e.at)};
    if (const auto value = e.value()) out.value = *value * f.factor * relations_.problem().world.step;
    return out;
  }

  Best of_objective(const Goal& goal, const Objective& objective, const Region& region) const {
    formula::Optimum o = formula::exact_optimum(relations_.solver(), region,
                                                {objective, goal.negated ? Sense::kMaximum : Sense::kMinimum});
    Best out{o.value(), o.unbounded, o.attained, std::move(o.at)};
    if (out.value && goal.negated) out.value = -*out.value;
    return out;
  }

  /// The distance depends on p - other.
  Best relative(const Goal& goal, const Objective& objective, const Region& region, const RealPoint& other) const {
    Best b = of_objective(goal, objective, plane::moved(region, opposite(other)));
    b.at = plane::moved(std::move(b.at), other);
    return b;
  }
  /// The distance depends on other - p.
  Best relative_back(const Goal& goal, const Objective& objective, const Region& region, const RealPoint& other) const {
    Best b = of_objective(goal, objective, plane::moved(plane::mirrored(region), other));
    b.at = plane::mirrored(plane::moved(std::move(b.at), opposite(other)));
    return b;
  }

  const Relations& relations_;
  std::size_t body_;
  const Poses& poses_;
  Roles roles_;
};

/// Keeps the positions with the least value of all; false where none takes it.
bool keep_least(std::vector<AtAngle>& positions, std::vector<Best> found, Chosen& out) {
  const Best* best = nullptr;
  for (const Best& o : found) {
    if (o.unbounded) {
      out.unbounded = true;
      out.values.push_back(std::nullopt);
      return false;
    }
    if (o.value && (best == nullptr || *o.value < *best->value)) best = &o;
  }
  if (best == nullptr) {
    out.values.push_back(std::nullopt);
    return true;
  }
  const Real least = *best->value;
  out.values.push_back(least);
  std::vector<AtAngle> kept;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    Best& o = found[k];
    if (o.attained && o.value && *o.value == least) kept.push_back({positions[k].angle, std::move(o.at)});
  }
  if (kept.empty()) return false;
  positions = std::move(kept);
  return true;
}

std::optional<RealPoint> lowest_leftmost(const Region& positions) {
  auto low = distance::linear_extremum(positions, distance::kY, Sense::kMinimum);
  if (!low.attained) return std::nullopt;
  auto left = distance::linear_extremum(low.at, distance::kX, Sense::kMinimum);
  if (!left.attained) return std::nullopt;
  return left.at.geometry.exact(left.at.vertices.front().point);
}

/// The nearest grid point of the set within a few steps of p that keeps the conditions; nothing where none does, or p
/// is one.
std::optional<RealPoint> near_grid(const Region& positions, const Demands& demands, const Real& step,
                                   const RealPoint& p) {
  if (p.x.integer() && p.y.integer()) return std::nullopt;
  plane::Locator locator(positions);
  const auto keeps = [&](const Goal& goal, const RealPoint& q) {
    return !goal.equals || ((*goal.form)[0] * q.x + (*goal.form)[1] * q.y) * step == *goal.equals;
  };
  const auto found = nearest_on_grid<2>({p.x, p.y}, kGridSteps, [&](const std::array<Real, 2>& at) {
    const RealPoint q{at[0], at[1]};
    return std::all_of(demands.goals.begin(), demands.goals.end(), [&](const Goal& g) { return keeps(g, q); }) &&
           locator.mark(q) > 0;
  });
  if (!found) return std::nullopt;
  return RealPoint{(*found)[0], (*found)[1]};
}

/// As near to a place in grid steps as it goes.
Goal nearest_to(const std::vector<Real>& place, const Relations& relations) {
  Goal goal;
  goal.objective.emplace();
  goal.objective->kind = Objective::Kind::kDistanceToPoint;
  for (const Real& c : place) goal.objective->point.push_back(c * relations.problem().world.step);
  return goal;
}

Pose first_of_all(const std::vector<AtAngle>& positions) {
  std::optional<Pose> best, other;
  for (const AtAngle& p : positions) {
    if (auto at = lowest_leftmost(p.region)) {
      const int order = best ? compare(at->y, best->at.y) : -1;
      if (order < 0 || (order == 0 && at->x < best->at.x)) best = Pose{p.angle, *at};
    } else if (!other) {
      other = Pose{p.angle, plane::summarize(p.region, Real(1)).components.front().sample_point};
    }
  }
  return best ? *best : *other;
}

}  // namespace

std::optional<RealPoint> representative(const Region& positions) {
  if (plane::is_empty(positions)) return std::nullopt;
  return first_of_all({{0, positions}}).at;
}

Region keeping_conditions(const Problem& problem, Region positions) {
  for (const Goal& goal : problem.goals)
    if (goal.equals) positions = on_line_of(goal, problem.world.step, positions);
  return positions;
}

Chosen choose(const Relations& relations, std::size_t body, const std::vector<AtAngle>& all, const Poses& poses,
              Pick pick) {
  std::vector<AtAngle> positions = all;
  const auto drop_empty = [&] { std::erase_if(positions, [](const AtAngle& p) { return plane::is_empty(p.region); }); };
  Chosen out;
  const Goals goals(relations, body, poses);
  for (AtAngle& p : positions)
    if (plane::is_bounded(p.region)) p.region = keeping_conditions(relations.problem(), std::move(p.region));
  drop_empty();
  bool on_grid = false;
  const Body& placed = relations.problem().bodies[body];
  if (placed.near) {
    std::vector<Best> found;
    for (const AtAngle& p : positions) found.push_back(*goals.least(nearest_to(*placed.near, relations), p));
    keep_least(positions, std::move(found), out);  // of a closure it goes to a position beside the nearest one
    out.values.clear();
    on_grid = true;
  }
  for (const Goal& goal : relations.problem().goals) {
    if (positions.empty()) return out;
    if (goal.grid) {
      on_grid = true;
      continue;
    }
    if (goal.equals) {  // of an unbounded set in its turn, where it may be bounded
      for (AtAngle& p : positions) p.region = on_line_of(goal, relations.problem().world.step, p.region);
      drop_empty();
      if (out.attained) out.values.push_back(std::nullopt);
      continue;
    }
    if (!out.attained) continue;
    std::vector<Best> found;
    for (const AtAngle& p : positions) {
      if (auto o = goals.least(goal, p)) found.push_back(std::move(*o));
    }
    if (found.size() < positions.size()) {
      out.values.push_back(std::nullopt);
    } else if (!keep_least(positions, std::move(found), out)) {
      out.attained = false;
      if (pick == Pick::kBest) return out;
    }
  }
  if (positions.empty()) return out;
  out.pose = first_of_all(positions);
  const bool is_long =
      !on_grid && std::max(exact::sign_bits(out.pose->at.x), exact::sign_bits(out.pose->at.y)) > kLongNumber;
  if (on_grid || is_long) {
    const auto& whole =
        *std::find_if(all.begin(), all.end(), [&](const AtAngle& p) { return p.angle == out.pose->angle; });
    const Problem& problem = relations.problem();
    if (auto at = near_grid(whole.region, problem, problem.world.step, out.pose->at)) {
      out.pose->at = *std::move(at);
      out.shortened = is_long;
    }
  }
  return out;
}

}  // namespace findspace::planning
