// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The nearest feasible position, where the region is made of boxes or is one convex set, or contacts decide
// (nearest_contact.h). Exact where that says so.
#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "findspace/error.h"
#include "formula/language/nearest_contact.h"
#include "formula/solid/optimize_convex.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

using distance::Coordinates;
using exact::Real;
using space::RealVector;

namespace {

/// Of a directed distance of a large mesh, as far as it is quickly known, all in grid steps.
bool surely_more(const SpaceSolver& solver, const Distance& d, const Real& level, const RealVector& p) {
  if (d.kind == Kind::kHausdorff) {
    Distance forth = d;
    forth.kind = Kind::kMu;
    Distance back = forth;
    std::swap(back.first, back.second);
    return surely_more(solver, forth, level, p) || surely_more(solver, back, level, p);
  }
  if (d.kind != Kind::kMu && d.kind != Kind::kH) return false;
  const SpaceSolver::QuickDistance quick = solver.quick_distance(d);
  if (!quick.large) return false;
  const double least = quick.within(space::rounded(p)).lo;
  return std::isfinite(least) && Real::from_double(least) > level;
}

std::optional<NearestFeasible> from_contacts(const SpaceSolver& solver, const Formula& formula, const RealVector& p) {
  const Real& step = solver.world().step;
  // Each is asked for more than once.
  struct Known {
    Distance of;
    Coordinates at;
    exact::Tried<std::optional<distance::Answer>> value;
  };
  std::deque<Known> known;
  const auto value = [&](const Distance& d, const Coordinates& q) {
    const auto same = [&](const Known& k) { return k.at == q && k.of == d; };
    const auto found = std::find_if(known.begin(), known.end(), same);
    if (found != known.end()) return found->value;
    known.push_back({d, q, solver.try_value(d, space::scaled(Real(1) / step, {q[0], q[1], q[2]}))});
    return known.back().value;
  };
  const ContactWorld asked{
      [&](const Distance& d, const Coordinates& q) -> std::optional<distance::SceneAnswer> {
        const auto v = value(d, q);
        return v && *v ? std::optional(distance::in_scene(**v, step)) : std::nullopt;
      },
      [&](std::size_t atom, const Coordinates& q) -> std::optional<int> {
        const Atom& a = formula.atoms()[atom];
        if (a.minimum || !a.more.empty()) return std::nullopt;
        const auto v = value(a.distance, q);
        if (!v) return std::nullopt;
        if (!*v) return 1;
        if ((*v)->minus_infinity) return -1;
        const distance::Enclosure e = (*v)->bounds();
        const Real level = a.level / step;
        if (e.lower && *e.lower > level) return 1;
        if (e.upper && *e.upper < level) return -1;
        return (*v)->proven ? std::optional(0) : std::nullopt;
      },
      [&](const Distance& d, const Real& level, const Coordinates& q) -> std::optional<Coordinates> {
        const Real per = Real(1) / step;
        const auto at = solver.nearest_apart(d, level * per, space::scaled(per, {q[0], q[1], q[2]}));
        return at ? std::optional(distance::coordinates(space::scaled(step, *at))) : std::nullopt;
      },
      [&](const Distance& d, const Real& level, const Coordinates& q) {
        return surely_more(solver, d, level / step, space::scaled(Real(1) / step, {q[0], q[1], q[2]}));
      }};
  return nearest_by_contact(asked, formula, distance::coordinates(p));
}

/// With `gap` in place of `distance` and `depth` at levels above 0: there they say the same, and contacts tell more.
Formula by_gaps(const Formula& formula) {
  std::vector<Atom> atoms = formula.atoms();
  for (Atom& a : atoms) {
    const bool depth = a.distance.kind == Kind::kPenetration;
    if (a.minimum || !a.more.empty() || a.level.sign() <= 0 || (!depth && a.distance.kind != Kind::kD1)) continue;
    a.distance.kind = Kind::kGamma1;
    if (!depth) continue;
    a.level = -a.level;
    a.relation = mirrored(a.relation);
  }
  return Formula(formula.root(), std::move(atoms));
}

}  // namespace

TriedNearest nearest_feasible(const SpaceSolver& solver, const Formula& asked, const RealVector& p) {
  const Formula formula = by_gaps(asked);
  const exact::Refusal not_computed(
      "the region is neither made of boxes nor a convex polytope, and the contacts near the position do not decide");
  const exact::Real& step = solver.world().step;
  Objective to_p;
  to_p.kind = Objective::Kind::kDistanceToPoint;
  to_p.point = {p[0], p[1], p[2]};
  if (const auto boxes = solver.try_feasible(formula)) {
    const auto best = optimize(*boxes, step, to_p, distance::Sense::kMinimum);
    if (!best.exists()) return std::optional<NearestFeasible>();
    const space::IntervalBox at = best.at.boxes().at(0);  // a point
    return std::optional(
        NearestFeasible{distance::coordinates(space::scaled(step, {*at[0].from, *at[1].from, *at[2].from})),
                        *best.value(), best.attained});
  }
  if (const auto convex = solver.feasible_convex(formula); convex && *convex) {
    const SpaceSolver::ConvexMap& map = **convex;
    if (const auto best = optimize(map.set, map.step, to_p, distance::Sense::kMinimum)) {
      if (!best->exists()) return std::optional<NearestFeasible>();
      return std::optional(
          NearestFeasible{distance::coordinates(space::scaled(map.step, best->at.region.vertices().front().at)),
                          *best->value(), best->attained});
    }
  }
  if (auto near = from_contacts(solver, formula, p)) return near;
  return not_computed;
}

}  // namespace findspace::formula
