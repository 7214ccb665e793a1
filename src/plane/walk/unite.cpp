// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/unite.h"

#include <algorithm>
#include <utility>

#include "exact/planar/unreduced_lines.h"
#include "plane/complex/overlay.h"
#include "plane/complex/ring_map.h"
#include "plane/walk/outer_walks.h"
#include "plane/walk/point_between.h"
#include "plane/walk/region_curves.h"

namespace findspace::plane {
namespace {

/// What bounds the union.
struct Rings {
  explicit Rings(Memory memory) : edges(memory), starts(memory) {}

  ArenaVector<RingEdge> edges;
  ArenaVector<Index> starts;
  bool touch = false;  // one itself, or another one; then those that run straight on are not joined

  Index end(std::size_t r) const { return r + 1 < starts.size() ? starts[r + 1] : Index(edges.size()); }
};

/// Along a walk the outer side is in the same sets everywhere, as no curve leads into it.
class UnionRings {
 public:
  UnionRings(RegionCurves& sets, const MeetingCurves& curves, Memory memory)
      : sets_(sets), curves_(curves), rings_(memory), place_(memory), passed_(memory) {
    rings_.edges.reserve(curves.size());
    choose_places();
  }

  /// Nothing where there are so many walks that an arrangement may cost less.
  std::optional<Rings> find(Memory memory) && {
    OuterWalks walks(curves_, memory);
    sets_.allow_looks(curves_.part_count());
    for (auto walk = walks.next(); !walk.empty(); walk = walks.next()) {
      if (!sets_.look_near(set_of(walk.front().curve))) return std::nullopt;
      if (!is_inside(simplest(walk))) add_ring(walk);
    }
    if (!place_.empty() && !rings_.touch) join_straight();
    return std::move(rings_);
  }

 private:
  /// Of every degenerate vertex one of its points, on the grid if there is one.
  void choose_places() {
    const DegenerateVertices& degenerate = curves_.degenerate_vertices();
    if (degenerate.empty()) return;
    const auto& points = sets_.curves.geometry.points;
    place_.assign(degenerate.count(), kNone);
    passed_.assign(degenerate.count(), 0);
    for (Index p = 0; p < points.size(); ++p)
      if (const Index at = degenerate.at(p); at != kNone)
        if (place_[at] == kNone || points[place_[at]].kind != exact::Point::Kind::kGrid) place_[at] = p;
  }

  Index set_of(Index curve) const { return sets_.curves.pieces[curve].group; }

  /// One that starts at the end of a curve, which is no crossing, if there is one.
  static CurvePart simplest(std::span<const CurvePart> walk) {
    const auto at = std::find_if(walk.begin(), walk.end(), [](const CurvePart& p) { return p.slot == 0; });
    return at == walk.end() ? walk.front() : *at;
  }

  bool is_inside(CurvePart p) {
    if (!place_.empty())
      return sets_.is_covered(
          point_between(sets_.curves.geometry, curves_.supporting_curve(p.curve), curves_.start(p), curves_.end(p)),
          p.curve);
    const Index own = set_of(p.curve), other = p.slot == 0 ? own : set_of(curves_.stop(p.curve, p.slot - 1).other);
    return sets_.is_inside_another(curves_.start(p), own, other);
  }

  void add_ring(std::span<const CurvePart> walk) {
    rings_.starts.push_back(Index(rings_.edges.size()));
    for (std::size_t k = walk.size(); k-- > 0;) {
      const CurvePart p = walk[k];
      Index from = curves_.start(p);
      if (const Index degenerate = curves_.degenerate_before(p); degenerate != kNone) {
        rings_.touch |= passed_[degenerate]++ > 0;
        from = place_[degenerate];
      }
      rings_.edges.push_back({from, curves_.supporting_curve(p.curve), curves_.right(p.curve)});
    }
  }

  void join_straight() {
    auto& edges = rings_.edges;
    Index kept = 0;
    for (std::size_t r = 0; r < rings_.starts.size(); ++r) {
      const Index first = rings_.starts[r], end = rings_.end(r);
      Index before = edges[end - 1].supporting_curve;
      rings_.starts[r] = kept;
      for (Index k = first; k < end; ++k) {
        const RingEdge e = edges[k];
        if (!parallel(before, e.supporting_curve)) edges[kept++] = e;
        before = e.supporting_curve;
      }
    }
    edges.resize(kept);
  }

  bool parallel(Index i, Index j) const {
    const auto& lines = sets_.curves.geometry.supporting_curves;
    return are_parallel(lines[i], lines[j]);
  }

  RegionCurves& sets_;
  const MeetingCurves& curves_;
  Rings rings_;
  ArenaVector<Index> place_, passed_;  // of a degenerate vertex: its point; how often a ring passes it
};

/// What the rings use is reduced: their lines, and the lines of corners where others cross.
void reduce_lines(exact::Geometry& geometry, const Rings& rings, Memory memory) {
  ArenaVector<Index> lines(memory), crossings(memory);
  lines.reserve(rings.edges.size());
  for (std::size_t r = 0; r < rings.starts.size(); ++r) {
    Index before = rings.edges[rings.end(r) - 1].supporting_curve;
    for (Index k = rings.starts[r]; k < rings.end(r); ++k) {
      const RingEdge& e = rings.edges[k];
      const Index line = e.supporting_curve;
      lines.push_back(line);
      const exact::Point& p = geometry.points[e.point];
      if (p.kind == exact::Point::Kind::kCross) {
        crossings.push_back(e.point);
        for (const Index other : {p.i, p.j})
          if (other != line && other != before) lines.push_back(other);
      }
      before = line;
    }
  }
  exact::reduce_lines(geometry, lines, crossings);
}

/// Rings that touch: their edges, which meet in common ends only, are arranged.
Region arranged(exact::Geometry geometry, const Rings& rings) {
  std::vector<Piece> pieces;
  pieces.reserve(rings.edges.size());
  for (std::size_t r = 0; r < rings.starts.size(); ++r) {
    const Index first = rings.starts[r], end = rings.end(r);
    for (Index k = first; k < end; ++k) {
      const RingEdge& e = rings.edges[k];
      const Index to = rings.edges[k + 1 == end ? first : k + 1].point;
      pieces.push_back({.supporting_curve = e.supporting_curve,
                        .p0 = e.right ? e.point : to,
                        .p1 = e.right ? to : e.point,
                        .group = 0});
    }
  }
  Arrangement a = arrange(std::move(geometry), std::move(pieces));
  Marks marks;
  marks.faces.assign(a.face_count, 0);
  marks.edges.assign(a.edge_count(), 1);
  marks.vertices.assign(a.vertex_count(), 1);
  for (Index e = 0; e < a.edge_count(); ++e) {
    const bool left = rings.edges[a.cover[a.cover_start[e]]].right;
    marks.faces[a.face[2 * e + (left ? 0 : 1)]] = 1;
  }
  return extract(std::move(a), marks);
}

std::optional<Rings> rings_of(RegionCurves& sets, Memory memory) {
  auto pairs = sets.pairs();
  if (!pairs) return std::nullopt;
  CurveStops stops = find_stops(sets.curves, *pairs, memory);
  pairs.reset();
  const MeetingCurves curves(sets.curves, std::move(stops), memory);
  return UnionRings(sets, curves, memory).find(memory);
}

std::optional<Region> united_by_walks(std::optional<RegionCurves> sets, Memory memory) {
  if (!sets) return std::nullopt;
  const std::optional<Rings> rings = rings_of(*sets, memory);
  if (!rings) return std::nullopt;
  if (rings->starts.empty()) return Region::uniform(0);
  const bool unreduced = sets->curves.unreduced;
  exact::Geometry geometry = std::move(sets->curves.geometry);
  sets.reset();
  if (unreduced) reduce_lines(geometry, *rings, memory);
  if (rings->touch) return arranged(std::move(geometry), *rings);
  const auto nested = nested_rings(geometry, rings->edges, rings->starts);
  return ring_map(std::move(geometry), rings->edges, nested, {1, 1, 0});
}

}  // namespace

std::optional<Region> united_by_walks(std::span<const Region* const> regions) {
  std::size_t edges = 0;
  for (const Region* r : regions) edges += r->edges.size();
  Arena arena(edges);
  return united_by_walks(RegionCurves::of(regions, arena.memory()), arena.memory());
}

std::optional<Region> united_by_walks(Polygons polygons) {
  std::size_t edges = 0;
  for (const auto& polygon : polygons) edges += polygon.empty() ? 0 : polygon[0].size();
  Arena arena(edges);
  return united_by_walks(RegionCurves::of(polygons, arena.memory()), arena.memory());
}

Region unite(std::span<const Region* const> regions) {
  if (regions.size() == 1) return *regions[0];
  if (auto united = united_by_walks(regions)) return *std::move(united);
  return unite_arranged(regions);
}

Region unite_rings(Polygons polygons) {
  if (auto united = united_by_walks(polygons)) return *std::move(united);
  std::vector<Region> regions;
  std::vector<const Region*> operands;
  for (const auto& polygon : polygons) regions.push_back(region_of_rings(polygon));
  for (const Region& r : regions) operands.push_back(&r);
  return unite(operands);
}

}  // namespace findspace::plane
