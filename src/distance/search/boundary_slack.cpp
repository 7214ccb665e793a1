// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/boundary_slack.h"

#include <algorithm>

#include "distance/search/boundary_columns.h"
#include "distance/search/tetrahedral_max_min.h"
#include "exact/number/interval.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr int kMostSlackCells = 20000;
constexpr int kSlackRounds = 4;  // of tangents in a cell
constexpr double kNear = 0.75;   // of the bound: a value that more tangents do not help

/// Over a cell the slack is at most the chords of what is to be kept out of, and the tangents of what is to be kept in.
class SlackTarget : public MaxMinTarget {
 public:
  explicit SlackTarget(const Constraints& constraints) : constraints_(constraints) {}

  bool look(MaxMinCell& cell, const Vector& middle, MaxMinBest& /*best*/) const override {
    ++looks_;
    for (const ConvexDistance& f : constraints_.reverse_convex) {
      Column& c = cell.distances.emplace_back();
      for (std::size_t v = 0; v < 4; ++v) c[v] = f(cell.corner[v]);
    }
    touch(middle, cell);
    for (const Column& c : cell.distances) cell.bound = std::min(cell.bound, most(c));
    return true;
  }

  void offer(const Vector& x, MaxMinCell& cell, MaxMinBest& best) const override {
    double least = exact::kInfinity;
    for (const ConvexDistance& f : constraints_.reverse_convex) least = std::min(least, f(x));
    for (const TouchingConstraint& g : constraints_.convex) least = std::min(least, -g(x).value);
    best.offer(x, least);
    if (!(least > kNear * cell.bound && least > 0)) touch(x, cell);
  }

  double distance(int set, const Vector& x) const override {
    return constraints_.reverse_convex[static_cast<std::size_t>(set)](x);
  }
  double shortest_share() const override { return 1; }
  int rounds() const override { return kSlackRounds; }
  int looks() const { return looks_; }

 private:
  void touch(const Vector& x, MaxMinCell& cell) const {
    for (const TouchingConstraint& g : constraints_.convex)
      cell.distances.push_back(less(0, tangent(g(x), x, cell.corner)));
  }

  const Constraints& constraints_;
  mutable int looks_ = 0;
};

}  // namespace

Slack most_slack(std::span<const Tetrahedron> domain, const Constraints& constraints, const SlackEnd& end) {
  const SlackTarget target(constraints);
  const SolidMaxMin found =
      tetrahedral_max_min({{domain.begin(), domain.end()}}, target,
                          MaxMinBest(-exact::kInfinity, end.enough, 1 - end.share, end.blur), kMostSlackCells);
  const int cells = (target.looks() - static_cast<int>(domain.size())) / 2;  // each is looked at by halves
  return {found.value, found.bound, found.place, cells};
}

}  // namespace findspace::distance
