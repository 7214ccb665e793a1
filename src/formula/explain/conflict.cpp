// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/conflict.h"

#include <algorithm>

namespace findspace::formula {
namespace {

constexpr std::size_t kMostSteps = 20000;

std::vector<std::size_t> members(const std::vector<bool>& kept) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (kept[k]) out.push_back(k);
  return out;
}

/// The first cell where the formula holds when only the kept demands count; size() if there is none.
std::size_t roomy(FailingCells& cells, const std::vector<bool>& kept) {
  return cells.first([&](std::size_t k) { return kept[k]; });
}

/// Searches conflicts of at most `most` demands, by depth.
class SmallerConflict {
 public:
  explicit SmallerConflict(FailingCells& cells) : cells_(cells) {}

  bool find(std::vector<bool>& kept, std::size_t most) {
    ended_ = ended_ && ++steps_ <= kMostSteps && cells_.allows_a_pass();
    if (!ended_) return false;
    const std::size_t cell = roomy(cells_, kept);
    if (cell == cells_.size()) return true;
    if (most == 0) return false;
    for (const std::uint32_t k : cells_.failing(cell)) {
      if (kept[k]) continue;
      kept[k] = true;
      if (find(kept, most - 1)) return true;
      kept[k] = false;
    }
    return false;
  }
  bool ended() const { return ended_; }

 private:
  FailingCells& cells_;
  std::size_t steps_ = 0;
  bool ended_ = true;
};

}  // namespace

Conflict find_conflict(FailingCells& cells) {
  std::vector<bool> kept(cells.demands(), true);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    kept[k] = false;
    if (roomy(cells, kept) < cells.size()) kept[k] = true;
  }
  const std::size_t count = members(kept).size();
  SmallerConflict search(cells);
  for (std::size_t most = 0; most < count && search.ended(); ++most) {
    std::vector<bool> fewer(cells.demands(), false);
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
