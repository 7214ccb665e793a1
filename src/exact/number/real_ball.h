// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Balls (midpoint, radius): the exact value is within `radius` of `mid`. Midpoints are MPFR numbers of the working
// precision, rounded to nearest, in memory the caller provides; radii are a double with an exponent of its own and are
// always rounded up. An operation that cannot bound its result (a divisor or a root whose ball reaches 0) gives an
// infinite radius, and the caller raises the precision. All balls of one evaluation have the same precision.
// Source: van der Hoeven, "Ball arithmetic" (2009); Johansson, "Arb" (2017). Internal to src/exact: brings in MPFR.
// Keywords: ball arithmetic, midpoint-radius interval.
#pragma once

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "exact/number/interval.h"

namespace findspace::exact::detail {

/// An upper bound m * 2^e >= 0 with m in [1/2, 1), or 0, or infinite; every operation rounds up.
class Radius {
 public:
  Radius() = default;
  static Radius power_of_two(std::int64_t exponent) { return {0.5, exponent + 1}; }
  static Radius infinite() { return {std::numeric_limits<double>::infinity(), 0}; }

  bool zero() const { return m_ == 0; }
  bool finite() const { return m_ < 1; }
  std::int64_t exponent() const { return e_; }  // value < 2^exponent, unless zero or infinite
  double to_double() const { return finite() ? std::ldexp(m_, int(std::clamp<std::int64_t>(e_, -2000, 2000))) : m_; }
  friend bool operator<(const Radius& a, const Radius& b) {
    if (a.zero() || b.zero()) return a.zero() && !b.zero();
    if (!a.finite() || !b.finite()) return a.finite() && !b.finite();
    return a.e_ != b.e_ ? a.e_ < b.e_ : a.m_ < b.m_;
  }

  friend Radius operator+(const Radius& a, const Radius& b) {
    if (a.zero() || !b.finite()) return b;
    if (b.zero() || !a.finite()) return a;
    const Radius &high = a.e_ >= b.e_ ? a : b, &low = a.e_ >= b.e_ ? b : a;
    const std::int64_t shift = high.e_ - low.e_;
    const double scale = shift > 60 ? 0x1p-60 : std::bit_cast<double>(static_cast<std::uint64_t>(1023 - shift) << 52);
    return normalised((high.m_ + low.m_ * scale) * kUp, high.e_);
  }
  /// this * 2^shift.
  Radius times_power_of_two(std::int64_t shift) const { return zero() || !finite() ? *this : Radius{m_, e_ + shift}; }
  friend Radius operator*(const Radius& a, const Radius& b) {
    if (a.zero() || b.zero()) return {};
    if (!a.finite() || !b.finite()) return infinite();
    return normalised(a.m_ * b.m_ * kUp, a.e_ + b.e_);
  }

 private:
  static constexpr double kUp = 1 + 0x1p-50;  // more than the error of the two operations it covers
  Radius(double m, std::int64_t e) : m_(m), e_(e) {}
  static Radius normalised(double m, std::int64_t e) {
    if (m >= 1) return {m / 2, e + 1};
    if (m < 0.5) return {m * 2, e - 1};
    return {m, e};
  }

  double m_ = 0;
  std::int64_t e_ = 0;
};

class Ball {
 public:
  /// `limbs` holds limbs_needed(precision) words and outlives the ball.
  Ball(mpfr_prec_t precision, mp_limb_t* limbs) {
    mpfr_custom_init(limbs, precision);
    mpfr_custom_init_set(mid_, MPFR_ZERO_KIND, 0, precision, limbs);
  }
  static std::size_t limbs_needed(mpfr_prec_t precision) {
    return (mpfr_custom_get_size(precision) + sizeof(mp_limb_t) - 1) / sizeof(mp_limb_t);
  }

  void set(mpz_srcptr value);
  void set(std::int64_t value);
  void set(const Ball& a);                           // of any precision
  void set_middle(const Ball& a);                    // radius 0
  void set_between(const Ball& lo, const Ball& hi);  // contains both and all between
  void negate(const Ball& a);
  void add(const Ball& a, const Ball& b);
  void subtract(const Ball& a, const Ball& b);
  void multiply(const Ball& a, const Ball& b);
  void multiply(const Ball& a, mpz_srcptr b);
  void add(const Ball& a, mpz_srcptr b);
  void divide(const Ball& a, const Ball& b);
  void divide(const Ball& a, mpz_srcptr b);
  void square_root(const Ball& a);  // the exact argument is positive

  /// The sign all points of the ball share; 0 if it contains 0.
  int sign() const;
  /// All points are below 2^-bits in magnitude.
  bool within(double bits) const;
  /// radius <= 2^-bits * |mid|.
  bool accurate_to(int bits) const;
  /// The radius is less than 2^-bits of the other's.
  bool narrower_than(const Ball& a, int bits) const;
  mpfr_prec_t precision() const { return mpfr_get_prec(mid_); }
  const Radius& radius() const { return radius_; }
  double to_double() const { return mpfr_get_d(mid_, MPFR_RNDN); }
  Interval interval() const;  // contains the ball

 private:
  /// radius += the error of rounding mid to nearest, of which MPFR said `inexact`.
  void add_rounding(int inexact);
  void give_up();

  mpfr_t mid_;
  Radius radius_;
};

}  // namespace findspace::exact::detail
