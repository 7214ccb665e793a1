// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/inner_mask.h"

#include <algorithm>

#include "plane/base/bitmap.h"
#include "plane/base/parallel.h"
#include "plane/grid/lattice_sum.h"

namespace findspace::plane {
namespace {

bool longer(const LatticeRun& p, const LatticeRun& q) { return p.last - p.first > q.last - q.first; }
bool by_place(const LatticeRun& p, const LatticeRun& q) { return p.row != q.row ? p.row < q.row : p.first < q.first; }

constexpr double kFarMore = 4;  // than the effort: a pair of many is left out

/// Lattice points and cells whose sums are cells inside.
struct Factors {
  std::vector<LatticeRun> points, cells;

  bool empty() const { return points.empty() || cells.empty(); }
  LatticeBox box() const { return LatticeBox::around(points) + LatticeBox::around(cells); }

  /// Keeps as many runs of points as the effort allows, the longest; none where the cells alone cost far more.
  void limit(double effort) {
    const LatticeBox of_cells = LatticeBox::around(cells);
    const double words =
        double(of_cells.row1 - of_cells.row0 + 1) * (double(of_cells.column1 - of_cells.column0) / 64 + 2);
    if (words > kFarMore * effort) return points.clear();
    const auto most = std::size_t(std::max(effort / words, 1.0));
    if (points.size() <= most) return;
    std::nth_element(points.begin(), points.begin() + std::ptrdiff_t(most), points.end(), longer);
    points.resize(most);
    std::sort(points.begin(), points.end(), by_place);
  }
};

/// Corners of the cells that belong to no other run: points of the set even where its outline is not exact.
std::vector<LatticeRun> lower_corners(std::vector<LatticeRun> cells) {
  for (LatticeRun& run : cells) ++run.last;
  return cells;
}

constexpr std::size_t kManyEdges = 500;  // from here on their runs are found at once

/// Of both operands of each pair, the points of one with the cells of the other; some may have none.
std::vector<Factors> factors_of(std::span<const InnerMask::Pair> pairs, double side, std::size_t edges) {
  std::vector<Factors> factors(2 * pairs.size());
  at_once(2 * factors.size(), edges, kManyEdges, [&](std::size_t k) {
    const InnerMask::Pair& pair = pairs[k / 4];
    const Outline& outline = k % 4 < 2 ? *pair.a : *pair.b;
    const bool round = k % 4 < 2 ? pair.a_round : pair.b_round;
    Factors* const of_pair = &factors[k / 4 * 2];  // points of A and cells of B, then the other way round
    if (k % 2 == 0)
      of_pair[k % 4 == 0].cells = cell_runs(outline, side);
    else
      of_pair[k % 4 != 1].points = round ? lower_corners(cell_runs(outline, side)) : point_runs(outline, side);
  });
  return factors;
}

}  // namespace

InnerMask::InnerMask(std::span<const Pair> pairs, std::int64_t side, double effort)
    : side_(side), scale_(1 / double(side)) {
  std::size_t edges = 0;
  for (const Pair& pair : pairs) edges += pair.a->size() + pair.b->size();
  std::vector<Factors> factors = factors_of(pairs, double(side), edges);
  std::erase_if(factors, [](const Factors& f) { return f.empty(); });
  if (factors.empty()) return;
  LatticeBox box;
  for (const Factors& f : factors) box.add(f.box());
  std::vector<LatticeSum> sums;
  for (Factors& f : factors) {
    f.limit(effort / double(factors.size()));
    if (!f.points.empty()) sums.push_back({f.points, f.cells});
  }
  Bitmap inside(box);
  // Both of a pair at once; of all at once too much would be kept.
  for (std::size_t k = 0; k < sums.size(); k += 2)
    add_sums(std::span(sums).subspan(k, std::min<std::size_t>(2, sums.size() - k)), inside);
  depths_ = CellDepths(inside);
}

}  // namespace findspace::plane
