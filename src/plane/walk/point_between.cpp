// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/point_between.h"

#include <algorithm>
#include <cmath>

namespace findspace::plane {

Index point_between(exact::Geometry& g, Index supporting_curve, Index p, Index q) {
  const exact::Point s = g.points[p], t = g.points[q];
  for (bool steep : {false, true}) {
    double u = steep ? s.y : s.x, w = steep ? t.y : t.x, low = std::min(u, w) + std::max(s.error, t.error) + 1,
           high = std::max(u, w) - std::max(s.error, t.error) - 1, middle = std::floor((low + high) / 2);
    if (!(low < middle && middle < high)) continue;
    Index line = g.add(exact::SupportingCurve::line(steep ? 0 : 1, steep ? 1 : 0, exact::int128(middle)));
    return g.add_crossing(supporting_curve, line, 0);
  }
  exact::RealPoint a = g.exact(p), b = g.exact(q);
  return g.add_real_point((a.x + b.x) / exact::Real(2), (a.y + b.y) / exact::Real(2));
}

}  // namespace findspace::plane
