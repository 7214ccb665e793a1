// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/polynomial_root.h"

#include <algorithm>

#include "exact/number/real_bound.h"
#include "exact/number/real_node.h"
#include "exact/number/root_balls.h"
#include "findspace/error.h"

namespace findspace::exact {
namespace {

using detail::RootBalls;
using detail::RootNode;

/// Without leading zeros, and without a denominator where all coefficients are rational.
Polynomial simplified(Polynomial p) {
  while (!p.empty() && p.back().sign() == 0) p.pop_back();
  Real common(1);
  for (const Real& c : p) {
    const auto parts = c.fraction();
    if (!parts) return p;
    const Real below((*parts)[1]);
    if (!(common / below).integer()) common *= below;
  }
  for (Real& c : p) c *= common;
  return p;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial out;
  for (std::size_t k = 1; k < p.size(); ++k) out.push_back(Real(k) * p[k]);
  return out;
}

Interval enclosure(const Polynomial& p, const Interval& x) {
  Interval out;
  for (std::size_t k = p.size(); k-- > 0;) out = out * x + p[k].interval();
  return out;
}

/// The root of p in [lo, hi], where it is monotone and changes its sign between lo and hi.
Real simple_root(const Polynomial& p, Real lo, Real hi) {
  if (p.size() == 2) return -p[0] / p[1];
  if (p.size() == 3) {
    const Real root = sqrt(p[1] * p[1] - Real(4) * p[0] * p[2]), below = Real(2) * p[2];
    const Real first = (-p[1] - root) / below;
    return lo <= first && first <= hi ? first : (root - p[1]) / below;
  }
  const int rises = value_at(p, hi).sign();
  auto balls = std::make_unique<RootBalls>(lo, hi);
  for (mpfr_prec_t precision = 128; !balls->converges(p, precision); precision += 32) {
    for (int k = 0; k < 4; ++k) {
      const Real middle = (lo + hi) / Real(2);
      const int sign = value_at(p, middle).sign();
      if (sign == 0) return middle;
      (sign == rises ? hi : lo) = middle;
    }
    balls = std::make_unique<RootBalls>(lo, hi);
  }
  const Interval interval = balls->at(p, 128).interval();
  return detail::Access::adopt(new RootNode(interval, p, std::move(balls)));
}

/// A rational number between x, where p has a sign, and the root of p on the way to `end`; p is monotone on that way.
Real beside(const Polynomial& p, const Real& x, const Real& end, int sign) {
  if (x.is_rational()) return x;
  constexpr int kMostBits = 120;
  for (int bits = 40; bits <= kMostBits; bits += 20) {
    const Real scale(int128(1) << bits);
    const bool up = x < end;
    const Real near = Real(floor(x * scale) + (up ? 1 : 0)) / scale;
    if ((up ? near < end : near > end) && value_at(p, near).sign() == sign) return near;
  }
  throw Error(ErrorCode::kUnsupported, "two roots of a polynomial are too close to each other to be distinguished");
}

std::vector<Real> roots(const Polynomial& p, const Real& lo, const Real& hi) {
  if (p.size() < 2) return {};
  const Interval all{lo.interval().lo, hi.interval().hi};
  if (certain_sign(enclosure(p, all)) != 0) return {};
  std::vector<Real> stops{lo}, out;
  const Polynomial slope = simplified(derivative(p));
  if (certain_sign(enclosure(slope, all)) == 0) {
    for (Real& r : roots(slope, lo, hi)) {
      if (stops.back() < r && r < hi) stops.push_back(std::move(r));
    }
  }
  stops.push_back(hi);
  std::vector<int> signs;
  for (const Real& s : stops) signs.push_back(value_at(p, s).sign());
  for (std::size_t k = 0; k < stops.size(); ++k) {
    if (signs[k] == 0) out.push_back(stops[k]);
    if (k + 1 == stops.size() || signs[k] * signs[k + 1] >= 0) continue;
    const Real &from = stops[k], &to = stops[k + 1];
    out.push_back(simple_root(p, beside(p, from, to, signs[k]), beside(p, to, from, signs[k + 1])));
  }
  return out;
}

}  // namespace

Real value_at(std::span<const Real> polynomial, const Real& x) {
  Real out;
  for (std::size_t k = polynomial.size(); k-- > 0;) out = out * x + polynomial[k];
  return out;
}

double degree_bound(const Real& x) { return detail::degree_bound(detail::Plan(x)); }

std::vector<Real> roots_between(Polynomial polynomial, const Real& lo, const Real& hi) {
  return roots(simplified(std::move(polynomial)), lo, hi);
}

}  // namespace findspace::exact
