// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/number/primitive.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

namespace findspace::exact {
namespace {

constexpr std::size_t kMostAtOnce = 24;

/// Sixteen bytes of numbers that advance together, and their bits.
template <class Number>
struct Pack;
template <>
struct Pack<float> {
  using Lanes [[gnu::vector_size(16)]] = float;
  using Bits [[gnu::vector_size(16)]] = std::int32_t;
  static constexpr std::int32_t kSign = std::numeric_limits<std::int32_t>::min();
};
template <>
struct Pack<double> {
  using Lanes [[gnu::vector_size(16)]] = double;
  using Bits [[gnu::vector_size(16)]] = std::int64_t;
  static constexpr std::int64_t kSign = std::numeric_limits<std::int64_t>::min();
};

/// Normals in kPacks packs.
template <class Number, std::size_t kPacks>
class Euclid {
 public:
  static constexpr std::size_t kEach = 16 / sizeof(Number), kLanes = kEach * kPacks;

  /// The last one fills the lanes that are left.
  explicit Euclid(std::span<const Normal> normals) {
    const std::size_t last = normals.size() - 1;
    for (std::size_t p = 0; p < kPacks; ++p) fill(normals.data(), last, p, std::make_index_sequence<kEach>());
  }

  void divide() { divide(std::make_index_sequence<kPacks>()); }

  void give(std::span<Normal> normals) const {
    std::array<Number, kLanes> x, y;
    std::memcpy(x.data(), x_.data(), sizeof x);
    std::memcpy(y.data(), y_.data(), sizeof y);
    for (std::size_t l = 0; l < normals.size(); ++l) normals[l] = {std::int64_t(x[l]), std::int64_t(y[l])};
  }

 private:
  using Lanes = typename Pack<Number>::Lanes;
  using Bits = typename Pack<Number>::Bits;

  /// Added and taken away again it rounds to an integer what is below a quarter of 1 / epsilon.
  static constexpr Number kRounding = Number(1.5) / std::numeric_limits<Number>::epsilon();

  /// a - q * b with q the integer nearest to a / b, or one of two nearly equally near; a where b = 0. The product is
  /// below |a| + |b|, so that nothing here is rounded but the quotient.
  static Lanes reduced(const Lanes& a, const Lanes& b) {
    const Lanes quotient = reinterpret_cast<Lanes>(reinterpret_cast<Bits>(a / b) & (b != 0));
    return a - ((quotient + kRounding) - kRounding) * b;
  }

  static Lanes square(const Lanes& a) { return a * a; }

  template <std::size_t... kLane>
  void fill(const Normal* normals, std::size_t last, std::size_t pack, std::index_sequence<kLane...>) {
    x_[pack] = Lanes{Number(normals[std::min(pack * kEach + kLane, last)].a)...};
    y_[pack] = Lanes{Number(normals[std::min(pack * kEach + kLane, last)].b)...};
  }

  static bool is_zero(const Lanes& sum) {
    std::array<std::uint64_t, 2> halves;
    std::memcpy(halves.data(), &sum, sizeof halves);
    return (halves[0] | halves[1]) == 0;
  }

  /// By the divisor, with the sign of the first number that is not 0.
  void divide_by(const Lanes& divisor, std::size_t pack) {
    const Lanes side = x_[pack] * kRounding + y_[pack];
    const Bits size = reinterpret_cast<Bits>(divisor) & ~Pack<Number>::kSign,
               sign = reinterpret_cast<Bits>(side) & Pack<Number>::kSign;
    const Lanes by = reinterpret_cast<Lanes>(size | sign);
    x_[pack] /= by;
    y_[pack] /= by;
  }

  template <std::size_t... kPack>
  void divide(std::index_sequence<kPack...>) {
    std::array<Lanes, kPacks> a = x_, b = y_;
    do {
      ((a[kPack] = reduced(a[kPack], b[kPack])), ...);
      ((b[kPack] = reduced(b[kPack], a[kPack])), ...);
    } while (!is_zero((square(a[kPack] * b[kPack]) + ...)));
    (divide_by(a[kPack] + b[kPack], kPack), ...);
  }

  std::array<Lanes, kPacks> x_, y_;
};

template <class Number, std::size_t kLanes>
void make_primitive_few(std::span<Normal> normals) {
  Euclid<Number, kLanes * sizeof(Number) / 16> all(normals);
  all.divide();
  all.give(normals);
}

/// Up to kMostAtOnce normals: as many as there are registers for.
void make_short_primitive(std::span<Normal> normals) {
  if (normals.size() > 16) return make_primitive_few<float, 24>(normals);
  if (normals.size() > 12) return make_primitive_few<float, 16>(normals);
  if (normals.size() > 8) return make_primitive_few<float, 12>(normals);
  if (normals.size() > 4) return make_primitive_few<float, 8>(normals);
  make_primitive_few<float, 4>(normals);
}

void make_long_primitive(std::span<Normal> normals) {
  constexpr std::size_t kEach = 12;
  for (; normals.size() > kEach; normals = normals.subspan(kEach))
    make_primitive_few<double, kEach>(normals.first(kEach));
  if (normals.size() > 8) return make_primitive_few<double, kEach>(normals);
  if (normals.size() > 4) return make_primitive_few<double, 8>(normals);
  make_primitive_few<double, 4>(normals);
}

/// Whether floats hold all that comes up: |a|, |b| <= 2^22.
bool are_short(std::span<const Normal> normals) {
  constexpr std::int64_t kLength = std::int64_t(1) << 22;
  std::uint64_t all = 0;
  for (const Normal& n : normals) all |= std::uint64_t(n.a + kLength) | std::uint64_t(n.b + kLength);
  return all < std::uint64_t(2 * kLength);
}

}  // namespace

void make_primitive(std::span<Normal> normals) {
  while (!normals.empty()) {
    const std::span<Normal> some = normals.first(std::min(kMostAtOnce, normals.size()));
    if (are_short(some))
      make_short_primitive(some);
    else
      make_long_primitive(some);
    normals = normals.subspan(some.size());
  }
}

}  // namespace findspace::exact
