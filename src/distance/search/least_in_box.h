// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The least value over a box of positions of a function that changes by at most the length of a step. Best first: the
// boxes of least bound (the value at the centre minus half the diagonal) are divided in eight, a fixed number at a time
// whatever the number of threads. Guarantee: `value` is taken at `at`; none in the box is less than `bound`. They agree
// to 2^-30 of the box, unless kMostValues values were not enough. Keywords: Lipschitz optimisation, branch and bound.
#pragma once

#include <functional>

#include "distance/answer/answer.h"
#include "space/polytope/real_vector.h"

namespace findspace::distance {

inline constexpr int kMostValues = 20000;

/// The least of a function that changes by at most the length of a step, over a box; `floor`: a bound that is known.
/// `value` is called from many threads; refused where it is.
exact::Tried<Answer> least_in_box(const std::function<exact::Tried<exact::Real>(const space::RealVector&)>& value,
                                  const space::Vector& low, const space::Vector& high, double floor);

}  // namespace findspace::distance
