// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/problem/pair_formula.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "formula/language/parse.h"
#include "formula/language/text.h"

namespace findspace::packing {
namespace {

constexpr const char* kSelf = "self";
constexpr const char* kOther = "other";
constexpr double kMostLevel = 1e15;  // below 2^53: parts in different containers are farther apart

exact::Real real(const Fraction& value) { return exact::Real(value.numerator()) / exact::Real(value.denominator()); }

}  // namespace

formula::Formula for_other(const formula::Formula& where) {
  std::vector<formula::Atom> atoms = where.atoms();
  for (formula::Atom& atom : atoms) {
    if (atom.distance.mode != formula::Mode::kToward) continue;
    for (exact::Real& c : atom.distance.vector) c = -c;
  }
  return {where.root(), std::move(atoms)};
}

std::string turned_back(const std::string& where) {
  const formula::Formula stated = parse_condition(where);
  std::vector<formula::Atom> atoms = stated.atoms();
  for (formula::Atom& atom : atoms) {
    formula::Distance& distance = atom.distance;
    if (distance.mode == formula::Mode::kPlain) continue;
    distance.vector = {distance.vector[1], -distance.vector[0]};
    distance.vector_text =
        fmt::format("({}, {})", formula::number_text(distance.vector[0]), formula::number_text(distance.vector[1]));
  }
  return formula::text(formula::Formula(stated.root(), std::move(atoms)));
}

formula::Formula parse_condition(const std::string& where, int dimension) {
  formula::Context context;
  context.dimension = dimension;
  context.shapes = {kSelf, kOther};
  context.moving = {kOther};
  formula::Formula result = formula::parse_formula(where, context);
  for (const formula::Atom& atom : result.atoms()) {
    if (atom.distance.mode == formula::Mode::kRotation)
      throw Error(ErrorCode::kUnsupported, "parts that are packed are not rotated by a condition");
    if (dimension == 2 && !atom.more.empty())
      throw Error(ErrorCode::kUnsupported, "sums of distances are not taken between parts that are packed");
    if (std::abs(atom.level.to_double()) > kMostLevel)
      throw Error(ErrorCode::kOutOfRange, "a condition of parts has a number above 1e15");
  }
  return result;
}

double greatest_level(const std::vector<PairCondition>& conditions, int dimension) {
  double greatest = 0;
  for (const PairCondition& condition : conditions) {
    const formula::Formula where = parse_condition(condition.where, dimension);
    for (const formula::Atom& atom : where.atoms()) greatest = std::max(greatest, std::abs(atom.level.to_double()));
  }
  return greatest;
}

PairFormula::PairFormula(const Problem& problem, std::size_t first, const plane::SharedRegion& a, std::size_t second,
                         const plane::SharedRegion& b, const exact::Real& step) {
  for (const PairCondition& condition : problem.conditions) {
    if (condition.first == first && condition.second == second) add(condition.where, a, b, kOther, step);
    if (condition.first == second && condition.second == first) add(condition.where, b, a, kSelf, step);
  }
}

PairFormula PairFormula::apart(const plane::SharedRegion& a, const plane::SharedRegion& b, const Fraction& distance,
                               const exact::Real& step) {
  PairFormula result;
  result.add(fmt::format("gap({}, {}) >= {}", kSelf, kOther, distance.text()), a, b, kOther, step);
  return result;
}

void PairFormula::add(const std::string& where, const plane::SharedRegion& self, const plane::SharedRegion& other,
                      const char* moving, const exact::Real& step) {
  formula::World world;
  world.shapes.emplace(kSelf, self);
  world.shapes.emplace(kOther, other);
  world.moving = {moving};
  world.step = step;
  formula::Context context;
  context.shapes = {kSelf, kOther};
  context.moving = {moving};
  const formula::Formula asked = formula::parse_formula(where, context);
  conditions_.push_back({std::make_shared<const formula::Solver>(std::move(world)),
                         moving == std::string_view(kOther) ? for_other(asked) : asked});
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
