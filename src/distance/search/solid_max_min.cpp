// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/solid_max_min.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "distance/search/round_solid.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/margins/space_distance.h"
#include "space/polytope/convex_region.h"
#include "space/polytope/polytope.h"

namespace findspace::distance {

using space::Vector;

namespace {

/// Convex sets that are all known: in each cell those that can be nearest.
class ConvexSets : public MaxMinTarget {
 public:
  explicit ConvexSets(std::span<const ConvexDistance> sets) : sets_(sets), all_(sets.size()) {
    std::iota(all_.begin(), all_.end(), 0);
  }
  /// A cell in the ball is no longer than twice its radius, and has a place of at most the least distance of the middle
  /// and the radius: look() would leave the others out. Of the radius two are to spare.
  std::vector<int> sets(const Vector& middle, double radius) const override {
    std::vector<double> distances;
    double least = exact::kInfinity;
    for (const int i : all_) {
      distances.push_back(std::isinf(radius) ? 0 : distance(i, middle));
      least = std::min(least, distances.back());
    }
    const double most = least + 6 * radius + margin::kPlaceNoise * (space::size_of(middle) + least + 1);
    std::vector<int> out;
    for (const int i : all_) {
      if (distances[static_cast<std::size_t>(i)] <= most) out.push_back(i);
    }
    return out;
  }

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& best) const override {
    std::size_t a = 0, b = 1;
    const double size = longest_edge(cell.corner, a, b);
    const std::vector<int> known = std::exchange(cell.sets, {});
    std::vector<Column> all;
    Column least;
    least.fill(exact::kInfinity);
    double bound = exact::kInfinity;
    for (const int i : known) {
      Column& d = all.emplace_back();
      for (std::size_t v = 0; v < 4; ++v) {
        d[v] = distance(i, cell.corner[v]);
        least[v] = std::min(least[v], d[v]);
      }
      bound = std::min(bound, *std::max_element(d.begin(), d.end()));
    }
    for (std::size_t k = 0; k < known.size(); ++k) {
      if (*std::max_element(all[k].begin(), all[k].end()) - size > bound) continue;
      cell.sets.push_back(known[k]);
      cell.distances.push_back(all[k]);
    }
    if (cell.round) {
      offer(middle, cell, best);
    } else {
      for (std::size_t v = 0; v < 4; ++v) best.offer(cell.corner[v], least[v]);
    }
    cell.bound = std::min(cell.bound, bound);
    return true;
  }

  /// Pulled into a round solid it may leave the cell, for which its sets are.
  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    const bool out = cell.round && cell.round->beyond(x) > 0;
    const Vector in = out ? cell.round->pulled_in(x) : x;
    double nearest = exact::kInfinity;
    for (const int i : out ? all_ : cell.sets) nearest = std::min(nearest, distance(i, in));
    best.offer(in, nearest);
  }

  double distance(int set, const Vector& x) const override { return sets_[static_cast<std::size_t>(set)](x); }

 private:
  std::span<const ConvexDistance> sets_;
  std::vector<int> all_;
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
  for (const std::vector<int>& ring : region.circuits()) add_fan(ring, at, out);
  return out;
}

SolidMaxMin solid_max_min(const Solids& solids, std::span<const ConvexDistance> sets, double slack, double share,
                          int most) {
  return tetrahedral_max_min(solids, ConvexSets(sets), MaxMinBest(std::min(0.0, slack), slack, share, 0), most);
}

std::vector<Tetrahedron> tetrahedra_of_box(const space::Extent& box) {
  const auto corner = [&](int k) {
    return Vector{(k & 1 ? box.high : box.low).x, (k & 2 ? box.high : box.low).y, (k & 4 ? box.high : box.low).z};
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
