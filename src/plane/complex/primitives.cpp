// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/primitives.h"

#include <algorithm>

#include "plane/base/append_made.h"
#include "plane/complex/piece_builder.h"
#include "plane/complex/simplify.h"
#include "plane/complex/winding.h"

namespace findspace::plane {
namespace {

/// Valid rings need no arrangement: their edges, cut into x-monotone curves, are those of the region, in order.
class RingBuilder {
 public:
  explicit RingBuilder(RingCurves& out) : out_(out), geometry_(out.geometry) {}

  void add(Polygons polygons) {
    std::size_t edges = 0, rings = 0;
    for (const auto& polygon : polygons) {
      rings += polygon.size();
      for (const Contour& ring : polygon) edges += ring.size();
    }
    geometry_.supporting_curves.reserve(edges);
    geometry_.points.reserve(edges);
    out_.edges.reserve(edges);
    out_.rings.reserve(rings);
    for (const auto& polygon : polygons) add_polygon(polygon);
  }

 private:
  /// Its face comes first, then those of its holes.
  void add_polygon(std::span<const Contour> polygon) {
    const Index inside = Index(out_.rings.size()) + 1;
    for (Index k = 0; k < polygon.size(); ++k) {
      out_.rings.push_back({Index(out_.edges.size()), inside, k == 0 ? 0 : inside + k, k == 0});
      add_ring(polygon[k]);
    }
  }

  void add_ring(std::span<const ContourEdge> ring) {
    const Index corner = Index(geometry_.points.size()), n = Index(ring.size());
    append_made(geometry_.points, n, [&](std::size_t k) { return exact::Point(ring[k].start.x, ring[k].start.y); });
    const std::size_t first = out_.edges.size();
    for (Index k = 0; k < n;) {
      if (ring[k].arc) {
        add_arc(ring[k], corner + k, corner + (k + 1 == n ? 0 : k + 1));
        ++k;
      } else {
        const Index end = end_of_segments(ring, k);
        add_segments(ring, k, end, corner);
        k = end;
      }
    }
    if (!out_.could_merge) out_.could_merge = some_continue(std::span(out_.edges).subspan(first));
  }

  /// From k on all are segments up to there.
  static Index end_of_segments(std::span<const ContourEdge> ring, Index k) {
    while (k < ring.size() && !ring[k].arc) ++k;
    return k;
  }

  void add_segments(std::span<const ContourEdge> ring, Index first, Index end, Index corner) {
    const Index line = Index(geometry_.supporting_curves.size());
    const std::size_t last = end == ring.size() ? end - first - 1 : end;  // that which ends at the start of the ring
    const ContourEdge* from = ring.data() + first;
    append_made(out_.edges, end - first, [&](std::size_t k) {
      const GridPoint &p = from[k].start, &q = k == last ? ring[0].start : from[k + 1].start;
      const bool right = bool(int(p.x < q.x) | (int(p.x == q.x) & int(p.y < q.y)));
      return RingEdge{corner + first + Index(k), line + Index(k), right};
    });
    geometry_.add_lines(corner + first, end - first, corner + (end == ring.size() ? 0 : end));
  }

  void add_arc(const ContourEdge& e, Index from, Index to) {
    const Index circle = geometry_.add(exact::SupportingCurve::circle_at(e.arc->cx, e.arc->cy, e.arc->r));
    cut_arc(geometry_, circle, from, to, e.ccw, [&](Index at, Index, std::int8_t half, bool right) {
      out_.edges.push_back({at, circle, right, half});
    });
  }

  /// Parallel lines or halves of the same kind: only such neighbours can be one edge.
  bool some_continue(std::span<const RingEdge> edges) const {
    const exact::SupportingCurve* curves = geometry_.supporting_curves.data();
    const RingEdge* before = &edges.back();
    const exact::SupportingCurve* k = curves + before->supporting_curve;
    for (const RingEdge& e : edges) {
      const exact::SupportingCurve* l = curves + e.supporting_curve;
      if (before->half == e.half && (e.half != 0 || (k->a == l->a && k->b == l->b))) return true;
      before = &e;
      k = l;
    }
    return false;
  }

  RingCurves& out_;
  exact::Geometry& geometry_;
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

RingCurves ring_curves(Polygons polygons, Memory memory) {
  RingCurves curves(memory);
  RingBuilder(curves).add(polygons);
  return curves;
}

Region region_of_rings(std::span<const Contour> rings) { return region_of_polygons({&rings, 1}); }

Region region_of_polygons(Polygons polygons) {
  Arena arena(polygons.empty() || polygons[0].empty() ? 0 : polygons[0][0].size());
  RingCurves curves = ring_curves(polygons, arena.memory());
  const auto region = [&] { return ring_complex(std::move(curves.geometry), curves.edges, curves.rings, {1, 1, 0}); };
  return curves.could_merge ? simplify(region()) : region();
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
