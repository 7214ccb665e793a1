// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A proof that a plan is 0, by algebra. With a variable for every root, which satisfies its radicand's or polynomial's
// equation, the value is a fraction whose numerator is a polynomial in the variables with integer coefficients. If it
// is the polynomial 0, so is the value, whichever numbers the roots are: zeros that come from an identity (a corner
// turned onto a circle lies on it) are of this kind. Where a square root is a combination of other roots, the numerator
// times that with the root's sign changed is the polynomial 0, for one root or two; then the value is 0 if those with
// changed signs are not. For what is left the separation bound decides (real_bound.h).
//
// Method: the coefficients modulo primes below 2^31 (modular_tower.h), until the product of these exceeds the greatest
// coefficient possible; that is bounded on the way, with numbers of at least 1 that satisfy the equations with absolute
// values for the variables. Guarantee: true only where the value is 0. Cost: for D the product of the roots' degrees up
// to D^2 products a step and a prime, one prime where there is no proof; the primes are as many as the separation bound
// needs divided by D. Internal to src/exact. Keywords: zero test, algebraic numbers, norm, Chinese remainders.
#pragma once

#include "exact/number/real_plan.h"

namespace findspace::exact::detail {

/// `most_coefficients`: the product of the roots' degrees for which it is tried.
bool proves_zero(const Plan& plan, std::size_t most_coefficients = 768);

}  // namespace findspace::exact::detail
