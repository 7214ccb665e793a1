// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Branch and bound: convex pieces by the distance of their farthest vertex. Where a set covers that vertex the piece is
// divided into its parts beyond the planes of the set, which may be flat: slits and points stay.
#include <algorithm>
#include <queue>

#include "space/body/open_union.h"
#include "space/polytope/convex_region.h"

namespace findspace::space {

namespace {

struct FarthestPiece {
  ConvexRegion region;
  double distance = 0;
  int farthest = 0;
  bool operator<(const FarthestPiece& other) const { return distance < other.distance; }
};

FarthestPiece piece_of(ConvexRegion region, const Vector& p) {
  FarthestPiece piece{std::move(region), -1, 0};
  for (int v = 0; v < static_cast<int>(piece.region.vertices().size()); ++v) {
    const double d = length(piece.region.vertices()[v].near - p);
    if (d > piece.distance) {
      piece.distance = d;
      piece.farthest = v;
    }
  }
  return piece;
}

}  // namespace

std::optional<RealVector> farthest_in_complement(const OpenUnion& cover, const RealVector& low, const RealVector& high,
                                                 const RealVector& p) {
  for (int k = 0; k < 3; ++k) {
    if (high[k] < low[k]) return std::nullopt;
  }
  const Vector near = space::rounded(p);
  std::priority_queue<FarthestPiece> queue;
  queue.push(piece_of(ConvexRegion(low, high), near));
  while (!queue.empty()) {
    FarthestPiece top = queue.top();
    queue.pop();
    const RealVector& v = top.region.vertices()[top.farthest].at;
    const int part = cover.covering(v);
    if (part < 0) return v;
    for (const HalfSpace& h : cover.planes(static_cast<std::size_t>(part))) {
      const ConvexRegion::Sides sides = top.region.sides(h);
      if (!sides.on && !sides.outside) continue;
      ConvexRegion beyond = top.region;
      beyond.cut(h.opposite());
      if (!beyond.empty()) queue.push(piece_of(std::move(beyond), near));
      top.region.cut(h);
      if (top.region.empty()) break;
    }
  }
  return std::nullopt;
}

}  // namespace findspace::space
