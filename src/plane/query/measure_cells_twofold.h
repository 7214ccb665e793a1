// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Numbers as unevaluated sums of two doubles, about 106 bits, for areas and lengths whose terms cancel: the area of a
// sliver or of a thin ring comes out to full double precision from exact coordinates. Guarantee: + - * / sqrt have
// relative error below 2^-98, atan2 below 2^-90. Nothing here decides a sign. Source: Dekker 1971; Knuth, TAOCP
// 2, 4.2.2; Hida, Li, Bailey, "Library for double-double arithmetic" (2001). Keywords: double-double, compensated
// arithmetic, error-free transformation.
#pragma once

#include <cmath>

#include "exact/number/real.h"

namespace findspace::plane {

struct Twofold {
  double hi = 0, lo = 0;

  Twofold() = default;
  Twofold(double value) : hi(value) {}  // NOLINT: exact, implicit on purpose
  Twofold(double high, double low) : hi(high), lo(low) {}
  explicit Twofold(const exact::Real& value) : hi(value.to_double()) {
    if (std::isfinite(hi)) lo = (value - exact::Real::from_double(hi)).to_double();
    *this = quick(hi, lo);
  }
  /// The value, of which `near` is an approximation to some 13 digits: one exact evaluation instead of two.
  Twofold(const exact::Real& value, double near) {
    *this = quick(near, (value - exact::Real::from_double(near)).to_double());
  }
  /// The double nearest to the sum, but for ties.
  double value() const { return hi + lo; }

  Twofold operator-() const { return {-hi, -lo}; }
  friend Twofold operator+(const Twofold& a, const Twofold& b) {
    Twofold s = sum(a.hi, b.hi), t = sum(a.lo, b.lo);
    s = quick(s.hi, s.lo + t.hi);
    return quick(s.hi, s.lo + t.lo);
  }
  friend Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }
  friend Twofold operator*(const Twofold& a, const Twofold& b) {
    double p = a.hi * b.hi;
    return quick(p, std::fma(a.hi, b.hi, -p) + (a.hi * b.lo + a.lo * b.hi));
  }
  friend Twofold operator/(const Twofold& a, const Twofold& b) {
    Twofold q(a.hi / b.hi), rest = a - b * q;
    q = q + Twofold(rest.hi / b.hi);
    return q + Twofold((a - b * q).hi / b.hi);
  }
  friend Twofold sqrt(const Twofold& a) {
    if (!(a.hi > 0)) return {};
    Twofold r(std::sqrt(a.hi));
    return r + Twofold((a - r * r).hi / (2 * r.hi));
  }
  Twofold& operator+=(const Twofold& b) { return *this = *this + b; }

 private:
  static Twofold sum(double a, double b) {
    double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  static Twofold quick(double a, double b) {
    double s = a + b;
    return {s, b - (s - a)};
  }
};

/// Sine and cosine of a double: Taylor series of the angle / 64, then six doublings.
struct SineCosine {
  Twofold sine, cosine;
};
inline SineCosine sine_cosine(double angle) {
  constexpr int kDoublings = 6, kTerms = 13;
  const Twofold x(std::ldexp(angle, -kDoublings)), x2 = x * x;
  // s = sin x and m = 1 - cos x: the doubling formulas lose nothing for small angles in this form.
  Twofold s, m, term(1);
  for (int k = 1; k <= 2 * kTerms; k += 2) {
    Twofold odd = term * x / Twofold(double(k)), even = term * x2 / Twofold(double(k) * (k + 1));
    s += odd;
    m += even;
    term = -even;
  }
  for (int k = 0; k < kDoublings; ++k) {
    Twofold next = Twofold(2) * s * (Twofold(1) - m);
    m = Twofold(2) * s * s;
    s = next;
  }
  return {s, Twofold(1) - m};
}

/// The angle of the vector (x, y), in (-pi, pi]: the double angle, then one Newton step.
inline Twofold atan2(const Twofold& y, const Twofold& x) {
  const double angle = std::atan2(y.hi, x.hi);
  const SineCosine at = sine_cosine(angle);
  return Twofold(angle) + (y * at.cosine - x * at.sine) / (x * at.cosine + y * at.sine);
}

}  // namespace findspace::plane
