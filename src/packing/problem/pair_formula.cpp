// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/problem/pair_formula.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>

#include "formula/language/parse.h"
#include "plane/complex/primitives.h"
#include "plane/contour/decimal_grid.h"

namespace findspace::packing {
namespace {

constexpr const char* kSelf = "self";
constexpr const char* kOther = "other";

exact::Real real(const Fraction& value) { return exact::Real(value.numerator()) / exact::Real(value.denominator()); }

std::int64_t on_grid(int128 c) {
  if (c < -plane::Grid::kLimit || c > plane::Grid::kLimit)
    throw Error(ErrorCode::kOutOfRange, "a part has too many digits for conditions of pairs");
  return std::int64_t(c);
}

}  // namespace

formula::Formula parse_condition(const std::string& where) {
  formula::Context context;
  context.shapes = {kSelf, kOther};
  context.moving = {kOther};
  return formula::parse_formula(where, context);
}

double greatest_level(const Problem& problem) {
  double greatest = 0;
  for (const PairCondition& condition : problem.conditions) {
    const formula::Formula where = parse_condition(condition.where);
    for (const formula::Atom& atom : where.atoms()) greatest = std::max(greatest, std::abs(atom.level.to_double()));
  }
  return greatest;
}

plane::Region region_of(const Polygon& shape) {
  std::vector<plane::Contour> contours;
  for (const Ring& ring : shape.rings) {
    plane::Contour& contour = contours.emplace_back();
    for (const LatticePoint& p : ring) contour.push_back({.start = {on_grid(p.x), on_grid(p.y)}});
  }
  return plane::region_of_rings(contours);
}

PairFormula::PairFormula(const Problem& problem, std::size_t first, const plane::Region& a, std::size_t second,
                         const plane::Region& b, const exact::Real& step) {
  const auto add = [&](const PairCondition& condition, const plane::Region& self, const plane::Region& other,
                       const char* moving) {
    formula::World world;
    world.shapes.emplace(kSelf, self);
    world.shapes.emplace(kOther, other);
    world.moving = {moving};
    world.step = step;
    formula::Context context;
    context.shapes = {kSelf, kOther};
    context.moving = {moving};
    conditions_.push_back(
        {std::make_shared<const formula::Solver>(std::move(world)), formula::parse_formula(condition.where, context)});
  };
  for (const PairCondition& condition : problem.conditions) {
    if (condition.first == first && condition.second == second) add(condition, a, b, kOther);
    if (condition.first == second && condition.second == first) add(condition, b, a, kSelf);
  }
}

bool PairFormula::holds(const Fraction& x, const Fraction& y) const {
  const exact::RealPoint at{real(x), real(y)};
  return std::all_of(conditions_.begin(), conditions_.end(),
                     [&](const Condition& c) { return c.solver->holds(c.where, at); });
}

std::vector<plane::Region> PairFormula::regions() const {
  std::vector<plane::Region> result;
  for (const Condition& c : conditions_) result.push_back(c.solver->feasible(c.where));
  return result;
}

}  // namespace findspace::packing
