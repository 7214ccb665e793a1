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
  find_depths(sums);
}

void InnerMask::find_depths(const Bitmap& cells) {
  const LatticeBox& box = cells.box();
  row0_ = box.row0;
  rows_ = box.row1 - box.row0 + 1;
  column0_ = box.column0;
  columns_ = box.column1 - box.column0 + 1;
  depth_.resize(std::size_t(columns_ * rows_));
  auto at = [&](std::int64_t r, std::int64_t c) -> std::uint8_t& { return depth_[std::size_t(r * columns_ + c)]; };
  auto grown = [](int least) { return std::uint8_t(std::min(1 + least, 255)); };
  // The chessboard distance to a cell that is not marked, by one pass from each corner; cells outside are not marked.
  for (std::int64_t r = 0; r < rows_; ++r)
    for (std::int64_t c = 0; c < columns_; ++c) {
      if (!cells.holds(row0_ + r, column0_ + c)) continue;
      bool edge = r == 0 || r == rows_ - 1 || c == 0 || c == columns_ - 1;
      at(r, c) = edge ? 1 : grown(std::min({at(r - 1, c - 1), at(r - 1, c), at(r - 1, c + 1), at(r, c - 1)}));
    }
  for (std::int64_t r = rows_ - 1; r-- > 1;)
    for (std::int64_t c = columns_ - 1; c-- > 1;) {
      std::uint8_t& d = at(r, c);
      if (d > 1) d = std::min(d, grown(std::min({at(r + 1, c - 1), at(r + 1, c), at(r + 1, c + 1), at(r, c + 1)})));
    }
}

}  // namespace findspace::plane
