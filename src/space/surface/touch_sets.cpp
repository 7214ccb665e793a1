// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/touch_sets.h"

#include <algorithm>
#include <tuple>

#include "space/surface/surface_side.h"

namespace findspace::space {
namespace {

using exact::Real;

/// How a set lies about a facet.
enum class Cover { kApart, kCuts, kCovers };

GridBox box_of(std::span<const Point> points) {
  GridBox box{points[0], points[0]};
  for (const Point& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

Cover cover(const std::vector<Point>& ring, const TouchSet& set, double& depth) {
  bool all = true;
  depth = -exact::kInfinity;
  for (std::size_t h = 0; h < set.planes.size(); ++h) {
    const HalfSpace& plane = set.planes[h];
    bool inside = false;
    double sum = 0;
    for (const Point& p : ring) {
      const Vector near = exact::approx(p);
      const double v = plane.approx_value(near), e = plane.error(near);
      const Plane& whole = set.closed.planes()[h];
      const int sign = v > e ? 1 : v < -e ? -1 : exact::sign(exact::dot(whole.normal, p) + whole.offset);
      inside = inside || sign < 0;
      all = all && sign < 0;
      sum += v;
    }
    if (!inside) return Cover::kApart;
    depth = std::max(depth, sum / static_cast<double>(ring.size()));
  }
  return all ? Cover::kCovers : Cover::kCuts;
}

RealVector middle_of(const Polytope& part) {
  RealVector sum{};
  for (const Point& v : part.vertices()) sum = plus(sum, real(v));
  return scaled(Real(1) / Real(part.vertex_count()), sum);
}

}  // namespace

TouchSets::TouchSets(std::shared_ptr<const Sheet> a, std::vector<Polytope> b, TouchSide side)
    : a_(std::move(a)),
      b_(std::move(b)),
      side_(side),
      facets_(a_->body, side),
      shards_(std::make_unique<std::array<Shard, kShards>>()) {
  for (const Polytope& part : b_) boxes_.push_back(box_of(part.vertices()));
}

const TouchSet& TouchSets::set(const Pair& pair) const {
  const std::size_t key = pair.triangle * b_.size() + pair.part;
  Shard& shard = (*shards_)[key % kShards];
  {
    const std::lock_guard lock(shard.guard);
    if (const auto found = shard.sets.find(key); found != shard.sets.end()) return *found->second;
  }
  auto made = std::make_unique<const TouchSet>(touch_set(a_->body, pair.triangle, b_[pair.part]));
  const std::lock_guard lock(shard.guard);
  return *shard.sets.emplace(key, std::move(made)).first->second;
}

std::vector<TouchSets::Facet> TouchSets::facets(const Pair& of) const {
  std::vector<Facet> out;
  const Polytope& closed = set(of).closed;
  for (int f = 0; f < closed.facet_count(); ++f) {
    const Wide3& normal = closed.planes()[static_cast<std::size_t>(f)].normal;
    if (!facets_.may_touch(of.triangle, normal, closed.normal_approx(f))) continue;
    Facet facet{of, f, {}, {}};
    for (const int v : closed.circuit(f)) facet.ring.push_back(closed.vertices()[static_cast<std::size_t>(v)]);
    facet.box = box_of(facet.ring);
    out.push_back(std::move(facet));
  }
  return out;
}

/// The sets that cut the facet; false if one covers all of it.
bool TouchSets::find_cutters(const Facet& facet, std::vector<Cutter>& cutters) const {
  for (std::size_t k = 0; k < b_.size(); ++k) {
    // t - S meets the box where t meets the box plus S.
    const GridBox about{facet.box.low + boxes_[k].low, facet.box.high + boxes_[k].high};
    const bool covered = a_->tree.any_meeting(about, [&](int face) {
      const Pair other{static_cast<std::size_t>(face), k};
      if (other == facet.of) return false;
      double depth = 0;
      const Cover found = cover(facet.ring, set(other), depth);
      if (found == Cover::kCuts) cutters.push_back({depth, other});
      return found == Cover::kCovers;
    });
    if (covered) return false;
  }
  const auto order = [](const Cutter& c) { return std::tuple(c.depth, c.pair.triangle, c.pair.part); };
  std::sort(cutters.begin(), cutters.end(), [&](const Cutter& p, const Cutter& q) { return order(p) < order(q); });
  return true;
}

void TouchSets::add_pieces(const Facet& facet, std::vector<FlatPiece>& out) const {
  std::vector<Cutter> cutters;
  if (!find_cutters(facet, cutters)) return;
  const TouchSet& own = set(facet.of);
  FlatPiece whole{&own.planes[static_cast<std::size_t>(facet.facet)], {}};
  for (int h = own.closed.first_half_edge(facet.facet); h < own.closed.first_half_edge(facet.facet + 1); ++h) {
    const HalfEdge& edge = own.closed.half_edges()[static_cast<std::size_t>(h)];
    const Point& p = own.closed.vertices()[static_cast<std::size_t>(edge.origin)];
    whole.corners.push_back({real(p), exact::approx(p), &own.planes[static_cast<std::size_t>(edge.right)]});
  }
  std::vector<FlatPiece> left{std::move(whole)}, next;
  for (const Cutter& cutter : cutters) {
    next.clear();
    for (FlatPiece& piece : left) subtract(std::move(piece), set(cutter.pair).planes, next);
    left.swap(next);
    if (left.empty()) return;
  }
  const Lies wanted = side_ == TouchSide::kInside ? Lies::kInside : Lies::kOutside;
  for (FlatPiece& piece : left) {
    if (sides(piece.corners[0].at) == wanted) out.push_back(std::move(piece));
  }
}

/// No set holds p.
bool TouchSets::encloses_part(std::size_t part, const RealVector& p) const {
  const RealVector point = plus(p, middle_of(b_[part]));
  return side_of(a_->body, a_->tree, point, rounded(point)) == SurfaceSide::kInside;
}

TouchSets::Lies TouchSets::sides(const RealVector& p) const {
  const bool first = encloses_part(0, p);
  for (std::size_t k = 1; k < b_.size(); ++k) {
    if (encloses_part(k, p) != first) return Lies::kAcross;
  }
  return first ? Lies::kInside : Lies::kOutside;
}

}  // namespace findspace::space
