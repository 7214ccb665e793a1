// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/row.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace findspace::packing {

Row::Row(const Problem& problem, const FieldTable& table, const std::vector<std::size_t>& kinds) {
  if (kinds.empty()) containers_.push_back({0, std::numeric_limits<double>::infinity(), table.height(), 0});
  const double steps = double(problem.steps()), edge = table.edge();
  double x = 0;
  for (const std::size_t kind : kinds) {
    const LatticeBox box = box_of(problem.sheets[kind].shape);
    containers_.push_back({x, double(box.high.x) / steps - 2 * edge, double(box.high.y) / steps - 2 * edge, kind});
    for (const std::size_t v : table.obstacles_of(kind)) obstacles_.push_back({v, {x - edge, -edge}});
    // Obstacles reach beyond their sheet, but not into the next one.
    x += containers_.back().width + 2 * (edge + 1.02 * table.gap() + 2) + table.greatest_level();
  }
  add_fixed(problem, table);
}

void Row::add_fixed(const Problem& problem, const FieldTable& table) {
  for (std::size_t k = 0; k < problem.fixed.size(); ++k) {
    const auto& [placed, kind] = problem.fixed[k];
    std::size_t container = 0;
    for (std::size_t before = placed.sheet; problem.on_sheets(); ++container)
      if (containers_[container].kind == kind && before-- == 0) break;
    const Vec at{placed.x.to_double() - table.edge() + containers_[container].x, placed.y.to_double() - table.edge()};
    const std::size_t variant = table.fixed_variants()[k];
    obstacles_.push_back({variant, at});
    fixed_containers_.push_back(container);
    fixed_end_ = std::max(fixed_end_, at.x + table.variants()[variant].high.x);
  }
}

std::size_t Row::container_of(const Variant& variant, Vec at) const {
  const double middle = at.x + 0.5 * (variant.low.x + variant.high.x);
  const auto behind = [](double x, const Container& container) { return x < container.x; };
  const auto next = std::upper_bound(containers_.begin(), containers_.end(), middle, behind);
  return next == containers_.begin() ? 0 : std::size_t(next - containers_.begin()) - 1;
}

std::vector<std::size_t> cheapest_sheets(const Problem& problem) {
  std::vector<std::size_t> kinds(problem.sheets.size());
  std::iota(kinds.begin(), kinds.end(), std::size_t{0});
  const auto cost_of_area = [&](std::size_t kind) {
    const auto& cost = problem.sheets[kind].cost;
    return cost ? cost->to_double() / twice_area(problem.sheets[kind].shape) : 0;
  };
  std::stable_sort(kinds.begin(), kinds.end(),
                   [&](std::size_t a, std::size_t b) { return cost_of_area(a) < cost_of_area(b); });
  std::vector<std::size_t> all;
  for (const std::size_t kind : kinds) all.insert(all.end(), sheets_with_fixed(problem, kind), kind);
  for (const std::size_t kind : kinds) {
    const std::size_t most = std::min(std::size_t(problem.sheets[kind].count), problem.items());
    all.insert(all.end(), std::max(most, sheets_with_fixed(problem, kind)) - sheets_with_fixed(problem, kind), kind);
  }
  return all;
}

}  // namespace findspace::packing
