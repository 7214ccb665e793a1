// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "plane/walk/unite.h"

#include <algorithm>
#include <utility>

#include "plane/complex/overlay.h"
#include "plane/complex/ring_map.h"
#include "plane/walk/outer_walks.h"
#include "plane/walk/region_curves.h"

namespace findspace::plane {
namespace {

/// A walk turns where it meets another set, so that other sets hold all of it or nothing.
class UnionRings {
 public:
  UnionRings(const RegionCurves& sets, const MeetingCurves& curves, Memory memory)
      : sets_(sets), curves_(curves), rings_(memory), starts_(memory) {
    rings_.reserve(curves.size());
    OuterWalks walks(curves, memory);
    for (Index i = 0; i < curves.size(); ++i)
      for (Index k = 0; k <= curves.stop_count(i); ++k) {
        if (!walks.is_new({i, k})) continue;
        const auto walk = walks.walk({i, k});
        if (!walk.empty() && !is_inside(walk.front())) add_ring(walk);
      }
  }

  std::span<const RingEdge> edges() const { return rings_; }
  std::span<const Index> starts() const { return starts_; }

 private:
  Index set_of(Index curve) const { return sets_.curves.pieces[curve].group; }

  bool is_inside(CurvePart p) const {
    const Index own = set_of(p.curve), other = p.slot == 0 ? own : set_of(curves_.stop(p.curve, p.slot - 1).other);
    return sets_.is_inside_another(curves_.start(p), own, other);
  }

  void add_ring(std::span<const CurvePart> walk) {
    starts_.push_back(Index(rings_.size()));
    for (std::size_t k = walk.size(); k-- > 0;)
      rings_.push_back({curves_.start(walk[k]), curves_.supporting_curve(walk[k].curve), curves_.right(walk[k].curve)});
  }

  const RegionCurves& sets_;
  const MeetingCurves& curves_;
  std::pmr::vector<RingEdge> rings_;
  std::pmr::vector<Index> starts_;
};

std::optional<Region> united_by_walks(std::optional<RegionCurves> sets, Memory memory) {
  if (!sets) return std::nullopt;
  const auto pairs = sets->pairs();
  if (!pairs) return std::nullopt;
  auto crossings = find_crossings(sets->curves, *pairs, memory);
  if (!crossings) return std::nullopt;
  const MeetingCurves curves(sets->curves, *std::move(crossings), memory);
  const UnionRings rings(*sets, curves, memory);
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

Region unite(Polygons polygons) {
  if (auto united = united_by_walks(polygons)) return *std::move(united);
  std::vector<Region> regions;
  std::vector<const Region*> operands;
  for (const auto& polygon : polygons) regions.push_back(region_of_rings(polygon));
  for (const Region& r : regions) operands.push_back(&r);
  return unite(operands);
}

}  // namespace findspace::plane
