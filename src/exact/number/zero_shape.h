// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a plan is as algebra (zero_proof.h): a variable for every root; every step a numerator, which is a polynomial in
// the variables with integer coefficients, over a product of integers and of numerators of steps; and a bound of the
// sum of the numerator's coefficients. Internal to src/exact.
#pragma once

#include <vector>

#include "exact/number/powers.h"
#include "exact/number/real_plan.h"

namespace findspace::exact::detail {

/// A step; before operands are joined they are multiplied by some factors.
struct Fraction {
  double size = 0;  // log2 of a bound of the sum of the numerator's coefficients
  Powers below, times_a, times_b;
  std::vector<Powers> times;  // of a polynomial's coefficients
  int variable = -1;          // of a root
  unsigned variables = 0;     // that it is made of, its own too: a bit each
};

/// What divides: an integer, or the numerator of a step.
struct Factor {
  mpz_class integer;
  int step = -1;
};

class ZeroShape {
 public:
  ZeroShape(const Plan& plan, std::size_t most_coefficients);

  bool possible() const { return possible_; }  // not more coefficients than that
  const Plan& plan() const { return plan_; }
  const std::vector<Fraction>& fractions() const { return fractions_; }
  const std::vector<Factor>& factors() const { return factors_; }

 private:
  int integer_factor(const mpz_class& q);
  int step_factor(int step);
  double size_of(const Powers& product) const;
  Fraction over(double size, const mpz_class& q);
  Fraction variable(double size, std::size_t degree);
  Fraction root_of(double radicand);
  Fraction polynomial(const Step& step);
  Fraction leaf(const Step& step, double root);
  Fraction sum(const Fraction& a, const Fraction& b) const;
  Fraction product(const Fraction& a, const Fraction& b) const;
  Fraction quotient(const Fraction& a, const Fraction& b, int divisor);
  Fraction square_root(const Fraction& a);
  Fraction fraction_of(const Step& step);

  const Plan& plan_;
  std::size_t most_coefficients_;
  std::vector<Fraction> fractions_;
  std::vector<Factor> factors_;
  std::size_t coefficients_ = 1;
  int variables_ = 0;
  bool possible_ = true;
};

}  // namespace findspace::exact::detail
