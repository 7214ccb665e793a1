// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A proof that a plan of square roots is 0, by algebra. With a variable t_i for every root, t_i^2 being its radicand,
// the value is a fraction whose numerator is a polynomial with integer coefficients, linear in every t_i. If it is the
// polynomial 0, so is the value, whichever numbers the roots are. Zeros that come from an identity (a corner turned
// onto a circle lies on it) are of this kind; others, where one root is a combination of others, are not, and no proof
// is found: then the separation bound decides (real_bound.h).
//
// Method: the coefficients modulo primes below 2^31, until the product of these exceeds the greatest coefficient
// possible, which is bounded on the way with |t_i| replaced by a bound of at least 1. Guarantee: true only where the
// value is 0. Cost: for k roots up to 4^k products a step and a prime, one prime where there is no proof; the primes
// are as many as the bound needs divided by 2^k. Source: this is the separation bound's argument with all conjugates at
// once. Internal to src/exact. Keywords: zero test, multiquadratic field, Chinese remainders.
#pragma once

#include "exact/real_plan.h"

namespace findspace::exact::detail {

bool proves_zero(const Plan& plan);

}  // namespace findspace::exact::detail
