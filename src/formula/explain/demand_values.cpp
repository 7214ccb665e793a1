// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/explain/demand_values.h"

#include "findspace/error.h"
#include "formula/language/text.h"

namespace findspace::formula {

using distance::Answer;
using exact::Interval;
using exact::Real;

namespace {

Interval span_of(const std::optional<Answer>& v) {
  if (!v) return {exact::kInfinity, exact::kInfinity};
  if (v->minus_infinity) return {-exact::kInfinity, -exact::kInfinity};
  const distance::OutwardEnds ends = distance::outward(v->bounds());
  return {ends.lower, ends.upper};
}

/// Nothing where the bounds do not tell.
std::optional<std::int8_t> sign_at(const std::optional<Answer>& v, const Real& level) {
  if (!v) return 1;
  if (v->minus_infinity) return -1;
  if (v->proven) return static_cast<std::int8_t>(compare(v->value, level));
  const distance::Enclosure ends = v->bounds();
  if (ends.lower && *ends.lower > level) return 1;
  if (ends.upper && *ends.upper < level) return -1;
  return std::nullopt;
}

Interval size_of(const Interval& a) { return a.lo >= 0 ? a : a.hi <= 0 ? -a : Interval{0, std::max(-a.lo, a.hi)}; }

Interval slack_of(Relation relation, const Interval& beyond) {
  switch (relation) {
    case Relation::kLess:
    case Relation::kLessEqual:
      return -beyond;
    case Relation::kGreater:
    case Relation::kGreaterEqual:
      return beyond;
    case Relation::kEqual:
      return -size_of(beyond);
    case Relation::kNotEqual:
      break;
  }
  return size_of(beyond);
}

}  // namespace

DemandValues::DemandValues(const SpaceSolver& solver, const Demands& demands) : solver_(solver), demands_(demands) {
  for (const Atom& atom : demands.formula().atoms()) {
    if (atom.minimum || atom.distance.mode != Mode::kPlain || atom.distance.prefix != Extremum::kNone)
      throw Error(ErrorCode::kUnsupported, "in space an explanation of '" + written(atom) + "' is not computed");
    levels_.push_back(atom.level / solver.world().step);
  }
}

DemandsAt DemandValues::at(const space::RealVector& p) const {
  DemandsAt out;
  const auto& atoms = demands_.formula().atoms();
  std::vector<std::optional<Answer>> values;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    std::size_t same = 0;
    while (!(atoms[same].distance == atoms[k].distance)) ++same;
    values.push_back(same < k ? values[same] : value(k, p));
    out.distance.push_back(span_of(values[k]));
    out.slack.push_back(slack_of(demands_.relation(k), out.distance[k] - levels_[k].interval()));
    const auto sign = sign_at(values[k], levels_[k]);
    out.met.push_back(sign && demands_.holds(k, *sign));
  }
  return out;
}

std::optional<Answer> DemandValues::value(std::size_t k, const space::RealVector& p) const {
  return solver_.value(demands_.formula().atoms()[k].distance, p);
}

}  // namespace findspace::formula
