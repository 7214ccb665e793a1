// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_depth/solid_column.h"

#include <findspace/error.h>

#include <algorithm>
#include <limits>

#include "packing/solid_problem/container_shape.h"

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
  add_fixed(problem, table);
  has_walls_.resize(rooms_.all().size());
  is_round_.resize(rooms_.all().size());
  if (problem.in_containers()) add_walls(problem, table);
}

void SolidColumn::add_fixed(const SolidProblem& problem, const SolidTable& table) {
  for (std::size_t k = 0; k < problem.fixed.size(); ++k) {
    const SolidPlaced& placed = problem.fixed[k].placed;
    const std::size_t room = problem.in_containers() ? room_of(problem.fixed[k]) : 0;
    const auto from_edge = [&](std::size_t axis) { return placed.at[axis].to_double() - table.edge(); };
    const std::size_t variant = table.fixed_variants()[k];
    obstacles_.push_back({variant, {from_edge(0), from_edge(1), from_edge(2) + rooms_[room].low.z}});
    fixed_rooms_.push_back(room);
    end_ = std::max(end_, obstacles_.back().at.z + table.variants()[variant].high.z);
  }
}

std::size_t SolidColumn::room_of(const FixedSolid& fixed) const {
  std::size_t before = fixed.placed.container;
  for (std::size_t room = 0; room < rooms_.all().size(); ++room)
    if (rooms_[room].kind == fixed.kind && before-- == 0) return room;
  throw Error(ErrorCode::kBadValue, "the container of a fixed solid is not used");
}

void SolidColumn::add_walls(const SolidProblem& problem, const SolidTable& table) {
  for (std::size_t room = 0; room < rooms_.all().size(); ++room) {
    const std::optional<std::size_t> walls = table.walls_of(rooms_[room].kind);
    if (!walls) continue;
    const Vector corner{table.edge(), table.edge(), table.edge()};
    obstacles_.push_back({*walls, rooms_[room].low - corner});
    has_walls_[room] = 1;
    is_round_[room] = problem.containers[rooms_[room].kind].inside->has_balls() ? 1 : 0;
  }
}

std::vector<std::size_t> cheapest_containers(const SolidProblem& problem) {
  std::vector<Stock> stock;
  for (const SolidContainer& c : problem.containers)
    stock.push_back({std::min(std::size_t(c.count), problem.items()), containers_with_fixed(problem, stock.size()),
                     c.cost, volume_of(problem, c)});
  return cheapest_first(stock);
}

}  // namespace findspace::packing
