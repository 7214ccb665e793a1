// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/solve_region.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "distance/planar/farthest.h"
#include "distance/planar_least/coordinate.h"
#include "distance/planar_least/level_extremum.h"
#include "findspace/error.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/least_values.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/regions.h"
#include "formula/planar/rotation_values.h"
#include "formula/planar/sums.h"
#include "plane/base/real_vector.h"
#include "plane/build/path_region.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/query/locate.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using distance::Sense;
using exact::Real;
using exact::Refusal;
using plane::operator+;
using plane::operator-;

namespace {

/// Whether no position belongs to the outer set alone.
bool same_sets(const RegionBounds& bounds) {
  const std::array<const plane::Region*, 2> both{&bounds.outer, &bounds.inner};
  return plane::is_empty(plane::subtract(both));
}

/// Why a formula without sums has no exact region, if it has none.
std::optional<Refusal> not_exact(const Solver& solver, const Formula& formula) {
  if (has_sums(formula) || !solver.known_between_bounds(formula)) return std::nullopt;
  if (auto why = between_bounds(solver.prepared(), formula)) return why;
  return Refusal("where a distance of shapes that rotate is least is known between bounds only");
}

}  // namespace

SolvedRegion solve_region(const Solver& solver, const Formula& formula) {
  if (!solver.known_between_bounds(formula)) return {feasible_near(solver, formula)};
  const bool compared = has_sums(formula);
  RegionBounds bounds = solver.feasible_bounds(formula);
  if (compared && same_sets(bounds)) return {std::move(bounds.inner)};
  return {std::move(bounds.inner), std::move(bounds.outer), compared};
}

SolvedRegion solve_region(std::shared_ptr<const Solver> solver, const Formula& formula) {
  if (solver->known_between_bounds(formula) || is_solved_near(*solver, formula)) return solve_region(*solver, formula);
  if (auto levels = region_by_levels(solver->prepared(), formula)) return {*std::move(levels)};
  std::vector<plane::SignMap> maps = sign_maps(solver->prepared(), formula);
  solver.reset();
  return {region_of(formula, std::move(maps))};
}

exact::Tried<plane::Region> exact_region(const Solver& solver, const Formula& formula) {
  if (auto why = not_exact(solver, formula)) return *std::move(why);
  SolvedRegion found = solve_region(solver, formula);
  if (!found.outer) return std::move(found.region);
  return Refusal(
      "distances are compared along a curve that is neither a line with a direction in integers nor a circle: the "
      "region is known between two sets only");
}

namespace {

constexpr double kUsualReach = 0x1p36;  // no sign: in steps, how far a line goes at least

double reach_of(const plane::Region& region) {
  const auto box = plane::extent(region);
  return box ? std::max({-box->x0, box->x1, -box->y0, box->y1}) : 0;
}

double reach_of(const exact::RealPoint& p) { return std::max(std::abs(p.x.to_double()), std::abs(p.y.to_double())); }

/// Of a distance, over all positions: its shapes with their motion, and the point about which they rotate.
double reach_of(const Distance& d, const PreparedWorld& world) {
  const SumTerm term{Real(1), d};
  double out = reach_of(world, {&term, 1});
  for (const auto& [name, moved] : world.motion().of)
    for (const exact::RealPoint& p : moved.path) out += 2 * reach_of(p);
  if (d.mode == Mode::kRotation) out += 2 * reach_of(world.steps({d.vector.at(0), d.vector.at(1)}));
  return out;
}

}  // namespace

PlanarLine reaching(PlanarLine line, const SolvedRegion& region) {
  line.reach = std::max(line.reach, reach_of(region.region));
  if (region.outer) line.reach = std::max(line.reach, reach_of(*region.outer));
  return line;
}

PlanarLine reaching(PlanarLine line, const SolvedRegion& region, const Objective& objective, const Solver& solver) {
  const PreparedWorld& world = solver.prepared();
  if (objective.kind == Objective::Kind::kDistanceToPoint)
    line.reach = std::max(line.reach, reach_of(world.steps({objective.point.at(0), objective.point.at(1)})));
  for (const Distance& d : distances_of(objective)) line.reach = std::max(line.reach, reach_of(d, world));
  return reaching(line, region);
}

std::array<exact::RealPoint, 2> ends_of(const PlanarLine& line) {
  const auto size = [](const std::array<std::int64_t, 2>& v) {
    return double(std::max({std::abs(v[0]), std::abs(v[1]), std::int64_t(1)}));
  };
  // Twice the sum is more than the length of any way from where the line goes through to a place within reach.
  const double far = std::max(kUsualReach, 2 * (line.reach + size(line.through)));
  const Real times = Real::from_double(std::ceil(far / size(line.direction)) + 1);  // within_line looks one step back
  const auto end = [&](const Real& way) {
    return exact::RealPoint{Real(line.through[0]) + way * Real(line.direction[0]),
                            Real(line.through[1]) + way * Real(line.direction[1])};
  };
  return {end(-times), end(times)};
}

plane::Region on_line(const plane::Region& region, const PlanarLine& line) {
  const auto [first, last] = ends_of(line);
  const plane::PathPiece piece{first, last, {Real(line.direction[0]), Real(line.direction[1])}};
  const plane::Region positions = plane::region_of_pieces({&piece, 1});
  const std::array<const plane::Region*, 2> both{&region, &positions};
  return plane::intersect(both);
}

SolvedRegion on_line(const SolvedRegion& region, const PlanarLine& line) {
  SolvedRegion out{on_line(region.region, line), std::nullopt, region.compared};
  if (region.outer) out.outer = on_line(*region.outer, line);
  return out;
}

namespace {

/// In the scene's unit; `unit`: that of the values.
Optimum in_scene(distance::Extremum e, const Real& step, bool negated, const Real& unit) {
  if (!e.exists()) e.at = plane::CellComplex::uniform(0);
  e.scale(unit);
  e.within *= step.to_double();
  if (negated) e.negate();
  return e;
}
Optimum in_scene(distance::Extremum e, const Real& step, bool negated = false) {
  return in_scene(std::move(e), step, negated, step);
}

Real unit_of(const Distance& d, const Solver& solver) {
  return d.mode == Mode::kRotation ? Real(1) : solver.world().step;
}

/// The best of the certain positions, and no better than the best of the possible ones.
Optimum between(Optimum certain, const Optimum& possible) {
  const auto value = certain.value(), best = possible.value();
  const bool exact = value && best && certain.proven() && possible.proven() && compare(*value, *best) == 0;
  const bool empty = !best && !possible.unbounded;
  if (exact || empty || certain.unbounded) return certain;
  certain.attained = certain.attained && value.has_value();
  certain.within = exact::kInfinity;
  certain.set_enclosed(value, possible.proven() ? best : possible.bound(), distance::Way::kSearch);
  return certain;
}

bool has(const plane::Region& set, const exact::RealPoint& p) { return mark_of(set, plane::locate(set, p)) > 0; }

/// Whether a set reaches an end of the line, beyond which there are more positions.
bool goes_on(const plane::Region& set, const BestQuery& query) {
  if (!query.line) return false;
  const auto ends = ends_of(*query.line);
  return std::any_of(ends.begin(), ends.end(), [&](const exact::RealPoint& p) { return has(set, p); });
}

/// Whether there may be a best position at an end of the line, as near as it is known where they are.
bool may_go_on(const distance::Extremum& best, const BestQuery& query) {
  if (!query.line) return false;
  const auto ends = ends_of(*query.line);
  return std::any_of(best.at.vertices.begin(), best.at.vertices.end(), [&](const auto& v) {
    const exact::RealPoint at = best.at.geometry.exact(v.point);
    return std::any_of(ends.begin(), ends.end(), [&](const exact::RealPoint& end) {
      return std::hypot((end.x - at.x).to_double(), (end.y - at.y).to_double()) <= best.within;
    });
  });
}

/// The sum is finite, or infinite everywhere.
Optimum best_sum(const distance::PositionBounds& over, const BestQuery& query, const Solver& solver) {
  const PreparedWorld& world = solver.prepared();
  const std::vector<SumTerm>& terms = query.objective.terms;
  const auto best = best_position(distance_sum(world, terms), over, query.sense, reach_of(world, terms));
  if (best.value() && goes_on(over.possible, query) && may_go_on(best, query)) distance::refuse_without_end();
  return in_scene(best, world.step());
}

/// The values are known between bounds only (rotation_values.h).
Optimum best_of_bounded(const distance::PositionBounds& over, const BestQuery& query, const Solver& solver) {
  const Objective& objective = query.objective;
  const Sense sense = objective.negated ? opposite(query.sense) : query.sense;
  return in_scene(best_position(solver.prepared(), objective.distance, over, sense, goes_on(over.possible, query)),
                  solver.world().step, objective.negated, unit_of(objective.distance, solver));
}

Optimum best_distance(const plane::Region& region, const Objective& objective, Sense sense, const Solver& solver) {
  const Real& step = solver.world().step;
  const Sense of_distance = objective.negated ? opposite(sense) : sense;
  if (solver.world().motion.given() || objective.distance.mode != Mode::kPlain) {
    const bool continuous = objective.distance.mode == Mode::kPlain;
    return in_scene(
        level_extremum(*position_function(solver.prepared(), objective.distance), region, of_distance, continuous),
        step, objective.negated);
  }
  return in_scene(extremum(*objective_distance(solver.prepared(), objective.distance), region, of_distance), step,
                  objective.negated);
}

/// Of one set, by exact maps.
Optimum best_in(const plane::Region& region, const Objective& objective, Sense sense, const Solver& solver) {
  const Real& step = solver.world().step;
  switch (objective.kind) {
    case Objective::Kind::kX:
      return in_scene(linear_extremum(region, distance::kX, sense), step);
    case Objective::Kind::kY:
      return in_scene(linear_extremum(region, distance::kY, sense), step);
    case Objective::Kind::kZ:
      throw Error(ErrorCode::kUnsupported, "the objective z needs a scene in three dimensions");
    case Objective::Kind::kDistanceToPoint: {
      auto f = distance::Farthest::from_point({objective.point.at(0) / step, objective.point.at(1) / step});
      return in_scene(extremum(f, region, sense), step);
    }
    case Objective::Kind::kSum:  // optimize() has asked for it
    case Objective::Kind::kDistance:
      break;
  }
  return best_distance(region, objective, sense, solver);
}

/// A best value at an end of the line is none, as it goes on, unless all positions up to the end have it.
Optimum within_line(Optimum best, const PlanarLine& line) {
  const exact::RealPoint step{Real(line.direction[0]), Real(line.direction[1])};
  const auto [first, last] = ends_of(line);
  for (const auto& [end, before] : {std::pair(first, first + step), std::pair(last, last - step)}) {
    if (!best.value() || !has(best.at, end) || has(best.at, before)) continue;
    best = distance::no_optimum<plane::Region>(best.sense, true);
    best.at = plane::Region::uniform(0);
  }
  return best;
}

/// `outer`: null where the region is exact.
Optimum best_over(const Solver& solver, const plane::Region& region, const plane::Region* outer,
                  const BestQuery& query) {
  const Objective& objective = query.objective;
  const distance::PositionBounds over{region, outer != nullptr ? *outer : region};
  if (objective.kind == Objective::Kind::kSum) return best_sum(over, query, solver);
  if (objective.kind == Objective::Kind::kDistance && is_bounded(solver.prepared(), objective.distance))
    return best_of_bounded(over, query, solver);
  const auto best = [&](const plane::Region& set) {
    Optimum found = best_in(set, objective, query.sense, solver);
    return query.line ? within_line(std::move(found), *query.line) : found;
  };
  return outer != nullptr ? between(best(region), best(*outer)) : best(region);
}

}  // namespace

Optimum optimize(const Solver& solver, const SolvedRegion& region, const BestQuery& query) {
  return best_over(solver, region.region, region.outer ? &*region.outer : nullptr, query);
}

Optimum exact_optimum(const Solver& solver, const plane::Region& region, const BestQuery& query) {
  if (query.objective.kind == Objective::Kind::kDistance)
    if (const auto why = between_bounds(solver.prepared(), query.objective.distance)) throw why->error;
  return best_over(solver, region, nullptr, query);
}

std::optional<Optimum> minimum_of(const Formula& formula, const Solver& solver) {
  for (const SignMap& m : formula.sign_maps())
    if (m.minimum)
      return in_scene(least(solver.prepared(), m.distance), solver.world().step, false, unit_of(m.distance, solver));
  return std::nullopt;
}

}  // namespace findspace::formula
