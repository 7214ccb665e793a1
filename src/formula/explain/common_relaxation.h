// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least t for which the formula holds somewhere when every level moves by t to the side that leaves more room: `<=`
// up, `>=` down, `=` both ways. The feasible sets grow with t, so bisection encloses it. Guarantee: exact regions
// decide at both ends, which are decimals at most a thousandth of `upper` apart, or of a grid step. Cost: some fifteen
// regions, or maps of the circle. Keywords: elastic programming, Chebyshev relaxation, bisection.
#pragma once

#include <functional>

#include "formula/explain/explain.h"

namespace findspace::formula {

/// A place where a formula holds, if there is one.
using FindPlace = std::function<std::optional<RemainingPlace>(const Formula&)>;

/// `step`: of the grid. `enough`: an amount that is known to leave a place, if one is. Precondition: 0 leaves none.
CommonRelaxation common_relaxation(const FindPlace& find, const exact::Real& step, const Demands& demands,
                                   const std::optional<exact::Real>& enough);

/// A power of ten of which the amount, which is above 0, has a thousand parts and less than ten thousand.
exact::Real decimal_part(const exact::Real& amount);

}  // namespace findspace::formula
