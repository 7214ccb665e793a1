// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The value of a distance of bodies at a position, and signed distances from the place at which they are 0.
#pragma once

#include <findspace/error.h>

#include <array>
#include <optional>

#include "space/polytope/real_vector.h"

namespace findspace::distance {

struct SolidValue {
  exact::Real value;
  bool proven = true;                        // the exact number; else within 2^-38 relative
  bool lowest = false;                       // minus infinity (the value is 0 then)
  std::optional<space::RealVector> nearest;  // signed distances: the nearest position where they are 0
  /// The points of B + p and of A that take the distance, where it is one of points.
  std::optional<std::array<space::RealVector, 2>> points;
  double error = 0;  // what a value that is not proven may be off
};

/// Throws Error(kUnsupported).
[[noreturn]] inline void not_computed(const char* what) { throw Error(ErrorCode::kUnsupported, what); }

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
