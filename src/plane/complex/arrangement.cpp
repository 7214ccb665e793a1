// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/arrangement.h"

#include <algorithm>
#include <utility>

#include "exact/planar/geometry_signs.h"
#include "plane/base/parallel.h"
#include "plane/base/release.h"
#include "plane/base/small_sort.h"
#include "plane/base/union_find.h"
#include "plane/complex/around_vertex.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/nesting.h"
#include "plane/complex/piece_meet.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

constexpr std::size_t kManyToSort = 2000;  // from here on ranges of them are worked on at once

struct Chains {
  ArenaVector<Index> start, point;  // piece -> its points from p0 to p1, ties dropped

  explicit Chains(Memory memory) : start(memory), point(memory) {}
};

/// Sorts the split points of every piece along it; equal points are tied and kept once.
class AlongPieces {
 public:
  AlongPieces(const Geometry& g, std::span<const Piece> pieces, const PieceMeetings& found, Memory memory)
      : g_(g), pieces_(pieces), start_(pieces.size() + 1, 0, memory), sorted_(found.splits.size(), memory) {
    for (auto& s : found.splits) ++start_[s.piece + 1];
    for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
    ArenaVector<Index> at(start_.begin(), start_.end() - 1, memory);
    for (auto& s : found.splits) sorted_[at[s.piece]++] = s.point;
  }

  struct Sorted {
    Chains chains;  // without the last start
    ArenaVector<PieceMeetings::Tie> ties;

    explicit Sorted(Memory memory) : chains(memory), ties(memory) {}
    void append(const Sorted& next) {
      for (const Index s : next.chains.start) chains.start.push_back(s + Index(chains.point.size()));
      chains.point.insert(chains.point.end(), next.chains.point.begin(), next.chains.point.end());
      ties.insert(ties.end(), next.ties.begin(), next.ties.end());
    }
  };

  void sort(IndexRange pieces, Sorted& to) {
    auto& [start, point] = to.chains;
    start.reserve(pieces.size() + 1);
    point.reserve(start_[pieces.end] - start_[pieces.first] + 2 * pieces.size());
    for (std::size_t i = pieces.first; i < pieces.end; ++i) {
      const Piece& p = pieces_[i];
      start.push_back(Index(point.size()));
      point.push_back(p.p0);
      auto first = sorted_.begin() + start_[i], last = sorted_.begin() + start_[i + 1];
      small_sort(first, last, [&](Index a, Index b) { return a != b && compare_along(g_, p, a, b) < 0; });
      for (auto k = first; k != last; ++k) {
        if (k != first && (*k == *(k - 1) || compare_along(g_, p, *k, *(k - 1)) == 0))
          to.ties.push_back({*k, *(k - 1)});
        else
          point.push_back(*k);
      }
      point.push_back(p.p1);
    }
  }

 private:
  const Geometry& g_;
  std::span<const Piece> pieces_;
  ArenaVector<Index> start_, sorted_;  // piece -> its splits
};

/// Ranges of the pieces at once where there are many.
Chains sort_along(const Geometry& g, std::span<const Piece> pieces, const PieceMeetings& found, UnionFind& same,
                  Memory memory) {
  AlongPieces along(g, pieces, found, memory);
  AlongPieces::Sorted all(memory);
  if (const std::size_t count = range_count(pieces.size(), kManyToSort); count == 1) {
    along.sort({0, pieces.size()}, all);
  } else {
    std::vector<AlongPieces::Sorted> parts(count, AlongPieces::Sorted(kHeap));
    parallel_for(count, [&](std::size_t k) { along.sort(range(k, count, pieces.size()), parts[k]); });
    all.chains.start.reserve(pieces.size() + 1);
    all.chains.point.reserve(found.splits.size() + 2 * pieces.size());
    for (AlongPieces::Sorted& part : parts) all.append(std::exchange(part, AlongPieces::Sorted(memory)));
  }
  for (const auto& t : all.ties) same.unite(t.p, t.q);
  all.chains.start.push_back(Index(all.chains.point.size()));
  return std::move(all.chains);
}

/// Isolated points that coincide with each other become one point.
void unite_isolated(const Geometry& g, std::span<const Index> isolated, UnionFind& same) {
  std::vector<Index> sorted(isolated.begin(), isolated.end());
  std::sort(sorted.begin(), sorted.end(), [&](Index a, Index b) { return compare_xy(g, a, b) < 0; });
  for (std::size_t k = 1; k < sorted.size(); ++k)
    if (compare_xy(g, sorted[k], sorted[k - 1]) == 0) same.unite(sorted[k], sorted[k - 1]);
}

/// Numbers the vertices in order of their leading point; grid points represent their vertex where there is one.
void number_vertices(Arrangement& a, const Chains& chains, std::span<const Index> isolated, UnionFind& same,
                     Memory memory) {
  const auto& points = a.geometry.points;
  ArenaVector<char> used(points.size(), 0, memory);
  for (Index p : chains.point) used[same.find(p)] = 1;
  for (Index p : isolated) used[same.find(p)] = 1;
  ArenaVector<Index> vertex(points.size(), kNone, memory);
  a.vertex_point.reserve(points.size());
  for (Index p = 0; p < points.size(); ++p)
    if (used[p]) {
      vertex[p] = Index(a.vertex_point.size());
      a.vertex_point.push_back(p);
    }
  a.point_vertex.assign(points.size(), kNone);
  for (Index p = 0; p < points.size(); ++p) {
    Index v = vertex[same.find(p)];
    a.point_vertex[p] = v;
    if (v != kNone && points[p].kind == exact::Point::Kind::kGrid &&
        points[a.vertex_point[v]].kind != exact::Point::Kind::kGrid)
      a.vertex_point[v] = p;
  }
}

/// Vertices where pieces meet and end; the points along the pieces.
Chains make_vertices(Arrangement& a, PieceMeetings& found, std::span<const Index> isolated, Memory memory) {
  UnionFind same(a.geometry.points.size(), memory);
  for (auto& t : found.ties) same.unite(t.p, t.q);
  Chains chains = sort_along(a.geometry, a.pieces, found, same, memory);
  release(found.splits);
  unite_isolated(a.geometry, isolated, same);
  number_vertices(a, chains, isolated, same, memory);
  return chains;
}

/// A part of a piece between neighbouring points on it, at its first vertex.
struct PiecePart {
  Index v1, piece, slot;
};

struct Parts {
  ArenaVector<Index> start;  // of each vertex
  ArenaVector<PiecePart> parts;
};

Parts parts_by_vertex(Arrangement& a, const Chains& chains, Memory memory) {
  Index n = a.vertex_count();
  ArenaVector<Index> start(n + 1, 0, memory);
  a.chain_start.reserve(a.pieces.size() + 1);
  a.chain_start.push_back(0);
  for (Index i = 0; i < a.pieces.size(); ++i) {
    for (Index k = chains.start[i]; k + 1 < chains.start[i + 1]; ++k) ++start[a.point_vertex[chains.point[k]] + 1];
    a.chain_start.push_back(a.chain_start.back() + (chains.start[i + 1] - chains.start[i] - 1));
  }
  for (Index v = 0; v < n; ++v) start[v + 1] += start[v];
  ArenaVector<PiecePart> parts(start.back(), memory);
  ArenaVector<Index> at(start.begin(), start.end() - 1, memory);
  for (Index i = 0; i < a.pieces.size(); ++i)
    for (Index k = chains.start[i]; k + 1 < chains.start[i + 1]; ++k) {
      Index v0 = a.point_vertex[chains.point[k]], v1 = a.point_vertex[chains.point[k + 1]];
      parts[at[v0]++] = {v1, i, a.chain_start[i] + (k - chains.start[i])};
    }
  return {std::move(start), std::move(parts)};
}

bool same_curve(const Arrangement& a, const Arrangement::Edge& e, const Piece& p) {
  return e.half == p.half && (p.half == 0 || e.supporting_curve == p.supporting_curve ||
                              same_supporting_curve(a.geometry.supporting_curves[e.supporting_curve],
                                                    a.geometry.supporting_curves[p.supporting_curve]));
}

/// Which pieces each edge lies on, given how many.
void make_covers(Arrangement& a, const ArenaVector<Index>& cover_count, Memory memory) {
  a.cover_start.reserve(cover_count.size() + 1);
  a.cover_start.push_back(0);
  for (Index c : cover_count) a.cover_start.push_back(a.cover_start.back() + c);
  a.cover.resize(a.chain.size());
  ArenaVector<Index> fill(a.cover_start.begin(), a.cover_start.end() - 1, memory);
  for (Index i = 0; i < a.pieces.size(); ++i)
    for (Index k = a.chain_start[i]; k < a.chain_start[i + 1]; ++k) a.cover[fill[a.chain[k]]++] = i;
}

/// The edges of some vertices, numbered from 0.
struct EdgesOfRange {
  std::vector<Arrangement::Edge> edges;
  std::vector<Index> cover_count;
};

/// Edges that are the same curve between the same vertices become one.
void find_edges(Arrangement& a, Parts& all, IndexRange vertices, EdgesOfRange& out) {
  const std::size_t most = all.start[vertices.end] - all.start[vertices.first];
  out.edges.reserve(most);
  out.cover_count.reserve(most);
  for (auto v = Index(vertices.first); v < vertices.end; ++v) {
    auto first = all.parts.begin() + all.start[v], last = all.parts.begin() + all.start[v + 1];
    small_sort(first, last,
               [](const PiecePart& p, const PiecePart& q) { return p.v1 != q.v1 ? p.v1 < q.v1 : p.piece < q.piece; });
    Index group = Index(out.edges.size());
    for (auto k = first; k != last; ++k) {
      if (k != first && k->v1 != (k - 1)->v1) group = Index(out.edges.size());
      const Piece& p = a.pieces[k->piece];
      Index e = group;
      while (e < out.edges.size() && !same_curve(a, out.edges[e], p)) ++e;
      if (e == out.edges.size()) {
        out.edges.push_back({v, k->v1, p.supporting_curve, p.half});
        out.cover_count.push_back(0);
      }
      ++out.cover_count[e];
      a.chain[k->slot] = e;
    }
  }
}

/// Cuts the pieces into edges, those of ranges of vertices at once.
void make_edges(Arrangement& a, Chains chains, Memory memory) {
  Parts all = parts_by_vertex(a, chains, memory);
  release(chains.point);
  a.chain.resize(a.chain_start.back());
  const std::size_t ranges = range_count(a.vertex_count(), kManyToSort);
  std::vector<EdgesOfRange> found(ranges);
  each_range(ranges, [&](std::size_t k) { find_edges(a, all, range(k, ranges, a.vertex_count()), found[k]); });
  std::vector<Index> before{0};
  for (const EdgesOfRange& r : found) before.push_back(before.back() + Index(r.edges.size()));
  a.edges.reserve(before.back());
  ArenaVector<Index> cover_count(memory);
  cover_count.reserve(before.back());
  for (EdgesOfRange& r : found) {
    a.edges.insert(a.edges.end(), r.edges.begin(), r.edges.end());
    cover_count.insert(cover_count.end(), r.cover_count.begin(), r.cover_count.end());
    release(r.edges);
    release(r.cover_count);
  }
  each_range(ranges, [&](std::size_t k) {
    if (k == 0) return;
    const IndexRange vertices = range(k, ranges, a.vertex_count());
    for (Index p = all.start[vertices.first]; p < all.start[vertices.end]; ++p) a.chain[all.parts[p].slot] += before[k];
  });
  release(all.parts);
  make_covers(a, cover_count, memory);
}

}  // namespace

Arrangement arrange(Geometry geometry, std::vector<Piece> pieces, std::span<const Index> isolated, Memory memory) {
  Arena arena(pieces.size());
  Memory working = arena.memory();
  Arrangement a(memory);
  a.geometry = std::move(geometry);
  a.pieces = std::move(pieces);
  CellGrid grid(a.geometry, a.pieces, isolated, working);
  PieceMeetings found(a.geometry, a.pieces, working);
  found.add_pairs(grid);
  for (Index p : isolated) {
    const exact::Point q = a.geometry.points[p];
    for (Index i : grid.cell(grid.column(q.x), grid.row(q.y))) found.add_point(p, i);
  }
  Chains chains = make_vertices(a, found, isolated, working);
  make_edges(a, std::move(chains), working);
  sort_around_vertices(a);
  nest(a, grid, working);
  return a;
}

}  // namespace findspace::plane
