// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/union_frontier.h"

#include <algorithm>
#include <iterator>

#include "exact/margins/rounding.h"
#include "space/polytope/polytope_sets.h"

namespace findspace::space {
namespace {

struct Box {
  Vector low, high;
};

Box box_of(const ConvexRegion& set) {
  Box box{set.vertices()[0].near, set.vertices()[0].near};
  double size = 1;
  for (const ConvexRegion::Vertex& v : set.vertices()) {
    box.low = {std::min(box.low.x, v.near.x), std::min(box.low.y, v.near.y), std::min(box.low.z, v.near.z)};
    box.high = {std::max(box.high.x, v.near.x), std::max(box.high.y, v.near.y), std::max(box.high.z, v.near.z)};
    size = std::max(size, size_of(v.near));
  }
  const double tolerance = margin::kWiderBox * size;
  box.low = box.low - Vector{tolerance, tolerance, tolerance};
  box.high = plus(box.high, {tolerance, tolerance, tolerance});
  return box;
}

bool apart(const Box& a, const Box& b) {
  return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y || a.high.z < b.low.z ||
         b.high.z < a.low.z;
}

}  // namespace

void subtract(ConvexRegion piece, const std::vector<HalfSpace>& set, std::vector<ConvexRegion>& out) {
  for (const HalfSpace& h : set) {
    if (!piece.sides(h).inside) {  // nothing of it lies in the open set
      out.push_back(std::move(piece));
      return;
    }
  }
  for (const HalfSpace& h : set) {
    const ConvexRegion::Sides sides = piece.sides(h);
    if (!sides.outside && !sides.on) continue;
    ConvexRegion beyond = piece;
    beyond.cut(h.opposite());
    if (!beyond.empty()) out.push_back(std::move(beyond));
    piece.cut(h);
    if (!piece.sides(h).inside) return;
  }
}

std::vector<ConvexRegion> cover_frontier(std::span<const std::vector<HalfSpace>> sets, const RealVector& low,
                                         const RealVector& high) {
  std::vector<ConvexRegion> bodies;
  std::vector<Box> boxes;
  std::vector<const std::vector<HalfSpace>*> planes;
  for (const std::vector<HalfSpace>& set : sets) {
    ConvexRegion body(low, high);
    for (const HalfSpace& h : set) body.cut(h);
    if (body.dimension() < 3) continue;
    boxes.push_back(box_of(body));
    bodies.push_back(std::move(body));
    planes.push_back(&set);
  }
  std::vector<ConvexRegion> frontier;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    for (const int f : bodies[k].facets()) {
      if (f < 6) continue;  // the box
      ConvexRegion facet = bodies[k];
      facet.cut(bodies[k].planes()[static_cast<std::size_t>(f)].opposite());
      std::vector<ConvexRegion> left{std::move(facet)}, next;
      for (std::size_t other = 0; other < bodies.size() && !left.empty(); ++other) {
        if (other == k) continue;
        next.clear();
        for (ConvexRegion& piece : left) {
          if (apart(box_of(piece), boxes[other]))
            next.push_back(std::move(piece));
          else
            subtract(std::move(piece), *planes[other], next);
        }
        left.swap(next);
      }
      for (ConvexRegion& piece : left) frontier.push_back(std::move(piece));
    }
  }
  return frontier;
}

namespace {

/// Whether facets of two of them may lie on each other, or one on a facet of a convex set that they are taken from.
bool flush_facets(std::span<const Polytope> kept, std::span<const Polytope> taken) {
  std::vector<Plane> planes, opposite;
  for (const Polytope& p : taken) planes.insert(planes.end(), p.planes().begin(), p.planes().end());
  for (const Plane& p : planes) opposite.push_back({-p.normal, -p.offset});
  for (const Polytope& p : kept) opposite.insert(opposite.end(), p.planes().begin(), p.planes().end());
  std::sort(planes.begin(), planes.end());
  return std::any_of(opposite.begin(), opposite.end(),
                     [&](const Plane& p) { return std::binary_search(planes.begin(), planes.end(), p); });
}

}  // namespace

std::vector<ConvexRegion> thin_pieces(std::span<const Polytope> kept, std::span<const Polytope> taken,
                                      std::span<const ConvexRegion> cells) {
  if (!flush_facets(kept, taken)) return {};
  const ConvexRegion region = common_region(kept);
  if (region.empty()) return {};
  std::vector<ConvexRegion> out;
  RealVector low = region.vertices()[0].at, high = low;
  for (const ConvexRegion::Vertex& v : region.vertices()) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v.at[k]);
      high[k] = std::max(high[k], v.at[k]);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {  // so that faces of the region count as those of the sets
    low[k] -= exact::Real(1);
    high[k] += exact::Real(1);
  }
  std::vector<std::vector<HalfSpace>> sets;
  for (const Polytope& p : taken) sets.emplace_back(p.planes().begin(), p.planes().end());
  std::vector<Box> boxes;
  for (const ConvexRegion& cell : cells) boxes.push_back(box_of(cell));
  for (ConvexRegion& piece : cover_frontier(sets, low, high)) {
    for (const HalfSpace& h : region.planes()) piece.cut(h);
    if (piece.empty()) continue;
    const Box around = box_of(piece);
    std::vector<ConvexRegion> near;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (!apart(around, boxes[k])) near.push_back(cells[k]);
    }
    std::vector<ConvexRegion> left = uncovered(piece, near);
    std::move(left.begin(), left.end(), std::back_inserter(out));
  }
  return out;
}

std::vector<ConvexRegion> complement_pieces(const OpenUnion& cover, const RealVector& low, const RealVector& high) {
  std::vector<ConvexRegion> left, next;
  const ConvexRegion whole(low, high);
  if (whole.dimension() == 3) left.push_back(whole);
  for (std::size_t k = 0; k < cover.size() && !left.empty(); ++k) {
    const Box around{cover.extent(k).low, cover.extent(k).high};
    next.clear();
    for (ConvexRegion& piece : left) {
      if (apart(box_of(piece), around))
        next.push_back(std::move(piece));
      else
        subtract(std::move(piece), cover.planes(k), next);
    }
    std::erase_if(next, [](const ConvexRegion& piece) { return piece.dimension() < 3; });
    left.swap(next);
  }
  return left;
}

}  // namespace findspace::space
