// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The answer to a question about a distance of solids: its value at a position, or its least value over positions. One
// type from the searches to the formulas: the value, whether it is exact, what encloses it, who takes it, and which way
// found it. Lengths in the steps of the asker.
#pragma once

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "distance/search/way.h"
#include "exact/number/margins.h"
#include "space/polytope/real_vector.h"

namespace findspace::distance {

struct Answer {
  exact::Real value;
  bool proven = true;                        // the exact number; else within 2^-38 relative, or within `error`
  bool lowest = false;                       // minus infinity (the value is 0 then)
  std::optional<space::RealVector> nearest;  // signed distances: the nearest position where they are 0
  /// The points of B + p and of A that take the distance, where it is one of points.
  std::optional<std::array<space::RealVector, 2>> points;
  double error = 0;  // what a value that is not proven may be off
  Way way = Way::kParts;
  /// Of a least value: a position that takes it, and what no position has less than.
  space::RealVector at{};
  exact::Real bound{};
  bool least = false;

  /// What the value at a position may be off, with room for its rounding; 0 where it is proven.
  double slack() const { return proven ? 0 : std::max(margin::kSideOfLevel * std::fabs(value.to_double()), error); }
  /// The true value lies between these two; they are the value where that is proven.
  exact::Real lower() const { return least ? bound : value - exact::Real::from_double(slack()); }
  exact::Real upper() const { return least ? value : value + exact::Real::from_double(slack()); }
};

/// Says that a value is not computed, and why.
[[noreturn]] inline void not_computed(const char* what) { throw Error(ErrorCode::kUnsupported, what); }

/// A least value that is taken at `at`.
inline Answer least_answer(exact::Real value, exact::Real bound, bool proven, space::RealVector at) {
  Answer out;
  out.value = std::move(value);
  out.bound = std::move(bound);
  out.proven = proven;
  out.at = std::move(at);
  out.least = true;
  if (!proven) out.way = Way::kSearch;
  return out;
}

/// A signed distance whose zero set is nearest at q.
inline Answer signed_value(const space::RealVector& p, const space::RealVector& q, int sign) {
  const space::RealVector w = space::minus(q, p);
  const exact::Real d = sqrt(space::dot(w, w));
  Answer out;
  out.value = sign < 0 ? -d : d;
  if (d.sign() != 0) out.nearest = q;
  return out;
}

/// max(0, v), or max(0, -v) if `negated`; nothing stands for +infinity.
inline std::optional<Answer> cut_off(std::optional<Answer> v, bool negated) {
  if (!v) return negated ? std::optional<Answer>(Answer{}) : std::nullopt;
  if (v->lowest) return negated ? std::nullopt : std::optional<Answer>(Answer{});
  if (negated) v->value = -v->value;
  if (v->value.sign() < 0) v->value = exact::Real();
  return v;
}

}  // namespace findspace::distance
