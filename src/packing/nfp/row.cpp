// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/row.h"

#include <algorithm>
#include <limits>

namespace findspace::packing {

Row::Row(const Problem& problem, const FieldTable& table, const std::vector<std::size_t>& kinds) {
  if (kinds.empty()) rooms_.add({std::numeric_limits<double>::infinity(), table.height()}, 0, 0);
  const double steps = double(problem.steps()), edge = table.edge();
  // Obstacles reach beyond their sheet, but not into the next one.
  const double wall = 2 * (edge + 1.02 * table.gap() + 2) + table.greatest_level();
  for (const std::size_t kind : kinds) {
    const LatticeBox box = box_of(problem.sheets[kind]);
    rooms_.add({double(box.high.x) / steps - 2 * edge, double(box.high.y) / steps - 2 * edge}, wall, kind);
    for (const std::size_t v : table.obstacles_of(kind))
      obstacles_.push_back({v, {rooms_.all().back().low.x - edge, -edge}});
  }
  add_fixed(problem, table);
}

void Row::add_fixed(const Problem& problem, const FieldTable& table) {
  for (std::size_t k = 0; k < problem.fixed.size(); ++k) {
    const auto& [placed, kind] = problem.fixed[k];
    std::size_t room = 0;
    for (std::size_t before = placed.sheet; problem.on_sheets(); ++room)
      if (rooms_[room].kind == kind && before-- == 0) break;
    const Vec at{placed.x.to_double() - table.edge() + rooms_[room].low.x, placed.y.to_double() - table.edge()};
    const std::size_t variant = table.fixed_variants()[k];
    obstacles_.push_back({variant, at});
    fixed_rooms_.push_back(room);
    fixed_end_ = std::max(fixed_end_, at.x + table.variants()[variant].high.x);
  }
}

std::vector<std::size_t> cheapest_sheets(const Problem& problem) {
  std::vector<Stock> stock;
  for (std::size_t kind = 0; kind < problem.sheets.size(); ++kind) {
    const Sheet& sheet = problem.sheets[kind];
    stock.push_back({std::min(std::size_t(sheet.count), problem.items()), sheets_with_fixed(problem, kind), sheet.cost,
                     twice_area(sheet)});
  }
  return cheapest_first(stock);
}

}  // namespace findspace::packing
