// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/explain/demand_values.h"

#include <algorithm>

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

/// Infinite ends that are meant stay.
Interval beyond_of(const Interval& distance, const Interval& level) {
  if (distance.lo == exact::kInfinity || distance.hi == -exact::kInfinity) return distance;
  return distance - level;
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
    near_levels_.push_back(levels_.back().interval());
  }
  const auto& atoms = demands.formula().atoms();
  std::vector<const Distance*> seen;
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    std::size_t same = 0;
    while (same < seen.size() && !(*seen[same] == atoms[k].distance)) ++same;
    if (same == seen.size()) {
      seen.push_back(&atoms[k].distance);
      asked_.push_back({solver.quick_distance(atoms[k].distance), {}});
    }
    asked_[same].demands.push_back(k);
  }
  std::stable_partition(asked_.begin(), asked_.end(), [](const Asked& a) { return !a.distance.large; });
}

void DemandValues::set(DemandsAt& here, std::size_t k, const Interval& distance) const {
  const Interval beyond = beyond_of(distance, near_levels_[k]);
  here.distance[k] = distance;
  here.slack[k] = slack_of(demands_.relation(k), beyond);
  const int sign = exact::certain_sign(beyond);
  here.met[k] = sign != 0 && demands_.holds(k, static_cast<std::int8_t>(sign));
}

DemandsAt DemandValues::within(const space::Vector& p, const std::function<bool(const DemandsAt&)>& enough) const {
  const std::size_t count = levels_.size();
  DemandsAt here{std::vector(count, exact::whole_line()), std::vector(count, exact::whole_line()),
                 MetDemands(count, false), true};
  bool open = false;
  for (const Asked& asked : asked_) {
    const Interval distance = asked.distance.within(p);
    for (const std::size_t k : asked.demands) {
      set(here, k, distance);
      open = open || (distance.lo < exact::kInfinity && !(here.slack[k].hi < exact::kInfinity));
    }
    if (enough(here)) return here;
  }
  here.open = open;
  return here;
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
    out.slack.push_back(slack_of(demands_.relation(k), beyond_of(out.distance[k], near_levels_[k])));
    const auto sign = sign_at(values[k], levels_[k]);
    out.met.push_back(sign && demands_.holds(k, *sign));
  }
  return out;
}

std::optional<Answer> DemandValues::value(std::size_t k, const space::RealVector& p) const {
  return solver_.value(demands_.formula().atoms()[k].distance, p);
}

}  // namespace findspace::formula
