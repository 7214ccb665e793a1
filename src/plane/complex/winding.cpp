// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/winding.h"

#include <atomic>
#include <span>

#include "plane/base/parallel.h"
#include "plane/complex/face_walk.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kManyCells = 4000;  // edges: from here on ranges of cells are worked on at once

std::span<const Index> cover(const Arrangement& a, Index e) {
  return {a.cover.data() + a.cover_start[e], a.cover_start[e + 1] - a.cover_start[e]};
}

/// Spreads the numbers over the faces; `jump(e)` is number(left of v0 -> v1) - number(right).
template <class Jump>
std::vector<std::int32_t> spread(const Arrangement& a, std::int32_t base, Jump&& jump) {
  std::vector<std::int32_t> number(a.face_count, 0);
  number[0] = base;
  walk_faces(a, [&](Index h) {
    std::int32_t f = number[a.face[h]];
    number[a.face[h ^ 1u]] = h & 1u ? f + jump(h / 2) : f - jump(h / 2);
  });
  return number;
}

class VertexNumbers {
 public:
  VertexNumbers(const Arrangement& a, const std::vector<Chain>& chains, Windings& w) : a_(a), chains_(chains), w_(w) {}

  /// Starts from the face in the sector after the vertex's first half-edge.
  void prepare(VertexScope scope) {
    w_.vertices.assign(a_.vertex_count(), kUnwanted);
    in_cell_ranges(a_.vertex_count(), [&](std::size_t v) {
      bool inside = scope == VertexScope::kAll || w_.faces[a_.some_face(Index(v))] > 0;
      for (Index k = a_.out_start[v]; inside && scope != VertexScope::kAll && k < a_.out_start[v + 1]; ++k)
        inside = w_.faces[a_.face[a_.out[k]]] > 0 && w_.edges[a_.out[k] / 2] > 0;
      if (inside) w_.vertices[v] = w_.faces[a_.some_face(Index(v))];
    });
  }

  void add_through() {
    in_cell_ranges(a_.pieces.size(), [&](std::size_t i) { add_through(Index(i)); });
  }

  void add(const std::vector<Corner>& corners) {
    in_cell_ranges(corners.size(), [&](std::size_t k) { add(corners[k]); });
  }

 private:
  /// Calls task(k) for all cells of a kind.
  template <class Task>
  void in_cell_ranges(std::size_t count, Task&& task) const {
    in_ranges(count, at_once_ ? 0 : SIZE_MAX, [&](IndexRange some) {
      for (std::size_t k = some.first; k < some.end; ++k) task(k);
    });
  }

  // Ranges may meet at a vertex; the sum does not depend on the order.
  bool is_wanted(Index v) const { return std::atomic_ref(w_.vertices[v]).load(std::memory_order_relaxed) != kUnwanted; }
  void add(Index v, std::int32_t number) {
    if (at_once_)
      std::atomic_ref(w_.vertices[v]).fetch_add(number, std::memory_order_relaxed);
    else
      w_.vertices[v] += number;
  }

  void add_through(Index i) {
    for (Index k = a_.chain_start[i] + 1; k < a_.chain_start[i + 1]; ++k) {
      Index v = a_.edges[a_.chain[k]].v0;
      if (!is_wanted(v)) continue;
      Index ahead = a_.rank[2 * a_.chain[k]], back = a_.rank[2 * a_.chain[k - 1] + 1];
      // Left of p0 -> p1 are the sectors from `ahead` counter-clockwise to `back`.
      bool face_left = passes(0, ahead, back);
      bool displaced_left = chains_[i].forward == chains_[i].displaced_left;
      if (face_left != displaced_left) continue;
      // The chain passes between the vertex and the face.
      int left_minus_right = chains_[i].forward ? chains_[i].weight : -chains_[i].weight;
      add(v, face_left ? -left_minus_right : left_minus_right);
    }
  }

  void add(const Corner& c) {
    Index in_back = back_half_edge(c.in), out_ahead = ahead_half_edge(c.out);
    Index v = a_.origin(in_back);
    if (!is_wanted(v)) return;
    const std::int32_t weight = c.weight;
    if (c.extra != 0) add(v, c.extra * weight);
    bool left = chains_[c.in].displaced_left, both = left == chains_[c.out].displaced_left;
    int rotation = both ? (left ? -1 : 1) : c.rotation;
    Index from = a_.rank[in_back], to = a_.rank[out_ahead];
    if (rotation == 0) return;
    if (from == to) {  // back on the same curve: around its tip, or inside it
      if (both && c.rotation == rotation) add(v, rotation * weight);
      return;
    }
    // Counter-clockwise around the vertex: the vertex lies to the path's left, the face to its right.
    if (rotation > 0 && passes(0, from, to)) add(v, weight);
    if (rotation < 0 && passes(0, to, from)) add(v, -weight);
  }

  Index back_half_edge(Index piece) const {
    return chains_[piece].forward ? 2 * a_.chain[a_.chain_start[piece + 1] - 1] + 1
                                  : 2 * a_.chain[a_.chain_start[piece]];
  }
  Index ahead_half_edge(Index piece) const {
    return chains_[piece].forward ? 2 * a_.chain[a_.chain_start[piece]]
                                  : 2 * a_.chain[a_.chain_start[piece + 1] - 1] + 1;
  }

  const Arrangement& a_;
  const std::vector<Chain>& chains_;
  Windings& w_;
  const bool at_once_ = range_count(a_.edge_count(), kManyCells) > 1;
};

}  // namespace

std::vector<std::int32_t> face_windings(const Arrangement& a, const std::vector<char>& forward, std::int32_t base) {
  return spread(a, base, [&](Index e) {
    std::int32_t jump = 0;
    for (Index i : cover(a, e)) jump += forward[i] ? 1 : -1;
    return jump;
  });
}

namespace {

/// Of each edge, number(left of v0 -> v1) - number(right), and number of the edge - number on its right.
struct Jumps {
  std::vector<std::int32_t> across, on;

  Jumps(const Arrangement& a, const std::vector<Chain>& chains) : across(a.edge_count(), 0), on(a.edge_count(), 0) {
    in_ranges(a.edge_count(), kManyCells, [&](IndexRange edges) {
      for (auto e = Index(edges.first); e < edges.end; ++e)
        for (Index i : cover(a, e)) {
          const Chain& s = chains[i];
          std::int32_t j = s.forward ? s.weight : -s.weight;
          across[e] += j;
          // Displaced to the left of v0 -> v1: the edge is on the right-hand side of the chain.
          if (s.forward != s.displaced_left) on[e] += j;
        }
    });
  }

  void number_edges(const Arrangement& a, Windings& w) const {
    w.edges.resize(a.edge_count());
    in_ranges(a.edge_count(), kManyCells, [&](IndexRange edges) {
      for (std::size_t e = edges.first; e < edges.end; ++e) w.edges[e] = w.faces[a.face[2 * e + 1]] + on[e];
    });
  }
};

void number_vertices(const Arrangement& a, const std::vector<Chain>& chains, const std::vector<Corner>& corners,
                     VertexScope scope, Windings& w) {
  VertexNumbers numbers(a, chains, w);
  numbers.prepare(scope);
  numbers.add_through();
  numbers.add(corners);
}

constexpr std::int32_t kSurelyInside = 1 << 30;  // more than curves change it by

/// Which edges are the border of the part.
std::vector<char> border_edges(const Arrangement& a, const InnerPart& inner) {
  std::vector<char> border(a.edge_count(), 0);
  for (Index k = a.chain_start[inner.first_border]; k < a.chain_start[a.pieces.size()]; ++k) border[a.chain[k]] = 1;
  return border;
}

/// One half-edge of each border edge, with the part on its left.
std::vector<Index> inner_sides(const Arrangement& a, const InnerPart& inner) {
  std::vector<Index> out;
  for (Index p = inner.first_border; p < a.pieces.size(); ++p)
    for (Index k = a.chain_start[p]; k < a.chain_start[p + 1]; ++k)
      out.push_back(2 * a.chain[k] + (inner.left_inside[p - inner.first_border] ? 0 : 1));
  return out;
}

std::vector<std::int32_t> spread(const Arrangement& a, const InnerPart& inner, const std::vector<char>& border,
                                 const std::vector<std::int32_t>& jump) {
  std::vector<std::int32_t> number(a.face_count, kUnwanted);
  std::vector<Index> starts;
  const auto start = [&](Index face, std::int32_t at) {
    if (number[face] != kUnwanted) return;
    number[face] = at;
    starts.push_back(face);
  };
  for (Index h : inner_sides(a, inner)) start(a.face[h], kSurelyInside);
  for (const InnerPart::Seed& s : inner.seeds) start(a.some_face(a.point_vertex[s.point]), s.number);
  if (starts.empty()) start(0, kSurelyInside);  // nothing is outside
  walk_faces(
      a, std::move(starts), [&](Index h) { return !border[h / 2]; },
      [&](Index h) {
        const std::int32_t f = number[a.face[h]];
        number[a.face[h ^ 1u]] = f == kSurelyInside ? f : h & 1u ? f + jump[h / 2] : f - jump[h / 2];
      });
  return number;
}

}  // namespace

Windings windings(const Arrangement& a, const std::vector<Chain>& chains, const std::vector<Corner>& corners,
                  std::int32_t base, VertexScope scope) {
  const Jumps jumps(a, chains);
  Windings w;
  w.faces = spread(a, base, [&](Index e) { return jumps.across[e]; });
  jumps.number_edges(a, w);
  number_vertices(a, chains, corners, scope, w);
  return w;
}

Windings windings(const Arrangement& a, const std::vector<Chain>& chains, const std::vector<Corner>& corners,
                  const InnerPart& inner) {
  const Jumps jumps(a, chains);
  const std::vector<char> border = border_edges(a, inner);
  Windings w;
  w.faces = spread(a, inner, border, jumps.across);
  jumps.number_edges(a, w);
  const auto is_inside = [&](Index h) { return w.faces[a.face[h]] == kSurelyInside; };
  for (Index e = 0; e < a.edge_count(); ++e)
    if (border[e] || is_inside(2 * e)) w.edges[e] = kSurelyInside;
  number_vertices(a, chains, corners, VertexScope::kInside, w);
  for (Index h = 0; h < a.face.size(); ++h)
    if (is_inside(h)) w.vertices[a.origin(h)] = kSurelyInside;
  return w;
}

}  // namespace findspace::plane
