// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/lowest_in_complement.h"

#include <queue>

namespace findspace::space {

using exact::Real;

namespace {

using Key = std::vector<Real>;

int compare_keys(const Key& a, const Key& b) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (const int order = compare(a[k], b[k]); order != 0) return order;
  }
  return 0;
}

struct LowestPiece {
  ConvexRegion region;
  std::size_t lowest = 0;
  Key key;
  bool operator<(const LowestPiece& other) const { return compare_keys(key, other.key) > 0; }  // the least is on top
};

Key key_of(const RealVector& p, std::span<const RealVector> forms) {
  Key key;
  for (const RealVector& f : forms) key.push_back(dot(f, p));
  return key;
}

LowestPiece piece_of(ConvexRegion region, std::span<const RealVector> forms) {
  LowestPiece piece{std::move(region), 0, {}};
  const auto vertices = piece.region.vertices();
  piece.key = key_of(vertices[0].at, forms);
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    Key key = key_of(vertices[v].at, forms);
    if (compare_keys(key, piece.key) < 0) {
      piece.key = std::move(key);
      piece.lowest = v;
    }
  }
  return piece;
}

}  // namespace

std::optional<RealVector> lowest_in_complement(const OpenUnion& cover, const ConvexRegion& within,
                                               std::span<const RealVector> forms) {
  std::priority_queue<LowestPiece> queue;
  if (!within.empty()) queue.push(piece_of(within, forms));
  while (!queue.empty()) {
    LowestPiece top = queue.top();
    queue.pop();
    const RealVector& lowest = top.region.vertices()[top.lowest].at;
    const int set = cover.covering(lowest);
    if (set < 0) return lowest;
    for (const HalfSpace& h : cover.planes(static_cast<std::size_t>(set))) {
      const ConvexRegion::Sides sides = top.region.sides(h);
      if (!sides.on && !sides.outside) continue;
      ConvexRegion beyond = top.region;
      beyond.cut(h.opposite());
      if (!beyond.empty()) queue.push(piece_of(std::move(beyond), forms));
      top.region.cut(h);
      if (top.region.empty()) break;
    }
  }
  return std::nullopt;
}

}  // namespace findspace::space
