// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/shape/rotation.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "exact/planar/angle.h"

namespace findspace::space {
namespace {

using exact::Real;

Rotation about_point(Rotation::Matrix rows, const Point& about, bool rounded) {
  Rotation r;
  r.rows = std::move(rows);
  r.rounded = rounded;
  const RealVector center = real(about);
  r.by = minus(center, r.linear(center));
  return r;
}

/// Within [-180, 180].
Real reduced(const Real& degrees) { return degrees - Real(360) * Real(exact::round(degrees / Real(360))); }

std::optional<exact::int128> whole_root(exact::int128 n) {
  if (n == 0) return n;
  auto r = static_cast<exact::int128>(std::sqrt(static_cast<double>(n)));
  for (int step = 0; step < 2; ++step) r = (r + n / r) / 2;  // Newton: 53 digits become all
  for (const exact::int128 root : {r - 1, r, r + 1})
    if (root * root == n) return root;
  return std::nullopt;
}

/// The root where it is rational.
std::optional<Real> rational_root(const Real& square) {
  const auto fraction = square.fraction();
  if (!fraction) return std::nullopt;
  const auto p = whole_root((*fraction)[0]), q = whole_root((*fraction)[1]);
  return p && q ? std::optional(Real::ratio(*p, *q)) : std::nullopt;
}

/// cot(degrees / 2)^2 where it is rational and the angle is rational too: of 60, 90, 120 and 180 degrees alone.
std::optional<Real> half_cotangent_square(const Real& degrees) {
  const Real size = exact::abs(degrees);
  if (size == Real(60)) return Real(3);
  if (size == Real(90)) return Real(1);
  if (size == Real(120)) return Real::ratio(1, 3);
  if (size == Real(180)) return Real(0);
  return std::nullopt;
}

}  // namespace

Rotation Rotation::about_axis(int axis, const Real& degrees, const Point& about) {
  constexpr int kBits = 60;
  const Real quarter(90), count(exact::round(degrees / quarter));
  const Real rest = degrees - count * quarter;  // within 45 degrees of 0
  const bool quarters = rest.sign() == 0;
  exact::ExactAngle turn;
  if (!quarters) turn = exact::ExactAngle::near(rest.to_double(), kBits);
  const exact::int128 whole = *count.integer();
  for (int k = static_cast<int>((whole % 4 + 4) % 4); k > 0; --k) turn = turn + exact::ExactAngle{Real(0), Real(1)};
  const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
  Matrix rows = Rotation{}.rows;
  rows[i][i] = turn.cos;
  rows[i][j] = -turn.sin;
  rows[j][i] = turn.sin;
  rows[j][j] = turn.cos;
  return about_point(std::move(rows), about, !quarters);
}

Rotation Rotation::about_direction(const RealVector& axis, const Real& degrees, const Point& about) {
  if (is_zero(axis)) throw Error(ErrorCode::kBadValue, "an axis of rotation must not be (0, 0, 0)");
  for (std::size_t k = 0; k < 3; ++k) {
    if (axis[(k + 1) % 3].sign() != 0 || axis[(k + 2) % 3].sign() != 0) continue;
    return about_axis(static_cast<int>(k), axis[k].sign() > 0 ? degrees : -degrees, about);
  }
  const Real angle = reduced(degrees), square = dot(axis, axis);
  if (angle.sign() == 0) return about_point(Rotation{}.rows, about, false);
  if (const auto cotangent = half_cotangent_square(angle)) {
    if (auto w = rational_root(square * *cotangent))
      return of_quaternion({angle.sign() > 0 ? *w : -*w, axis[0], axis[1], axis[2]}, about);
  }
  // (1, axis * tan(angle / 2) / |axis|): a rational multiple of the axis, so its direction is exact.
  const double half = angle.to_double() * std::numbers::pi / 360;
  const Real t = Real::from_double(std::tan(half) / std::sqrt(square.to_double()));
  Rotation out = of_quaternion({Real(1), t * axis[0], t * axis[1], t * axis[2]}, about);
  out.rounded = true;
  return out;
}

Rotation Rotation::of_quaternion(const std::array<Real, 4>& q, const Point& about) {
  const auto& [w, x, y, z] = q;
  const Real norm = w * w + x * x + y * y + z * z;
  if (norm.sign() == 0) throw Error(ErrorCode::kBadValue, "a quaternion of a rotation must not be (0, 0, 0, 0)");
  const Real two(2);
  Matrix rows{RealVector{w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)},
              RealVector{two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)},
              RealVector{two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z}};
  for (RealVector& row : rows)
    for (Real& entry : row) entry = entry / norm;
  return about_point(std::move(rows), about, false);
}

Rotation Rotation::of_matrix(const Matrix& rows, const Point& about) {
  constexpr const char* kOtherWays = "; a quaternion of any length is always taken exactly";
  for (std::size_t i = 0; i < 3; ++i) {
    const Real square = dot(rows[i], rows[i]);
    if (!(square == Real(1)))
      throw Error(ErrorCode::kBadValue, fmt::format("row {} of a rotation's matrix has length {:.9g}, not 1{}", i,
                                                    std::sqrt(square.to_double()), kOtherWays));
    for (std::size_t j = 0; j < i; ++j) {
      const Real product = dot(rows[i], rows[j]);
      if (product.sign() != 0)
        throw Error(
            ErrorCode::kBadValue,
            fmt::format("rows {} and {} of a rotation's matrix are not perpendicular: their product is {:.17g}{}", j, i,
                        product.to_double(), kOtherWays));
    }
  }
  if (dot(cross(rows[0], rows[1]), rows[2]).sign() < 0)
    throw Error(ErrorCode::kBadValue, "the matrix mirrors: its determinant is -1, that of a rotation is 1");
  return about_point(rows, about, false);
}

bool Rotation::keeps_axes() const {
  for (const RealVector& row : rows)
    for (const Real& entry : row)
      if (entry.sign() != 0 && !(exact::abs(entry) == Real(1))) return false;
  return true;
}

bool Rotation::keeps_z() const { return keeps_axes() && rows[2][2] == Real(1); }

}  // namespace findspace::space
