// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/nfp/rooms.h"

#include <numeric>

namespace findspace::packing {

std::vector<std::size_t> cheapest_first(const std::vector<Stock>& stock) {
  std::vector<std::size_t> kinds(stock.size());
  std::iota(kinds.begin(), kinds.end(), std::size_t{0});
  const auto cost_of_size = [&](std::size_t kind) {
    return stock[kind].cost ? stock[kind].cost->to_double() / stock[kind].size : 0;
  };
  std::stable_sort(kinds.begin(), kinds.end(),
                   [&](std::size_t a, std::size_t b) { return cost_of_size(a) < cost_of_size(b); });
  std::vector<std::size_t> all;
  for (const std::size_t kind : kinds) all.insert(all.end(), stock[kind].occupied, kind);
  for (const std::size_t kind : kinds)
    all.insert(all.end(), std::max(stock[kind].count, stock[kind].occupied) - stock[kind].occupied, kind);
  return all;
}

}  // namespace findspace::packing
