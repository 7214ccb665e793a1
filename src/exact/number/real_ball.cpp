// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/real_ball.h"

namespace findspace::exact::detail {

namespace {

/// |x| < 2^result, within a factor of 2; x != 0. (MPFR's exponent e means 2^(e-1) <= |x| < 2^e.)
std::int64_t top(mpfr_srcptr x) { return mpfr_get_exp(x); }

/// An upper bound of |mid|.
Radius magnitude(mpfr_srcptr x) { return mpfr_zero_p(x) ? Radius() : Radius::power_of_two(top(x)); }

}  // namespace

void Ball::give_up() {
  mpfr_set_zero(mid_, 1);
  radius_ = Radius::infinite();
}

void Ball::add_rounding(int inexact) {
  if (inexact == 0 && mpfr_number_p(mid_)) return;
  if (!mpfr_number_p(mid_) || mpfr_zero_p(mid_)) return give_up();  // out of MPFR's exponent range
  radius_ = radius_ + Radius::power_of_two(top(mid_) - mpfr_get_prec(mid_) - 1);
}

void Ball::set(mpz_srcptr value) {
  radius_ = Radius();
  add_rounding(mpfr_set_z(mid_, value, MPFR_RNDN));
}

void Ball::set(std::int64_t value) {
  radius_ = Radius();
  add_rounding(mpfr_set_si(mid_, value, MPFR_RNDN));
}

void Ball::set(const Ball& a) {
  radius_ = a.radius_;
  add_rounding(mpfr_set(mid_, a.mid_, MPFR_RNDN));
}

void Ball::set_middle(const Ball& a) {
  mpfr_set(mid_, a.mid_, MPFR_RNDN);  // any number near it will do
  radius_ = Radius();
}

void Ball::set_between(const Ball& lo, const Ball& hi) {
  // From the middle to an end is half of |hi - lo| <= 2^e, and the ends have radii of their own.
  radius_ = lo.radius_ + hi.radius_;
  mpfr_sub(mid_, hi.mid_, lo.mid_, MPFR_RNDA);
  radius_ = radius_ + magnitude(mid_);
  const int inexact = mpfr_add(mid_, lo.mid_, hi.mid_, MPFR_RNDN);
  if (!mpfr_zero_p(mid_)) mpfr_div_2ui(mid_, mid_, 1, MPFR_RNDN);
  if (inexact != 0) add_rounding(inexact);
}

bool Ball::narrower_than(const Ball& a, int bits) const { return radius_.times_power_of_two(bits) < a.radius_; }

Interval Ball::interval() const {
  if (!radius_.finite()) return whole_line();
  const double r = next_up(radius_.to_double());
  return outward(mpfr_get_d(mid_, MPFR_RNDD) - r, mpfr_get_d(mid_, MPFR_RNDU) + r);
}

void Ball::negate(const Ball& a) {
  mpfr_neg(mid_, a.mid_, MPFR_RNDN);  // the same precision: exact
  radius_ = a.radius_;
}

void Ball::add(const Ball& a, const Ball& b) {
  radius_ = a.radius_ + b.radius_;
  if (!radius_.finite()) return give_up();
  add_rounding(mpfr_add(mid_, a.mid_, b.mid_, MPFR_RNDN));
}

void Ball::subtract(const Ball& a, const Ball& b) {
  radius_ = a.radius_ + b.radius_;
  if (!radius_.finite()) return give_up();
  add_rounding(mpfr_sub(mid_, a.mid_, b.mid_, MPFR_RNDN));
}

void Ball::add(const Ball& a, mpz_srcptr b) {
  radius_ = a.radius_;
  if (!radius_.finite()) return give_up();
  add_rounding(mpfr_add_z(mid_, a.mid_, b, MPFR_RNDN));
}

void Ball::multiply(const Ball& a, const Ball& b) {
  // |a| rb + (|b| + rb) ra
  radius_ = magnitude(a.mid_) * b.radius_ + (magnitude(b.mid_) + b.radius_) * a.radius_;
  if (!radius_.finite() || !a.radius_.finite() || !b.radius_.finite()) return give_up();
  add_rounding(mpfr_mul(mid_, a.mid_, b.mid_, MPFR_RNDN));
}

void Ball::multiply(const Ball& a, mpz_srcptr b) {
  if (!a.radius_.finite()) return give_up();
  radius_ = a.radius_.times_power_of_two(static_cast<std::int64_t>(mpz_sizeinbase(b, 2)));
  add_rounding(mpfr_mul_z(mid_, a.mid_, b, MPFR_RNDN));
}

void Ball::divide(const Ball& a, const Ball& b) {
  // |(a+x)/(b+y) - a/b| = |x - y a/b| / |b+y|. With |b| >= 2^(e-1) and rb <= 2^(e-2): |b+y| >= 2^(e-2), and
  // |a/b| <= |a| 2^(1-e), so the error is at most (ra + rb |a| 2^(1-e)) 2^(2-e).
  if (!a.radius_.finite() || !b.radius_.finite() || mpfr_zero_p(b.mid_)) return give_up();
  const std::int64_t e = top(b.mid_);
  if (!b.radius_.zero() && b.radius_.exponent() > e - 2) return give_up();
  const Radius quotient = magnitude(a.mid_).times_power_of_two(1 - e);
  radius_ = (a.radius_ + b.radius_ * quotient).times_power_of_two(2 - e);
  add_rounding(mpfr_div(mid_, a.mid_, b.mid_, MPFR_RNDN));
}

void Ball::divide(const Ball& a, mpz_srcptr b) {
  if (!a.radius_.finite()) return give_up();
  radius_ = a.radius_.times_power_of_two(1 - static_cast<std::int64_t>(mpz_sizeinbase(b, 2)));
  add_rounding(mpfr_div_z(mid_, a.mid_, b, MPFR_RNDN));
}

void Ball::square_root(const Ball& a) {
  // |sqrt(a+x) - sqrt(a)| = |x| / (sqrt(a+x) + sqrt(a)) <= ra / sqrt(a), and sqrt(a) >= 2^floor((e-1)/2)
  if (!a.radius_.finite() || mpfr_sgn(a.mid_) <= 0) return give_up();
  const std::int64_t e = top(a.mid_);
  if (!a.radius_.zero() && a.radius_.exponent() > e - 1) return give_up();
  const Radius error = a.radius_.times_power_of_two(-((e - 1) >> 1));
  const int inexact = mpfr_sqrt(mid_, a.mid_, MPFR_RNDN);
  radius_ = error;
  add_rounding(inexact);
}

int Ball::sign() const {
  if (!radius_.finite() || mpfr_zero_p(mid_)) return 0;
  if (!radius_.zero() && radius_.exponent() > top(mid_) - 1) return 0;
  return mpfr_sgn(mid_);
}

bool Ball::within(double bits) const {
  const Radius most = magnitude(mid_) + radius_;
  return most.zero() || (most.finite() && static_cast<double>(most.exponent()) <= -bits);
}

bool Ball::accurate_to(int bits) const {
  if (!radius_.finite()) return false;
  if (radius_.zero()) return true;
  return !mpfr_zero_p(mid_) && radius_.exponent() + bits <= top(mid_) - 1;
}

}  // namespace findspace::exact::detail
