// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/path_region.h"

#include "exact/planar/geometry_signs.h"
#include "plane/build/swept.h"
#include "plane/complex/piece_builder.h"

namespace findspace::plane {

std::vector<PathPiece> pieces_of_path(std::span<const RealVector> path) {
  if (path.size() == 1) return {{path[0], path[0], {}}};
  std::vector<PathPiece> out;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) out.push_back({path[k], path[k + 1], path[k + 1] - path[k]});
  return out;
}

Region region_of_pieces(std::span<const PathPiece> pieces) {
  using exact::Real;
  PieceBuilder builder;
  exact::Geometry& g = builder.geometry;
  std::vector<Index> single;
  for (const PathPiece& piece : pieces) {
    const Index from = g.add_real_point(piece.from.x, piece.from.y);
    if (piece.along == RealVector{}) {
      single.push_back(from);
      continue;
    }
    const Index to = g.add_real_point(piece.to.x, piece.to.y);
    const Window leg = window_between({}, piece.along);
    std::int64_t a = leg.dy, b = -leg.dx;
    exact::make_primitive(a, b);
    const Index line = g.add(exact::SupportingCurve::line(a, b, Real(a) * piece.from.x + Real(b) * piece.from.y));
    builder.segment(line, from, to, compare_xy(g, from, to) < 0);
  }
  Arrangement a = arrange(std::move(g), std::move(builder.pieces), single);
  Marks marks;
  marks.faces.assign(a.face_count, 0);
  marks.edges.assign(a.edge_count(), 1);
  marks.vertices.assign(a.vertex_count(), 1);
  return extract(std::move(a), marks);
}

Region region_of_path(std::span<const RealVector> path) { return region_of_pieces(pieces_of_path(path)); }

}  // namespace findspace::plane
