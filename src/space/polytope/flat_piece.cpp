// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/polytope/flat_piece.h"

#include <algorithm>

namespace findspace::space {
namespace {

using exact::Real;
using FlatCorner = FlatPiece::Corner;

/// Where three planes meet, whose normals are linearly independent.
RealVector meeting(const HalfSpace& f, const HalfSpace& g, const HalfSpace& h) {
  const RealVector fg = cross(f.normal, g.normal), gh = cross(g.normal, h.normal), hf = cross(h.normal, f.normal);
  const RealVector sum = plus(plus(scaled(f.offset, gh), scaled(g.offset, hf)), scaled(h.offset, fg));
  return scaled(Real(-1) / dot(fg, h.normal), sum);
}

FlatCorner meeting(const FlatPiece& piece, const FlatCorner& edge, const HalfSpace& h, const HalfSpace* next) {
  RealVector at = meeting(*piece.plane, *edge.side, h);
  const Vector near = rounded(at);
  return {std::move(at), near, next};
}

}  // namespace

std::optional<std::array<FlatPiece, 2>> split(const FlatPiece& polygon, const HalfSpace& h) {
  std::vector<int> signs;
  for (const FlatCorner& c : polygon.corners) signs.push_back(h.sign(c.at, c.near));
  const auto [least, most] = std::minmax_element(signs.begin(), signs.end());
  if (*least >= 0 || *most <= 0) return std::nullopt;
  std::array<FlatPiece, 2> out{FlatPiece{polygon.plane, {}}, FlatPiece{polygon.plane, {}}};
  const std::size_t n = polygon.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const FlatCorner& a = polygon.corners[k];
    const int here = signs[k], next = signs[(k + 1) % n];
    for (const int side : {-1, 1}) {
      // The cut runs on from a corner on the plane behind which the part ends.
      if (here * side >= 0) out[side > 0].corners.push_back({a.at, a.near, here == 0 && next * side < 0 ? &h : a.side});
    }
    if (here * next >= 0) continue;
    const FlatCorner cut = meeting(polygon, a, h, &h);
    out[here > 0].corners.push_back(cut);
    out[next > 0].corners.push_back({cut.at, cut.near, a.side});
  }
  return out;
}

}  // namespace findspace::space
