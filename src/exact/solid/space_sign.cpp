// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/solid/space_sign.h"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

namespace findspace::exact {
namespace {

using uint128 = unsigned __int128;

uint128 magnitude(int128 v) { return v < 0 ? -static_cast<uint128>(v) : static_cast<uint128>(v); }

int bits(int128 v) {
  const uint128 m = magnitude(v);
  const auto high = static_cast<std::uint64_t>(m >> 64), low = static_cast<std::uint64_t>(m);
  return high ? 128 - std::countl_zero(high) : 64 - std::countl_zero(low);
}

/// A number of GMP with a life time.
class Big {
 public:
  Big() { mpz_init(v_); }
  explicit Big(int128 value) : Big() {
    const uint128 m = magnitude(value);
    mpz_set_ui(v_, static_cast<unsigned long>(m >> 64));
    mpz_mul_2exp(v_, v_, 64);
    mpz_add_ui(v_, v_, static_cast<unsigned long>(m));
    if (value < 0) mpz_neg(v_, v_);
  }
  Big(const Big&) = delete;
  Big& operator=(const Big&) = delete;
  ~Big() { mpz_clear(v_); }
  mpz_t& get() { return v_; }

 private:
  mpz_t v_;
};

/// A double as mantissa * 2^exponent with an odd mantissa (or 0, with the exponent 0).
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

Dyadic split(double value) {
  if (value == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa >> zeros, exponent - 53 + zeros};
}

/// The three coordinates over one power of two: coordinate i is mantissa[i] * 2^(up[i] - down), down >= 0, up >= 0.
struct DyadicPoint {
  std::array<Dyadic, 3> part;
  int down = 0;
  DyadicPoint(double x, double y, double z) : part{split(x), split(y), split(z)} {
    for (const Dyadic& p : part) down = std::max(down, -p.exponent);
  }
  int up(int i) const { return part[i].exponent + down; }
};

/// sum = (n . x + d) * 2^down with GMP.
void scaled_value(Big& sum, const Wide3& n, int128 d, const DyadicPoint& at) {
  mpz_set(sum.get(), Big(d).get());
  mpz_mul_2exp(sum.get(), sum.get(), static_cast<mp_bitcnt_t>(at.down));
  const std::array<int128, 3> normal{n.x, n.y, n.z};
  for (int i = 0; i < 3; ++i) {
    if (normal[i] == 0 || at.part[i].mantissa == 0) continue;
    Big term(normal[i]);
    mpz_mul_si(term.get(), term.get(), at.part[i].mantissa);
    mpz_mul_2exp(term.get(), term.get(), static_cast<mp_bitcnt_t>(at.up(i)));
    mpz_add(sum.get(), sum.get(), term.get());
  }
}

/// The fixed width stage: (n . x + d) * 2^down if it surely fits in int128.
bool narrow_value(const Wide3& n, int128 d, const DyadicPoint& at, int128& sum) {
  const std::array<int128, 3> normal{n.x, n.y, n.z};
  if (d != 0 && bits(d) + at.down > 124) return false;
  for (int i = 0; i < 3; ++i) {
    if (at.part[i].mantissa == 0 || normal[i] == 0) continue;
    if (bits(normal[i]) + bits(at.part[i].mantissa) + at.up(i) > 124) return false;
  }
  sum = d == 0 ? 0 : d * (static_cast<int128>(1) << at.down);
  for (int i = 0; i < 3; ++i) {
    if (at.part[i].mantissa == 0 || normal[i] == 0) continue;
    sum += normal[i] * at.part[i].mantissa * (static_cast<int128>(1) << at.up(i));
  }
  return true;
}

void squared_length(Big& sum, const Wide3& n) {
  mpz_set_ui(sum.get(), 0);
  for (const int128 c : {n.x, n.y, n.z}) {
    Big part(c);
    mpz_addmul(sum.get(), part.get(), part.get());
  }
}

}  // namespace

int128 gcd(int128 a, int128 b) {
  uint128 p = magnitude(a), q = magnitude(b);
  while ((q >> 64) != 0 || ((p >> 64) != 0 && q != 0)) {
    p %= q;
    std::swap(p, q);
  }
  if (q == 0) return static_cast<int128>(p);
  return static_cast<int128>(std::gcd(static_cast<std::uint64_t>(p), static_cast<std::uint64_t>(q)));
}

Wide3 primitive(const Wide3& n) {
  const int128 g = gcd(gcd(n.x, n.y), n.z);
  if (g == 1) return n;
  const auto narrow = [](int128 v) { return v == static_cast<std::int64_t>(v); };
  if (narrow(n.x) && narrow(n.y) && narrow(n.z) && narrow(g)) {
    const auto h = static_cast<std::int64_t>(g);
    return {static_cast<std::int64_t>(n.x) / h, static_cast<std::int64_t>(n.y) / h, static_cast<std::int64_t>(n.z) / h};
  }
  return {n.x / g, n.y / g, n.z / g};
}

Approx3 approx(const Wide3& n) {
  const auto one = [](int128 v) {
    const auto low = static_cast<std::int64_t>(v);
    return low == v ? static_cast<double>(low) : static_cast<double>(v);
  };
  return {one(n.x), one(n.y), one(n.z)};
}

int sign_plane_at(const Wide3& n, int128 d, double x, double y, double z) {
  // Filter: four roundings of the inputs, three products, three sums.
  const Approx3 s = approx(n);
  const double a = s.x * x, b = s.y * y, c = s.z * z, e = static_cast<double>(d);
  const double sum = ((a + b) + c) + e;
  const double bound = 0x1p-49 * (((std::fabs(a) + std::fabs(b)) + std::fabs(c)) + std::fabs(e));
  if (bound > 0x1p-900 && std::fabs(sum) > bound) return sum > 0 ? 1 : -1;
  const DyadicPoint at(x, y, z);
  int128 narrow = 0;
  if (narrow_value(n, d, at, narrow)) return sign(narrow);
  Big value;
  scaled_value(value, n, d, at);
  return mpz_sgn(value.get());
}

double value_plane_at(const Wide3& n, int128 d, double x, double y, double z) {
  const DyadicPoint at(x, y, z);
  Big value;
  scaled_value(value, n, d, at);
  // mpz_get_d truncates: keep 53 bits and round the rest to nearest by hand.
  const auto size = mpz_sizeinbase(value.get(), 2);
  if (size <= 53) return std::ldexp(mpz_get_d(value.get()), -at.down);
  const auto drop = static_cast<mp_bitcnt_t>(size - 53);
  const bool negative = mpz_sgn(value.get()) < 0;
  mpz_abs(value.get(), value.get());
  const bool half = mpz_tstbit(value.get(), drop - 1) != 0;
  const bool tail = mpz_scan1(value.get(), 0) < drop - 1;
  mpz_fdiv_q_2exp(value.get(), value.get(), drop);
  if (half && (tail || mpz_odd_p(value.get()))) mpz_add_ui(value.get(), value.get(), 1);
  const double rounded = std::ldexp(mpz_get_d(value.get()), static_cast<int>(drop) - at.down);
  return negative ? -rounded : rounded;
}

int compare_planes_at(const Wide3& n, int128 d, const Wide3& m, int128 e, double x, double y, double z) {
  const DyadicPoint at(x, y, z);
  Big a, b, p, q;
  scaled_value(a, n, d, at);
  scaled_value(b, m, e, at);
  const int sa = mpz_sgn(a.get()), sb = mpz_sgn(b.get());
  if (sa != sb) return sa < sb ? -1 : 1;
  if (sa == 0) return 0;
  squared_length(p, n);
  squared_length(q, m);
  mpz_mul(a.get(), a.get(), a.get());
  mpz_mul(a.get(), a.get(), q.get());
  mpz_mul(b.get(), b.get(), b.get());
  mpz_mul(b.get(), b.get(), p.get());
  const int order = mpz_cmp(a.get(), b.get());
  return sa * ((order > 0) - (order < 0));
}

}  // namespace findspace::exact
