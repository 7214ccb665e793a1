// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What samples say for certain about the places around them: a T-distance is 1-Lipschitz
// (distances.md 3.7). If `widened(f, w)` does not hold at q, f holds nowhere within w of q; if `narrowed(f, w)` holds
// at q, f holds everywhere within w of q. So cells of radius w about the places where one or the other holds are an
// outer and an inner bound of the region. Unless w is 0, the one holds at its levels and the other does not. So signs
// that a search leaves at 0 near a level (side.h) err to the same side. Guarantee: exact, for formulas over plain
// T-distances. Keywords: Lipschitz bound, conservative rasterisation, inner and outer approximation.
#pragma once

#include "formula/language/formula.h"

namespace findspace::formula {

/// `by` >= 0 in the scene's unit. No atom may ask for a minimum.
Formula widened(const Formula& formula, const exact::Real& by);
Formula narrowed(const Formula& formula, const exact::Real& by);

}  // namespace findspace::formula
