// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/deepest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/margins/space.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {
namespace {

using exact::Real;
using Four = std::array<std::size_t, 4>;

template <class T>
struct Meeting {
  std::array<T, 3> at;
  T value;
};

/// The place at one signed distance from four planes n . x + d = v l, by elimination. False where there is none.
template <class T, class IsZero>
bool solve(std::array<std::array<T, 5>, 4> rows, IsZero is_zero, Meeting<T>& out) {
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t pivot = c;
    while (pivot < 4 && is_zero(rows[pivot][c])) ++pivot;
    if (pivot == 4) return false;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == c || is_zero(rows[r][c])) continue;
      const T factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k < 5; ++k) rows[r][k] = rows[r][k] - factor * rows[c][k];
    }
  }
  for (std::size_t c = 0; c < 3; ++c) out.at[c] = rows[c][4] / rows[c][c];
  out.value = rows[3][4] / rows[3][3];
  return true;
}

/// The four planes whose meeting is the best, by doubles.
std::optional<Four> proposed(std::span<const HalfSpace> planes) {
  std::optional<Four> best;
  double least = std::numeric_limits<double>::infinity(), size = 1;
  for (const HalfSpace& h : planes) size = std::max(size, std::fabs(h.shift));
  const auto row = [&](std::size_t k) {
    const HalfSpace& h = planes[k];
    return std::array<double, 5>{h.unit.x, h.unit.y, h.unit.z, -1, -h.shift};
  };
  const double slack = margin::kProposedPlace * size;
  const std::size_t n = planes.size();
  for (Four f{0, 0, 0, 0}; f[0] < n; ++f[0]) {
    for (f[1] = f[0] + 1; f[1] < n; ++f[1]) {
      for (f[2] = f[1] + 1; f[2] < n; ++f[2]) {
        for (f[3] = f[2] + 1; f[3] < n; ++f[3]) {
          Meeting<double> m{};
          const auto tiny = [](double v) { return std::fabs(v) < margin::kFlatMeeting; };
          if (!solve<double>({row(f[0]), row(f[1]), row(f[2]), row(f[3])}, tiny, m) || !(m.value < least)) continue;
          const bool holds = std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& h) {
            return h.approx_value({m.at[0], m.at[1], m.at[2]}) <= m.value + slack;
          });
          if (holds) {
            best = f;
            least = m.value;
          }
        }
      }
    }
  }
  return best;
}

}  // namespace

std::optional<Deepest> deepest(std::span<const HalfSpace> planes, const RealVector& low, const RealVector& high) {
  if (planes.size() > kMostPlanes) return std::nullopt;
  const auto four = proposed(planes);
  if (!four) return std::nullopt;
  std::array<std::array<Real, 5>, 4> rows;
  for (std::size_t k = 0; k < 4; ++k) {
    const HalfSpace& h = planes[(*four)[k]];
    rows[k] = {h.normal[0], h.normal[1], h.normal[2], -sqrt(dot(h.normal, h.normal)), -h.offset};
  }
  Meeting<Real> m{};
  if (!solve<Real>(
          rows, [](const Real& v) { return v.sign() == 0; }, m))
    return std::nullopt;
  // All that is as deep: that place alone, if it is the best and the only one.
  ConvexRegion region(low, high);
  for (const HalfSpace& h : planes) {
    region.cut(HalfSpace(h.normal, h.offset - m.value * sqrt(dot(h.normal, h.normal))));
    if (region.empty()) return std::nullopt;
  }
  if (region.dimension() != 0 || region.vertices()[0].at != m.at) return std::nullopt;
  return Deepest{m.at, m.value};
}

}  // namespace findspace::space
