// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/inner_mask.h"

#include <algorithm>

#include "plane/base/bitmap.h"
#include "plane/grid/lattice_sum.h"

namespace findspace::plane {
namespace {

bool longer(const LatticeRun& p, const LatticeRun& q) { return p.last - p.first > q.last - q.first; }
bool by_place(const LatticeRun& p, const LatticeRun& q) { return p.row != q.row ? p.row < q.row : p.first < q.first; }

/// Lattice points and cells whose sums are cells inside.
struct Factors {
  std::vector<LatticeRun> points, cells;

  bool empty() const { return points.empty() || cells.empty(); }
  LatticeBox box() const { return LatticeBox::around(points) + LatticeBox::around(cells); }

  /// Adds the sums of as many runs of points as the effort allows, the longest first.
  void add_to(Bitmap& sums, double effort) {
    LatticeBox of_cells = LatticeBox::around(cells);
    double words = double(of_cells.row1 - of_cells.row0 + 1) * (double(of_cells.column1 - of_cells.column0) / 64 + 2);
    auto most = std::size_t(std::max(effort / words, 1.0));
    if (points.size() > most) {
      std::nth_element(points.begin(), points.begin() + std::ptrdiff_t(most), points.end(), longer);
      points.resize(most);
      std::sort(points.begin(), points.end(), by_place);
    }
    add_sums(points, cells, sums);
  }
};

}  // namespace

InnerMask::InnerMask(std::span<const Pair> pairs, std::int64_t side, double effort)
    : side_(side), scale_(1 / double(side)) {
  std::vector<Factors> factors;
  LatticeBox box;
  for (const Pair& pair : pairs)
    for (auto [p, c] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)}) {
      Factors f{point_runs(*p, double(side)), cell_runs(*c, double(side))};
      if (f.empty()) continue;
      box.add(f.box());
      factors.push_back(std::move(f));
    }
  if (box.empty()) return;
  Bitmap sums(box);
  for (Factors& f : factors) f.add_to(sums, effort / double(factors.size()));
  depths_ = CellDepths(sums);
}

}  // namespace findspace::plane
