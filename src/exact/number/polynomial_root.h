// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Real roots of polynomials as exact numbers. A polynomial is the list of its coefficients, of 1, x, x^2 ...; these are
// Reals without roots of polynomials in them.
//
// Method: between the roots of its derivative, found first, a polynomial is monotone, and the signs of its values at
// them and at the ends tell where it has roots; where the derivative has none, as seen in intervals, at once. A root of
// P that is one of P' as well is found as that, where it is simple or a root of P'' in turn. A root is kept as a square
// root where the degree is 2, else as a leaf of the expression graph with its polynomial (real_node.h).
// Guarantee: all roots in the interval, each once, exact. Cost: a few signs; where P and P' nearly have a common root,
// a few signs of P at roots of P'. Source: the method of Rolle; Mignotte, Mathematics for Computer Algebra (1992).
// Keywords: real root isolation, algebraic number, RootOf.
#pragma once

#include <span>
#include <vector>

#include "exact/number/real.h"

namespace findspace::exact {

using Polynomial = std::vector<Real>;

Real value_at(std::span<const Real> polynomial, const Real& x);

/// The roots in [lo, hi], lo < hi rational; ascending. None of the polynomial 0.
/// Throws Error(kUnsupported) for two roots within 2^-120 of each other.
std::vector<Real> roots_between(Polynomial polynomial, const Real& lo, const Real& hi);

/// No less than the number's algebraic degree, from the roots it is made of. What decides a zero made with it costs
/// grows with it.
double degree_bound(const Real& x);

}  // namespace findspace::exact
