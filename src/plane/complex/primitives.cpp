// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/primitives.h"

#include <algorithm>

#include "exact/number/primitive.h"
#include "plane/complex/piece_builder.h"
#include "plane/complex/simplify.h"
#include "plane/complex/winding.h"

namespace findspace::plane {
namespace {

/// Valid rings need no arrangement: their edges, cut into x-monotone curves, are those of the region, in order.
class RingBuilder {
 public:
  RingBuilder(Polygons polygons, Memory memory) : out_(memory), normals_(memory) {
    std::size_t edges = 0, rings = 0, longest = 0;
    for (const auto& polygon : polygons) {
      rings += polygon.size();
      for (const Contour& ring : polygon) {
        edges += ring.size();
        longest = std::max(longest, ring.size());
      }
    }
    normals_.reserve(longest);
    curves_.geometry.supporting_curves.reserve(edges);
    curves_.geometry.points.reserve(edges);
    out_.edges.reserve(edges);
    out_.rings.reserve(rings);
    for (const auto& polygon : polygons) add_polygon(polygon);
  }

  RingCurves build() && {
    out_.geometry = std::move(curves_.geometry);
    return std::move(out_);
  }

 private:
  /// Its face comes first, then those of its holes.
  void add_polygon(std::span<const Contour> polygon) {
    const Index inside = Index(out_.rings.size()) + 1;
    for (Index k = 0; k < polygon.size(); ++k) {
      out_.rings.push_back({Index(out_.edges.size()), inside, k == 0 ? 0 : inside + k, k == 0});
      add(polygon[k]);
    }
  }

  void add(const Contour& ring) {
    const Index first = Index(out_.edges.size()), corner = Index(curves_.geometry.points.size()),
                n = Index(ring.size());
    add_corners(ring);
    const exact::Normal* normal = normals_.data();
    for (Index k = 0; k < n; ++k, ++normal) {
      const Index next = k + 1 == n ? 0 : k + 1;
      if (ring[k].arc)
        add_arc(ring[k], corner + k, corner + next);
      else
        add_segment(*normal, corner + k, ring[k].start, ring[next].start);
    }
    for (std::size_t k = first, before = out_.edges.size() - 1; k < out_.edges.size() && !out_.could_merge;
         before = k++)
      out_.could_merge = could_continue(out_.edges[before], out_.edges[k]);
  }

  /// And finds the primitive normals of its segments.
  void add_corners(const Contour& ring) {
    const std::size_t n = ring.size();
    normals_.clear();
    for (std::size_t k = 0; k < n; ++k) {
      curves_.geometry.add_grid_point(ring[k].start.x, ring[k].start.y);
      normals_.push_back(normal(ring[k], ring[k + 1 == n ? 0 : k + 1]));
    }
    exact::make_primitive(normals_);
  }

  static exact::Normal normal(const ContourEdge& edge, const ContourEdge& next) {
    if (edge.arc) return {1, 0};
    return {next.start.y - edge.start.y, edge.start.x - next.start.x};
  }

  void add_segment(const exact::Normal& n, Index from, const GridPoint& p, const GridPoint& q) {
    const Index line = curves_.geometry.add_line(n.a, n.b, exact::int128(n.a) * p.x + exact::int128(n.b) * p.y);
    out_.edges.push_back({from, line, p < q});
  }

  void add_arc(const ContourEdge& e, Index from, Index to) {
    curves_.pieces.clear();
    curves_.forward.clear();
    curves_.arc(curves_.geometry.add(exact::SupportingCurve::circle_at(e.arc->cx, e.arc->cy, e.arc->r)), from, to,
                e.ccw);
    for (std::size_t i = 0; i < curves_.pieces.size(); ++i) {
      const Piece& p = curves_.pieces[i];
      out_.edges.push_back({curves_.forward[i] ? p.p0 : p.p1, p.supporting_curve, bool(curves_.forward[i]), p.half});
    }
  }

  /// Parallel lines or halves of the same kind: only such neighbours can be one edge.
  bool could_continue(const RingEdge& p, const RingEdge& q) const {
    if (p.half != q.half) return false;
    const exact::SupportingCurve &k = curves_.geometry.supporting_curves[p.supporting_curve],
                                 &l = curves_.geometry.supporting_curves[q.supporting_curve];
    return p.half != 0 || (k.a == l.a && k.b == l.b);
  }

  PieceBuilder curves_;
  RingCurves out_;
  std::pmr::vector<exact::Normal> normals_;  // of the segments of one ring
};

/// Faces with a positive winding number, and everything on their boundary.
Region closed_inside(PieceBuilder b) {
  std::vector<char> forward = std::move(b.forward);
  Arrangement a = arrange(std::move(b.geometry), std::move(b.pieces));
  auto number = face_windings(a, forward, 0);
  Marks m;
  for (auto k : number) m.faces.push_back(k > 0);
  m.vertices.assign(a.vertex_count(), 0);
  for (Index e = 0; e < a.edge_count(); ++e) {
    bool in = m.faces[a.face[2 * e]] || m.faces[a.face[2 * e + 1]];
    m.edges.push_back(in);
    if (in) m.vertices[a.edges[e].v0] = m.vertices[a.edges[e].v1] = 1;
  }
  return extract(std::move(a), m);
}

Region all_cells(PieceBuilder b, std::span<const Index> isolated) {
  Arrangement a = arrange(std::move(b.geometry), std::move(b.pieces), isolated);
  Marks m;
  m.faces.assign(a.face_count, 0);
  m.edges.assign(a.edge_count(), 1);
  m.vertices.assign(a.vertex_count(), 1);
  return extract(std::move(a), m);
}

}  // namespace

RingCurves ring_curves(Polygons polygons, Memory memory) { return RingBuilder(polygons, memory).build(); }

Region region_of_rings(std::span<const Contour> rings) { return region_of_polygons({&rings, 1}); }

Region region_of_polygons(Polygons polygons) {
  Arena arena(polygons.empty() || polygons[0].empty() ? 0 : polygons[0][0].size());
  RingCurves curves = ring_curves(polygons, arena.memory());
  Region region = ring_complex(std::move(curves.geometry), curves.edges, curves.rings, {1, 1, 0});
  if (curves.could_merge) return simplify(std::move(region));
  return region;
}

Region region_of_disc(const exact::Real& cx, const exact::Real& cy, const exact::Real& radius) {
  PieceBuilder b;
  b.circle(b.geometry.add(exact::SupportingCurve::circle_at(cx, cy, radius)));
  return closed_inside(std::move(b));
}

Region region_of_points(std::span<const GridPoint> points) {
  PieceBuilder b;
  std::vector<Index> isolated;
  for (const GridPoint& p : points) isolated.push_back(b.geometry.add_grid_point(p.x, p.y));
  return all_cells(std::move(b), isolated);
}

Region region_of_chain(const Contour& chain) {
  PieceBuilder b;
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) b.edge(chain[k], chain[k + 1].start);
  return all_cells(std::move(b), {});
}

}  // namespace findspace::plane
