// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/matrix_game.h"

#include <algorithm>

namespace findspace::distance {

// With entries shifted to be positive: maximise sum y subject to M y <= 1, y >= 0. The value is 1 / sum y, the weights
// of the rows are the dual values over that sum. The slack variables are a feasible start.
GameValue matrix_game(const std::vector<std::array<double, 4>>& columns) {
  double shift = 0;
  for (const auto& c : columns) shift = std::max(shift, *std::max_element(c.begin(), c.end()));
  if (shift == 0) return {0, {1, 0, 0, 0}};
  const std::size_t n = columns.size(), width = n + 5;
  std::vector<std::vector<double>> rows(5, std::vector<double>(width, 0));  // four rows, then the objective
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t j = 0; j < n; ++j) rows[r][j] = columns[j][r] / shift + 1;
    rows[r][n + r] = 1;
    rows[r][width - 1] = 1;
  }
  for (std::size_t j = 0; j < n; ++j) rows[4][j] = -1;
  constexpr double kEntering = 0x1p-48;
  for (int step = 0; step < 200; ++step) {
    // The first column that helps (Bland: no cycles).
    std::size_t in = 0;
    while (in + 1 < width && rows[4][in] >= -kEntering) ++in;
    if (in + 1 == width) break;
    std::size_t out = 4;
    for (std::size_t r = 0; r < 4; ++r) {
      if (rows[r][in] <= kEntering) continue;
      if (out == 4 || rows[r][width - 1] * rows[out][in] < rows[out][width - 1] * rows[r][in]) out = r;
    }
    if (out == 4) break;
    const double pivot = rows[out][in];
    for (double& x : rows[out]) x /= pivot;
    for (std::size_t r = 0; r < 5; ++r) {
      if (r == out || rows[r][in] == 0) continue;
      const double factor = rows[r][in];
      for (std::size_t j = 0; j < width; ++j) rows[r][j] -= factor * rows[out][j];
    }
  }
  const double sum = rows[4][width - 1];
  GameValue game;
  game.value = (1 / sum - 1) * shift;
  double weights = 0;
  for (std::size_t r = 0; r < 4; ++r) weights += game.rows[r] = std::max(0.0, rows[4][n + r]);
  for (double& w : game.rows) w /= weights;
  return game;
}

GameValue bounding_game(std::vector<std::array<double, 4>> columns,
                        const std::optional<std::array<double, 4>>& beyond) {
  if (beyond) {
    const std::size_t count = columns.size();
    for (std::size_t k = 0; k < count; ++k) {
      std::array<double, 4> less = columns[k];
      for (std::size_t v = 0; v < 4; ++v) less[v] -= (*beyond)[v];
      columns.push_back(less);
    }
  }
  double least = 0;
  for (const auto& c : columns) least = std::min(least, *std::min_element(c.begin(), c.end()));
  if (least < 0) {
    for (auto& c : columns) {
      for (double& entry : c) entry -= least;
    }
  }
  GameValue game = matrix_game(columns);
  game.value += least;
  return game;
}

}  // namespace findspace::distance
