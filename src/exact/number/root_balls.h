// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Balls around one root of a polynomial, in growing precision, found by the interval Newton method
//     X <- m - P(m) / P'(X),   m the middle of X,
// which loses no root while P' has none in X. Precisions are 128 * 2^k, each level made from the one before, so what is
// found does not depend on who asked before. Guarantee: every ball contains the root. Cost: a doubling of the precision
// takes about one evaluation of P and P'. Internal to src/exact. Source: Moore, Interval Analysis (1966).
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "exact/number/real_ball.h"
#include "exact/number/real_node.h"

namespace findspace::exact::detail {

/// With memory of its own.
class OwnBall {
 public:
  explicit OwnBall(mpfr_prec_t precision)
      : limbs_(std::make_unique<mp_limb_t[]>(Ball::limbs_needed(precision))), ball(precision, limbs_.get()) {}

 private:
  std::unique_ptr<mp_limb_t[]> limbs_;

 public:
  Ball ball;
};

OwnBall ball_of(const Real& x, mpfr_prec_t precision);

class RootBalls {
 public:
  /// The root is the only one of P in [lo, hi], and simple.
  RootBalls(const Real& lo, const Real& hi) : lo_(lo), hi_(hi) {}

  /// Threads: any number.
  const Ball& at(const std::vector<Real>& polynomial, mpfr_prec_t precision);
  /// Whether the first step at a precision narrows the ball around [lo, hi] so much that the next ones do, too.
  bool converges(const std::vector<Real>& polynomial, mpfr_prec_t precision) const;

 private:
  class Newton;
  OwnBall refined(const std::vector<Real>& polynomial, mpfr_prec_t precision, const Ball* start) const;

  Real lo_, hi_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<OwnBall>> levels_;
};

}  // namespace findspace::exact::detail
