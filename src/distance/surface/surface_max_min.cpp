// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_max_min.h"

#include <algorithm>
#include <cassert>
#include <queue>

#include "distance/search/boundary_cells.h"
#include "distance/search/lp_bound.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::Vector;
using Signed = SurfaceField::Signed;

namespace {

constexpr std::size_t kMostNear = 24;  // triangles that can be nearest in a cell, for a bound_of_lp

struct DistanceCell {
  Tetrahedron corner;
  std::vector<SurfaceField::Distance> sets;  // all that can be nearest in the cell; none: too many
  std::vector<std::array<double, 4>> distances;
  const RoundSolid* round = nullptr;  // only what lies in it counts
  double bound = 0;
  bool operator<(const DistanceCell& other) const { return bound < other.bound; }
};

Vector middle_of(const Tetrahedron& t) {
  return space::scaled(0.25, space::plus(space::plus(t[0], t[1]), space::plus(t[2], t[3])));
}

class DistanceMaxMin {
 public:
  DistanceMaxMin(const MaxMinDomain& domain, const SurfaceField& a) : domain_(domain), a_(a) {
    best_.value = -exact::kInfinity;
    for (const Vector& v : domain.corners) {
      size_ = std::max(size_, space::size_of(v));
      offer_in_b(v);
    }
    for (const Tetrahedron& t : domain.cells) add(t, nullptr, exact::kInfinity, {});
    for (const RoundSolid& r : domain.round) add_round(r);
  }

  SurfaceMaxMin run() {
    for (int count = 0; !queue_.empty(); ++count) {
      const DistanceCell top = queue_.top();
      if (!worth(top.bound)) break;
      if (count == kMostMaxMinCells) {
        best_.complete = false;
        best_.bound = top.bound;
        return best_;
      }
      queue_.pop();
      observe(seen_, top.corner);
      split(top);
    }
    best_.bound = best_.value + slack();
    return best_;
  }

 private:
  double slack() const {
    return std::isfinite(best_.value) ? margin::kMaxMinNear * std::fabs(best_.value) + margin::kPlaceNoise * size_ : 0;
  }
  bool worth(double bound) const { return bound > best_.value + slack(); }

  /// Of a place in B.
  Signed offer_in_b(const Vector& x, double known = exact::kInfinity) {
    const Signed here = a_.at(x, known);
    const double value = here.certain ? here.value : -here.distance;
    if (value > best_.value) {
      best_.value = value;
      best_.place = x;
    }
    return here;
  }

  bool in_b(const Vector& x) const {
    if (!domain_.within) return true;
    const Signed of_b = domain_.within->at(x);
    return of_b.certain && of_b.value <= 0;
  }

  /// Of any place; what A says of it.
  Signed offer(const Vector& x, const RoundSolid* round, double known) {
    const Signed here = a_.at(x, known);
    if (!worth(here.value)) return here;
    if (round && round->beyond(x) > 0)
      offer_in_b(round->pulled_in(x));
    else if (in_b(x))
      offer_in_b(x, known);
    return here;
  }

  /// How far the corners are beyond the plane of B's hull that the place is farthest beyond.
  std::array<double, 4> beyond_hull(const Vector& x, const Tetrahedron& corners) const {
    const space::HalfSpace* most = nullptr;
    double value = -exact::kInfinity;
    for (const space::HalfSpace& h : domain_.planes) {
      const double v = h.approx_value(x - domain_.within->by());
      if (v > value) {
        value = v;
        most = &h;
      }
    }
    assert(most != nullptr);  // a hull has planes
    std::array<double, 4> out{};
    for (std::size_t v = 0; v < 4; ++v) out[v] = most->approx_value(corners[v] - domain_.within->by());
    return out;
  }

  static double nearest(const Vector& x, const std::vector<SurfaceField::Distance>& sets) {
    double least = exact::kInfinity;
    for (const auto& d : sets) least = std::min(least, d(x));
    return least;
  }

  /// A ball has no more than its radius over its centre, often opposite to what is nearest there.
  void add_round(const RoundSolid& r) {
    const Signed here = offer_in_b(r.from);
    if (here.certain && here.distance > 0) {
      const double part = r.radius / here.value;
      offer_in_b(space::plus(r.from, space::scaled(part, r.from - here.projection)));
    }
    for (const Tetrahedron& t : around(r)) add(t, &r, here.value + r.radius, {});
  }

  void add(const Tetrahedron& corner, const RoundSolid* round, double ceiling,
           const std::vector<SurfaceField::Distance>& sets) {
    const Vector middle = middle_of(corner);
    double reach = 0;
    for (const Vector& v : corner) reach = std::max(reach, space::length(v - middle));
    std::optional<std::array<double, 4>> beyond;
    if (round) beyond = round->beyond_plane(middle, corner);
    if (!round && !domain_.planes.empty()) beyond = beyond_hull(middle, corner);
    if (beyond && *std::min_element(beyond->begin(), beyond->end()) > slack()) return;
    DistanceCell cell{corner, {}, {}, round, ceiling};
    const double known = nearest(middle, sets);
    const Signed here = offer(middle, round, known);
    cell.bound = std::min(ceiling, here.value + reach);
    if (!worth(cell.bound)) return;
    if (!round && domain_.within && domain_.within->at(middle).value > reach + slack()) return;
    const double within = here.distance + 2 * reach;
    if (sets.empty()) {
      if (auto found = a_.near(middle, within, kMostNear)) cell.sets = *std::move(found);
    } else {
      for (const auto& d : sets) {
        if (d(middle) <= within + slack()) cell.sets.push_back(d);
      }
    }
    if (!cell.sets.empty() && !play(cell, beyond)) return;
    queue_.push(std::move(cell));
  }

  /// The bound by the bound_of_lp of the distances; whether the cell is still worth it.
  bool play(DistanceCell& cell, const std::optional<std::array<double, 4>>& beyond) {
    for (const auto& d : cell.sets) {
      std::array<double, 4> column{};
      for (std::size_t v = 0; v < 4; ++v) column[v] = d(cell.corner[v]);
      cell.distances.push_back(column);
    }
    const LpBound bound_of_lp = bounding_lp(cell.distances, beyond);
    cell.bound = std::min(cell.bound, bound_of_lp.value);
    if (!worth(cell.bound)) return false;
    Vector x;
    for (std::size_t v = 0; v < 4; ++v) x = space::plus(x, space::scaled(bound_of_lp.rows[v], cell.corner[v]));
    offer(x, cell.round, nearest(x, cell.sets));
    return worth(cell.bound);
  }

  /// By how much the distances half-way between two corners fall short of their means there: what the bound loses.
  double bend(const DistanceCell& cell, std::size_t v, std::size_t w) const {
    const Vector middle = space::scaled(0.5, space::plus(cell.corner[v], cell.corner[w]));
    double most = 0;
    for (std::size_t k = 0; k < cell.sets.size(); ++k)
      most = std::max(most, (cell.distances[k][v] + cell.distances[k][w]) / 2 - cell.sets[k](middle));
    if (!cell.round) return most;
    const double mean = (cell.round->beyond(cell.corner[v]) + cell.round->beyond(cell.corner[w])) / 2;
    return std::max(most, mean - cell.round->beyond(middle));
  }

  /// Across the edge with the greatest bend, unless it is much shorter than the longest; else across that.
  void split(const DistanceCell& cell) {
    std::array<std::size_t, 2> longest{0, 1}, bent{0, 1};
    double length = 0, most = 0, bent_length = 0;
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t w = v + 1; w < 4; ++w) {
        const double d = space::length(cell.corner[v] - cell.corner[w]), b = bend(cell, v, w);
        if (d > length) {
          length = d;
          longest = {v, w};
        }
        if (b > most) {
          most = b;
          bent = {v, w};
          bent_length = d;
        }
      }
    }
    const bool by_bend = most > slack() && bent_length > length / 4;
    const auto [v, w] = by_bend ? bent : longest;
    const Vector middle = space::scaled(0.5, space::plus(cell.corner[v], cell.corner[w]));
    for (const std::size_t moved : {v, w}) {
      Tetrahedron corner = cell.corner;
      corner[moved] = middle;
      add(corner, cell.round, cell.bound, cell.sets);
    }
  }

  const MaxMinDomain& domain_;
  const SurfaceField& a_;
  double size_ = 0;
  std::priority_queue<DistanceCell> queue_;
  plane::ObservedCells seen_{"tetrahedra of the farthest place of a solid from a surface"};
  SurfaceMaxMin best_;
};

}  // namespace

SurfaceMaxMin surface_max_min(const MaxMinDomain& domain, const SurfaceField& a) {
  return DistanceMaxMin(domain, a).run();
}

}  // namespace findspace::distance
