// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The gap of shapes that turn, between bounds that change no faster than the shapes do. Below 0 gamma1 jumps, as places
// where B is free come and go. The least signed distance v of a point of B to A does not. It is gamma1 where that
// is not negative; elsewhere it is negative, but no less. Of two convex shapes gamma1 itself changes no faster.
// Guarantee: the bounds hold for all pairs whose points are off by at most `off` from those of the pair. Cost: a sign
// map or value of gamma1, or of B and what lies deep in A. Source: distances.md 2.3, 3.3, 3.7. Keywords:
// penetration depth, Lipschitz bound.
#pragma once

#include "distance/planar/shape_pair.h"
#include "distance/planar_least/best_position.h"

namespace findspace::distance {

/// A bounded regular set that contains every segment between two of its points. Exact.
bool is_convex(const plane::Region& r);

class RatedGap {
 public:
  /// `convex`: both shapes are, before their vertices were rounded. The pair must outlive this.
  RatedGap(const ShapePair& pair, bool convex) : pair_(pair), convex_(convex) {}

  /// The signs of a function that is at most gamma1 - level; of one that is at least that.
  plane::SignMap lower(const exact::Real& level, const exact::Real& off) const;
  plane::SignMap upper(const exact::Real& level, const exact::Real& off) const;
  /// At least v at p, and at most 0, where gamma1 is negative.
  double value(const exact::RealPoint& p) const;
  /// Of a negative gamma1 at p, for all pairs whose points are off by at most `off`: rounded shapes may lack a place to
  /// be free, or have one that is none.
  ValueRange depth(const exact::RealPoint& p, const exact::Real& off) const;

 private:
  const ShapePair& pair_;
  bool convex_;
};

}  // namespace findspace::distance
