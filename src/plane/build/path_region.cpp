// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/path_region.h"

#include "exact/planar/geometry_signs.h"
#include "plane/build/swept.h"
#include "plane/complex/piece_builder.h"

namespace findspace::plane {

Region region_of_path(std::span<const RealVector> path) {
  using exact::Real;
  PieceBuilder builder;
  exact::Geometry& g = builder.geometry;
  std::vector<Index> points;
  for (const RealVector& p : path) points.push_back(g.add_real_point(p.x, p.y));
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (path[k] == path[k + 1]) continue;
    const Window leg = window_between(path[k], path[k + 1]);
    std::int64_t a = leg.dy, b = -leg.dx;
    exact::make_primitive(a, b);
    const Index line = g.add(exact::SupportingCurve::line(a, b, Real(a) * path[k].x + Real(b) * path[k].y));
    builder.segment(line, points[k], points[k + 1], compare_xy(g, points[k], points[k + 1]) < 0);
  }
  Arrangement a = arrange(std::move(g), std::move(builder.pieces), std::span(points).first(1));
  Marks marks;
  marks.faces.assign(a.face_count, 0);
  marks.edges.assign(a.edge_count(), 1);
  marks.vertices.assign(a.vertex_count(), 1);
  return extract(std::move(a), marks);
}

}  // namespace findspace::plane
