// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The first precision: where the separation bound is small, at once what proves a 0, since a sign that the doubles left
// open is nearly always a true tie; else 128 bits, and if these leave it open, a look for a proof by algebra. Then from
// what each evaluation has shown about its own error.
#include "exact/number/expression_sign.h"

#include <cmath>

#include "exact/number/real_balls.h"
#include "exact/number/real_bound.h"
#include "exact/number/stages.h"
#include "exact/number/zero_proof.h"
#include "findspace/error.h"

namespace findspace::exact::detail {

namespace {

constexpr double kFirst = 128;          // bits
constexpr double kSmallBound = 1200;    // up to there, one evaluation that proves costs less than two
constexpr double kLargeBound = 0x1p20;  // from there, seconds: larger proofs are tried
constexpr std::size_t kLargeProof = 4096, kProof = 768;
constexpr double kMostBits =
    0x1p33;  // of all steps together, a gigabyte: a sign that needs more is refused, after minutes

double first_precision(const Plan& plan, double bound_bits) {
  if (bound_bits > kSmallBound) return kFirst;
  const double enough = bound_bits + plan.error_bits() + 8;
  return enough <= 2 * kSmallBound ? std::max(enough, 64.0) : kFirst;
}

/// Radii shrink by one bit for each bit of precision.
double next_precision(double precision, const Ball& value, double bound_bits) {
  if (!value.radius().finite() || value.radius().zero()) return 2 * precision;
  const double enough = precision + bound_bits + static_cast<double>(value.radius().exponent()) + 8;
  return 6 * precision >= enough ? std::max(enough, 1.25 * precision) : 3 * precision;
}

}  // namespace

double separation_bits(const Real& x) { return separation_bits(Plan(x)); }

Evaluation evaluate(const Real& x, int relative_bits, bool count) {
  const Plan plan(x);
  StageCounts ignored;
  StageCounts& counts = count ? stage_counts() : ignored;
  if (plan.is_zero()) {
    ++counts.filter;
    return {};
  }
  const double bound_bits = relative_bits == 0 || certain_sign(x.interval()) == 0 ? separation_bits(plan) : kInfinity;
  for (double precision = first_precision(plan, bound_bits);;) {
    const Balls balls(plan, static_cast<mpfr_prec_t>(std::ceil(precision)));
    const Ball& value = balls.root();
    const int sign = value.sign();
    if (sign != 0 && value.accurate_to(relative_bits)) {
      ++counts.bigfloat;
      return {sign, value.to_double()};
    }
    if (sign == 0 && value.within(bound_bits)) {
      ++counts.zero_bound;
      return {};
    }
    if (precision == kFirst && bound_bits > kSmallBound &&
        proves_zero(plan, bound_bits > kLargeBound ? kLargeProof : kProof)) {
      ++counts.zero_identity;
      return {};
    }
    precision = next_precision(precision, value, bound_bits);
    if (precision * static_cast<double>(plan.steps().size()) > kMostBits) {
      throw Error(ErrorCode::kUnsupported, "a sign needs more than 2^33 bits: roots nested too deeply");
    }
  }
}

}  // namespace findspace::exact::detail
