// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/zero_proof.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace findspace::exact::detail {

namespace {

using Word = std::uint32_t;
using Coefficients = std::vector<Word>;  // of the products of the t_i, by bits; empty for 0, else a power of 2 many
using Powers = std::map<int, int>;       // from factors to how often

constexpr int kMostRoots = 9;
constexpr std::size_t kMostPrimes = 512;

/// The largest primes below 2^31, descending.
const std::vector<Word>& primes() {
  static const std::vector<Word> found = [] {
    constexpr Word kTop = Word(1) << 31, kSpan = 16384, kRoot = 46341;
    std::vector<char> composite(kSpan), small(kRoot);
    for (Word d = 2; d < kRoot; ++d) {
      if (small[d] != 0) continue;
      for (Word m = d * d; d < 216 && m < kRoot; m += d) small[m] = 1;
      for (Word m = kTop - kTop % d; kTop - m < kSpan; m -= d) composite[kTop - m] = 1;
    }
    std::vector<Word> out;
    for (Word k = 1; k < kSpan && out.size() < kMostPrimes; ++k)
      if (composite[k] == 0) out.push_back(kTop - k);
    return out;
  }();
  return found;
}

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
  int root = -1;  // of kSqrt and kPlainRoot
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
  int roots() const { return roots_; }

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
    Fraction out{size, {}, {}, {}};
    if (q != 1) out.below[integer_factor(q)] = 1;
    return out;
  }

  Fraction root_of(double radicand) {
    Fraction out{up(radicand / 2), {}, {}, {}};
    out.root = roots_++;
    if (roots_ > kMostRoots) possible_ = false;
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
    Fraction out{up(a.size + b.size), a.below, {}, {}};
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
        break;
      case StepKind::kLeaf:
        return leaf(step, step.a < 0 ? 0 : operand(step.a).size);
      case StepKind::kNeg:
        return {operand(step.a).size, operand(step.a).below, {}, {}};
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
    possible_ = false;
    return {};
  }

  const Plan& plan_;
  std::vector<Fraction> fractions_;
  std::vector<Factor> factors_;
  int roots_ = 0;
  bool possible_ = true;
};

/// The numerators modulo one prime.
class Modulo {
 public:
  Modulo(const Shape& shape, Word prime) : shape_(shape), prime_(prime), radicands_(std::size_t(shape.roots())) {
    const std::vector<Step>& steps = shape.plan().steps();
    for (std::size_t k = 0; k < steps.size(); ++k) values_.push_back(value(steps[k], shape.fractions()[k]));
  }

  bool is_zero() const { return values_[std::size_t(shape_.plan().root())].empty(); }

 private:
  Coefficients number(const mpz_class& z) const {
    const auto rest = Word(mpz_fdiv_ui(z.get_mpz_t(), prime_));
    return rest == 0 ? Coefficients{} : Coefficients{rest};
  }

  Coefficients variable(int root) const {
    Coefficients out(std::size_t(2) << root);
    out[out.size() / 2] = 1;
    return out;
  }

  /// a + sign * b.
  Coefficients sum(Coefficients a, const Coefficients& b, int sign) const {
    if (a.size() < b.size()) a.resize(b.size());
    for (std::size_t k = 0; k < b.size(); ++k) {
      const Word plus = sign > 0 || b[k] == 0 ? b[k] : prime_ - b[k];
      a[k] = Word((std::uint64_t(a[k]) + plus) % prime_);
    }
    return trimmed(std::move(a));
  }

  static Coefficients trimmed(Coefficients a) {
    std::size_t used = a.size();
    while (used > 0 && a[used - 1] == 0) --used;
    std::size_t size = used == 0 ? 0 : 1;
    while (size < used) size *= 2;
    a.resize(size);
    return a;
  }

  Coefficients product(std::span<const Word> a, std::span<const Word> b) const {
    if (a.size() < b.size()) std::swap(a, b);
    while (!b.empty() && b.back() == 0 && std::all_of(b.begin(), b.end(), [](Word w) { return w == 0; })) b = {};
    if (b.empty()) return {};
    if (a.size() == 1) return {Word(std::uint64_t(a[0]) * b[0] % prime_)};
    const std::size_t half = a.size() / 2;
    const auto low = a.first(half), high = a.subspan(half);
    if (b.size() <= half) return joined(product(low, b), product(high, b), half);
    const auto first = b.first(half), second = b.subspan(half);
    const Coefficients& square = radicands_[std::size_t(std::countr_zero(half))];
    return joined(sum(product(low, first), product(product(high, second), square), 1),
                  sum(product(low, second), product(high, first), 1), half);
  }

  static Coefficients joined(Coefficients low, const Coefficients& high, std::size_t half) {
    if (high.empty()) return trimmed(std::move(low));
    low.resize(half);
    low.insert(low.end(), high.begin(), high.end());
    low.resize(2 * half);
    return low;
  }

  Coefficients times(Coefficients a, const Powers& factors) const {
    for (const auto& [f, power] : factors) {
      const Factor& factor = shape_.factors()[std::size_t(f)];
      const Coefficients by = factor.step < 0 ? number(factor.integer) : values_[std::size_t(factor.step)];
      for (int k = 0; k < power; ++k) a = product(a, by);
    }
    return a;
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
        radicands_[std::size_t(f.root)] = number(step.leaf->n);
        return variable(f.root);
      case StepKind::kLeaf:
        if (step.leaf->rational()) return number(step.leaf->p);
        return sum(product(operand(step.a), number(step.leaf->r)), number(step.leaf->p), 1);
      case StepKind::kNeg:
        return sum({}, operand(step.a), -1);
      case StepKind::kAdd:
      case StepKind::kSub:
        return sum(times(operand(step.a), f.times_a), times(operand(step.b), f.times_b),
                   step.kind == StepKind::kAdd ? 1 : -1);
      case StepKind::kMul:
        return product(operand(step.a), operand(step.b));
      case StepKind::kDiv:
        return times(operand(step.a), f.times_a);
      case StepKind::kSqrt:
        radicands_[std::size_t(f.root)] = times(operand(step.a), f.times_a);
        return variable(f.root);
      case StepKind::kPolynomialRoot:
        break;  // no Shape
    }
    return {};
  }

  const Shape& shape_;
  Word prime_;
  std::vector<Coefficients> radicands_, values_;
};

}  // namespace

bool proves_zero(const Plan& plan) {
  const Shape shape(plan);
  if (!shape.possible()) return false;
  double open = shape.fractions()[std::size_t(plan.root())].size;
  for (const Word prime : primes()) {
    if (!Modulo(shape, prime).is_zero()) return false;
    open -= 30.9;  // no sign: less than log2 of the prime
    if (open < 0) return true;
  }
  return false;
}

}  // namespace findspace::exact::detail
