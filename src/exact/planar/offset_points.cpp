// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "exact/planar/offset_points.h"

#include <algorithm>

#include "exact/planar/geometry_stages.h"

namespace findspace::exact {
namespace {

std::uint32_t add_near(Geometry& g, std::uint32_t i, std::uint32_t j, const Approx& x, const Approx& y) {
  Point& p = g.points.emplace_back();
  p.kind = Point::Kind::kCross;
  p.i = std::min(i, j);
  p.j = std::max(i, j);
  p.x = x.value;
  p.y = y.value;
  p.error = std::max(x.error, y.error);
  return std::uint32_t(g.points.size() - 1);
}

}  // namespace

Approx approx(const Real& shift) { return from_real(shift); }

std::uint32_t add_shifted_crossing(Geometry& g, const ShiftedLine& p, const ShiftedLine& q, std::int64_t x,
                                   std::int64_t y) {
  // With unit normals m and n, rotated so that both lines are at the distance s from the point: the crossing is away
  // from it by s * (m + n) / (1 + m * n).
  const SupportingCurve &k = g.supporting_curves[p.supporting_curve], &l = g.supporting_curves[q.supporting_curve];
  const bool opposite = (p.shift.value > 0) != (q.shift.value > 0);
  const Approx mx = opposite ? -k.x() : k.x(), my = opposite ? -k.y() : k.y();
  const Approx divisor = Approx{1, 0} + (mx * l.x() + my * l.y());
  if (divisor.sign() <= 0) return g.add_crossing(p.supporting_curve, q.supporting_curve, 0);
  const Approx by = q.shift / divisor;
  return add_near(g, p.supporting_curve, q.supporting_curve, from_int(x) + by * (mx + l.x()),
                  from_int(y) + by * (my + l.y()));
}

std::uint32_t add_shifted_touch(Geometry& g, const ShiftedLine& line, std::uint32_t circle, std::int64_t x,
                                std::int64_t y) {
  const SupportingCurve& k = g.supporting_curves[line.supporting_curve];
  return add_near(g, line.supporting_curve, circle, from_int(x) + line.shift * k.x(), from_int(y) + line.shift * k.y());
}

}  // namespace findspace::exact
