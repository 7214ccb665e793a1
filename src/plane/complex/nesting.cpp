// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/nesting.h"

#include <algorithm>

#include "exact/planar/geometry_signs.h"
#include "plane/base/parallel.h"
#include "plane/base/union_find.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

/// The vertical ray downwards from just left of a vertex.
class DownwardRay {
 public:
  DownwardRay(const Arrangement& a, const CellGrid& grid) : a_(a), g_(a.geometry), grid_(grid) {}

  /// A half-edge whose left face is the face just left of the vertex, which has nothing to its left; kNone: unbounded.
  Index face_side(Index vertex) {
    from_ = a_.vertex_point[vertex];
    const exact::Point& p = g_.points[from_];
    best_ = kNone;
    Index top = grid_.row(p.y + 2 * grid_.slack());
    for (Index c = grid_.column(p.x - 2 * grid_.slack()), last = grid_.column(p.x + 2 * grid_.slack()); c <= last; ++c)
      for (Index r = top + 1; r-- > 0;) {
        if (best_ != kNone && best_y_.value - best_y_.error > grid_.row_top(r) + 2 * grid_.slack()) break;
        for (Index i : grid_.cell(c, r)) consider(i);
      }
    return best_ == kNone ? kNone : side_of_hit();
  }

 private:
  void consider(Index i) {
    const Piece& p = a_.pieces[i];
    if (i == best_ || (p.half == 0 && g_.supporting_curves[p.supporting_curve].b == 0))
      return;  // vertical: never left of the vertex
    if (compare_x(g_, p.p0, from_) >= 0 || compare_x(g_, p.p1, from_) < 0) return;
    if (height(g_, p, from_) <= 0) return;
    if (best_ != kNone && compare_heights(g_, p, a_.pieces[best_], from_) <= 0) return;
    best_ = i;
    best_y_ = approx_y_at(g_, p, from_);
  }

  Index side_of_hit() const {
    auto first = a_.chain.begin() + a_.chain_start[best_], last = a_.chain.begin() + a_.chain_start[best_ + 1];
    auto hit = std::partition_point(first, last,
                                    [&](Index e) { return compare_x(g_, a_.vertex_point[a_.edges[e].v1], from_) < 0; });
    Index w = a_.edges[*hit].v1;
    if (compare_x(g_, a_.vertex_point[w], from_) != 0) return 2 * *hit;
    // The ray ends in a vertex: the sector that looks up and a little to the left.
    auto begin = a_.out.begin() + a_.out_start[w], end = a_.out.begin() + a_.out_start[w + 1];
    auto left = std::find_if(begin, end, [](Index h) { return h & 1u; });
    return left == begin ? *(end - 1) : *(left - 1);
  }

  const Arrangement& a_;
  const Geometry& g_;
  const CellGrid& grid_;
  Index from_ = 0, best_ = kNone;
  exact::Approx best_y_;
};

struct Components {
  UnionFind connected;
  ArenaVector<Index> first;  // leading vertex -> its lexicographically smallest vertex
  Components(const Arrangement& a, Memory memory)
      : connected(a.vertex_count(), memory), first(a.vertex_count(), kNone, memory), a_(a) {}

  void find() {
    const Arrangement& a = a_;
    for (const auto& e : a.edges) connected.unite(e.v0, e.v1);
    for (Index v = 0; v < a.vertex_count(); ++v) {
      // A smallest vertex has nothing to its left, so all its half-edges go right.
      if (a.degree(v) && (a.out[a.out_start[v + 1] - 1] & 1u)) continue;
      Index& f = first[connected.find(v)];
      if (f == kNone || compare_xy(a.geometry, a.vertex_point[v], a.vertex_point[f]) < 0) f = v;
    }
  }

 private:
  const Arrangement& a_;
};

constexpr std::size_t kManyHalfEdges = 10'000;  // from here on cycles and components are found at once

/// Which cycle each half-edge is part of; how many there are.
Index number_cycles(const Arrangement& a, ArenaVector<Index>& cycle) {
  Index cycles = 0;
  for (Index h = 0; h < a.next.size(); ++h) {
    if (cycle[h] != kNone) continue;
    for (Index k = h; cycle[k] == kNone; k = a.next[k]) cycle[k] = cycles;
    ++cycles;
  }
  return cycles;
}

}  // namespace

void nest(Arrangement& a, const CellGrid& grid, Memory memory) {
  auto& cycle = a.face;  // of each half-edge, until the faces are known
  cycle.assign(a.next.size(), kNone);
  Index cycles = 0;
  Components parts(a, memory);
  at_once(2, a.next.size(), kManyHalfEdges, [&](std::size_t k) {
    if (k == 0)
      cycles = number_cycles(a, cycle);
    else
      parts.find();
  });
  ArenaVector<Index> order(memory);
  for (Index v = 0; v < a.vertex_count(); ++v)
    if (parts.first[v] != kNone) order.push_back(parts.first[v]);
  // From left to right, so that the component a ray hits is known before.
  std::sort(order.begin(), order.end(),
            [&](Index v, Index w) { return compare_xy(a.geometry, a.vertex_point[v], a.vertex_point[w]) < 0; });
  ArenaVector<Index> face_of(cycles, kNone, memory);
  ArenaVector<char> outside(cycles, 0, memory);
  for (Index v : order)
    if (a.degree(v)) outside[cycle[a.out[a.out_start[v + 1] - 1]]] = 1;
  a.face_count = 1;
  for (Index c = 0; c < cycles; ++c)
    if (!outside[c]) face_of[c] = a.face_count++;
  a.isolated_face.assign(a.vertex_count(), kNone);
  DownwardRay ray(a, grid);
  for (Index v : order) {
    Index h = order.front() == v ? kNone : ray.face_side(v);
    Index f = h == kNone ? 0 : face_of[cycle[h]];
    if (a.degree(v))
      face_of[cycle[a.out[a.out_start[v + 1] - 1]]] = f;
    else
      a.isolated_face[v] = f;
  }
  for (Index& f : a.face) f = face_of[f];
}

}  // namespace findspace::plane
