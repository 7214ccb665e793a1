// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/zero_proof.h"

#include <array>

#include "exact/number/modular_tower.h"
#include "exact/number/zero_shape.h"

namespace findspace::exact::detail {

namespace {

using Word = ModularTower::Word;
using Coefficients = ModularTower::Coefficients;

/// The numerators modulo one prime.
class Modulo {
 public:
  Modulo(const ZeroShape& shape, Word prime) : shape_(shape), tower_(prime) {
    const std::vector<Step>& steps = shape.plan().steps();
    for (std::size_t k = 0; k < steps.size(); ++k) values_.push_back(value(steps[k], shape.fractions()[k]));
  }

  const Coefficients& numerator() const { return values_[std::size_t(shape_.plan().root())]; }
  bool occurs(int variable) const { return tower_.flipped(numerator(), std::size_t(variable)) != numerator(); }
  /// The numerator times those with the signs of some variables changed, one after the other.
  Coefficients norm(const std::vector<int>& variables) const {
    Coefficients out = numerator();
    for (const int v : variables) out = tower_.product(out, tower_.flipped(out, std::size_t(v)));
    return out;
  }

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

  const ZeroShape& shape_;
  ModularTower tower_;
  std::vector<Coefficients> values_;
};

/// The value with the signs of some square roots changed; roots of what changes with them are those of the new values.
class Conjugate {
 public:
  explicit Conjugate(const ZeroShape& shape) : shape_(shape), steps_(shape.plan().steps()) {}

  Interval value(unsigned flipped) {
    values_.clear();
    changed_.clear();
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const Step& s = steps_[k];
      const Fraction& f = shape_.fractions()[k];
      const bool flip = f.variable >= 0 && (flipped >> f.variable & 1u) != 0;
      changed_.push_back(flip || (s.a >= 0 && changed(s.a)) || (s.b >= 0 && changed(s.b)));
      const Interval own = s.kind == StepKind::kPlainRoot ? sqrt(enclose(s.leaf->n)) : s.interval;
      const Interval now = (s.a >= 0 && changed(s.a)) || (s.b >= 0 && changed(s.b)) ? operated(s) : own;
      values_.push_back(flip ? -now : now);
    }
    return values_[std::size_t(shape_.plan().root())];
  }

 private:
  bool changed(int step) const { return changed_[std::size_t(step)]; }

  Interval operated(const Step& s) const {
    const Interval a = values_[std::size_t(s.a)], b = s.b >= 0 ? values_[std::size_t(s.b)] : Interval{};
    switch (s.kind) {
      case StepKind::kLeaf:
        return (enclose(s.leaf->p) + enclose(s.leaf->r) * a) / enclose(s.leaf->q);
      case StepKind::kNeg:
        return -a;
      case StepKind::kAdd:
        return a + b;
      case StepKind::kSub:
        return a - b;
      case StepKind::kMul:
        return a * b;
      case StepKind::kDiv:
        return a / b;
      case StepKind::kSqrt:
        return certain_sign(a) > 0 ? sqrt(a) : whole_line();
      default:
        return whole_line();  // has no operand that changes
    }
  }

  const ZeroShape& shape_;
  const std::vector<Step>& steps_;
  std::vector<Interval> values_;
  std::vector<bool> changed_;
};

/// The square roots over which norms may help, one or two, the later one first. A root's sign can be changed in what is
/// left of the others if none of these is made of it.
std::vector<std::vector<int>> choices(const ZeroShape& shape) {
  constexpr int kAny = 32;
  std::array<unsigned, kAny> made_of{};
  std::vector<int> roots;
  for (std::size_t k = shape.fractions().size(); k-- > 0;) {
    const Fraction& f = shape.fractions()[k];
    if (f.variable < 0) continue;
    made_of[std::size_t(f.variable)] = f.variables & ~(1u << f.variable);
    if (shape.plan().steps()[k].kind != StepKind::kPolynomialRoot) roots.push_back(f.variable);
  }
  const unsigned all = shape.fractions()[std::size_t(shape.plan().root())].variables;
  const auto may_change = [&](int v, unsigned among) {
    for (int k = 0; k < kAny; ++k)
      if ((among >> k & 1u) != 0 && (made_of[std::size_t(k)] >> v & 1u) != 0) return false;
    return true;
  };
  std::vector<std::vector<int>> out;
  for (const int r : roots)
    if (may_change(r, all)) out.push_back({r});
  const std::size_t singles = out.size();
  for (std::size_t i = 0; i < singles; ++i)
    for (const int r : roots)
      if (r < out[i][0] && may_change(r, all & ~(1u << out[i][0]))) out.push_back({out[i][0], r});
  return out;
}

/// Whether all values with some of these signs changed, but not none, are certainly not 0.
bool others_differ(Conjugate& conjugate, const std::vector<int>& variables) {
  for (unsigned some = 1; some < 1u << variables.size(); ++some) {
    unsigned flipped = 0;
    for (std::size_t k = 0; k < variables.size(); ++k)
      if ((some >> k & 1u) != 0) flipped |= 1u << variables[k];
    if (certain_sign(conjugate.value(flipped)) == 0) return false;
  }
  return true;
}

/// The norm over the variables (none: the numerator) is the polynomial 0.
bool norm_is_zero(const ZeroShape& shape, const std::vector<int>& variables) {
  double open = shape.fractions()[std::size_t(shape.plan().root())].size * double(1u << variables.size());
  for (const Word prime : tower_primes()) {
    if (!Modulo(shape, prime).norm(variables).empty()) return false;
    open -= 30.9;  // no sign: less than log2 of the prime
    if (open < 0) return true;
  }
  return false;
}

}  // namespace

bool proves_zero(const Plan& plan, std::size_t most_coefficients) {
  const ZeroShape shape(plan, most_coefficients);
  if (!shape.possible()) return false;
  const Modulo first(shape, tower_primes()[0]);
  if (first.numerator().empty()) return norm_is_zero(shape, {});
  Conjugate conjugate(shape);
  for (const std::vector<int>& variables : choices(shape)) {
    if (!first.occurs(variables[0]) || !others_differ(conjugate, variables)) continue;
    if (first.norm(variables).empty() && norm_is_zero(shape, variables)) return true;
  }
  return false;
}

}  // namespace findspace::exact::detail
