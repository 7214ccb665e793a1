// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/planar/rotation_polynomial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace findspace::exact {

namespace {

Polynomial sum(const Polynomial& a, const Polynomial& b) {
  Polynomial out = a.size() >= b.size() ? a : b;
  const Polynomial& other = a.size() >= b.size() ? b : a;
  for (std::size_t k = 0; k < other.size(); ++k) out[k] += other[k];
  return out;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial out(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) out[i + k] += a[i] * b[k];
  return out;
}

/// The turn by a quarter, several times.
ExactAngle quarter_rotated(ExactAngle t, int quarters) {
  for (int k = quarters & 3; k > 0; --k) t = {-t.sin, t.cos};
  return t;
}

}  // namespace

RotationPolynomial RotationPolynomial::linear(const Real& constant, const Real& cosine, const Real& sine,
                                              int quarters) {
  // a cos(r + q) + b sin(r + q) = a' cos r + b' sin r, (a', b') being (a, b) rotated back by the quarters.
  const ExactAngle v = quarter_rotated({cosine, sine}, -quarters);
  return {{constant + v.cos, Real(2) * v.sin, constant - v.cos}, 1};
}

RotationPolynomial RotationPolynomial::raised(int to) const {
  RotationPolynomial out = *this;
  for (; out.raise_ < to; ++out.raise_) out.c_ = product(out.c_, {1, 0, 1});
  return out;
}

RotationPolynomial operator+(const RotationPolynomial& a, const RotationPolynomial& b) {
  const int raise = std::max(a.raise_, b.raise_);
  return {sum(a.raised(raise).c_, b.raised(raise).c_), raise};
}

RotationPolynomial operator*(const RotationPolynomial& a, const RotationPolynomial& b) {
  return {product(a.c_, b.c_), a.raise_ + b.raise_};
}

RotationPolynomial operator*(const Real& s, const RotationPolynomial& a) {
  RotationPolynomial out = a;
  for (Real& c : out.c_) c = s * c;
  return out;
}

bool RotationPolynomial::is_zero() const {
  return std::all_of(c_.begin(), c_.end(), [](const Real& c) { return c.sign() == 0; });
}

bool RotationPolynomial::is_rational() const {
  return std::all_of(c_.begin(), c_.end(), [](const Real& c) { return c.is_rational(); });
}

bool RotationPolynomial::is_closed() const {
  return std::all_of(c_.begin(), c_.end(), [](const Real& c) { return c.is_closed(); });
}

std::vector<ExactAngle> RotationPolynomial::rotations_between(double from, double to, int quarters) const {
  const double middle = quarters * std::numbers::pi / 2;
  const Real lo = Real::from_double(std::tan((from - middle) / 2)), hi = Real::from_double(std::tan((to - middle) / 2));
  std::vector<ExactAngle> out;
  for (const Real& u : roots_between(c_, lo, hi)) {
    const Real square = u * u, below = Real(1) + square;
    out.push_back(quarter_rotated({(Real(1) - square) / below, Real(2) * u / below}, quarters));
  }
  return out;
}

}  // namespace findspace::exact
