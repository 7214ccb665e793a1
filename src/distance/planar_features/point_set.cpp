// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_features/point_set.h"

namespace findspace::distance {

plane::CellComplex point_set(std::span<const exact::RealPoint> points, plane::Mark in, plane::Mark out) {
  plane::CellComplex m = plane::CellComplex::uniform(out);
  for (const exact::RealPoint& p : points) {
    plane::Vertex v;
    v.point = m.geometry.add_real_point(p.x, p.y);
    v.mark = in;
    v.face = 0;
    m.faces[0].isolated.push_back(plane::Index(m.vertices.size()));
    m.vertices.push_back(v);
  }
  return m;
}

}  // namespace findspace::distance
