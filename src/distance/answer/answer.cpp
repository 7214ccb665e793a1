// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/answer/answer.h"

#include <cmath>

#include "exact/margins/formula.h"
#include "exact/number/real_text.h"
#include "space/polytope/real_vector.h"

namespace findspace::distance {

double rounding_of(const exact::Real& value) { return margin::kSideOfLevel * std::fabs(value.to_double()); }

OutwardEnds outward(const Enclosure& ends) {
  const auto below = [](const exact::Real& v) {
    const double d = v.to_double();
    return exact::Real::from_double(d) > v ? std::nextafter(d, -exact::kInfinity) : d;
  };
  return {ends.lower ? below(*ends.lower) : -exact::kInfinity, ends.upper ? -below(-*ends.upper) : exact::kInfinity};
}

std::optional<std::string> closed_form(const SceneAnswer& a) {
  if (!a.proven || a.minus_infinity || !a.value.is_closed()) return std::nullopt;
  return exact::RealWriter().text(a.value);
}

void exchange_roles(Answer& answer, const SpacePosition& p) {
  if (answer.witness.empty()) return;
  answer.witness = point_pair(space::plus(answer.witness[1].at, p), space::plus(answer.witness[0].at, p));
}

Answer signed_value(const SpacePosition& p, const SpacePosition& q, int sign) {
  const space::RealVector w = space::minus(q, p);
  const exact::Real d = sqrt(space::dot(w, w));
  Answer out;
  out.value = sign < 0 ? -d : d;
  if (d.sign() != 0) out.nearest = q;
  return out;
}

}  // namespace findspace::distance
