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

void find_signs(const FlatPiece& piece, const HalfSpace& h, std::vector<int>& signs) {
  signs.clear();
  for (const FlatCorner& c : piece.corners) signs.push_back(h.sign(c.at, c.near));
}

bool any(const std::vector<int>& signs, int sign) { return std::find(signs.begin(), signs.end(), sign) != signs.end(); }

/// What lies on the side of the plane with the given sign, or on it.
FlatPiece clipped(const FlatPiece& piece, const HalfSpace& h, const std::vector<int>& signs, int side) {
  FlatPiece out{piece.plane, {}};
  const std::size_t n = piece.corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const FlatCorner& a = piece.corners[i];
    const int sa = signs[i] * side, sb = signs[(i + 1) % n] * side;
    if (sa >= 0) out.corners.push_back({a.at, a.near, sa == 0 && sb < 0 ? &h : a.side});
    if (n == 2 && i == 1) continue;  // the way back
    if (sa > 0 && sb < 0) out.corners.push_back(meeting(piece, a, h, n == 2 ? a.side : &h));
    if (sa < 0 && sb > 0) out.corners.push_back(meeting(piece, a, h, a.side));
  }
  return out;
}

}  // namespace

void subtract(FlatPiece piece, std::span<const HalfSpace> set, std::vector<FlatPiece>& out) {
  std::vector<int> signs;
  for (const HalfSpace& h : set) {
    find_signs(piece, h, signs);
    if (any(signs, -1)) continue;
    out.push_back(std::move(piece));  // nothing of it lies in the open set
    return;
  }
  for (const HalfSpace& h : set) {
    find_signs(piece, h, signs);
    if (!any(signs, 0) && !any(signs, 1)) continue;
    out.push_back(clipped(piece, h, signs, 1));
    if (!any(signs, -1)) return;
    if (any(signs, 1)) piece = clipped(piece, h, signs, -1);
  }
}

}  // namespace findspace::space
