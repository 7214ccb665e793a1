// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A sum of T-distances with weights as a function of the position,
//     F(p) = w1 f1(p) + ... + wn fn(p),
// known by its range over discs, which is what best_position.h and sum_map.h search with. Over a disc each summand is
// one of a few smooth forms (smooth_form.h), so that gradients of several summands cancel before they are bounded;
// where there are too many, or the family has none, the summand changes no faster than the position. Guarantee: the
// range holds every value over the disc, to margin::kMaxMinNoise of the coordinates; a single value is that of exact
// numbers, rounded. Cost: linear in the boundaries, and at most kMostForms combinations. Source: second order bounds of
// branch and bound. Keywords: weighted sum, Weber point, wire length, Lipschitz optimisation.
#pragma once

#include <optional>
#include <vector>

#include "distance/planar_least/best_position.h"

namespace findspace::distance {

/// weight * f(p + by), or weight * f(by - p) if `reflected`.
struct Summand {
  TDistancePointer f;
  exact::Real weight;
  exact::RealPoint by{};
  bool reflected = false;
};

class DistanceSum {
 public:
  explicit DistanceSum(std::vector<Summand> summands);

  const std::vector<Summand>& summands() const { return summands_; }
  /// +1, -1: F(p) is infinite, and so it is everywhere; 0: finite; nothing: two summands are, with opposite signs.
  std::optional<int> infinite(const exact::RealPoint& p) const;
  /// How F goes on beyond the reach of all shapes: F(p) >= rising * (|p| - reach) + start - falling * |p|, and F falls
  /// without end where `falling` is more than `rising`. All 0 where F is constant there.
  struct Growth {
    exact::Real rising, falling, start;
  };
  /// `p` is beyond the reach; nothing where it is not known.
  std::optional<Growth> growth_beyond(const exact::RealPoint& p) const;
  DistanceSum negated() const;
  /// No summand's place is farther off than this from the position, or from minus the position.
  double displacement() const;
  /// F changes by no more than this times the way.
  double rate() const { return rate_; }

  ValueRange range(const exact::RealPoint& p, double radius) const;
  /// F(p); nothing where it is +infinity or has no value. Exact where the summands are.
  std::optional<PlanarAnswer> answer(const exact::RealPoint& p) const;
  std::optional<exact::Real> value(const exact::RealPoint& p) const;
  /// Of F(p) - level; nothing where a value between bounds does not decide it, or there is no value.
  std::optional<int> sign(const exact::RealPoint& p, const exact::Real& level) const;

  /// What a range may be off by rounding.
  double noise(const exact::RealPoint& p, double radius) const;

  /// Every smooth form that F can be over a disc, if there are not more than `most`.
  struct Form {
    SmoothForm sum;                     // without a curve
    std::vector<const SmoothForm*> of;  // of each summand
  };
  struct Forms {
    std::vector<std::vector<SmoothForm>> summands;  // as they are, without weight and displacement
    std::vector<Form> all;
  };
  std::optional<Forms> forms(const exact::RealPoint& p, double radius, std::size_t most) const;

 private:
  exact::RealPoint place(const Summand& s, const exact::RealPoint& p) const;
  std::vector<SmoothForm> loose(double value, double weight, double radius) const;

  std::vector<Summand> summands_;
  double rate_ = 0;
};

/// The least or greatest value over positions of S (best_position.h), `size`: the reach of all shapes. Throws
/// Error(kUnsupported) where S is unbounded and it is not known whether F far away grows, falls or is constant.
Extremum best_position(const DistanceSum& f, const PositionBounds& s, Sense sense, double size);
/// Throws that Error.
[[noreturn]] void refuse_without_end();

}  // namespace findspace::distance
