// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_max_min.h"

#include <algorithm>

#include "distance/search/boundary_cells.h"
#include "distance/search/lp_bound.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::Vector;
using Signed = SurfaceField::Signed;

namespace {

constexpr std::size_t kMostNear = 24;  // triangles that can be nearest in a cell

/// A cell is bounded by the signed distance of its middle, and by few triangles where no others are near.
class SurfaceTarget : public MaxMinTarget {
 public:
  SurfaceTarget(const MaxMinDomain& domain, const SurfaceField& a) : domain_(domain), a_(a) {}

  /// Of a place in B.
  Signed offer_in_b(const Vector& x, MaxMinBest& best, double known = exact::kInfinity) const {
    const Signed here = a_.at(x, known);
    best.offer(x, here.certain ? here.value : -here.distance);
    return here;
  }

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& best) const override {
    double reach = 0;
    for (const Vector& v : cell.corner) reach = std::max(reach, space::length(v - middle));
    const Signed here = seen(middle, cell.round, nearest(middle, cell.sets), best);
    cell.bound = std::min(cell.bound, here.value + reach);
    if (!best.worth(cell.bound)) return false;
    if (!cell.round && domain_.within && domain_.within->at(middle).value > reach + best.near()) return false;
    const double within = here.distance + 2 * reach;
    if (cell.sets.empty()) {
      if (auto found = a_.near(middle, within, kMostNear)) cell.sets = *std::move(found);
    } else {
      std::erase_if(cell.sets, [&](int set) { return distance(set, middle) > within + best.near(); });
    }
    for (const int set : cell.sets) {
      Column& column = cell.distances.emplace_back();
      for (std::size_t v = 0; v < 4; ++v) column[v] = distance(set, cell.corner[v]);
    }
    return true;
  }

  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    seen(x, cell.round, nearest(x, cell.sets), best);
  }

  double distance(int set, const Vector& x) const override { return a_.distance(set, x); }

  std::optional<Column> beyond(const MaxMinCell& cell, const Vector& middle) const override {
    if (cell.round) return cell.round->beyond_plane(middle, cell.corner);
    if (domain_.planes.empty()) return std::nullopt;
    return beyond_hull(middle, cell.corner);
  }

  double shortest_share() const override { return 0.25; }

 private:
  bool in_b(const Vector& x) const {
    if (!domain_.within) return true;
    const Signed of_b = domain_.within->at(x);
    return of_b.certain && of_b.value <= 0;
  }

  /// Of any place; what A says of it.
  Signed seen(const Vector& x, const RoundSolid* round, double known, MaxMinBest& best) const {
    const Signed here = a_.at(x, known);
    if (!best.worth(here.value)) return here;
    if (round && round->beyond(x) > 0)
      offer_in_b(round->pulled_in(x), best);
    else if (in_b(x))
      offer_in_b(x, best, known);
    return here;
  }

  /// How far the corners are beyond the plane of B's hull that the place is farthest beyond.
  Column beyond_hull(const Vector& x, const Tetrahedron& corners) const {
    const Vector& by = domain_.within->by();
    const auto most = std::max_element(domain_.planes.begin(), domain_.planes.end(), [&](const auto& g, const auto& h) {
      return g.approx_value(x - by) < h.approx_value(x - by);
    });
    Column out{};
    for (std::size_t v = 0; v < 4; ++v) out[v] = most->approx_value(corners[v] - by);
    return out;
  }

  double nearest(const Vector& x, const std::vector<int>& sets) const {
    double least = exact::kInfinity;
    for (const int set : sets) least = std::min(least, distance(set, x));
    return least;
  }

  const MaxMinDomain& domain_;
  const SurfaceField& a_;
};

}  // namespace

SolidMaxMin surface_max_min(const MaxMinDomain& domain, const SurfaceField& a) {
  const SurfaceTarget target(domain, a);
  double size = 0;
  for (const Vector& v : domain.corners) size = std::max(size, space::size_of(v));
  TetrahedralMaxMin search(target, MaxMinBest(-exact::kInfinity, -exact::kInfinity, 0, margin::kPlaceNoise * size));
  for (const Vector& v : domain.corners) target.offer_in_b(v, search.best());
  for (const Tetrahedron& t : domain.cells) search.add(t, nullptr, exact::kInfinity, {});
  for (const RoundSolid& r : domain.round) {
    // A ball has no more than its radius over its centre, often opposite to what is nearest there.
    const Signed here = target.offer_in_b(r.from, search.best());
    if (here.certain && here.distance > 0)
      target.offer_in_b(space::plus(r.from, space::scaled(r.radius / here.value, r.from - here.projection)),
                        search.best());
    for (const Tetrahedron& t : around(r)) search.add(t, &r, here.value + r.radius, {});
  }
  return search.run(kMostMaxMinCells);
}

}  // namespace findspace::distance
