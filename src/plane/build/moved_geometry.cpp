// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/moved_geometry.h"

namespace findspace::plane {
namespace {

using exact::Real;
using exact::SupportingCurve;

SupportingCurve moved(const SupportingCurve& k, const RealVector& by) {
  if (k.circle) return SupportingCurve::circle_at(k.center_x() + by.x, k.center_y() + by.y, k.w());
  return SupportingCurve::line(k.a, k.b, k.offset() + Real(k.a) * by.x + Real(k.b) * by.y);
}

}  // namespace

Index append_moved(exact::Geometry& to, const exact::Geometry& from, const RealVector& by) {
  const Index supporting_curves = Index(to.supporting_curves.size()), points = Index(to.points.size());
  for (const SupportingCurve& k : from.supporting_curves) to.add(moved(k, by));
  for (Index p = 0; p < from.points.size(); ++p) {
    const exact::Point& q = from.points[p];
    if (q.kind == exact::Point::Kind::kCross) {
      to.add_crossing(supporting_curves + q.i, supporting_curves + q.j, q.root);
    } else {
      const RealVector at = from.exact(p) + by;
      to.add_real_point(at.x, at.y);
    }
  }
  return points;
}

}  // namespace findspace::plane
