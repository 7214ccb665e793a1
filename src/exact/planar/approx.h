// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A double together with a bound on its distance from the exact value: the first stage of every predicate.
// Guarantee: |exact - value| <= error after any sequence of the operations below. Each operation adds the rounding
// error of its own result (half an ulp, bounded by kUnit * |value|) and inflates the bound by kGrow to cover the
// rounding of the bound itself. Cost: two to six floating point operations. Keywords: static filter, running error
// analysis.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace findspace::exact {

struct Approx {
  static constexpr double kUnit = 0x1p-53;
  static constexpr double kGrow = 1 + 0x1p-50;
  static constexpr double kTiny = 0x1p-1000;  // covers underflow of a product

  double value = 0, error = 0;

  /// Certain sign, or 0 when the bound does not decide (or the value is exactly 0).
  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
  bool certain() const { return sign() != 0 || (value == 0 && error == 0); }
  double lo() const { return (value - error) - std::abs(value) * 2 * kUnit; }
  double hi() const { return (value + error) + std::abs(value) * 2 * kUnit; }

  friend Approx operator+(const Approx& p, const Approx& q) {
    double v = p.value + q.value;
    return {v, (p.error + q.error + kUnit * std::abs(v)) * kGrow};
  }
  friend Approx operator-(const Approx& p, const Approx& q) {
    double v = p.value - q.value;
    return {v, (p.error + q.error + kUnit * std::abs(v)) * kGrow};
  }
  friend Approx operator-(const Approx& p) { return {-p.value, p.error}; }
  friend Approx operator*(const Approx& p, const Approx& q) {
    double v = p.value * q.value;
    return {v, (std::abs(p.value) * q.error + std::abs(q.value) * p.error + p.error * q.error + kUnit * std::abs(v)) *
                       kGrow +
                   kTiny};
  }
  friend Approx operator/(const Approx& p, const Approx& q) {
    double least = std::abs(q.value) - q.error;
    if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
    double v = p.value / q.value;
    return {v, ((p.error + std::abs(v) * q.error) / least + 2 * kUnit * std::abs(v)) * kGrow + kTiny};
  }
  /// Square root; the part of the range below zero is ignored (the caller knows the exact value is not negative).
  friend Approx sqrt(const Approx& p) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    if (!(p.value + p.error < kInfinite)) return {0, kInfinite};  // NaN, of an unknown times 0, as well
    if (!(p.value > 0)) return {0, std::sqrt(std::max(0.0, p.value + p.error)) * kGrow};
    double v = std::sqrt(p.value);
    double below = p.value - p.error;
    double spread = below > 0 ? p.error / (v + std::sqrt(below)) : std::max(v, p.error / v);
    return {v, (spread + kUnit * v) * kGrow};
  }
};

/// A bound on an error in half the room: the float nearest to what it is made of if that is not below, else the next
/// one, so above by 2^-23 of it at most. Copies are the same.
class ErrorBound {
 public:
  ErrorBound() = default;
  ErrorBound(double error) {  // NOLINT: implicit on purpose
    const float near = float(error);
    const bool below = double(near) < error;  // added, not asked: every second time it is
    bound_ = std::bit_cast<float>(std::bit_cast<std::uint32_t>(near) + below);
  }
  operator double() const { return double(bound_); }  // NOLINT

  /// |value| times the factor or a little more. The value is 0 or between 2^-70 and 2^127, so that no step leaves its
  /// range; each rounds by 2^-24 at most.
  template <int kUnits>
  static ErrorBound units(double value) {
    constexpr float kMore = float(kUnits * Approx::kUnit) * (1 + 0x1p-22f);
    ErrorBound out;
    out.bound_ = std::abs(float(value)) * kMore;
    return out;
  }

 private:
  float bound_ = 0;
};

}  // namespace findspace::exact
