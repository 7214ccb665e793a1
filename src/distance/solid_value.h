// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values of signed distances from the place at which they are 0. Internal to solid_pair.
#pragma once

#include "distance/solid_pair.h"

namespace findspace::distance {

/// A signed distance whose zero set is nearest at q.
inline SolidValue signed_value(const space::RealVector& p, const space::RealVector& q, int sign) {
  const space::RealVector w = space::minus(q, p);
  const exact::Real d = sqrt(space::dot(w, w));
  SolidValue out;
  out.value = sign < 0 ? -d : d;
  if (d.sign() != 0) out.nearest = q;
  return out;
}

/// max(0, v), or max(0, -v) if `negated`; nothing stands for +infinity.
inline std::optional<SolidValue> cut_off(std::optional<SolidValue> v, bool negated) {
  if (!v) return negated ? std::optional<SolidValue>(SolidValue{}) : std::nullopt;
  if (v->lowest) return negated ? std::nullopt : std::optional<SolidValue>(SolidValue{});
  if (negated) v->value = -v->value;
  if (v->value.sign() < 0) v->value = exact::Real();
  return v;
}

}  // namespace findspace::distance
