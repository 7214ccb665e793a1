// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The subdivision of the plane by a set of segments, circular arcs and isolated points in any position: pieces may
// overlap, touch, share ends and meet many at a point. Guarantee: exact, vertices are implicit points and coinciding
// ones are one vertex. Cost: O(n log n + k log k) for inputs spread evenly over a grid of cells, k crossings found;
// about 0.2 us a crossing. Method: pairs from a uniform grid, exact sorting along every piece (ties unite points),
// exact angular order at every vertex, one vertical ray a connected component for the nesting. Source: Halperin &
// Sharir; Guibas & Marimont for ties.
#pragma once

#include <span>
#include <vector>

#include "plane/base/arena.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// An x-monotone curve: a segment, or part of the upper or lower half of a circle, from p0 to the lexicographically
/// larger p1.
struct Piece {
  Index supporting_curve = 0;
  Index p0 = 0, p1 = 0;  // in geometry.points
  std::int8_t half = 0;  // circle: +1 upper, -1 lower
  bool smooth0 = false;  // at p0 it continues into exactly one other piece with the same tangent ...
  bool smooth1 = false;  // ... and the same at p1; the two then meet nowhere else
  Index group = kNone;   // pieces of one group (not kNone) meet only in common ends
};

struct Arrangement {
  struct Edge {
    Index v0, v1, supporting_curve;
    std::int8_t half;
  };

  exact::Geometry geometry;
  std::vector<Piece> pieces;
  using Indices = ArenaVector<Index>;
  Indices vertex_point;  // vertex -> point
  Indices point_vertex;  // point -> vertex, kNone if unused
  ArenaVector<Edge> edges;
  Indices cover_start, cover;  // edge -> pieces that cover it
  Indices chain_start, chain;  // piece -> its edges from p0 to p1
  Indices out_start, out;      // vertex -> half-edges, counter-clockwise from straight down
  Indices rank;                // half-edge -> its place in its vertex's list
  Indices next;                // half-edge -> next of the face on its left
  Indices face;                // half-edge -> face; 0 is unbounded
  Indices isolated_face;       // vertex without edges -> face; kNone otherwise
  Index face_count = 1;

  explicit Arrangement(Memory memory)
      : vertex_point(memory),
        point_vertex(memory),
        edges(memory),
        cover_start(memory),
        cover(memory),
        chain_start(memory),
        chain(memory),
        out_start(memory),
        out(memory),
        rank(memory),
        next(memory),
        face(memory),
        isolated_face(memory) {}

  Index origin(Index h) const { return h & 1u ? edges[h / 2].v1 : edges[h / 2].v0; }
  Index vertex_count() const { return Index(vertex_point.size()); }
  Index edge_count() const { return Index(edges.size()); }
  Index degree(Index v) const { return out_start[v + 1] - out_start[v]; }
  /// Some face at the vertex: the one after its first half-edge, or the one around it.
  Index some_face(Index v) const { return degree(v) ? face[out[out_start[v]]] : isolated_face[v]; }
};

/// `memory`: where the arrangement is kept; it must outlive it.
Arrangement arrange(exact::Geometry geometry, std::vector<Piece> pieces, std::span<const Index> isolated_points = {},
                    Memory memory = kHeap);

/// Marks of all cells of an arrangement, to be turned into a complex.
struct Marks {
  std::vector<Mark> faces, edges, vertices;
};

/// The same, kept elsewhere.
struct MarkViews {
  std::span<const Mark> faces, edges, vertices;
  MarkViews(const Marks& m) : faces(m.faces), edges(m.edges), vertices(m.vertices) {}
  MarkViews(std::span<const Mark> f, std::span<const Mark> e, std::span<const Mark> v)
      : faces(f), edges(e), vertices(v) {}
};

/// The complex with these marks, cells that agree merged. The arrangement's geometry becomes that of the complex.
CellComplex extract(Arrangement&& arrangement, const MarkViews& marks);

}  // namespace findspace::plane
