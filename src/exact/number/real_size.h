// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How long an exact number is: the bits to which it may have to be computed before a sign about it is certain, from the
// root bound of its expression. Numbers that are computed from computed numbers double it at every step or more.
// Guarantee: an upper bound. Cost: linear in the expression. Keywords: separation bound, bit complexity.
#pragma once

#include "exact/number/real.h"

namespace findspace::exact {

double sign_bits(const Real& x);

}  // namespace findspace::exact
