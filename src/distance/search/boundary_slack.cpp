// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/boundary_slack.h"

#include <algorithm>
#include <cmath>

#include "distance/search/boundary_cells.h"
#include "distance/search/boundary_columns.h"
#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr int kMostSlackCells = 20000;
constexpr int kSlackRounds = 4;  // of tangents in a cell
constexpr double kNear = 0.75;   // of the bound: a value that more tangents do not help

struct SlackCell : TetrahedralCell {
  double bound = 0;
  bool operator<(const SlackCell& other) const { return bound < other.bound; }
};

double slack_at(const Constraints& rules, const Vector& x) {
  double least = exact::kInfinity;
  for (const ConvexDistance& f : rules.keep_out) least = std::min(least, f(x));
  for (const TouchingRule& g : rules.keep_in) least = std::min(least, -g(x).value);
  return least;
}

/// What the slack is at most: chords of what is to be kept out of.
std::vector<Column> chords(const Constraints& rules, const Tetrahedron& corner) {
  std::vector<Column> out;
  for (const ConvexDistance& f : rules.keep_out) {
    Column& c = out.emplace_back();
    for (std::size_t v = 0; v < 4; ++v) c[v] = f(corner[v]);
  }
  return out;
}

/// Tangents at x of what is to be kept in.
void touch(const Constraints& rules, const Tetrahedron& corner, const Vector& x, std::vector<Column>& out) {
  for (const TouchingRule& g : rules.keep_in) out.push_back(less(0, tangent(g(x), x, corner)));
}

/// The greatest slack that the columns leave, and where.
Slack highest_slack(const std::vector<Column>& columns, const Tetrahedron& corner) {
  const HighestPlace high = highest_place(columns, corner);
  const Vector& x = high.place;
  if (std::isfinite(x.x + x.y + x.z)) {
    const double bound = high.value + margin::kLpNoise * high.spread;
    return {bound, bound, x, 0};
  }
  double greatest = 0;  // a cell of rounding
  for (const Column& c : columns) greatest = std::max(greatest, most(c));
  return {greatest, greatest, centre(corner), 0};
}

}  // namespace

Slack most_slack(std::span<const Tetrahedron> domain, const Constraints& rules, const SlackEnd& end) {
  Slack best{-exact::kInfinity, exact::kInfinity, {}, 0};
  plane::Subdivision<SlackCell> queue("tetrahedra of the place with the most slack");
  const auto add = [&](const Tetrahedron& corner) {
    std::vector<Column> columns = chords(rules, corner);
    touch(rules, corner, centre(corner), columns);
    double bound = exact::kInfinity;
    for (int round = 0; round < kSlackRounds && bound > std::max(end.enough, best.value); ++round) {
      const Slack at = highest_slack(columns, corner);
      bound = std::min(bound, at.bound);
      const double value = slack_at(rules, at.place);
      if (value > best.value) {
        best.value = value;
        best.place = at.place;
      }
      if (value > kNear * bound && value > 0) break;
      touch(rules, corner, at.place, columns);
    }
    queue.push({{corner}, bound});
  };
  for (const Tetrahedron& t : domain) add(t);
  const auto settled = [&](const SlackCell& top) {
    return top.bound <= end.enough || top.bound - best.value <= end.blur ||
           (best.value > std::max(0.0, end.enough) && best.value >= end.share * top.bound);
  };
  queue.run(kMostSlackCells, settled, [&](const SlackCell& top) {
    ++best.cells;
    std::size_t a = 0, b = 1;
    longest_edge(top.corner, a, b);
    for (const Tetrahedron& half : halves(top.corner, a, b)) add(half);
  });
  best.bound = queue.empty() ? best.value : std::max(best.value, queue.best().bound);
  return best;
}

}  // namespace findspace::distance
