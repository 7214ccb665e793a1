// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Signed integers of 256 and 512 bits: the fixed-width stage of the predicates, between the double filter and GMP.
// Two's complement in 64-bit limbs, lowest first. Arithmetic is exact as long as the result fits; the caller bounds
// its degrees so that it does (sums wrap silently, products are always exact as their result type is wide enough).
// Cost: a few ns, no allocation, no branches in add and multiply.
// Keywords: int256, int512, fixed width big integer, multiprecision.
#pragma once

#include <bit>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace findspace::exact {

using int128 = __int128;
using uint128 = unsigned __int128;

template <int N>
struct WideInt {
  std::uint64_t limb[N] = {};

  WideInt() = default;
  WideInt(int128 value) {  // NOLINT: exact, implicit on purpose
    limb[0] = static_cast<std::uint64_t>(value);
    limb[1] = static_cast<std::uint64_t>(value >> 64);
    fill_sign<2>();
  }
  /// Sign extension from a narrower integer.
  template <int M>
  requires(M < N) WideInt(const WideInt<M>& narrow) {  // NOLINT: exact, implicit on purpose
    for (int i = 0; i < M; ++i) limb[i] = narrow.limb[i];
    fill_sign<M>();
  }

  /// a * b, sign-extended to this width: Int256::product(int128, int128), Int512::product(Int256, int128 or Int256).
  static WideInt product(int128 a, int128 b);
  template <int M>
  static WideInt product(const WideInt<M>& a, int128 b);
  template <int M>
  static WideInt product(const WideInt<M>& a, const WideInt<M>& b);

  bool negative() const { return static_cast<std::int64_t>(limb[N - 1]) < 0; }
  int sign() const {
    std::uint64_t any = 0;
    for (int i = 0; i < N; ++i) any |= limb[i];
    return negative() ? -1 : any != 0;
  }

  friend WideInt operator+(const WideInt& a, const WideInt& b) {
    WideInt sum;
    std::uint64_t carry = 0;
    for (int i = 0; i < N; ++i) {
      const uint128 t = static_cast<uint128>(a.limb[i]) + b.limb[i] + carry;
      sum.limb[i] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    return sum;
  }
  friend WideInt operator-(const WideInt& a, const WideInt& b) {
    WideInt difference;
    std::uint64_t borrow = 0;
    for (int i = 0; i < N; ++i) {
      const uint128 t = static_cast<uint128>(a.limb[i]) - b.limb[i] - borrow;
      difference.limb[i] = static_cast<std::uint64_t>(t);
      borrow = static_cast<std::uint64_t>(t >> 64) & 1;
    }
    return difference;
  }
  WideInt operator-() const { return WideInt() - *this; }
  WideInt& operator+=(const WideInt& b) { return *this = *this + b; }
  WideInt& operator-=(const WideInt& b) { return *this = *this - b; }

  friend bool operator==(const WideInt& a, const WideInt& b) {
    std::uint64_t differ = 0;
    for (int i = 0; i < N; ++i) differ |= a.limb[i] ^ b.limb[i];
    return differ == 0;
  }
  friend std::strong_ordering operator<=>(const WideInt& a, const WideInt& b) {
    const auto top_a = static_cast<std::int64_t>(a.limb[N - 1]), top_b = static_cast<std::int64_t>(b.limb[N - 1]);
    if (top_a != top_b) return top_a <=> top_b;
    for (int i = N - 2; i >= 0; --i) {
      if (a.limb[i] != b.limb[i]) return a.limb[i] <=> b.limb[i];
    }
    return std::strong_ordering::equal;
  }

  /// |value| as an unsigned number in the same limbs (the most negative value maps to itself, which is right unsigned).
  WideInt magnitude() const { return negative() ? -*this : *this; }

  /// Bits of |value|; 0 for 0.
  int bit_length() const {
    const WideInt m = magnitude();
    for (int i = N - 1; i >= 0; --i) {
      if (m.limb[i] != 0) return 64 * i + 64 - std::countl_zero(m.limb[i]);
    }
    return 0;
  }

  /// Relative error at most 2^-52: 64 leading bits are kept (2^-63), then rounded once to a double (2^-53).
  double to_double() const {
    const WideInt m = magnitude();
    int top = N - 1;
    while (top >= 0 && m.limb[top] == 0) --top;
    if (top < 0) return 0;
    std::uint64_t lead = m.limb[top];
    int exponent = 64 * top;
    if (const int shift = std::countl_zero(lead); shift != 0 && top > 0) {
      lead = lead << shift | m.limb[top - 1] >> (64 - shift);
      exponent -= shift;
    }
    const double value = std::ldexp(static_cast<double>(lead), exponent);
    return negative() ? -value : value;
  }

 private:
  template <int From>
  void fill_sign() {
    const auto fill = static_cast<std::uint64_t>(static_cast<std::int64_t>(limb[From - 1]) >> 63);
    for (int i = From; i < N; ++i) limb[i] = fill;
  }
};

using Int256 = WideInt<4>;
using Int512 = WideInt<8>;

namespace detail {
/// a * b mod 2^(64 (N+M)), exact: the unsigned product of the limbs, less b * 2^(64 N) where a < 0 and a * 2^(64 M)
/// where b < 0, since a two's complement number is its limbs less 2^(64 N) where negative.
template <int N, int M>
WideInt<N + M> wide_product(const WideInt<N>& a, const WideInt<M>& b) {
  WideInt<N + M> result;
  for (int i = 0; i < N; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < M; ++j) {
      const uint128 t = static_cast<uint128>(a.limb[i]) * b.limb[j] + result.limb[i + j] + carry;
      result.limb[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    result.limb[i + M] = carry;
  }
  const std::uint64_t mask_a = a.negative() ? ~std::uint64_t{0} : 0, mask_b = b.negative() ? ~std::uint64_t{0} : 0;
  std::uint64_t borrow = 0;
  for (int j = 0; j < M; ++j) {
    const uint128 t = static_cast<uint128>(result.limb[N + j]) - (b.limb[j] & mask_a) - borrow;
    result.limb[N + j] = static_cast<std::uint64_t>(t);
    borrow = static_cast<std::uint64_t>(t >> 64) & 1;
  }
  borrow = 0;
  for (int i = 0; i < N; ++i) {
    const uint128 t = static_cast<uint128>(result.limb[M + i]) - (a.limb[i] & mask_b) - borrow;
    result.limb[M + i] = static_cast<std::uint64_t>(t);
    borrow = static_cast<std::uint64_t>(t >> 64) & 1;
  }
  return result;
}
}  // namespace detail

template <int N>
WideInt<N> WideInt<N>::product(int128 a, int128 b) {
  return detail::wide_product(WideInt<2>(a), WideInt<2>(b));
}
template <int N>
template <int M>
WideInt<N> WideInt<N>::product(const WideInt<M>& a, int128 b) {
  return detail::wide_product(a, WideInt<2>(b));
}
template <int N>
template <int M>
WideInt<N> WideInt<N>::product(const WideInt<M>& a, const WideInt<M>& b) {
  return detail::wide_product(a, b);
}

template <int N>
int compare(const WideInt<N>& a, const WideInt<N>& b) {
  return a < b ? -1 : a != b;
}

/// 128 x 128 -> 256 bits.
inline Int256 multiply(int128 a, int128 b) { return detail::wide_product(WideInt<2>(a), WideInt<2>(b)); }
/// 256 x 128 -> 512 bits (the product has 384).
inline Int512 multiply(const Int256& a, int128 b) { return detail::wide_product(a, WideInt<2>(b)); }
/// 256 x 256 -> 512 bits.
inline Int512 multiply(const Int256& a, const Int256& b) { return detail::wide_product(a, b); }

}  // namespace findspace::exact
