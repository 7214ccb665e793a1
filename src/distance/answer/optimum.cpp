// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/answer/optimum.h"

namespace findspace::distance {

using exact::Real;

bool OptimalValue::exists() const { return answer && answer->side != Side::kOuter; }

std::optional<Real> OptimalValue::value() const {
  if (!exists() || answer->minus_infinity) return std::nullopt;
  return answer->value;
}

std::optional<Real> OptimalValue::bound() const {
  if (proven()) return std::nullopt;
  return maximum() ? answer->enclosed->upper : answer->enclosed->lower;
}

void OptimalValue::set_exact(Real value, Way way) {
  answer.emplace();
  answer->value = std::move(value);
  answer->way = way;
}

void OptimalValue::set_enclosed(std::optional<Real> reached, std::optional<Real> bound, Way way) {
  answer.emplace();
  answer->set_unproven(reached ? Side::kInner : Side::kOuter);
  answer->way = way;
  if (reached) answer->value = *reached;
  if (reached && bound) answer->error = abs(*reached - *bound).to_double();
  answer->enclosed.emplace();
  (maximum() ? answer->enclosed->lower : answer->enclosed->upper) = std::move(reached);
  (maximum() ? answer->enclosed->upper : answer->enclosed->lower) = std::move(bound);
}

void OptimalValue::set_nearby(Real value, std::optional<Real> bound, Way way) {
  set_enclosed(std::nullopt, std::move(bound), way);
  answer->value = std::move(value);
  answer->side = Side::kNone;
}

void OptimalValue::set_found(SceneAnswer least) {
  if (least.minus_infinity) return set_lowest(least.way);
  const bool taken = least.side != Side::kNone;
  if (!least.proven) {
    const Enclosure ends = least.bounds();
    set_enclosed(ends.upper, ends.lower, least.way);
    least.value = answer->value;
    least.side = answer->side;
    least.error = answer->error;
    least.enclosed = answer->enclosed;
  }
  attained = taken;
  answer = std::move(least);
  if (attained) return;
  if (proven()) answer->side = Side::kExact;
  answer->at.clear();
}

void OptimalValue::set_lowest(Way way) {
  set_exact(Real(), way);
  answer->minus_infinity = true;
  unbounded = attained = true;
}

void OptimalValue::negate() {
  sense = opposite(sense);
  if (!answer) return;
  answer->value = -answer->value;
  if (!answer->enclosed) return;
  std::swap(answer->enclosed->lower, answer->enclosed->upper);
  for (std::optional<Real>* end : {&answer->enclosed->lower, &answer->enclosed->upper})
    if (*end) *end = -**end;
}

void OptimalValue::scale(const Real& unit) {
  if (!answer) return;
  answer = in_unit(*answer, unit, [](const Coordinates& p) { return p; });
}

}  // namespace findspace::distance
