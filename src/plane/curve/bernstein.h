// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Polynomials on [0, 1] by their Bernstein coefficients: products, differences, subdivision. A polynomial whose
// coefficients all lie in [a, b] lies there itself, so signs of coefficients prove signs of polynomials.
// Guarantee: with intervals, the coefficients of the true polynomial are enclosed. Cost: O(n^2) an operation.
// Source: Farouki, "The Bernstein polynomial basis: a centennial retrospective" (2012).
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "exact/number/interval.h"

namespace findspace::plane {

template <class T>
using Coefficients = std::vector<T>;
using IntervalPolynomial = Coefficients<exact::Interval>;

/// The highest degree that is multiplied: binomials stay whole numbers of a double.
inline constexpr std::size_t kMostDegree = 25;

/// n over k, exact up to n = 2 * kMostDegree.
inline double binomial(std::size_t n, std::size_t k) {
  double value = 1;
  for (std::size_t i = 1; i <= std::min(k, n - k); ++i) value = value * double(n - i + 1) / double(i);
  return value;
}

inline IntervalPolynomial product(const IntervalPolynomial& a, const IntervalPolynomial& b) {
  using exact::Interval;
  const std::size_t n = a.size() - 1, m = b.size() - 1;
  IntervalPolynomial out(n + m + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= m; ++j) {
      const double factor = binomial(n, i) * binomial(m, j), whole = binomial(n + m, i + j);
      const Interval weight = exact::outward(factor, factor) / Interval{whole, whole};
      out[i + j] = out[i + j] + weight * (a[i] * b[j]);
    }
  }
  return out;
}

inline IntervalPolynomial sum(IntervalPolynomial a, const IntervalPolynomial& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] + b[i];
  return a;
}

inline IntervalPolynomial difference(IntervalPolynomial a, const IntervalPolynomial& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] - b[i];
  return a;
}

inline IntervalPolynomial scaled(IntervalPolynomial a, const exact::Interval& by) {
  for (exact::Interval& c : a) c = c * by;
  return a;
}

/// The derivative over the degree: differences of neighbours.
inline IntervalPolynomial hodograph(const IntervalPolynomial& a) {
  IntervalPolynomial out;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) out.push_back(a[i + 1] - a[i]);
  return out;
}

/// The same polynomial on [0, t] and on [t, 1].
inline std::pair<IntervalPolynomial, IntervalPolynomial> split(IntervalPolynomial a, const exact::Interval& t) {
  using exact::Interval;
  const Interval left = Interval{1, 1} - t;
  IntervalPolynomial first{a.front()}, last{a.back()};
  for (std::size_t n = a.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = left * a[i] + t * a[i + 1];
    a.pop_back();
    first.push_back(a.front());
    last.push_back(a.back());
  }
  std::reverse(last.begin(), last.end());
  return {std::move(first), std::move(last)};
}

}  // namespace findspace::plane
