// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/number/real_size.h"

#include "exact/number/expression_sign.h"

namespace findspace::exact {

double sign_bits(const Real& x) { return detail::separation_bits(x); }

}  // namespace findspace::exact
