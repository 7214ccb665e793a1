// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/walk/degenerate_vertices.h"

#include <algorithm>
#include <cassert>

namespace findspace::plane {
namespace {

/// Where a half-edge points, seen from another one.
enum ExactAngle { kRight = 1, kBack = 2, kLeft = 3, kSame = 4 };

int cross_sign(const DirectedEdge& p, const DirectedEdge& q) {
  const exact::int128 cross = exact::int128(p.dx) * q.dy - exact::int128(p.dy) * q.dx;
  return (cross > 0) - (cross < 0);
}

ExactAngle turn(const DirectedEdge& from, const DirectedEdge& to) {
  if (const int s = cross_sign(from, to); s != 0) return s < 0 ? kRight : kLeft;
  const bool same = from.dx != 0 ? (from.dx > 0) == (to.dx > 0) : (from.dy > 0) == (to.dy > 0);
  return same ? kSame : kBack;
}

/// Of two half-edges that point alike seen from another one: is p passed before q, turning clockwise?
bool comes_first(const DirectedEdge& p, const DirectedEdge& q) {
  const int s = cross_sign(p, q);
  return s != 0 ? s < 0 : p.starts && !q.starts;  // of two on one line, the one that shows an inner side
}

}  // namespace

Index& DegenerateVertices::parent(Index point) {
  constexpr std::size_t kSome = 16;
  if (point >= degenerate_of_.size()) {
    degenerate_of_.resize(std::max<std::size_t>(point + 1, points_), kNone);
    same_.reserve(kSome);
  }
  Index& degenerate = degenerate_of_[point];
  if (degenerate == kNone) same_.push_back(degenerate = Index(same_.size()));
  while (same_[degenerate] != degenerate) degenerate = same_[degenerate] = same_[same_[degenerate]];
  return same_[degenerate];
}

void DegenerateVertices::make(Index point) { parent(point); }

void DegenerateVertices::tie(Index p, Index q) {
  if (p == q) return make(p);
  parent(q);  // may move the other one
  Index &u = parent(p), &v = parent(q);
  if (u < v)
    v = u;
  else
    u = v;
}

void DegenerateVertices::settle(std::size_t points) {
  if (empty()) return;
  degenerate_of_.resize(points, kNone);
  for (Index k = 0; k < same_.size(); ++k) same_[k] = same_[k] == k ? count_++ : same_[same_[k]];
  for (Index& degenerate : degenerate_of_)
    if (degenerate != kNone) degenerate = same_[degenerate];
}

void DegenerateVertices::reserve(std::size_t directed_edges) {
  directed_edges_.reserve(directed_edges);
  first_directed_edge_.assign(count_, kNone);
}

const DirectedEdge& DegenerateVertices::clockwise(Index degenerate, Index curve, Index slot) const {
  const DirectedEdge *from = first(degenerate), *best = nullptr;
  while (!from->starts || from->curve != curve || from->slot != slot) from = next(*from);
  ExactAngle least = kSame;  // of the best
  for (const DirectedEdge* directed_edge = first(degenerate); directed_edge; directed_edge = next(*directed_edge)) {
    if (directed_edge == from) continue;
    const ExactAngle angle = turn(*from, *directed_edge);
    if (best && (angle > least || (angle == least && !comes_first(*directed_edge, *best)))) continue;
    best = directed_edge;
    least = angle;
  }
  assert(best);  // a chain that comes in goes out
  return *best;
}

bool DegenerateVertices::is_surrounded(Index degenerate) const {
  // A curve hides the half plane on its left. Some direction is left over if and only if the ways of the curves lie in
  // an open half plane: then there is one among them with none of the others to its right or straight behind it.
  auto way = [](DirectedEdge a) {
    if (!a.starts) {
      a.dx = -a.dx;
      a.dy = -a.dy;
    }
    return a;
  };
  bool any = false;
  for (const DirectedEdge* a = first(degenerate); a; a = next(*a)) {
    if (!a->hides) continue;
    any = true;
    const DirectedEdge rightmost = way(*a);
    bool is_rightmost = true;
    for (const DirectedEdge* b = first(degenerate); b && is_rightmost; b = next(*b)) {
      const ExactAngle t = b->hides ? turn(rightmost, way(*b)) : kSame;
      is_rightmost = t == kLeft || t == kSame;
    }
    if (is_rightmost) return false;
  }
  return any;
}

}  // namespace findspace::plane
