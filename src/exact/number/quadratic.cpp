// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/quadratic.h"

#include <mpfr.h>

#include <utility>

namespace findspace::exact::detail {

void set(mpz_class& z, int128 value) {
  const auto low = static_cast<std::int64_t>(value);
  if (low == value) {
    mpz_set_si(z.get_mpz_t(), low);
    return;
  }
  const bool negative = value < 0;
  const auto magnitude = negative ? -static_cast<unsigned __int128>(value) : static_cast<unsigned __int128>(value);
  const std::uint64_t limbs[2] = {static_cast<std::uint64_t>(magnitude), static_cast<std::uint64_t>(magnitude >> 64)};
  mpz_import(z.get_mpz_t(), 2, -1, sizeof(std::uint64_t), 0, 0, limbs);
  if (negative) mpz_neg(z.get_mpz_t(), z.get_mpz_t());
}

bool fits_int128(const mpz_class& z) { return mpz_sizeinbase(z.get_mpz_t(), 2) <= 127; }

int128 to_int128(const mpz_class& z) {
  if (mpz_fits_slong_p(z.get_mpz_t())) return mpz_get_si(z.get_mpz_t());
  std::uint64_t limbs[2] = {};
  mpz_export(limbs, nullptr, -1, sizeof(std::uint64_t), 0, 0, z.get_mpz_t());
  const auto magnitude = static_cast<int128>(static_cast<unsigned __int128>(limbs[1]) << 64 | limbs[0]);
  return sgn(z) < 0 ? -magnitude : magnitude;
}

namespace {

bool is_one(const mpz_class& z) { return mpz_cmp_ui(z.get_mpz_t(), 1) == 0; }

/// Restores q > 0, gcd(p, r, q) = 1 and n = 0 for rationals.
Quadratic normalised(Quadratic a) {
  if (sgn(a.q) < 0) {
    a.p = -a.p;
    a.r = -a.r;
    a.q = -a.q;
  }
  if (sgn(a.r) == 0) a.n = 0;
  if (is_one(a.q)) return a;
  mpz_class g = gcd(a.p, a.q);
  if (sgn(a.r) != 0 && !is_one(g)) g = gcd(g, a.r);
  if (is_one(g)) return a;
  for (mpz_class* z : {&a.p, &a.r, &a.q}) mpz_divexact(z->get_mpz_t(), z->get_mpz_t(), g.get_mpz_t());
  return a;
}

/// b written with sqrt(n): sqrt(m) = s/n sqrt(n) where s = sqrt(n*m). Nothing where that is not an integer.
std::optional<Quadratic> in_field(const Quadratic& b, const mpz_class& n) {
  const mpz_class product = n * b.n;
  if (!mpz_perfect_square_p(product.get_mpz_t())) return std::nullopt;
  Quadratic c;
  c.p = b.p * n;
  c.r = b.r * sqrt(product);
  c.q = b.q * n;
  c.n = n;
  return normalised(std::move(c));
}

/// Calls op(a, b, n) with both operands in Q(sqrt n), or returns nothing.
template <class Operation>
std::optional<Quadratic> in_common_field(const Quadratic& a, const Quadratic& b, Operation op) {
  if (a.rational()) return op(a, b, b.n);
  if (b.rational() || a.n == b.n) return op(a, b, a.n);
  const auto moved = in_field(b, a.n);
  if (!moved) return std::nullopt;
  return op(a, *moved, a.n);
}

Quadratic sum_in_field(const Quadratic& a, const Quadratic& b, const mpz_class& n) {
  Quadratic c;
  c.n = n;
  if (a.q == b.q) {
    c.p = a.p + b.p;
    c.r = a.r + b.r;
    c.q = a.q;
  } else {
    c.p = a.p * b.q + b.p * a.q;
    c.r = a.r * b.q + b.r * a.q;
    c.q = a.q * b.q;
  }
  return normalised(std::move(c));
}

Quadratic product_in_field(const Quadratic& a, const Quadratic& b, const mpz_class& n) {
  Quadratic c;
  c.n = n;
  c.p = a.p * b.p;
  if (!a.rational() && !b.rational()) c.p += a.r * b.r * n;
  if (!b.rational()) c.r = a.p * b.r;
  if (!a.rational()) c.r += a.r * b.p;
  c.q = a.q * b.q;
  return normalised(std::move(c));
}

/// 1/a = q (p - r sqrt n) / (p^2 - r^2 n).
Quadratic inverse(const Quadratic& a) {
  Quadratic c;
  c.n = a.n;
  if (a.rational()) {
    c.p = a.q;
    c.q = a.p;
  } else {
    c.p = a.p * a.q;
    c.r = -a.r * a.q;
    c.q = a.p * a.p - a.r * a.r * a.n;
  }
  return normalised(std::move(c));
}

/// sqrt(p/q) = sqrt(p q)/q, with small square factors of p*q taken out of the root.
Quadratic root_of_rational(const Quadratic& a) {
  Quadratic c;
  c.q = a.q;
  c.n = a.p * a.q;
  if (mpz_perfect_square_p(c.n.get_mpz_t())) {
    c.p = sqrt(c.n);
    return normalised(std::move(c));
  }
  c.r = 1;
  for (unsigned long prime : {2UL, 3UL, 5UL, 7UL}) {
    while (mpz_divisible_ui_p(c.n.get_mpz_t(), prime * prime)) {
      mpz_divexact_ui(c.n.get_mpz_t(), c.n.get_mpz_t(), prime * prime);
      c.r *= prime;
    }
  }
  return normalised(std::move(c));
}

}  // namespace

Quadratic quadratic_of(int128 value) {
  Quadratic c;
  set(c.p, value);
  return c;
}

Quadratic quadratic_ratio(mpz_class numerator, mpz_class denominator) {
  Quadratic c;
  c.p = std::move(numerator);
  c.q = std::move(denominator);
  return normalised(std::move(c));
}

int sign(const Quadratic& a) {
  const int sign_p = sgn(a.p), sign_r = sgn(a.r);
  if (sign_r == 0) return sign_p;
  if (sign_p == 0 || sign_p == sign_r) return sign_r;
  return cmp(a.p * a.p, a.r * a.r * a.n) > 0 ? sign_p : sign_r;  // never equal: n is not a square
}

Quadratic negate(const Quadratic& a) {
  Quadratic c = a;
  mpz_neg(c.p.get_mpz_t(), c.p.get_mpz_t());
  mpz_neg(c.r.get_mpz_t(), c.r.get_mpz_t());
  return c;
}

std::optional<Quadratic> add(const Quadratic& a, const Quadratic& b) { return in_common_field(a, b, sum_in_field); }
std::optional<Quadratic> subtract(const Quadratic& a, const Quadratic& b) { return add(a, negate(b)); }
std::optional<Quadratic> multiply(const Quadratic& a, const Quadratic& b) {
  return in_common_field(a, b, product_in_field);
}
std::optional<Quadratic> divide(const Quadratic& a, const Quadratic& b) { return multiply(a, inverse(b)); }

std::optional<Quadratic> root(const Quadratic& a) {
  if (a.rational()) return root_of_rational(a);
  // sqrt(p + r sqrt n) = x + y sqrt n needs x^2 + n y^2 = p, 2xy = r, so x^2 = (p +- s)/2 with s^2 = p^2 - r^2 n.
  // The q below the root goes in front: sqrt((p + r sqrt n)/q) = sqrt(q p + q r sqrt n)/q.
  const mpz_class p = a.p * a.q, r = a.r * a.q;
  const mpz_class norm = p * p - r * r * a.n;
  if (sgn(norm) < 0 || !mpz_perfect_square_p(norm.get_mpz_t())) return std::nullopt;
  const mpz_class s = sqrt(norm);
  for (const mpz_class& twice_square : {mpz_class(p + s), mpz_class(p - s)}) {
    const mpz_class four_squares = 2 * twice_square;  // (2x)^2
    if (sgn(four_squares) <= 0 || !mpz_perfect_square_p(four_squares.get_mpz_t())) continue;
    Quadratic c;  // x = t/2, y = r/t, so (x + y sqrt n)/q = (t^2 + 2 r sqrt n) / (2 t q)
    const mpz_class t = sqrt(four_squares);
    c.p = four_squares;
    c.r = 2 * r;
    c.q = 2 * t * a.q;
    c.n = a.n;
    c = normalised(std::move(c));
    return sign(c) < 0 ? negate(c) : c;
  }
  return std::nullopt;
}

Interval enclose(const mpz_class& z) {
  const double d = mpz_get_d(z.get_mpz_t());  // rounds towards 0; infinite where too large
  const std::size_t bits = mpz_sizeinbase(z.get_mpz_t(), 2);
  if (bits <= 53) return {d, d};
  if (bits > 1023) return sgn(z) > 0 ? Interval{0x1p1022, kInfinity} : Interval{-kInfinity, -0x1p1022};
  return d > 0 ? Interval{d, next_up(d)} : Interval{next_down(d), d};
}

namespace {

/// Enclosure by MPFR, for parts beyond the range of doubles: 128 bits, then outward by far more than their error.
Interval enclose_wide(const Quadratic& a) {
  mpfr_t x, y, z;
  // Cancellation in p + r sqrt n loses at most the bits of p^2 - r^2 n, an integer >= 1.
  const auto bits = static_cast<mpfr_prec_t>(2 * mpz_sizeinbase(a.p.get_mpz_t(), 2) + 128);
  mpfr_inits2(bits, x, y, z, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_z(x, a.p.get_mpz_t(), MPFR_RNDN);
  if (!a.rational()) {
    mpfr_set_z(y, a.n.get_mpz_t(), MPFR_RNDN);
    mpfr_sqrt(y, y, MPFR_RNDN);
    mpfr_mul_z(y, y, a.r.get_mpz_t(), MPFR_RNDN);
    mpfr_add(x, x, y, MPFR_RNDN);
  }
  mpfr_set_z(z, a.q.get_mpz_t(), MPFR_RNDN);
  mpfr_div(x, x, z, MPFR_RNDN);
  const double d = mpfr_get_d(x, MPFR_RNDN);
  mpfr_clears(x, y, z, static_cast<mpfr_ptr>(nullptr));
  const Interval wide = outward(d, d);
  // Underflow and overflow: the sign is known exactly, so no enclosure crosses 0.
  return sign(a) > 0 ? Interval{std::max(wide.lo, 0.0), wide.hi} : Interval{wide.lo, std::min(wide.hi, -0.0)};
}

bool fits_doubles(const Quadratic& a) {
  const auto bits = [](const mpz_class& z) { return mpz_sizeinbase(z.get_mpz_t(), 2); };
  return bits(a.p) < 400 && bits(a.q) < 400 && 2 * bits(a.r) + bits(a.n) < 800;
}

}  // namespace

Interval enclose(const Quadratic& a, bool& cancelled) {
  cancelled = false;
  if (!fits_doubles(a)) {
    cancelled = !a.rational() && sgn(a.p) * sgn(a.r) < 0;
    return enclose_wide(a);
  }
  const Interval q = enclose(a.q);
  if (a.rational()) return is_one(a.q) ? enclose(a.p) : enclose(a.p) / q;
  const Interval p = enclose(a.p), root_part = enclose(a.r) * sqrt(enclose(a.n));
  const Interval sum = p + root_part;
  cancelled = certain_sign(sum) == 0;
  constexpr double kGoodWidth = 0x1p-48;  // relative; a sum without cancellation has about 2^-50
  if (!cancelled && sum.hi - sum.lo <= kGoodWidth * std::min(std::abs(sum.lo), std::abs(sum.hi))) return sum / q;
  const mpz_class norm = a.p * a.p - a.r * a.r * a.n;
  return enclose(norm) / ((p - root_part) * q);  // p and the root part have opposite signs here: no cancellation
}

std::uint64_t hash(const Quadratic& a) {
  std::uint64_t h = 0;
  for (const mpz_class* z : {&a.p, &a.r, &a.q, &a.n}) {
    h = (h ^ mpz_get_ui(z->get_mpz_t()) ^ static_cast<std::uint64_t>(sgn(*z))) * 0x9E3779B97F4A7C15ULL;
    h ^= h >> 29;
  }
  return h;
}

bool same(const Quadratic& a, const Quadratic& b) { return a.p == b.p && a.r == b.r && a.q == b.q && a.n == b.n; }

bool perfect_square_product(const mpz_class& n, const mpz_class& m) {
  const mpz_class product = n * m;
  return mpz_perfect_square_p(product.get_mpz_t()) != 0;
}

}  // namespace findspace::exact::detail
