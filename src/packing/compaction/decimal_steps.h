// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The decimal grid on which a layout is given: numbers of the search rounded to it, and exact ones next to it. It is
// fine enough for the size of the layout; next to a step of the problem's own grid a number goes there, where stacks
// without clearance stand. Guarantee: above() and below() are exact. Keywords: snap rounding.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/margins/packing.h"
#include "packing/problem/fraction.h"

namespace findspace::packing {

class DecimalSteps {
 public:
  DecimalSteps(int problem_digits, double size, int least_digits = 0) : problem_digits_(problem_digits) {
    while (double(power_of_ten(digits_)) * size * margin::kLayoutGrid < 1) ++digits_;
    digits_ = std::max(digits_, std::min(least_digits, digits_ + 2));
  }

  int digits() const { return digits_; }
  int128 in_one() const { return power_of_ten(digits_); }
  double step() const { return 1 / double(in_one()); }

  /// The step nearest to a value; that of the problem's grid within `snap` steps.
  int128 nearest(double value, double snap) const {
    const int128 fine = int128(std::llround(value * double(in_one())));
    if (snap == 0 || problem_digits_ > digits_) return fine;
    const double coarse = double(power_of_ten(problem_digits_)), own = std::round(value * coarse) / coarse;
    return std::abs(own - value) <= snap * step() ? nearest(own, 0) : fine;
  }
  /// The least step that is not below a value, and the greatest not above one.
  int128 above(const Fraction& value) const { return -below(0 - value); }
  int128 below(const Fraction& value) const {
    const int128 scaled = bounded_product(value.numerator(), in_one()), d = value.denominator();
    return scaled >= 0 ? scaled / d : -((-scaled + d - 1) / d);
  }

 private:
  int problem_digits_;
  int digits_ = 0;
};

}  // namespace findspace::packing
