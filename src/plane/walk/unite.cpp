// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/unite.h"

#include <algorithm>
#include <utility>

#include "plane/complex/overlay.h"
#include "plane/complex/ring_map.h"
#include "plane/walk/outer_walks.h"
#include "plane/walk/point_between.h"
#include "plane/walk/region_curves.h"

namespace findspace::plane {
namespace {

/// Along a walk the outer side is in the same sets everywhere, as no curve leads into it.
class UnionRings {
 public:
  UnionRings(RegionCurves& sets, const MeetingCurves& curves, Memory memory)
      : sets_(sets), curves_(curves), rings_(memory), starts_(memory), place_(memory) {
    rings_.reserve(curves.size());
    choose_places();
  }

  /// False where a ring touches itself or another one.
  bool find(Memory memory) {
    OuterWalks walks(curves_, memory);
    for (Index i = 0; i < curves_.size(); ++i)
      for (Index k = 0; k <= curves_.stop_count(i); ++k) {
        if (!walks.is_new({i, k})) continue;
        const auto walk = walks.walk({i, k});
        if (!walk.empty() && !is_inside(walk.front()) && !add_ring(walk)) return false;
      }
    return true;
  }

  std::span<const RingEdge> edges() const { return rings_; }
  std::span<const Index> starts() const { return starts_; }

 private:
  static constexpr Index kPassed = kNone - 1;

  /// Of every degenerate vertex one of its points, on the grid if there is one.
  void choose_places() {
    const DegenerateVertices& degenerate = curves_.degenerate_vertices();
    if (degenerate.empty()) return;
    const auto& points = sets_.curves.geometry.points;
    place_.assign(degenerate.count(), kNone);
    for (Index p = 0; p < points.size(); ++p)
      if (const Index at = degenerate.at(p); at != kNone)
        if (place_[at] == kNone || points[place_[at]].kind != exact::Point::Kind::kGrid) place_[at] = p;
  }

  Index set_of(Index curve) const { return sets_.curves.pieces[curve].group; }

  bool is_inside(CurvePart p) {
    if (!place_.empty())
      return sets_.is_covered(
          point_between(sets_.curves.geometry, curves_.supporting_curve(p.curve), curves_.start(p), curves_.end(p)),
          p.curve);
    const Index own = set_of(p.curve), other = p.slot == 0 ? own : set_of(curves_.stop(p.curve, p.slot - 1).other);
    return sets_.is_inside_another(curves_.start(p), own, other);
  }

  bool add_ring(std::span<const CurvePart> walk) {
    starts_.push_back(Index(rings_.size()));
    for (std::size_t k = walk.size(); k-- > 0;) {
      const CurvePart p = walk[k];
      Index from = curves_.start(p);
      if (const Index degenerate = curves_.degenerate_before(p); degenerate != kNone) {
        if (place_[degenerate] == kPassed) return false;
        from = std::exchange(place_[degenerate], kPassed);
        if (straight(walk[k + 1 == walk.size() ? 0 : k + 1].curve, p.curve)) continue;
      }
      rings_.push_back({from, curves_.supporting_curve(p.curve), curves_.right(p.curve)});
    }
    return true;
  }

  bool straight(Index i, Index j) const {
    const auto& lines = sets_.curves.geometry.supporting_curves;
    const auto &k = lines[curves_.supporting_curve(i)], &l = lines[curves_.supporting_curve(j)];
    return k.a == l.a && k.b == l.b;
  }

  RegionCurves& sets_;
  const MeetingCurves& curves_;
  std::pmr::vector<RingEdge> rings_;
  std::pmr::vector<Index> starts_;
  std::pmr::vector<Index> place_;  // of a degenerate vertex; kPassed where a ring passes it
};

std::optional<Region> united_by_walks(std::optional<RegionCurves> sets, Memory memory) {
  if (!sets) return std::nullopt;
  const auto pairs = sets->pairs();
  if (!pairs) return std::nullopt;
  const MeetingCurves curves(sets->curves, find_stops(sets->curves, *pairs, memory), memory);
  UnionRings rings(*sets, curves, memory);
  if (!rings.find(memory)) return std::nullopt;
  if (rings.starts().empty()) return Region::uniform(0);
  const auto nested = nested_rings(sets->curves.geometry, rings.edges(), rings.starts());
  return ring_map(std::move(sets->curves.geometry), rings.edges(), nested, {1, 1, 0});
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
