// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Evaluation of a plan in balls: all steps at one precision, in one block of memory. Internal to src/exact.
#pragma once

#include <vector>

#include "exact/number/real_ball.h"
#include "exact/number/real_plan.h"

namespace findspace::exact::detail {

class Balls {
 public:
  Balls(const Plan& plan, mpfr_prec_t precision);
  const Ball& root() const { return balls_[root_]; }

 private:
  void evaluate(const Step& step);
  void evaluate_small(const Small& value);
  void evaluate_leaf(const Step& step);

  std::vector<mp_limb_t> limbs_;
  std::vector<Ball> balls_;
  mpz_class arena_;
  int root_;
};

}  // namespace findspace::exact::detail
