// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/real_balls.h"

#include "exact/number/root_balls.h"

namespace findspace::exact::detail {

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
    set(arena_, value.p);
    result.set(arena_.get_mpz_t());
  }
  if (value.q == 1) return;
  mpz_set_si(arena_.get_mpz_t(), value.q);
  result.divide(result, arena_.get_mpz_t());
}

void Balls::evaluate_leaf(const Step& step) {
  Ball& result = balls_.back();
  const Quadratic& leaf = *step.leaf;
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
    case StepKind::kPolynomialRoot:
      result.set(step.polynomial->balls->at(step.polynomial->coefficients, result.precision()));
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

}  // namespace findspace::exact::detail
