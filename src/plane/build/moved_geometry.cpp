// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/moved_geometry.h"

namespace findspace::plane {
namespace {

using exact::Carrier;
using exact::Real;

Carrier moved(const Carrier& k, const RealVector& by) {
  if (k.circle) return Carrier::circle_at(k.center_x() + by.x, k.center_y() + by.y, k.w);
  return Carrier::line(k.a, k.b, k.offset() + Real(k.a) * by.x + Real(k.b) * by.y);
}

}  // namespace

Index append_moved(exact::Geometry& to, const exact::Geometry& from, const RealVector& by) {
  const Index carriers = Index(to.carriers.size()), points = Index(to.points.size());
  for (const Carrier& k : from.carriers) to.add(moved(k, by));
  for (Index p = 0; p < from.points.size(); ++p) {
    const exact::Point& q = from.points[p];
    if (q.kind == exact::Point::Kind::kCross) {
      to.add_crossing(carriers + q.i, carriers + q.j, q.root);
    } else {
      const RealVector at = from.exact(p) + by;
      to.add_real_point(at.x, at.y);
    }
  }
  return points;
}

}  // namespace findspace::plane
