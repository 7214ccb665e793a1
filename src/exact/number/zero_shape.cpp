// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/zero_shape.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"

namespace findspace::exact::detail {

namespace {

/// No less than the logarithm, whatever its computation lost.
double over_rounding(double bits) { return bits + std::abs(bits) * margin::kLogarithm + margin::kLogarithm; }

double bits_of(const mpz_class& z) { return sgn(z) == 0 ? 0 : double(mpz_sizeinbase(z.get_mpz_t(), 2)); }

double bits_of_sum(double a, double b) {
  return over_rounding(std::max(a, b) + std::log2(1 + std::exp2(-std::abs(a - b))));
}

}  // namespace

ZeroShape::ZeroShape(const Plan& plan, std::size_t most_coefficients)
    : plan_(plan), most_coefficients_(most_coefficients) {
  for (std::size_t k = 0; k < plan.steps().size() && possible_; ++k) {
    const Step& step = plan.steps()[k];
    Fraction f = fraction_of(step);
    if (f.variable >= 0) f.variables |= 1u << f.variable;
    const auto take = [&](int operand) { f.variables |= fractions_[std::size_t(operand)].variables; };
    if (step.a >= 0) take(step.a);
    if (step.b >= 0) take(step.b);
    for (std::size_t c = 0; c < f.times.size(); ++c) take(plan.coefficients()[std::size_t(step.first) + c]);
    fractions_.push_back(std::move(f));
  }
}

int ZeroShape::integer_factor(const mpz_class& q) {
  const auto found =
      std::find_if(factors_.begin(), factors_.end(), [&](const Factor& f) { return f.step < 0 && f.integer == q; });
  if (found != factors_.end()) return int(found - factors_.begin());
  factors_.push_back({q, -1});
  return int(factors_.size()) - 1;
}

int ZeroShape::step_factor(int step) {
  const auto found = std::find_if(factors_.begin(), factors_.end(), [&](const Factor& f) { return f.step == step; });
  if (found != factors_.end()) return int(found - factors_.begin());
  factors_.push_back({{}, step});
  return int(factors_.size()) - 1;
}

double ZeroShape::size_of(const Powers& product) const {
  double bits = 0;
  for (const auto& [f, power] : product) {
    const Factor& factor = factors_[std::size_t(f)];
    bits += power * (factor.step < 0 ? bits_of(factor.integer) : fractions_[std::size_t(factor.step)].size);
  }
  return bits;
}

Fraction ZeroShape::over(double size, const mpz_class& q) {
  Fraction out;
  out.size = size;
  if (q != 1) out.below[integer_factor(q)] = 1;
  return out;
}

Fraction ZeroShape::variable(double size, std::size_t degree) {
  coefficients_ *= degree;
  if (coefficients_ > most_coefficients_) possible_ = false;
  return {size, {}, {}, {}, {}, variables_++, 0};
}

Fraction ZeroShape::root_of(double radicand) { return variable(std::max(0.0, over_rounding(radicand / 2)), 2); }

/// A root of a_n r^n + ... is t / a_n, with t^n = -(a_(n-1) t^(n-1) + a_n a_(n-2) t^(n-2) + ...). That t is bounded
/// by the greatest of the n-th part's k-th roots: then each term is at most an n-th of t^n.
Fraction ZeroShape::polynomial(const Step& step) {
  const std::size_t degree = step.polynomial->coefficients.size() - 1;
  const int* of = plan_.coefficients().data() + step.first;
  const auto coefficient = [&](std::size_t k) -> const Fraction& { return fractions_[std::size_t(of[k])]; };
  Powers common;
  for (std::size_t k = 0; k <= degree; ++k)
    for (const auto& [f, power] : coefficient(k).below) common[f] = std::max(common[f], power);
  std::vector<Powers> times;
  std::vector<double> sizes;
  for (std::size_t k = 0; k <= degree; ++k) {
    times.push_back(lacking(coefficient(k).below, common));
    sizes.push_back(std::max(0.0, coefficient(k).size) + size_of(times.back()));
  }
  double most = 0;
  for (std::size_t k = 0; k < degree; ++k) {
    const double term = sizes[k] + double(degree - 1 - k) * sizes[degree] + std::log2(double(degree));
    most = std::max(most, over_rounding(term / double(degree - k)));
  }
  Fraction out = variable(most, degree);
  out.below = times[degree];
  ++out.below[step_factor(of[degree])];
  out.times = std::move(times);
  return out;
}

Fraction ZeroShape::leaf(const Step& step, double root) {
  const Quadratic& c = *step.leaf;
  return over(c.rational() ? bits_of(c.p) : bits_of_sum(bits_of(c.p), bits_of(c.r) + root), c.q);
}

Fraction ZeroShape::sum(const Fraction& a, const Fraction& b) const {
  Fraction out;
  out.times_a = lacking(a.below, b.below);
  out.times_b = lacking(b.below, a.below);
  out.below = a.below;
  for (const auto& [f, power] : out.times_a) out.below[f] += power;
  out.size = bits_of_sum(a.size + size_of(out.times_a), b.size + size_of(out.times_b));
  return out;
}

Fraction ZeroShape::product(const Fraction& a, const Fraction& b) const {
  Fraction out;
  out.size = over_rounding(a.size + b.size);
  out.below = a.below;
  for (const auto& [f, power] : b.below) out.below[f] += power;
  return out;
}

Fraction ZeroShape::quotient(const Fraction& a, const Fraction& b, int divisor) {
  Fraction out;
  out.below = lacking(b.below, a.below);
  out.times_a = lacking(a.below, b.below);
  ++out.below[step_factor(divisor)];
  out.size = over_rounding(a.size + size_of(out.times_a));
  return out;
}

Fraction ZeroShape::square_root(const Fraction& a) {
  Powers odd, half;
  for (const auto& [f, power] : a.below) {
    half[f] = (power + 1) / 2;
    if (power % 2 != 0) odd[f] = 1;
  }
  Fraction out = root_of(a.size + size_of(odd));
  out.times_a = std::move(odd);
  out.below = std::move(half);
  return out;
}

Fraction ZeroShape::fraction_of(const Step& step) {
  const auto operand = [&](int k) -> const Fraction& { return fractions_[std::size_t(k)]; };
  switch (step.kind) {
    case StepKind::kSmall: {
      mpz_class p, q;
      set(p, step.small.p);
      set(q, step.small.q);
      return over(bits_of(p), q);
    }
    case StepKind::kPlainRoot:
      return root_of(bits_of(step.leaf->n));
    case StepKind::kPolynomialRoot:
      return polynomial(step);
    case StepKind::kLeaf:
      return leaf(step, step.a < 0 ? 0 : operand(step.a).size);
    case StepKind::kNeg:
      return {operand(step.a).size, operand(step.a).below, {}, {}, {}, -1, 0};
    case StepKind::kAdd:
    case StepKind::kSub:
      return sum(operand(step.a), operand(step.b));
    case StepKind::kMul:
      return product(operand(step.a), operand(step.b));
    case StepKind::kDiv:
      return quotient(operand(step.a), operand(step.b), step.b);
    case StepKind::kSqrt:
      return square_root(operand(step.a));
  }
  return {};
}

}  // namespace findspace::exact::detail
