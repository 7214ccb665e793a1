// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/front_slack.h"

#include <algorithm>
#include <queue>

#include "distance/matrix_game.h"
#include "exact/interval.h"

namespace findspace::distance {

using space::Vector;

namespace {

constexpr int kMostSlackCells = 20000;

using Column = std::array<double, 4>;

struct Cell {
  Tetrahedron corner;
  double bound = 0;
  bool operator<(const Cell& other) const { return bound < other.bound; }
};

double slack_at(const Rules& rules, const Vector& x) {
  double least = exact::kInfinity;
  for (const ConvexDistance& f : rules.keep_out) least = std::min(least, f(x));
  for (const TouchingRule& g : rules.keep_in) least = std::min(least, -g(x).value);
  return least;
}

std::vector<Column> columns_of(const Rules& rules, const Tetrahedron& corner) {
  std::vector<Column> out;
  for (const ConvexDistance& f : rules.keep_out) {
    Column& c = out.emplace_back();
    for (std::size_t v = 0; v < 4; ++v) c[v] = f(corner[v]);
  }
  const Vector middle =
      space::scaled(0.25, space::plus(space::plus(corner[0], corner[1]), space::plus(corner[2], corner[3])));
  for (const TouchingRule& g : rules.keep_in) {
    const Touching at = g(middle);
    Column& c = out.emplace_back();
    for (std::size_t v = 0; v < 4; ++v) c[v] = -at.value - space::dot(at.slope, corner[v] - middle);
  }
  return out;
}

}  // namespace

Slack most_slack(std::span<const Tetrahedron> room, const Rules& rules, double enough) {
  Slack best{-exact::kInfinity, exact::kInfinity, {}};
  std::priority_queue<Cell> queue;
  const auto add = [&](const Tetrahedron& corner) {
    std::vector<Column> columns = columns_of(rules, corner);
    double lowest = 0, highest = 0;
    for (const Column& c : columns) {
      for (const double entry : c) lowest = std::min(lowest, entry), highest = std::max(highest, entry);
    }
    for (Column& c : columns) {
      for (double& entry : c) entry -= lowest;
    }
    const GameValue game = matrix_game(columns);
    Vector x;
    for (std::size_t v = 0; v < 4; ++v) x = space::plus(x, space::scaled(game.rows[v], corner[v]));
    const double value = slack_at(rules, x);
    if (value > best.value) best.value = value, best.place = x;
    queue.push({corner, game.value + lowest + 0x1p-44 * (highest - lowest)});
  };
  for (const Tetrahedron& t : room) add(t);
  for (int count = 0; !queue.empty() && count < kMostSlackCells; ++count) {
    const Cell top = queue.top();
    if (top.bound <= enough || (best.value > enough && 2 * best.value >= top.bound)) break;
    queue.pop();
    std::size_t a = 0, b = 1;
    longest_edge(top.corner, a, b);
    const Vector middle = space::scaled(0.5, space::plus(top.corner[a], top.corner[b]));
    for (const std::size_t moved : {a, b}) {
      Tetrahedron corner = top.corner;
      corner[moved] = middle;
      add(corner);
    }
  }
  best.bound = queue.empty() ? best.value : std::max(best.value, queue.top().bound);
  return best;
}

}  // namespace findspace::distance
