// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/level_truth.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "formula/language/evaluate.h"

namespace findspace::formula {
namespace {

std::vector<std::size_t> by_level(const std::vector<SignMap>& maps) {
  std::vector<std::size_t> order(maps.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return maps[a].level < maps[b].level; });
  return order;
}

}  // namespace

bool of_one_distance(const Formula& a, const Formula& b) {
  if (a.sign_maps().empty() || a.sign_maps()[0].distance.mode == Mode::kRotation) return false;
  const Distance& distance = a.sign_maps()[0].distance;
  const auto is_of_it = [&](const SignMap& m) { return !m.minimum && m.more.empty() && m.distance == distance; };
  return std::all_of(a.sign_maps().begin(), a.sign_maps().end(), is_of_it) && !b.sign_maps().empty() &&
         std::all_of(b.sign_maps().begin(), b.sign_maps().end(), is_of_it);
}

std::optional<LevelTruth> level_truth(const Formula& formula) {
  const std::vector<SignMap>& maps = formula.sign_maps();
  if (maps.size() < 2 || !of_one_distance(formula, formula)) return std::nullopt;
  // From below all levels upwards: the signs are -1 till the value has come to a level.
  std::vector<std::int8_t> signs(maps.size(), -1);
  std::int32_t below = evaluate(formula, signs) ? 1 : 0;
  std::vector<std::array<std::int32_t, 3>> added(maps.size());
  LevelTruth out;
  out.sum.first = below;
  for (const std::size_t k : by_level(maps)) {
    signs[k] = 0;
    const std::int32_t here = evaluate(formula, signs) ? 1 : 0;
    signs[k] = 1;
    const std::int32_t above = evaluate(formula, signs) ? 1 : 0;
    added[k] = {0, here - below, above - below};
    if (here != below || above != below) out.sign_maps.push_back(k);
    below = above;
  }
  std::sort(out.sign_maps.begin(), out.sign_maps.end());
  for (const std::size_t k : out.sign_maps) out.sum.added.push_back(added[k]);
  return out;
}

}  // namespace findspace::formula
