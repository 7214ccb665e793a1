// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/offset/joined_pieces.h"

#include <numeric>
#include <utility>

#include "plane/complex/around_vertex.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/nesting.h"

namespace findspace::plane {
namespace {

/// In the order of the points.
void number_ends(Arrangement& a, std::span<const Index> isolated) {
  constexpr Index kUsed = 0;
  a.point_vertex.assign(a.geometry.points.size(), kNone);
  for (const Piece& p : a.pieces) a.point_vertex[p.p0] = a.point_vertex[p.p1] = kUsed;
  for (const Index p : isolated) a.point_vertex[p] = kUsed;
  for (Index p = 0; p < a.point_vertex.size(); ++p) {
    if (a.point_vertex[p] == kNone) continue;
    a.point_vertex[p] = Index(a.vertex_point.size());
    a.vertex_point.push_back(p);
  }
}

/// Each piece is one edge.
void set_edges(Arrangement& a) {
  const std::size_t n = a.pieces.size();
  a.edges.reserve(n);
  for (const Piece& p : a.pieces)
    a.edges.push_back({a.point_vertex[p.p0], a.point_vertex[p.p1], p.supporting_curve, p.half});
  for (auto* list : {&a.chain, &a.cover}) {
    list->resize(n);
    std::iota(list->begin(), list->end(), Index(0));
  }
  for (auto* list : {&a.chain_start, &a.cover_start}) {
    list->resize(n + 1);
    std::iota(list->begin(), list->end(), Index(0));
  }
}

}  // namespace

Arrangement arrange_joined(exact::Geometry geometry, std::vector<Piece> pieces, std::span<const Index> isolated,
                           Memory memory) {
  Arena arena(pieces.size());
  Arrangement a(memory);
  a.geometry = std::move(geometry);
  a.pieces = std::move(pieces);
  number_ends(a, isolated);
  set_edges(a);
  sort_around_vertices(a);
  nest(a, CellGrid(a.geometry, a.pieces, isolated, arena.memory()), arena.memory());
  return a;
}

}  // namespace findspace::plane
