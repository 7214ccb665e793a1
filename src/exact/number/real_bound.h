// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Root separation bounds: how near 0 the value of a plan can be without being 0.
//
// BFMSS (ESA 2001, theorem 1). Rewriting without divisions, every step is U/L with algebraic integers U, L, all
// conjugates of which are at most u and l in magnitude:
//     (p + r sqrt n)/q:  u = |p| + |r| sqrt n,        l = q
//     a +- b:            u = ua lb + la ub,           l = la lb
//     a * b:             u = ua ub,                   l = la lb
//     a / b:             u = ua lb,                   l = la ub
//     sqrt(a):           u = sqrt(ua la), l = la   if ua >= la,   else  u = ua, l = sqrt(ua la)
// If the value is not 0 then |value| >= 1 / (l u^(D-1)), where D bounds the degree: 2 for every distinct root, nested
// ones as well; plain roots sqrt(n_i) count only as far as they are independent modulo squares.
//
// Roots r of polynomials P_r, of degree n_r over a field of degree D_r, with integral coefficients of euclidean norm at
// most m_r under every conjugation. There U and L are polynomials in the roots: at every place v of the number field
//     |U|_v <= u_v * product of max(1, |r|_v)^d_r,    u_v = u where v is infinite, 1 where it is finite.
// The product formula, and Mahler's bound (the heights of all conjugates of r together are at most log m_r for each of
// the D_r conjugates of P_r), give, D being the product of all degrees,
//     |U| >= 1 / (u^(D-1) * product of m_r^(d_r D / n_r)).
// The denominator L is kept as a product of powers of the numerators it came from, so that sums of fractions with
// common factors, such as the sines and cosines of one angle, do not multiply them up.
// Logarithms are kept as doubles and rounded up by far more than the error of log2. Internal to src/exact.
// Keywords: BFMSS, Mahler measure, height, Liouville inequality.
#pragma once

#include "exact/number/real_plan.h"

namespace findspace::exact::detail {

/// A value below 2^-result in magnitude is 0. Throws Error(kUnsupported) where a polynomial's coefficients are
/// themselves made of roots of polynomials.
double separation_bits(const Plan& plan);
double degree_bound(const Plan& plan);

}  // namespace findspace::exact::detail
