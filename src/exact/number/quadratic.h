// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The closed form (p + r*sqrt(n)) / q: one number of the field Q(sqrt n), or a rational where r = 0.
// Invariant: q > 0; gcd(p, r, q) = 1; r = 0 exactly if n = 0; otherwise n > 1 is not a perfect square and has no square
// factor 4, 9, 25, 49 (only to keep numbers short: fields are compared by "n*m is a square", which needs no factoring).
// So equal numbers of one n have equal fields p, r, q, and the sign is found by comparing p^2 with r^2 n.
// Internal to src/exact: this header brings in GMP.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>

#include "exact/number/interval.h"

namespace findspace::exact::detail {

struct Quadratic {
  mpz_class p, r, q{1}, n;

  bool rational() const { return sgn(r) == 0; }
};

void set(mpz_class& z, int128 value);
bool fits_int128(const mpz_class& z);
int128 to_int128(const mpz_class& z);  // where it fits

Quadratic quadratic_of(int128 value);
/// numerator / denominator, reduced; the denominator is not 0.
Quadratic quadratic_ratio(mpz_class numerator, mpz_class denominator);

int sign(const Quadratic& a);
Quadratic negate(const Quadratic& a);

/// Nothing where the operands lie in two different quadratic fields.
std::optional<Quadratic> add(const Quadratic& a, const Quadratic& b);
std::optional<Quadratic> subtract(const Quadratic& a, const Quadratic& b);
std::optional<Quadratic> multiply(const Quadratic& a, const Quadratic& b);
std::optional<Quadratic> divide(const Quadratic& a, const Quadratic& b);  // b != 0
/// Nothing where the root leaves the field (always found for rationals). The argument is >= 0.
std::optional<Quadratic> root(const Quadratic& a);

/// Enclosure of a, with relative width about 2^-50 wherever its parts fit doubles, cancellation or not.
/// `cancelled` tells whether p + r*sqrt(n) in doubles alone would have left the sign open.
Interval enclose(const Quadratic& a, bool& cancelled);
Interval enclose(const mpz_class& z);
using exact::enclose;

std::uint64_t hash(const Quadratic& a);
bool same(const Quadratic& a, const Quadratic& b);
bool perfect_square_product(const mpz_class& n, const mpz_class& m);

}  // namespace findspace::exact::detail
