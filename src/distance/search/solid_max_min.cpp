// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/solid_max_min.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "distance/search/lp_bound.h"
#include "distance/search/max_min_queue.h"
#include "distance/search/round_solid.h"
#include "exact/margins/space_distance.h"
#include "space/polytope/convex_region.h"
#include "space/polytope/polytope.h"

namespace findspace::distance {

using space::Vector;

namespace {

struct MaxMinCell {
  Tetrahedron corner;
  std::vector<int> sets;  // that can be nearest in the cell
  std::vector<Column> distances;
  const RoundSolid* round = nullptr;  // only what lies in it counts
  double bound = 0;
  bool operator<(const MaxMinCell& other) const { return bound < other.bound; }
};

class MaxMinSearch {
 public:
  MaxMinSearch(std::span<const Tetrahedron> solid, std::span<const RoundSolid> round,
               std::span<const ConvexDistance> sets, double slack, double share)
      : sets_(sets), queue_(slack, share) {
    all_.resize(sets.size());
    std::iota(all_.begin(), all_.end(), 0);
    for (const Tetrahedron& t : solid) add(t, all_, exact::kInfinity, nullptr);
    for (const RoundSolid& r : round) {
      for (const Tetrahedron& t : around(r)) add(t, all_, exact::kInfinity, &r);
    }
  }

  SolidMaxMin run(int most) {
    return queue_.run([this](const MaxMinCell& top) { split(top); }, most);
  }

 private:
  double nearest(const Vector& x, const std::vector<int>& sets) const {
    double least = exact::kInfinity;
    for (const int i : sets) least = std::min(least, sets_[std::size_t(i)](x));
    return least;
  }

  void add(const Tetrahedron& corner, const std::vector<int>& sets, double ceiling, const RoundSolid* round) {
    MaxMinCell cell;
    cell.corner = corner;
    cell.round = round;
    const Vector middle =
        space::scaled(0.25, space::plus(space::plus(corner[0], corner[1]), space::plus(corner[2], corner[3])));
    std::optional<Column> beyond;
    if (round) beyond = round->beyond_plane(middle, corner);
    if (beyond && *std::min_element(beyond->begin(), beyond->end()) > 0) return;
    double size = 0, bound = exact::kInfinity;
    for (const Vector& v : corner) {
      for (const Vector& w : corner) size = std::max(size, space::length(v - w));
    }
    std::vector<Column> all;
    Column least;
    least.fill(exact::kInfinity);
    for (const int i : sets) {
      Column d{};
      for (std::size_t v = 0; v < 4; ++v) {
        d[v] = sets_[std::size_t(i)](corner[v]);
        least[v] = std::min(least[v], d[v]);
      }
      all.push_back(d);
      bound = std::min(bound, *std::max_element(d.begin(), d.end()));
    }
    for (std::size_t k = 0; k < sets.size(); ++k) {
      if (*std::max_element(all[k].begin(), all[k].end()) - size > bound) continue;
      cell.sets.push_back(sets[k]);
      cell.distances.push_back(all[k]);
    }
    if (round) {
      offer_in(*round, middle, cell.sets);
    } else {
      for (std::size_t v = 0; v < 4; ++v) queue_.offer(corner[v], least[v]);
    }
    if (!queue_.worth(bound)) return;
    const LpBound lp = bounding_lp(cell.distances, beyond);
    cell.bound = std::min(ceiling, lp.value);
    if (!queue_.worth(cell.bound)) return;
    Vector x;
    for (std::size_t v = 0; v < 4; ++v) x = space::plus(x, space::scaled(lp.rows[v], corner[v]));
    if (round)
      offer_in(*round, x, cell.sets);
    else
      queue_.offer(x, nearest(x, cell.sets));
    queue_.push(std::move(cell));
  }

  /// Pulled into the solid it may leave the cell, for which `sets` are.
  void offer_in(const RoundSolid& round, const Vector& x, const std::vector<int>& sets) {
    const bool out = round.beyond(x) > 0;
    const Vector in = out ? round.pulled_in(x) : x;
    queue_.offer(in, nearest(in, out ? all_ : sets));
  }

  /// By how much the distances exceed, half-way between two corners, what their values there make one expect: none
  /// where they are linear. That is what the bound of a cell loses.
  double bend(const MaxMinCell& cell, std::size_t v, std::size_t w) const {
    const Vector middle = space::scaled(0.5, space::plus(cell.corner[v], cell.corner[w]));
    double most = 0;
    for (std::size_t k = 0; k < cell.sets.size(); ++k) {
      const double mean = (cell.distances[k][v] + cell.distances[k][w]) / 2;
      most = std::max(most, mean - sets_[std::size_t(cell.sets[k])](middle));
    }
    if (!cell.round) return most;
    const double mean = (cell.round->beyond(cell.corner[v]) + cell.round->beyond(cell.corner[w])) / 2;
    return std::max(most, mean - cell.round->beyond(middle));
  }

  /// Across the edge with the greatest bend, so that cells stay long on flat ridges; else the longest edge.
  void split(const MaxMinCell& cell) {
    std::size_t a = 0, b = 1;
    double longest = 0, greatest = margin::kDistanceNoise * std::fabs(queue_.best().value);
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t w = v + 1; w < 4; ++w) {
        const double d = space::length(cell.corner[v] - cell.corner[w]), bent = bend(cell, v, w);
        if (bent > greatest) {
          greatest = bent;
          longest = exact::kInfinity;
          a = v;
          b = w;
        } else if (d > longest) {
          longest = d;
          a = v;
          b = w;
        }
      }
    }
    const Vector middle = space::scaled(0.5, space::plus(cell.corner[a], cell.corner[b]));
    for (const std::size_t moved : {a, b}) {
      Tetrahedron corner = cell.corner;
      corner[moved] = middle;
      add(corner, cell.sets, cell.bound, cell.round);
    }
  }

  std::span<const ConvexDistance> sets_;
  std::vector<int> all_;
  MaxMinQueue<MaxMinCell> queue_;
};

/// A fan over the facet's circuit from corner `apex`.
template <class At>
void add_fan(const std::vector<int>& ring, At at, std::vector<Tetrahedron>& out) {
  if (std::find(ring.begin(), ring.end(), 0) != ring.end()) return;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) out.push_back({at(0), at(ring[0]), at(ring[i]), at(ring[i + 1])});
}

}  // namespace

std::vector<Tetrahedron> tetrahedra(const space::Polytope& s) {
  std::vector<Tetrahedron> out;
  const auto at = [&](int v) { return exact::approx(s.vertices()[static_cast<std::size_t>(v)]); };
  for (int f = 0; f < s.facet_count(); ++f) add_fan(s.circuit(f), at, out);
  return out;
}

std::vector<Tetrahedron> tetrahedra(const space::ConvexRegion& region) {
  std::vector<Tetrahedron> out;
  if (region.dimension() < 3) return out;
  const auto at = [&](int v) { return region.vertices()[static_cast<std::size_t>(v)].near; };
  for (const int f : region.facets()) add_fan(region.circuit(f), at, out);
  return out;
}

SolidMaxMin solid_max_min(std::span<const Tetrahedron> solid, std::span<const ConvexDistance> sets, double slack,
                          double share) {
  return MaxMinSearch(solid, {}, sets, slack, share).run(kMostCells);
}

SolidMaxMin solid_max_min(std::span<const Tetrahedron> solid, std::span<const RoundSolid> round,
                          std::span<const ConvexDistance> sets, double slack, double share, int most) {
  return MaxMinSearch(solid, round, sets, slack, share).run(most);
}

std::vector<Tetrahedron> tetrahedra_of_box(const Vector& low, const Vector& high) {
  const auto corner = [&](int k) {
    return Vector{k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z};
  };
  std::vector<Tetrahedron> out;
  for (const int a : {1, 2, 4}) {
    for (const int b : {1, 2, 4}) {
      if (a != b) out.push_back({corner(0), corner(a), corner(a | b), corner(7)});
    }
  }
  return out;
}

}  // namespace findspace::distance
