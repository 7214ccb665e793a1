// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/real_bound.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "exact/number/powers.h"
#include "findspace/error.h"

namespace findspace::exact::detail {
namespace {

struct Bound {
  double u = 0, l = 0;  // log2, rounded up
};

double up(double log_value) {
  return log_value == -kInfinity ? log_value : log_value + std::abs(log_value) * 1e-14 + 1e-12;
}

/// log2 |z| <= result; -infinity for 0.
double log2_of(const mpz_class& z) {
  if (sgn(z) == 0) return -kInfinity;
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, z.get_mpz_t());
  return up(std::log2(std::abs(mantissa) * (1 + 1e-15)) + static_cast<double>(exponent));
}

double log2_of(const Interval& a) { return up(std::log2(std::max(std::abs(a.lo), std::abs(a.hi)))); }

/// log2(2^x + 2^y) <= result.
double log2_sum(double x, double y) {
  const double high = std::max(x, y), low = std::min(x, y);
  if (low == -kInfinity || high - low > 80) return up(high);
  return up(high + std::log2(1 + std::exp2(low - high)));
}

Bound bound_of(const Step& step, const std::vector<Bound>& bounds) {
  const Bound a = step.a >= 0 ? bounds[step.a] : Bound{}, b = step.b >= 0 ? bounds[step.b] : Bound{};
  switch (step.kind) {
    case StepKind::kSmall:
      return {log2_of(enclose(step.small.p)), log2_of(enclose(step.small.q))};
    case StepKind::kPlainRoot:
      return {log2_of(step.leaf->n) / 2, 0};
    case StepKind::kPolynomialRoot:
      break;  // RootedBounds
    case StepKind::kLeaf:
      if (step.leaf->rational()) return {log2_of(step.leaf->p), log2_of(step.leaf->q)};
      return {log2_sum(log2_of(step.leaf->p), log2_of(step.leaf->r) + a.u), log2_of(step.leaf->q)};
    case StepKind::kNeg:
      return a;
    case StepKind::kAdd:
    case StepKind::kSub:
      return {log2_sum(a.u + b.l, a.l + b.u), up(a.l + b.l)};
    case StepKind::kMul:
      return {up(a.u + b.u), up(a.l + b.l)};
    case StepKind::kDiv:
      return {up(a.u + b.l), up(a.l + b.u)};
    case StepKind::kSqrt:
      if (a.u >= a.l) return {up((a.u + a.l) / 2), a.l};
      return {a.u, up((a.u + a.l) / 2)};
  }
  return {};
}

/// Of the square roots.
double log2_degree(const Plan& plan) {
  // Products of the independent n found so far, modulo squares; past kMostProducts new ones are taken as independent.
  constexpr std::size_t kMostProducts = 16;
  std::vector<mpz_class> products;
  double degree = 0;
  for (const Step& step : plan.steps()) {
    if (step.kind == StepKind::kSqrt) ++degree;
    if (step.kind != StepKind::kPlainRoot) continue;
    const mpz_class& n = step.leaf->n;
    const bool dependent =
        std::any_of(products.begin(), products.end(), [&](const mpz_class& m) { return perfect_square_product(m, n); });
    if (dependent) continue;
    ++degree;
    const std::size_t before = products.size();
    if (before >= kMostProducts) continue;
    for (std::size_t i = 0; i < before; ++i) products.emplace_back(products[i] * n);
    products.push_back(n);
  }
  return degree;
}

double degree_of(const Step& root) { return double(root.polynomial->coefficients.size()) - 1; }

/// Powers of one root of a polynomial each: max(1, |r|)^d.
using RootPowers = std::vector<double>;

/// |U| <= 2^u * powers, L a product of factors.
struct RootedFraction {
  double u = 0;
  RootPowers powers;
  Powers below;  // from factors to how often
};

/// Something that divides: an integer, or the numerator of a step.
struct RootedFactor {
  double bits = 0;
  RootPowers powers;
};

void add_to(RootPowers& to, const RootPowers& more, double times) {
  for (std::size_t r = 0; r < to.size(); ++r) to[r] += times * more[r];
}

class RootedBounds {
 public:
  explicit RootedBounds(const Plan& plan) : plan_(plan), log2_degree_(log2_degree(plan)) {
    for (const Step& s : plan.steps()) {
      if (s.kind == StepKind::kPolynomialRoot) {
        roots_.push_back(&s);
        log2_degree_ += std::log2(degree_of(s));
      }
    }
    for (const Step& s : plan.steps()) fractions_.push_back(fraction_of(s));
  }

  double bits() const {
    const RootedFraction& value = fractions_[std::size_t(plan_.root())];
    const double degree = std::exp2(log2_degree_);
    const RootedFactor l = factor(value.below);
    double bits = std::max(value.u, 0.0) * (degree - 1) + std::max(l.bits, 0.0);
    for (std::size_t r = 0; r < roots_.size(); ++r) {
      bits += value.powers[r] * std::max(norms_[r], 0.0) * degree / degree_of(*roots_[r]);
      bits += l.powers[r] * std::max(log2_of(roots_[r]->interval), 0.0);
    }
    return up(bits);
  }

 private:
  RootedFactor factor(const Powers& below) const {
    RootedFactor out{0, RootPowers(roots_.size())};
    for (const auto& [f, power] : below) {
      const RootedFactor& one = factors_[std::size_t(f)];
      out.bits = up(out.bits + power * one.bits);
      add_to(out.powers, one.powers, power);
    }
    return out;
  }
  /// The numerator times these factors.
  void raise(RootedFraction& a, const Powers& by) const {
    const RootedFactor f = factor(by);
    a.u = up(a.u + f.bits);
    add_to(a.powers, f.powers, 1);
  }
  RootedFraction expanded(RootedFraction a, const Powers& by) const {
    raise(a, by);
    for (const auto& [f, power] : by) a.below[f] += power;
    return a;
  }

  RootedFraction leaf(double u, const mpz_class& q) {
    RootedFraction out{u, RootPowers(roots_.size()), {}};
    if (q == 1) return out;
    const auto [at, is_new] = integers_.try_emplace(q, int(factors_.size()));
    if (is_new) factors_.push_back({log2_of(q), RootPowers(roots_.size())});
    out.below[at->second] = 1;
    return out;
  }

  RootedFraction sum(const RootedFraction& a, const RootedFraction& b) const {
    RootedFraction p = expanded(a, lacking(a.below, b.below));
    const RootedFraction q = expanded(b, lacking(b.below, a.below));
    p.u = log2_sum(p.u, q.u);
    for (std::size_t r = 0; r < p.powers.size(); ++r) p.powers[r] = std::max(p.powers[r], q.powers[r]);
    return p;
  }

  static RootedFraction product(RootedFraction a, const RootedFraction& b) {
    a.u = up(a.u + b.u);
    add_to(a.powers, b.powers, 1);
    for (const auto& [f, power] : b.below) a.below[f] += power;
    return a;
  }

  /// (ua / la) / (ub / lb): what la and lb share cancels.
  RootedFraction quotient(const RootedFraction& a, const RootedFraction& b, int divisor) {
    RootedFraction out = a;
    out.below = lacking(b.below, a.below);
    raise(out, lacking(a.below, b.below));
    const auto [at, is_new] = numerators_.try_emplace(divisor, int(factors_.size()));
    if (is_new) factors_.push_back({b.u, b.powers});
    ++out.below[at->second];
    return out;
  }

  /// sqrt(U/L) = sqrt(U L) / L.
  RootedFraction square_root(RootedFraction a) const {
    raise(a, a.below);
    a.u = up(a.u / 2);
    for (double& d : a.powers) d /= 2;
    return a;
  }

  RootedFraction root_of(const Step& s) {
    norms_.push_back(norm_of(s));
    RootedFraction out{0, RootPowers(roots_.size()), {}};
    out.powers[norms_.size() - 1] = 1;
    return out;
  }

  /// log2 of the norm of a root's polynomial, made integral.
  double norm_of(const Step& s) const {
    const auto coefficient = [&](std::size_t k) -> const RootedFraction& {
      return fractions_[std::size_t(plan_.coefficients()[std::size_t(s.first) + k])];
    };
    Powers all;
    const std::size_t n = s.polynomial->coefficients.size();
    for (std::size_t k = 0; k < n; ++k) {
      for (const auto& [f, power] : lacking(all, coefficient(k).below)) all[f] += power;
    }
    double norm = -kInfinity;
    for (std::size_t k = 0; k < n; ++k) {
      const RootedFraction c = expanded(coefficient(k), lacking(coefficient(k).below, all));
      if (std::any_of(c.powers.begin(), c.powers.end(), [](double d) { return d > 0; })) {
        throw Error(ErrorCode::kUnsupported, "roots of polynomials made of roots of polynomials");
      }
      norm = log2_sum(norm, c.u);
    }
    return norm;
  }

  RootedFraction fraction_of(const Step& s) {
    const auto a = [&]() -> const RootedFraction& { return fractions_[std::size_t(s.a)]; };
    const auto b = [&]() -> const RootedFraction& { return fractions_[std::size_t(s.b)]; };
    switch (s.kind) {
      case StepKind::kSmall:
        return leaf(log2_of(enclose(s.small.p)), mpz_class(static_cast<long>(s.small.q)));
      case StepKind::kPlainRoot:
        return leaf(log2_of(s.leaf->n) / 2, 1);
      case StepKind::kLeaf:
        if (s.leaf->rational()) return leaf(log2_of(s.leaf->p), s.leaf->q);
        return leaf(log2_sum(log2_of(s.leaf->p), log2_of(s.leaf->r) + a().u), s.leaf->q);
      case StepKind::kPolynomialRoot:
        return root_of(s);
      case StepKind::kNeg:
        return a();
      case StepKind::kAdd:
      case StepKind::kSub:
        return sum(a(), b());
      case StepKind::kMul:
        return product(a(), b());
      case StepKind::kDiv:
        return quotient(a(), b(), s.b);
      case StepKind::kSqrt:
        return square_root(a());
    }
    return {};
  }

  const Plan& plan_;
  double log2_degree_;
  std::vector<const Step*> roots_;
  std::vector<double> norms_;  // of the roots met so far, in the order of roots_
  std::vector<RootedFactor> factors_;
  std::map<mpz_class, int> integers_;
  std::map<int, int> numerators_;  // by step
  std::vector<RootedFraction> fractions_;
};

/// Of plans without roots of polynomials.
double plain_bits(const Plan& plan) {
  std::vector<Bound> bounds;
  bounds.reserve(plan.steps().size());
  for (const Step& step : plan.steps()) bounds.push_back(bound_of(step, bounds));
  const Bound& result = bounds[std::size_t(plan.root())];
  return up(result.l + std::max(result.u, 0.0) * (std::exp2(log2_degree(plan)) - 1));
}

}  // namespace

double degree_bound(const Plan& plan) {
  double degree = std::exp2(log2_degree(plan));
  for (const Step& s : plan.steps())
    if (s.kind == StepKind::kPolynomialRoot) degree *= degree_of(s);
  return degree;
}

double separation_bits(const Plan& plan) {
  const bool plain = std::none_of(plan.steps().begin(), plan.steps().end(),
                                  [](const Step& s) { return s.kind == StepKind::kPolynomialRoot; });
  return plain ? plain_bits(plan) : RootedBounds(plan).bits();
}

}  // namespace findspace::exact::detail
