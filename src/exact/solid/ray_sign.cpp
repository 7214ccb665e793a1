// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/solid/ray_sign.h"

#include <algorithm>
#include <array>

namespace findspace::exact {
namespace {

int128 floor_divide(int128 a, int128 b) {
  const int128 q = a / b;
  return q - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

/// x * y - z * w in 256 bits.
Int256 cross_term(int128 x, int128 y, int128 z, int128 w) { return multiply(x, y) - multiply(z, w); }

/// x . (y x z) in doubles, and the sum of the magnitudes of its terms.
struct Determinant {
  double value, size;

  /// 0 where the rounding may decide: each term has three roundings of factors and at most six of operations, below
  /// 2^-49 of the magnitudes.
  int certain_sign() const {
    const double bound = 0x1p-49 * size;
    return (value > bound) - (value < -bound);
  }
};

Determinant determinant(const Approx3& x, const Approx3& y, const Approx3& z) {
  const double p = y.y * z.z, q = y.z * z.y, r = y.z * z.x, s = y.x * z.z, t = y.x * z.y, o = y.y * z.x;
  return {x.x * (p - q) + x.y * (r - s) + x.z * (t - o), std::fabs(x.x) * (std::fabs(p) + std::fabs(q)) +
                                                             std::fabs(x.y) * (std::fabs(r) + std::fabs(s)) +
                                                             std::fabs(x.z) * (std::fabs(t) + std::fabs(o))};
}

}  // namespace

Fraction reduced(const Fraction& f) {
  if (f.numerator == 0) return {0, 1};
  const int128 g = gcd(f.numerator, f.denominator);
  return {f.numerator / g, f.denominator / g};
}

double to_double(const Fraction& f) {
  // Whole part and rest apart: a quotient of rounded numbers would be good to few bits of a small rest.
  const int128 whole = floor_divide(f.numerator, f.denominator);
  return static_cast<double>(whole) +
         static_cast<double>(f.numerator - whole * f.denominator) / static_cast<double>(f.denominator);
}

int compare_fractions(const Fraction& a, const Fraction& b) {
  if (a.denominator == b.denominator) return sign(a.numerator - b.numerator);
  return cross_term(a.numerator, b.denominator, b.numerator, a.denominator).sign();
}

Fraction between(const Fraction& a, const Fraction& b) {
  // The first dyadic number of the least denominator above a; beyond 2^20 parts of a step, the mediant.
  for (int bits = 0; bits <= 20; bits += 4) {
    const int128 parts = int128(1) << bits;
    const int128 whole = floor_divide(a.numerator, a.denominator);
    const int128 rest = a.numerator - whole * a.denominator;  // below the denominator: the product fits
    const Fraction next{whole * parts + floor_divide(rest * parts, a.denominator) + 1, parts};
    if (compare_fractions(next, b) >= 0) continue;
    // As near to the middle as the same denominator allows.
    const double middle = (to_double(a) + to_double(b)) / 2 * static_cast<double>(parts);
    const Fraction centre{static_cast<int128>(middle), parts};
    const bool inside = compare_fractions(a, centre) < 0 && compare_fractions(centre, b) < 0;
    return inside ? centre : next;
  }
  // The mediant lies strictly between, without larger products.
  const Fraction p = reduced(a), q = reduced(b);
  return {p.numerator + q.numerator, p.denominator + q.denominator};
}

int sign_volume(const Grid3& a, const Grid3& b, const Grid3& c, const Grid3& d) {
  const Grid3 u = b - a, v = c - a, w = d - a;
  const Determinant rounded = determinant(approx(u), approx(v), approx(w));
  if (const int sign = rounded.certain_sign(); sign != 0) return sign;
  if (rounded.size < 0x1p52) return (rounded.value > 0) - (rounded.value < 0);  // nothing was rounded
  const Wide3 n = cross(v, w);
  return (multiply(n.x, u.x) + multiply(n.y, u.y) + multiply(n.z, u.z)).sign();
}

int sign_volume(const RaisedPoint& a, const RaisedPoint& b, const RaisedPoint& c, const RaisedPoint& d,
                const Fraction& by) {
  const int low = sign_volume(a.at, b.at, c.at, d.at);
  if (by.numerator == 0 || (a.raised == b.raised && b.raised == c.raised && c.raised == d.raised)) return low;
  const auto up = [](const RaisedPoint& p) { return Grid3{p.at.x, p.at.y, p.at.z + (p.raised ? 1 : 0)}; };
  const Grid3 p = up(a), q = up(b), r = up(c), s = up(d);
  const int high = sign_volume(p, q, r, s);
  if (low == high) return low;  // the volume is linear in the height
  const auto volume = [](const Grid3& i, const Grid3& j, const Grid3& k, const Grid3& l) {
    const Wide3 n = cross(j - i, k - i);
    const Grid3 e = l - i;
    return multiply(n.x, e.x) + multiply(n.y, e.y) + multiply(n.z, e.z);
  };
  const Int256 bottom = volume(a.at, b.at, c.at, d.at), top = volume(p, q, r, s);
  const Int512 at = multiply(bottom, by.denominator) + multiply(top - bottom, by.numerator);
  return at.sign();
}

int sign_turn(const RaisedPoint& a, const RaisedPoint& b, const RaisedPoint& c, int axis, const Fraction& by) {
  RaisedPoint apex = c;
  (axis == 0 ? apex.at.x : axis == 1 ? apex.at.y : apex.at.z) += 1;
  return sign_volume(a, b, c, apex, by);
}

int compare_coordinate(const RaisedPoint& a, const RaisedPoint& b, int axis, const Fraction& by) {
  const auto one = [](std::int64_t p, std::int64_t q) { return (p > q) - (p < q); };
  if (axis == 0) return one(a.at.x, b.at.x);
  if (axis == 1) return one(a.at.y, b.at.y);
  if (a.raised == b.raised || by.numerator == 0 || a.at.z != b.at.z) {
    // A whole step apart outweighs a fraction of one, but for the raised point exactly one step below: still below.
    return one(a.at.z, b.at.z);
  }
  return a.raised ? 1 : -1;
}

int lexicographic_sign_cross(const Wide3& l, const Wide3& m) {
  if (const int x = cross_term(l.y, m.z, l.z, m.y).sign(); x != 0) return x;
  if (const int y = cross_term(l.z, m.x, l.x, m.z).sign(); y != 0) return y;
  return cross_term(l.x, m.y, l.y, m.x).sign();
}

int sign_triple(const Wide3& l, const Wide3& m, const Wide3& n) {
  if (const int sign = determinant(approx(l), approx(m), approx(n)).certain_sign(); sign != 0) return sign;
  Int512 sum = multiply(cross_term(m.y, n.z, m.z, n.y), l.x);
  sum += multiply(cross_term(m.z, n.x, m.x, n.z), l.y);
  sum += multiply(cross_term(m.x, n.y, m.y, n.x), l.z);
  return sum.sign();
}

}  // namespace findspace::exact
