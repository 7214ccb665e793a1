// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/tetrahedral_max_min.h"

#include <algorithm>
#include <cmath>

#include "distance/search/strict_work.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using space::Vector;

double MaxMinBest::near() const {
  return std::isfinite(found_.value) ? margin::kMaxMinNear * std::fabs(found_.value) + noise_ : 0;
}

void MaxMinBest::offer(const Vector& x, double value) {
  if (!(value > found_.value)) return;
  found_.value = value;
  found_.place = x;
}

bool MaxMinBest::worth(double bound) const {
  return bound > found_.value + near() && bound > slack_ && !(found_.value - slack_ > (bound - slack_) * (1 - share_));
}

void MaxMinTarget::offer_all(std::span<const Vector> places, MaxMinBest& best) const {
  for (const Vector& v : places) offer_in(v, best);
}

std::optional<Column> MaxMinTarget::beyond(const MaxMinCell& cell, const Vector& middle) const {
  return cell.round ? cell.round->beyond_plane(middle, cell.corner) : std::nullopt;
}

namespace {

class TetrahedralMaxMin {
 public:
  TetrahedralMaxMin(const MaxMinTarget& target, const MaxMinBest& start) : target_(target), best_(start) {}

  void add(const Solids& solids);
  SolidMaxMin run(long most);

 private:
  void add(MaxMinCell cell);
  void split(const MaxMinCell& cell);
  bool dropped(double bound);
  double bend(const MaxMinCell& cell, std::size_t v, std::size_t w) const;

  const MaxMinTarget& target_;
  MaxMinBest best_;
  double bound_ = -exact::kInfinity;  // of what was left out
  plane::Subdivision<MaxMinCell> queue_{"tetrahedra of the farthest place of a solid from a set"};
};

void TetrahedralMaxMin::add(const Solids& solids) {
  target_.offer_all(solids.corners, best_);
  for (auto first = solids.cells.begin(); first != solids.cells.end();) {
    // Those of one part begin with one corner.
    const auto last = std::find_if(first, solids.cells.end(),
                                   [&](const Tetrahedron& t) { return space::length(t[0] - (*first)[0]) > 0; });
    const Vector middle = centre(*first);
    double radius = 0;
    for (auto t = first; t != last; ++t) {
      for (const Vector& v : *t) radius = std::max(radius, space::length(v - middle));
    }
    const std::vector<int> sets = target_.sets(middle, radius);
    for (; first != last; ++first) add({{*first}, sets, {}, nullptr, exact::kInfinity});
  }
  const std::vector<int> all = solids.round.empty() ? std::vector<int>() : target_.sets({}, exact::kInfinity);
  for (const RoundSolid& r : solids.round) {
    // No distance grows faster than a step.
    const double ceiling =
        r.way ? exact::kInfinity : target_.offer_in(r.from, best_) + space::length(r.to - r.from) + r.radius;
    for (const Tetrahedron& t : around(r)) add({{t}, all, {}, &r, ceiling});
  }
}

/// Nothing in it has more than its bound.
void TetrahedralMaxMin::add(MaxMinCell cell) {
  const Vector middle = centre(cell.corner);
  cell.beyond = target_.beyond(cell, middle);
  if (cell.beyond && *std::min_element(cell.beyond->begin(), cell.beyond->end()) > best_.near()) return;
  if (!target_.look(cell, middle, best_) || dropped(cell.bound)) return;
  for (int round = 0; round < target_.rounds() && !cell.distances.empty(); ++round) {
    const LpBound lp = bounding_lp(cell.distances, cell.beyond);
    cell.bound = std::min(cell.bound, lp.value);
    if (dropped(cell.bound)) return;
    const std::size_t known = cell.distances.size();
    target_.offer(mean(lp.rows, cell.corner), cell, best_);
    if (cell.distances.size() == known) break;
  }
  if (!dropped(cell.bound)) queue_.push(std::move(cell));
}

/// Whether a cell is not worth a look.
bool TetrahedralMaxMin::dropped(double bound) {
  if (best_.worth(bound)) return false;
  bound_ = std::max(bound_, bound);
  return true;
}

SolidMaxMin TetrahedralMaxMin::run(long most) {
  bool spent = false;
  const auto end = queue_.run(
      most,
      [&](const MaxMinCell& top) { return !best_.worth(top.bound) || (spent = target_.spent() || strictly_spent()); },
      [this](const MaxMinCell& top) { split(top); });
  SolidMaxMin out = best_.found();
  out.complete = !spent && end != plane::SubdivisionEnd::kSpent;
  // Less than these was not looked for; and of more than the slack a share may lack.
  out.bound = std::max({out.value + best_.near(), best_.slack(), bound_});
  if (!queue_.empty()) out.bound = std::max(out.bound, queue_.best().bound);
  return out;
}

/// By how much the distances exceed, half-way between two corners, what their values there make one expect: none where
/// they are linear. That is what the bound of a cell loses.
double TetrahedralMaxMin::bend(const MaxMinCell& cell, std::size_t v, std::size_t w) const {
  const Vector middle = space::scaled(0.5, space::plus(cell.corner[v], cell.corner[w]));
  double most = 0;
  for (std::size_t k = 0; k < cell.distances.size(); ++k) {
    const double expected = (cell.distances[k][v] + cell.distances[k][w]) / 2;
    most = std::max(most, expected - target_.distance(cell.sets[k], middle));
  }
  if (!cell.round) return most;
  const double expected = (cell.round->beyond(cell.corner[v]) + cell.round->beyond(cell.corner[w])) / 2;
  return std::max(most, expected - cell.round->beyond(middle));
}

/// Across the edge along which the distances bend most, so that cells stay long on flat ridges.
void TetrahedralMaxMin::split(const MaxMinCell& cell) {
  plane::count_cell();
  std::size_t a = 0, b = 1;
  const double longest = longest_edge(cell.corner, a, b);
  if (target_.shortest_share() < 1) {
    std::size_t v_bent = a, w_bent = b;
    double greatest = best_.near();
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t w = v + 1; w < 4; ++w) {
        const double bent = bend(cell, v, w);
        if (bent <= greatest) continue;
        greatest = bent;
        v_bent = v;
        w_bent = w;
      }
    }
    if (space::length(cell.corner[v_bent] - cell.corner[w_bent]) > target_.shortest_share() * longest) {
      a = v_bent;
      b = w_bent;
    }
  }
  for (const Tetrahedron& half : halves(cell.corner, a, b))
    add({{half}, cell.sets, {}, cell.round, cell.bound, {}, cell.near, cell.near_reach, cell.outside, cell.inner});
}

}  // namespace

SolidMaxMin tetrahedral_max_min(const Solids& solids, const MaxMinTarget& target, const MaxMinBest& start, long most) {
  TetrahedralMaxMin search(target, start);
  search.add(solids);
  return search.run(most);
}

}  // namespace findspace::distance
