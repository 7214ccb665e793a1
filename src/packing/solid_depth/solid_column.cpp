// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/solid_column.h"

#include <limits>

namespace findspace::packing {
namespace {

constexpr double kWall = 0.25;  // of the floor: farther than a linear program moves parts towards each other

}  // namespace

SolidColumn::SolidColumn(const SolidProblem& problem, const SolidTable& table, const std::vector<std::size_t>& kinds) {
  const auto within = [&](const Fraction& side) { return (side - problem.edge - problem.edge).to_double(); };
  if (kinds.empty()) {
    rooms_.add({within(problem.width), within(problem.depth), std::numeric_limits<double>::infinity()}, 0, 0);
    end_ = table.tallest();
  }
  const double wall = kWall * table.size() + 2 * (table.gap() + table.greatest_level());
  for (const std::size_t kind : kinds) {
    const SolidContainer& c = problem.containers[kind];
    rooms_.add({within(c.width), within(c.depth), within(c.height)}, wall, kind);
  }
}

std::vector<std::size_t> cheapest_containers(const SolidProblem& problem) {
  std::vector<Stock> stock;
  for (const SolidContainer& c : problem.containers)
    stock.push_back({std::min(std::size_t(c.count), problem.items()), 0, c.cost,
                     c.width.to_double() * c.depth.to_double() * c.height.to_double()});
  return cheapest_first(stock);
}

}  // namespace findspace::packing
