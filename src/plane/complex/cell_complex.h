// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The result type of the plane: a finite partition of R^2 into relatively open cells (vertices, open edges, open faces,
// one of them unbounded), each with a small integer mark. With marks 0/1 it is a `Region` (mark 1 = belongs to the
// set); with marks -1/0/+1 it is a `SignMap` (sign of a distance minus its level at every position).
//
// Invariants: faces[0] is the unbounded face. Every edge is x-monotone: a segment, or a part of the upper or lower half
// of a circle, running from its lexicographically smaller end `v0` to `v1`. Half-edge 2e runs v0 -> v1, 2e+1 back; the
// face of a half-edge lies to its left. Nothing can be merged further without leaving the x-monotone form: no edge
// whose two sides and itself carry one mark, no vertex inside a curve of one supporting curve with equal marks.
// Guarantee: exact; coordinates are implicit points of `exact::Geometry`. Source: distances.md 8.1; Halperin & Sharir,
// Arrangements (Handbook of DCG). Keywords: DCEL, planar map, selective Nef complex, marked subdivision.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "exact/planar/geometry_signs.h"
#include "plane/base/short_list.h"

namespace findspace::plane {

using Mark = std::int8_t;
inline bool is_in(Mark m) { return m > 0; }
inline bool is_out(Mark m) { return m <= 0; }
using Index = std::uint32_t;
inline constexpr Index kNone = std::numeric_limits<Index>::max();

struct Vertex {
  Index point = 0;  // in geometry.points
  Mark mark = 0;
  Index out = kNone;   // the first half-edge that starts here, counter-clockwise from straight down, those to the right
                       // (and straight up) first; kNone for an isolated vertex
  Index face = kNone;  // the face around an isolated vertex; kNone otherwise
};

struct Edge {
  Index v0 = 0, v1 = 0;        // lexicographically v0 < v1
  Index supporting_curve = 0;  // in geometry.supporting_curves
  std::int8_t half = 0;        // circle: +1 upper half, -1 lower half; line: 0
  Mark mark = 0;
};

struct HalfEdge {
  Index next = kNone;  // next half-edge of the same boundary cycle, the face on its left
  Index face = 0;
};

struct Face {
  Mark mark = 0;
  Index outer = kNone;        // a half-edge of its outer boundary; kNone for the unbounded face
  ShortList<Index> inner;     // one half-edge of each inner boundary cycle
  ShortList<Index> isolated;  // isolated vertices inside
};

struct CellComplex {
  exact::Geometry geometry;
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<HalfEdge> half_edges;  // 2 * edges.size()
  std::vector<Face> faces;

  /// The whole plane as one face with this mark.
  static CellComplex uniform(Mark mark) {
    CellComplex c;
    c.faces.push_back(Face{.mark = mark, .outer = kNone, .inner = {}, .isolated = {}});
    return c;
  }

  static Index twin(Index h) { return h ^ 1u; }
  Index origin(Index h) const { return h & 1u ? edges[h / 2].v1 : edges[h / 2].v0; }
  Index target(Index h) const { return h & 1u ? edges[h / 2].v0 : edges[h / 2].v1; }
  Index face(Index h) const { return half_edges[h].face; }
  Index next(Index h) const { return half_edges[h].next; }
  /// Next half-edge clockwise around the same origin.
  Index clockwise(Index h) const { return half_edges[twin(h)].next; }
  const exact::Point& point(Index vertex) const { return geometry.points[vertices[vertex].point]; }
  const exact::SupportingCurve& supporting_curve(Index edge) const {
    return geometry.supporting_curves[edges[edge].supporting_curve];
  }
  bool is_arc(Index edge) const { return edges[edge].half != 0; }
  /// Direction of travel of a half-edge on its supporting curve (see exact::Heading).
  exact::Heading heading(Index h) const {
    const Edge& e = edges[h / 2];
    bool right = !(h & 1u);
    bool forward =
        e.half != 0 ? (e.half < 0) == right : (geometry.supporting_curves[e.supporting_curve].b > 0) == right;
    return {e.supporting_curve, forward};
  }
};

using Region = CellComplex;   // marks 0, 1
using SignMap = CellComplex;  // marks -1, 0, +1

}  // namespace findspace::plane
