// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/number/primitive.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace findspace::exact {
namespace {

constexpr std::size_t kMostAtOnce = 16;

template <std::size_t kLanes>
using Lanes = std::array<double, kLanes>;

/// Added and taken away again it rounds what is below 2^51 to an integer.
constexpr double kRounding = 0x1.8p52;

/// a - q * b with q the integer nearest to a / b, or one of two nearly equally near; a where b = 0. The product is
/// below |a| + |b|, so that nothing here is rounded but the quotient.
template <std::size_t kLanes>
void reduce(Lanes<kLanes>& a, const Lanes<kLanes>& b) {
  for (std::size_t l = 0; l < kLanes; ++l) {
    const double by = b[l] == 0 ? 1 : b[l], q = (a[l] / by + kRounding) - kRounding;
    a[l] -= q * b[l];
  }
}

template <std::size_t kLanes>
bool all_ended(const Lanes<kLanes>& a, const Lanes<kLanes>& b) {
  double even = 0, odd = 0;
  for (std::size_t l = 0; l < kLanes; l += 2) {
    even += std::abs(a[l] * b[l]);
    odd += std::abs(a[l + 1] * b[l + 1]);
  }
  return even + odd == 0;
}

/// Up to kLanes normals.
template <std::size_t kLanes>
void make_primitive_few(std::span<Normal> normals) {
  Lanes<kLanes> a, b;
  a.fill(1);
  b.fill(1);
  for (std::size_t l = 0; l < normals.size(); ++l) {
    a[l] = double(normals[l].a);
    b[l] = double(normals[l].b);
  }
  const Lanes<kLanes> x = a, y = b;
  do {
    reduce(a, b);
    reduce(b, a);
  } while (!all_ended(a, b));
  for (std::size_t l = 0; l < kLanes; ++l) {
    const double divisor = std::abs(a[l] + b[l]), side = x[l] == 0 ? y[l] : x[l];
    a[l] = side < 0 ? -divisor : divisor;
  }
  for (std::size_t l = 0; l < normals.size(); ++l) normals[l] = {std::int64_t(x[l] / a[l]), std::int64_t(y[l] / a[l])};
}

}  // namespace

void make_primitive(std::span<Normal> normals) {
  for (; normals.size() > kMostAtOnce; normals = normals.subspan(kMostAtOnce))
    make_primitive_few<kMostAtOnce>(normals.first(kMostAtOnce));
  if (normals.size() > 12) return make_primitive_few<16>(normals);
  if (normals.size() > 8) return make_primitive_few<12>(normals);
  if (normals.size() > 4) return make_primitive_few<8>(normals);
  make_primitive_few<4>(normals);
}

}  // namespace findspace::exact
