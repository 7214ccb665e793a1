// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/wound_loops.h"

#include <algorithm>

#include "plane/complex/piece_builder.h"
#include "plane/complex/winding.h"
#include "plane/contour/contour.h"
#include "plane/query/topology.h"

namespace findspace::plane {

WoundLoops::WoundLoops(const std::vector<Loop>& loops, std::span<const std::size_t> chosen)
    : a_(arranged(loops, chosen)), windings_(face_windings(a_, forward_, 0)) {}

Arrangement WoundLoops::arranged(const std::vector<Loop>& loops, std::span<const std::size_t> chosen) {
  PieceBuilder b;
  for (const std::size_t i : chosen) {
    const Contour& edges = loops[i].edges;
    const std::size_t first = b.pieces.size();
    for (std::size_t k = 0; k < edges.size(); ++k) b.edge(edges[k], end_of(edges, k));
    loop_.resize(b.pieces.size(), i);
    if (!is_turned(loops[i])) continue;
    for (std::size_t k = first; k < b.pieces.size(); ++k) b.forward[k] = !b.forward[k];
  }
  forward_ = std::move(b.forward);
  return arrange(std::move(b.geometry), std::move(b.pieces));
}

bool WoundLoops::are_apart(std::span<const std::size_t> some) const {
  for (Index p = 0; p < a_.pieces.size(); ++p) {
    if (std::find(some.begin(), some.end(), loop_[p]) == some.end()) continue;
    if (a_.chain_start[p + 1] - a_.chain_start[p] != 1) return false;
    const Index e = a_.chain[a_.chain_start[p]];
    if (a_.cover_start[e + 1] - a_.cover_start[e] != 1) return false;
    if (a_.degree(a_.edges[e].v0) != 2 || a_.degree(a_.edges[e].v1) != 2) return false;
  }
  return true;
}

Region WoundLoops::run_back(const std::vector<Loop>& loops) const {
  Marks m = no_marks();
  for (Index e = 0; e < a_.edge_count(); ++e) {
    const std::int32_t left = windings_[a_.face[2 * e]], right = windings_[a_.face[2 * e + 1]];
    m.edges[e] = Mark(left == right && !(left >= 1 && is_shared_side(loops, e)));
  }
  return closed_set(m);
}

Marks WoundLoops::no_marks() const {
  return {std::vector<Mark>(a_.face_count, 0), std::vector<Mark>(a_.edge_count(), 0),
          std::vector<Mark>(a_.vertex_count(), 0)};
}

Region WoundLoops::closed_set(const Marks& marks) const {
  Arrangement copy = a_;
  return closure(extract(std::move(copy), marks));
}

bool WoundLoops::is_shared_side(const std::vector<Loop>& loops, Index edge) const {
  const Index from = a_.cover_start[edge];
  if (a_.cover_start[edge + 1] - from != 2) return false;
  const Loop &f = loops[loop_[a_.cover[from]]], &g = loops[loop_[a_.cover[from + 1]]];
  return f.ring != g.ring && f.depth % 2 == 0 && g.depth % 2 == 0;
}

}  // namespace findspace::plane
