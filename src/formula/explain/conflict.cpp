// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/conflict.h"

#include <algorithm>

namespace findspace::formula {
namespace {

constexpr std::size_t kMostSteps = 20000;

/// The first cell where the formula holds when only the kept demands count; the end if there is none.
std::vector<MetDemands>::const_iterator roomy(const Demands& demands, const std::vector<MetDemands>& cells,
                                              const std::vector<bool>& kept) {
  std::vector<bool> met(demands.size());
  return std::find_if(cells.begin(), cells.end(), [&](const MetDemands& cell) {
    for (std::size_t k = 0; k < met.size(); ++k) met[k] = cell[k] || !kept[k];
    return demands.truth(met);
  });
}

std::vector<std::size_t> members(const std::vector<bool>& kept) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (kept[k]) out.push_back(k);
  return out;
}

/// Searches conflicts of at most `most` demands, by depth.
class SmallerConflict {
 public:
  SmallerConflict(const Demands& demands, const std::vector<MetDemands>& cells) : demands_(demands), cells_(cells) {}

  bool find(std::vector<bool>& kept, std::size_t most) {
    if (++steps_ > kMostSteps) return false;
    const auto cell = roomy(demands_, cells_, kept);
    if (cell == cells_.end()) return true;
    if (most == 0) return false;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      if (kept[k] || (*cell)[k]) continue;
      kept[k] = true;
      if (find(kept, most - 1)) return true;
      kept[k] = false;
    }
    return false;
  }
  bool ended() const { return steps_ <= kMostSteps; }

 private:
  const Demands& demands_;
  const std::vector<MetDemands>& cells_;
  std::size_t steps_ = 0;
};

}  // namespace

bool is_satisfiable(const Demands& demands, const std::vector<MetDemands>& cells, const std::vector<bool>& kept) {
  return roomy(demands, cells, kept) != cells.end();
}

Conflict find_conflict(const Demands& demands, const std::vector<MetDemands>& cells) {
  std::vector<bool> kept(demands.size(), true);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    kept[k] = false;
    if (is_satisfiable(demands, cells, kept)) kept[k] = true;
  }
  const std::size_t count = members(kept).size();
  SmallerConflict search(demands, cells);
  for (std::size_t most = 0; most < count && search.ended(); ++most) {
    std::vector<bool> fewer(demands.size(), false);
    if (search.find(fewer, most)) return {members(fewer), true};
  }
  return {members(kept), search.ended()};
}

std::vector<std::size_t> find_correction(const Demands& demands, const MetDemands& cell) {
  std::vector<bool> met(cell.size(), true);
  for (std::size_t k = 0; k < met.size(); ++k) {
    met[k] = cell[k];
    if (!cell[k] && !demands.truth(met)) met[k] = true;
  }
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < met.size(); ++k)
    if (met[k] && !cell[k]) out.push_back(k);
  return out;
}

}  // namespace findspace::formula
