// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/build/touching_rings.h"

#include <algorithm>
#include <vector>

#include "plane/complex/piece_builder.h"
#include "plane/complex/winding.h"
#include "plane/contour/contour.h"

namespace findspace::plane {
namespace {

/// The edges that have a length.
Contour without_repeated(const Contour& ring) {
  Contour out;
  for (std::size_t k = 0; k < ring.size(); ++k)
    if (ring[k].start != end_of(ring, k)) out.push_back(ring[k]);
  return out;
}

bool has_common_corners(std::span<const Contour> clean) {
  std::vector<GridPoint> all;
  for (const Contour& ring : clean)
    for (const ContourEdge& e : ring) all.push_back(e.start);
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
}

/// Edges meet in common ends alone.
bool meet_in_corners_only(const Arrangement& a) {
  for (Index e = 0; e < a.edge_count(); ++e)
    if (a.cover_start[e + 1] - a.cover_start[e] != 1) return false;
  for (Index p = 0; p < a.pieces.size(); ++p)
    if (a.chain_start[p + 1] - a.chain_start[p] != 1) return false;
  return true;
}

}  // namespace

std::optional<Region> region_of_touching_rings(std::span<const Contour> rings, RingRule rule) {
  std::vector<Contour> clean;
  for (const Contour& ring : rings) clean.push_back(without_repeated(ring));
  if (!has_common_corners(clean)) return std::nullopt;
  PieceBuilder b;
  for (std::size_t r = 0; r < clean.size(); ++r) {
    const Contour& ring = clean[r];
    const std::size_t first = b.pieces.size();
    for (std::size_t k = 0; k < ring.size(); ++k) b.edge(ring[k], end_of(ring, k));
    if (rule == RingRule::kEvenOdd) continue;
    if (ring.empty() || has_common_corners({&ring, 1})) return std::nullopt;
    if (orientation(ring) == (r == 0 ? 1 : -1)) continue;
    for (std::size_t k = first; k < b.forward.size(); ++k) b.forward[k] = !b.forward[k];
  }
  const std::vector<char> forward = std::move(b.forward);
  Arrangement a = arrange(std::move(b.geometry), std::move(b.pieces));
  if (!meet_in_corners_only(a)) return std::nullopt;
  Marks m{{}, std::vector<Mark>(a.edge_count(), 1), std::vector<Mark>(a.vertex_count(), 1)};
  for (std::int32_t number : face_windings(a, forward, 0)) {
    if (rule == RingRule::kHoles && number != 0 && number != 1) return std::nullopt;
    m.faces.push_back(Mark(number & 1));
  }
  return extract(std::move(a), m);
}

}  // namespace findspace::plane
