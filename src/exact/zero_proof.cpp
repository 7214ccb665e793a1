// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/zero_proof.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "exact/modular_tower.h"

namespace findspace::exact::detail {

namespace {

using Word = ModularTower::Word;
using Coefficients = ModularTower::Coefficients;
using Powers = std::map<int, int>;  // from factors to how often

constexpr std::size_t kMostCoefficients = 768;

double up(double bits) { return bits + std::abs(bits) * 0x1p-40 + 0x1p-40; }  // no sign: more than log2 loses

double log2_of(const mpz_class& z) { return sgn(z) == 0 ? 0 : double(mpz_sizeinbase(z.get_mpz_t(), 2)); }

double log2_sum(double a, double b) { return up(std::max(a, b) + std::log2(1 + std::exp2(-std::abs(a - b)))); }

/// The factors of `to` that `from` lacks.
Powers lacking(const Powers& from, const Powers& to) {
  Powers out;
  for (const auto& [f, power] : to) {
    const auto have = from.find(f);
    const int rest = power - (have == from.end() ? 0 : have->second);
    if (rest > 0) out[f] = rest;
  }
  return out;
}

/// A step as a numerator over a product of factors; before operands are joined they are multiplied by some of these.
struct Fraction {
  double size = 0;  // log2 of a bound of the sum of the numerator's coefficients
  Powers below, times_a, times_b;
  std::vector<Powers> times;  // of a polynomial's coefficients
};

/// What divides: an integer, or the numerator of a step.
struct Factor {
  mpz_class integer;
  int step = -1;
};

/// All that does not depend on the prime.
class Shape {
 public:
  explicit Shape(const Plan& plan) : plan_(plan) {
    for (std::size_t k = 0; k < plan.steps().size() && possible_; ++k)
      fractions_.push_back(fraction_of(plan.steps()[k]));
  }

  bool possible() const { return possible_; }
  const Plan& plan() const { return plan_; }
  const std::vector<Fraction>& fractions() const { return fractions_; }
  const std::vector<Factor>& factors() const { return factors_; }

 private:
  int integer_factor(const mpz_class& q) {
    const auto found =
        std::find_if(factors_.begin(), factors_.end(), [&](const Factor& f) { return f.step < 0 && f.integer == q; });
    if (found != factors_.end()) return int(found - factors_.begin());
    factors_.push_back({q, -1});
    return int(factors_.size()) - 1;
  }

  int step_factor(int step) {
    const auto found = std::find_if(factors_.begin(), factors_.end(), [&](const Factor& f) { return f.step == step; });
    if (found != factors_.end()) return int(found - factors_.begin());
    factors_.push_back({{}, step});
    return int(factors_.size()) - 1;
  }

  double size_of(const Powers& product) const {
    double bits = 0;
    for (const auto& [f, power] : product) {
      const Factor& factor = factors_[std::size_t(f)];
      bits += power * (factor.step < 0 ? log2_of(factor.integer) : fractions_[std::size_t(factor.step)].size);
    }
    return bits;
  }

  Fraction over(double size, const mpz_class& q) {
    Fraction out{size, {}, {}, {}, {}};
    if (q != 1) out.below[integer_factor(q)] = 1;
    return out;
  }

  Fraction variable(double size, std::size_t degree) {
    coefficients_ *= degree;
    if (coefficients_ > kMostCoefficients) possible_ = false;
    return {size, {}, {}, {}, {}};
  }

  Fraction root_of(double radicand) { return variable(std::max(0.0, up(radicand / 2)), 2); }

  /// A root of a_n r^n + ... is t / a_n, with t^n = -(a_(n-1) t^(n-1) + a_n a_(n-2) t^(n-2) + ...). That t is bounded
  /// by the greatest of the n-th part's k-th roots: then each term is at most an n-th of t^n.
  Fraction polynomial(const Step& step) {
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
      most = std::max(most, up(term / double(degree - k)));
    }
    Fraction out = variable(most, degree);
    out.below = times[degree];
    ++out.below[step_factor(of[degree])];
    out.times = std::move(times);
    return out;
  }

  Fraction leaf(const Step& step, double root) {
    const Closed& c = *step.leaf;
    return over(c.rational() ? log2_of(c.p) : log2_sum(log2_of(c.p), log2_of(c.r) + root), c.q);
  }

  Fraction sum(const Fraction& a, const Fraction& b) const {
    Fraction out;
    out.times_a = lacking(a.below, b.below), out.times_b = lacking(b.below, a.below);
    out.below = a.below;
    for (const auto& [f, power] : out.times_a) out.below[f] += power;
    out.size = log2_sum(a.size + size_of(out.times_a), b.size + size_of(out.times_b));
    return out;
  }

  static Fraction product(const Fraction& a, const Fraction& b) {
    Fraction out{up(a.size + b.size), a.below, {}, {}, {}};
    for (const auto& [f, power] : b.below) out.below[f] += power;
    return out;
  }

  Fraction quotient(const Fraction& a, const Fraction& b, int divisor) {
    Fraction out;
    out.below = lacking(b.below, a.below), out.times_a = lacking(a.below, b.below);
    ++out.below[step_factor(divisor)];
    out.size = up(a.size + size_of(out.times_a));
    return out;
  }

  Fraction square_root(const Fraction& a) {
    Powers odd, half;
    for (const auto& [f, power] : a.below) {
      half[f] = (power + 1) / 2;
      if (power % 2 != 0) odd[f] = 1;
    }
    Fraction out = root_of(a.size + size_of(odd));
    out.times_a = std::move(odd), out.below = std::move(half);
    return out;
  }

  Fraction fraction_of(const Step& step) {
    const auto operand = [&](int k) -> const Fraction& { return fractions_[std::size_t(k)]; };
    switch (step.kind) {
      case StepKind::kSmall: {
        mpz_class p, q;
        set(p, step.small.p), set(q, step.small.q);
        return over(log2_of(p), q);
      }
      case StepKind::kPlainRoot:
        return root_of(log2_of(step.leaf->n));
      case StepKind::kPolynomialRoot:
        return polynomial(step);
      case StepKind::kLeaf:
        return leaf(step, step.a < 0 ? 0 : operand(step.a).size);
      case StepKind::kNeg:
        return {operand(step.a).size, operand(step.a).below, {}, {}, {}};
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

  const Plan& plan_;
  std::vector<Fraction> fractions_;
  std::vector<Factor> factors_;
  std::size_t coefficients_ = 1;
  bool possible_ = true;
};

/// The numerators modulo one prime.
class Modulo {
 public:
  Modulo(const Shape& shape, Word prime) : shape_(shape), tower_(prime) {
    const std::vector<Step>& steps = shape.plan().steps();
    for (std::size_t k = 0; k < steps.size(); ++k) values_.push_back(value(steps[k], shape.fractions()[k]));
  }

  bool is_zero() const { return values_[std::size_t(shape_.plan().root())].empty(); }

 private:
  Coefficients number(const mpz_class& z) const {
    const auto rest = Word(mpz_fdiv_ui(z.get_mpz_t(), tower_.prime()));
    return rest == 0 ? Coefficients{} : Coefficients{rest};
  }

  Coefficients times(Coefficients a, const Powers& factors) const {
    for (const auto& [f, power] : factors) {
      const Factor& factor = shape_.factors()[std::size_t(f)];
      const Coefficients by = factor.step < 0 ? number(factor.integer) : values_[std::size_t(factor.step)];
      for (int k = 0; k < power; ++k) a = tower_.product(a, by);
    }
    return a;
  }

  Coefficients polynomial(const Step& step, const Fraction& f) {
    const std::size_t degree = f.times.size() - 1;
    std::vector<Coefficients> a;
    for (std::size_t k = 0; k <= degree; ++k) {
      const int of = shape_.plan().coefficients()[std::size_t(step.first) + k];
      a.push_back(times(values_[std::size_t(of)], f.times[k]));
    }
    Coefficients leading{1};
    for (std::size_t k = degree; k-- > 0; leading = tower_.product(leading, a[degree]))
      a[k] = tower_.negative(tower_.product(a[k], leading));
    a.pop_back();
    return tower_.add_variable(std::move(a));
  }

  Coefficients value(const Step& step, const Fraction& f) {
    const auto operand = [&](int k) -> const Coefficients& { return values_[std::size_t(k)]; };
    switch (step.kind) {
      case StepKind::kSmall: {
        mpz_class p;
        set(p, step.small.p);
        return number(p);
      }
      case StepKind::kPlainRoot:
        return tower_.add_variable({number(step.leaf->n), {}});
      case StepKind::kLeaf:
        if (step.leaf->rational()) return number(step.leaf->p);
        return tower_.sum(tower_.product(operand(step.a), number(step.leaf->r)), number(step.leaf->p));
      case StepKind::kNeg:
        return tower_.negative(operand(step.a));
      case StepKind::kAdd:
        return tower_.sum(times(operand(step.a), f.times_a), times(operand(step.b), f.times_b));
      case StepKind::kSub:
        return tower_.sum(times(operand(step.a), f.times_a), tower_.negative(times(operand(step.b), f.times_b)));
      case StepKind::kMul:
        return tower_.product(operand(step.a), operand(step.b));
      case StepKind::kDiv:
        return times(operand(step.a), f.times_a);
      case StepKind::kSqrt:
        return tower_.add_variable({times(operand(step.a), f.times_a), {}});
      case StepKind::kPolynomialRoot:
        return polynomial(step, f);
    }
    return {};
  }

  const Shape& shape_;
  ModularTower tower_;
  std::vector<Coefficients> values_;
};

}  // namespace

bool proves_zero(const Plan& plan) {
  const Shape shape(plan);
  if (!shape.possible()) return false;
  double open = shape.fractions()[std::size_t(plan.root())].size;
  for (const Word prime : tower_primes()) {
    if (!Modulo(shape, prime).is_zero()) return false;
    open -= 30.9;  // no sign: less than log2 of the prime
    if (open < 0) return true;
  }
  return false;
}

}  // namespace findspace::exact::detail
