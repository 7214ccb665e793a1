// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact real numbers closed under + - * / and sqrt, with exact signs.
//
// A Real is an immutable value. It is held in the simplest of three forms:
//   * a rational with 128 bits above and 63 below the line, inline (no allocation); in particular integers;
//   * the closed form (p + r*sqrt(n)) / q with big integers, evaluated eagerly: all rationals, and all numbers of one
//     quadratic field, such as the offset c0 + c1*sqrt(a^2+b^2) of a line. Two fields that are the same one
//     (n*m a square) are recognised. Signs by squaring;
//   * an expression graph over those, whose nodes carry a double enclosure found when they are made; its leaves may
//     also be roots of polynomials (polynomial_root.h).
// Guarantee: sign() and compare() are exact for every input. In the graph form a sign is found by evaluation with
//   growing precision until the enclosure excludes 0 or falls below the root separation bound, which proves 0.
//   A sign that would need more than 2^33 bits, of all nodes together, is refused with Error(kUnsupported), never
//   guessed.
// Cost: inline rationals 10 to 60 ns an operation; other closed forms 300 ns or more; a graph node 40 ns (one
//   allocation); its sign 1 ns where the enclosure decides, else microseconds (3 for degree 4 with 2^40 coordinates,
//   100 for degree 16), growing with 2^k * bits for k distinct roots.
// Threads: reading one Real from many threads is safe (the reference count is atomic, nodes never change).
// Source: Burnikel, Funke, Mehlhorn, Schirra, Schmitt, "A separation bound for real algebraic expressions" (ESA 2001).
// Keywords: exact geometric computation, algebraic number, lazy number, separation bound, leda_real, CORE.
#pragma once

#include <array>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "exact/number/interval.h"

namespace findspace::exact {

namespace detail {
struct Access;
enum class NodeKind : std::uint8_t { kRational, kQuadratic, kPolynomialRoot, kNeg, kAdd, kSub, kMul, kDiv, kSqrt };
/// What every node starts with; the rest is known to the .cpp files only.
struct Node {
  Node(NodeKind kind_of, Interval enclosure) : kind(kind_of), interval(enclosure) {}
  std::atomic<std::uint32_t> references{1};
  NodeKind kind;
  Interval interval;
};
void destroy(Node* node) noexcept;  // without recursion: graphs may be deep
}  // namespace detail

class Real {
 public:
  Real() noexcept = default;  // 0, allocates nothing
  template <std::integral T>
  Real(T value) noexcept : numerator_(value) {}       // NOLINT: exact, implicit on purpose
  Real(int128 value) noexcept : numerator_(value) {}  // NOLINT
  Real(double) = delete;                              // say from_double or parse_decimal
  /// numerator / denominator; throws Error(kBadValue) if the denominator is 0.
  static Real ratio(int128 numerator, int128 denominator);
  /// The exact dyadic value; throws Error(kBadValue) for NaN and infinities.
  static Real from_double(double finite);
  /// "1.1" = 11/10, "2.5e-3"; throws Error(kSyntax), and Error(kOutOfRange) for absurd exponents. See decimal.h.
  static Real parse_decimal(std::string_view text);

  Real(const Real& other) noexcept
      : numerator_(other.numerator_), denominator_(other.denominator_), node_(other.node_) {
    if (node_) node_->references.fetch_add(1, std::memory_order_relaxed);
  }
  Real(Real&& other) noexcept
      : numerator_(other.numerator_), denominator_(other.denominator_), node_(std::exchange(other.node_, nullptr)) {}
  Real& operator=(Real other) noexcept {
    std::swap(node_, other.node_);
    numerator_ = other.numerator_;
    denominator_ = other.denominator_;
    return *this;
  }
  ~Real() {
    if (node_ && node_->references.fetch_sub(1, std::memory_order_acq_rel) == 1) detail::destroy(node_);
  }

  friend Real operator+(const Real&, const Real&);
  friend Real operator-(const Real&, const Real&);
  friend Real operator*(const Real&, const Real&);
  friend Real operator/(const Real&, const Real&);  // throws Error(kBadValue) if the divisor is exactly 0
  Real operator-() const;
  friend Real sqrt(const Real&);  // throws Error(kBadValue) if the argument is negative
  Real& operator+=(const Real& b) { return *this = *this + b; }
  Real& operator-=(const Real& b) { return *this = *this - b; }
  Real& operator*=(const Real& b) { return *this = *this * b; }
  Real& operator/=(const Real& b) { return *this = *this / b; }

  int sign() const;                              // exact: -1, 0, +1
  friend int compare(const Real&, const Real&);  // exact: sign of the difference
  friend bool operator==(const Real& a, const Real& b) { return compare(a, b) == 0; }
  friend bool operator<(const Real& a, const Real& b) { return compare(a, b) < 0; }
  friend bool operator>(const Real& a, const Real& b) { return compare(a, b) > 0; }
  friend bool operator<=(const Real& a, const Real& b) { return compare(a, b) <= 0; }
  friend bool operator>=(const Real& a, const Real& b) { return compare(a, b) >= 0; }

  /// Enclosure known without further work.
  Interval interval() const {
    if (node_) return node_->interval;
    return denominator_ == 1 ? enclose(numerator_) : enclose(numerator_) / enclose(denominator_);
  }
  /// Relative error at most 2^-52, also after cancellation; 0 for zero.
  double to_double() const;
  /// Known to be rational (held as one). False does not prove it irrational.
  bool is_rational() const { return !node_ || node_->kind == detail::NodeKind::kRational; }
  /// Held as an integer or as (p + r*sqrt(n)) / q, so that its sign never needs a separation bound.
  bool is_closed() const { return !node_ || node_->kind <= detail::NodeKind::kQuadratic; }
  /// The value, when held as a rational integer that fits.
  std::optional<int128> integer() const {
    return node_ || denominator_ != 1 ? std::nullopt : std::optional<int128>(numerator_);
  }
  /// Numerator and positive denominator in lowest terms, when held as a rational whose parts fit.
  std::optional<std::array<int128, 2>> fraction() const;
  /// Integers in full, otherwise the shortest decimal that reads back as to_double(); for messages.
  std::string text() const;

 private:
  friend struct detail::Access;
  explicit Real(detail::Node* adopted) noexcept : node_(adopted) {}
  Real(int128 numerator, std::int64_t denominator) noexcept : numerator_(numerator), denominator_(denominator) {}

  // The value where node_ is null: reduced, the denominator positive.
  int128 numerator_ = 0;
  std::int64_t denominator_ = 1;
  detail::Node* node_ = nullptr;  // counted
};

Real sqrt(const Real&);
int compare(const Real&, const Real&);
/// Exact where both are closed forms; else of the values rounded once, as deep roots are costly to compare: 0 where
/// they are one double.
int compare_if_closed(const Real&, const Real&);
Real abs(const Real&);
/// Greatest integer <= x and nearest integer (ties away from zero); throw Error(kOutOfRange) beyond 2^126.
int128 floor(const Real&);
int128 round(const Real&);

}  // namespace findspace::exact
