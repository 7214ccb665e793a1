// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/facet_rays.h"

#include <set>
#include <tuple>
#include <utility>

#include "space/convolution/ray_convolution.h"
#include "space/rays/piece_rays.h"

namespace findspace::space {
namespace {

using exact::Real;
using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t>;

Key key(const Point& p) { return {p.x, p.y, p.z}; }

/// Corners, edges and faces of facets that may touch, each once.
std::vector<LinePiece> pieces_about(const std::vector<RayFacet>& facets, const Real& radius) {
  std::vector<LinePiece> pieces;
  std::set<Key> corners;
  std::set<std::pair<Key, Key>> edges;
  std::vector<RealVector> ring;
  for (const RayFacet& f : facets) {
    const Wide3 normal = f.normal();
    if (!f.outer || exact::is_zero(normal)) continue;
    ring.clear();
    for (int k = 0; k < f.corners; ++k) {
      const Point &p = f.corner[static_cast<std::size_t>(k)],
                  &q = f.corner[static_cast<std::size_t>(k + 1 == f.corners ? 0 : k + 1)];
      ring.push_back(real(p));
      if (corners.insert(key(p)).second) pieces.push_back(ball_piece(real(p), radius));
      if (edges.insert(std::minmax(key(p), key(q))).second) pieces.push_back(cylinder_piece(real(p), real(q), radius));
    }
    pieces.push_back(slab_piece(ring, real(normal), radius));
  }
  return pieces;
}

}  // namespace

RaySourcePointer clearance_rays(const Triangles& a, const Triangles& b, const Real& level, const RayGrid& grid,
                                PairRays::Side side_of_a) {
  const bool complement = side_of_a == PairRays::Side::kComplement;
  const RayBody fixed(complement ? inside_out(a) : a), mirrored(scaled(b, -1));
  std::vector<RaySourcePointer> both;
  both.push_back(std::make_unique<PairRays>(a, b, grid, side_of_a));
  both.push_back(std::make_unique<PieceRays>(pieces_about(convolution(fixed, mirrored), level), 1, grid));
  return combined_rays(std::move(both), [complement](std::span<const std::int8_t> s) {
    // Of the complement the overlap is where the first sign is not -.
    if (complement) return static_cast<std::int8_t>(s[0] < 0 ? -s[1] : 1);
    return s[0] < 0 ? std::int8_t{-1} : s[1];
  });
}

}  // namespace findspace::space
