// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The first precision: where the separation bound is small, at once what proves a 0, since a sign that the doubles left
// open is nearly always a true tie; else 128 bits. Then from what each evaluation has shown about its own error.
#include "exact/real_sign.h"

#include <cmath>
#include <vector>

#include "exact/real_ball.h"
#include "exact/real_plan.h"
#include "exact/stages.h"
#include "findspace/error.h"

namespace findspace::exact::detail {

namespace {

/// The balls of all steps at one precision, in one block of memory.
class Balls {
 public:
  Balls(const Plan& plan, mpfr_prec_t precision);
  const Ball& root() const { return balls_[root_]; }

 private:
  void evaluate(const Step& step);
  void evaluate_small(const Small& value);
  void evaluate_leaf(const Step& step);

  std::vector<mp_limb_t> limbs_;
  std::vector<Ball> balls_;
  mpz_class scratch_;
  int root_;
};

Balls::Balls(const Plan& plan, mpfr_prec_t precision) : root_(plan.root()) {
  const std::size_t each = Ball::limbs_needed(precision);
  limbs_.resize(each * plan.steps().size());
  balls_.reserve(plan.steps().size());
  for (const Step& step : plan.steps()) {
    balls_.emplace_back(precision, limbs_.data() + each * balls_.size());
    evaluate(step);
  }
}

void Balls::evaluate_small(const Small& value) {
  Ball& result = balls_.back();
  if (const auto low = static_cast<std::int64_t>(value.p); low == value.p) {
    result.set(low);
  } else {
    set(scratch_, value.p);
    result.set(scratch_.get_mpz_t());
  }
  if (value.q == 1) return;
  mpz_set_si(scratch_.get_mpz_t(), value.q);
  result.divide(result, scratch_.get_mpz_t());
}

void Balls::evaluate_leaf(const Step& step) {
  Ball& result = balls_.back();
  const Closed& leaf = *step.leaf;
  if (leaf.rational()) {
    result.set(leaf.p.get_mpz_t());
  } else {
    result.multiply(balls_[step.a], leaf.r.get_mpz_t());
    result.add(result, leaf.p.get_mpz_t());
  }
  if (mpz_cmp_ui(leaf.q.get_mpz_t(), 1) != 0) result.divide(result, leaf.q.get_mpz_t());
}

void Balls::evaluate(const Step& step) {
  Ball& result = balls_.back();
  switch (step.kind) {
    case StepKind::kSmall:
      evaluate_small(step.small);
      break;
    case StepKind::kPlainRoot:
      result.set(step.leaf->n.get_mpz_t());
      result.square_root(result);
      break;
    case StepKind::kLeaf:
      evaluate_leaf(step);
      break;
    case StepKind::kNeg:
      result.negate(balls_[step.a]);
      break;
    case StepKind::kAdd:
      result.add(balls_[step.a], balls_[step.b]);
      break;
    case StepKind::kSub:
      result.subtract(balls_[step.a], balls_[step.b]);
      break;
    case StepKind::kMul:
      result.multiply(balls_[step.a], balls_[step.b]);
      break;
    case StepKind::kDiv:
      result.divide(balls_[step.a], balls_[step.b]);
      break;
    case StepKind::kSqrt:
      result.square_root(balls_[step.a]);
      break;
  }
}

constexpr double kFirst = 128;    // bits
constexpr double kMost = 0x1p28;  // a sign that needs more is refused: hours, not seconds

double first_precision(const Plan& plan, double bound_bits) {
  constexpr double kSmallBound = 1200;  // there, one evaluation that proves costs less than two
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

double separation_bits(const Real& x) { return Plan(x).separation_bits(); }

Evaluation evaluate(const Real& x, int relative_bits, bool count) {
  const Plan plan(x);
  StageCounts ignored;
  StageCounts& counts = count ? stage_counts() : ignored;
  if (plan.is_zero()) {
    ++counts.filter;
    return {};
  }
  const double bound_bits = relative_bits == 0 || certain_sign(x.interval()) == 0 ? plan.separation_bits() : kInfinity;
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
    precision = next_precision(precision, value, bound_bits);
    if (precision > kMost) {
      throw Error(ErrorCode::kUnsupported, "a sign needs more than 2^28 bits: roots nested too deeply");
    }
  }
}

}  // namespace findspace::exact::detail
