// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/moved.h"

#include <cmath>
#include <optional>
#include <utility>

namespace findspace::plane {
namespace {

using exact::int128;
using exact::Real;
using exact::SupportingCurve;

constexpr std::int64_t kLargestStep = std::int64_t{1} << 41;  // a grid point plus such a step stays far below 2^63

std::optional<std::int64_t> grid_step(const Real& x) {
  const std::optional<int128> whole = x.integer();
  if (!whole || *whole > kLargestStep || *whole < -kLargestStep) return std::nullopt;
  return std::int64_t(*whole);
}

SupportingCurve shifted(const SupportingCurve& k, const exact::RealPoint& by) {
  if (k.circle) return SupportingCurve::circle_at(k.center_x() + by.x, k.center_y() + by.y, k.w());
  return SupportingCurve::line(k.a, k.b, k.offset() + Real(k.a) * by.x + Real(k.b) * by.y);
}

SupportingCurve shifted(const SupportingCurve& k, std::int64_t x, std::int64_t y) {
  if (k.displaced()) return SupportingCurve::displaced_line(k.a, k.b, k.c + int128(k.a) * x + int128(k.b) * y, k.reals);
  if (!k.grid) return shifted(k, exact::RealPoint{Real(x), Real(y)});
  if (k.circle) return SupportingCurve::circle_at(k.a + x, k.b + y, k.reals);
  return SupportingCurve::line(k.a, k.b, k.c + int128(k.a) * x + int128(k.b) * y);
}

}  // namespace

CellComplex moved(CellComplex c, const exact::RealPoint& by) {
  const auto x = grid_step(by.x), y = grid_step(by.y);
  const exact::Geometry& from = c.geometry;
  exact::Geometry to;
  // SupportingCurves keep their order and direction, so the roots of crossings stay.
  for (const SupportingCurve& k : from.supporting_curves) to.add(x && y ? shifted(k, *x, *y) : shifted(k, by));
  for (const exact::Point& p : from.points) {
    if (p.kind == exact::Point::Kind::kCross) {
      to.add_crossing(p.i, p.j, p.root);
    } else if (p.kind == exact::Point::Kind::kReal) {
      to.add_real_point(from.reals[p.i].x + by.x, from.reals[p.i].y + by.y);
    } else if (x && y) {
      to.add_grid_point(p.gx + *x, p.gy + *y);
    } else {
      to.add_real_point(Real(p.gx) + by.x, Real(p.gy) + by.y);
    }
  }
  c.geometry = std::move(to);
  return c;
}

}  // namespace findspace::plane
