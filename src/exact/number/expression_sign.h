// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Signs and doubles of expression graphs: evaluation in growing precision against the root separation bound.
// Internal to src/exact.
#pragma once

#include "exact/number/real.h"

namespace findspace::exact::detail {

struct Evaluation {
  int sign = 0;      // exact
  double value = 0;  // nearest double up to a relative error of 2^-relative_bits
};

/// Exact sign; with relative_bits > 0 also a value of that accuracy. Counts no stage unless `count`.
Evaluation evaluate(const Real& x, int relative_bits, bool count);

/// log2 of 1/bound, where a value below the bound in magnitude is 0 (for tests and for the curious).
double separation_bits(const Real& x);

}  // namespace findspace::exact::detail
