// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/scaled.h"

#include <utility>

namespace findspace::plane {

CellComplex scaled(CellComplex complex, std::int64_t factor) {
  using exact::SupportingCurve;
  const exact::Real f(factor);
  exact::Geometry to;
  for (const SupportingCurve& k : complex.geometry.supporting_curves)
    to.add(k.circle ? SupportingCurve::circle_at(f * k.center_x(), f * k.center_y(), f * k.w())
                    : SupportingCurve::line(k.a, k.b, f * k.offset()));
  for (Index p = 0; p < complex.geometry.points.size(); ++p) {
    const exact::Point& q = complex.geometry.points[p];
    if (q.kind == exact::Point::Kind::kCross) {
      to.add_crossing(q.i, q.j, q.root);  // supporting curves keep their order and direction, so roots stay
    } else {
      const exact::RealPoint at = complex.geometry.exact(p);
      to.add_real_point(f * at.x, f * at.y);
    }
  }
  complex.geometry = std::move(to);
  return complex;
}

}  // namespace findspace::plane
