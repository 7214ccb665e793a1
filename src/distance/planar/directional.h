// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances when B may move along a direction u only (distances.md 7.1), both ways (`along=`) or one way (`toward=`, t
// >= 0): with the sections O_p = {t : p + tu in O}, C_p = {t : p + tu in C} of the plane sets O and C of the signed
// distance (or C alone)
//   gamma1, eta1, delta1: f(p) = -inf {|t| : t not in O_p} for p in O, 0 for p in C \ O, inf {|t| : t in C_p} else;
//   gamma2, eta2, delta2: f(p) = sup {|t| : t in C_p};
// +infinity where C_p is empty, -infinity where O_p holds all t. These functions jump: their regions may be neither
// open nor closed. Guarantee: values and sign maps are exact. Cost: a value: one section of the base map; a sign map:
// one sweep of it (gamma2, eta2, delta2: three). Source: partial Minkowski operations, distances.md 7.1. Keywords:
// directional distance, directional penetration depth, partial Minkowski sum.
#pragma once

#include "distance/planar_features/t_distance.h"
#include "plane/build/swept.h"
#include "plane/query/section.h"

namespace findspace::distance {

/// A direction, as a primitive integer vector, and whether t may be negative.
struct TranslationDirection {
  std::int64_t dx = 1, dy = 0;
  bool both_ways = true;
};

/// From the sign map at level 0 of gamma1, eta1 or delta1 (- on O, 0 on C \ O).
class DirectionalSigned : public PositionFunction {
 public:
  DirectionalSigned(plane::SignMap base, const TranslationDirection& direction);

  bool defined() const override { return defined_; }
  plane::SignMap sign_map(const exact::Real& level) const override;
  std::optional<PlanarAnswer> value(const exact::RealPoint& p) const override;

 private:
  plane::SignMap base_;
  TranslationDirection direction_;
  bool defined_;
};

/// gamma2, eta2 or delta2 from the same maps: C is where they are not +.
class DirectionalFarthest : public PositionFunction {
 public:
  DirectionalFarthest(plane::SignMap base, const TranslationDirection& direction);

  bool defined() const override { return defined_; }
  plane::SignMap sign_map(const exact::Real& level) const override;
  std::optional<PlanarAnswer> value(const exact::RealPoint& p) const override;
  /// Maps of which sign_map() is the greatest: - where C is met nearer than the level, 0 where at it; then for each way
  /// + where it is met farther off, 0 where at the level. The level is not negative.
  std::vector<plane::SignMap> parts(const exact::Real& level) const;

 private:
  plane::SignMap near_map(const exact::Real& level) const;
  plane::SignMap far_map(const exact::Real& level, bool forward) const;

  plane::SignMap base_;
  TranslationDirection direction_;
  bool defined_;
};

}  // namespace findspace::distance
