// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Many queries against one pair: a grid of boxes over A - B, each with the facets whose planes can be the highest
// somewhere in the box. A query looks at those only.
// Guarantee: the same value, bit for bit, as PhiFunction::max_form, and a facet that takes it. A facet is dropped from
// a box only if another plane is higher in the whole box by more than the error bound of both values. Cost: about 20 ns
// a query; building takes about a millisecond for each hundred facets; memory some hundred bytes a box. Positions
// outside the bounding box of A - B are answered from all facets.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "space/phi/phi_function.h"

namespace findspace::space {

/// The planes to look at in one box, and the facet that each of them is.
struct CellPlanes {
  const PlaneBlock* blocks = nullptr;
  std::size_t count = 0;
  const int* facets = nullptr;
};

class DepthGrid {
 public:
  /// Keeps a reference to `phi`. `levels`: 2^levels boxes a side; 0 chooses by the number of facets.
  explicit DepthGrid(const PhiFunction& phi, int levels = 0);

  /// The max form at many positions (finite), and the highest facet at each when `facets` is not empty.
  void evaluate(std::span<const Vector> at, std::span<double> values, std::span<int> facets = {}) const;
  double max_form(const Vector& u) const;

  CellPlanes cell(const Vector& u) const {
    const double x = (u.x - low_.x) * scale_.x, y = (u.y - low_.y) * scale_.y, z = (u.z - low_.z) * scale_.z;
    const double side = side_;
    if (!(x >= 0 && y >= 0 && z >= 0 && x < side && y < side && z < side)) return everywhere_;
    const std::size_t index = (static_cast<std::size_t>(static_cast<int>(z)) * static_cast<std::size_t>(side_) +
                               static_cast<std::size_t>(static_cast<int>(y))) *
                                  static_cast<std::size_t>(side_) +
                              static_cast<std::size_t>(static_cast<int>(x));
    const Cell& c = cells_[index];
    return {blocks_.data() + c.first, c.count, facets_.data() + std::size_t{c.first} * 8};
  }
  /// Mean number of planes a box looks at.
  double mean_planes() const;

 private:
  struct Cell {
    std::uint32_t first = 0, count = 0;
  };
  struct Box;
  void divide(const Box& box, const std::vector<int>& facets, int level);
  std::vector<int> candidates(const Box& box, const std::vector<int>& facets) const;
  void store(const Box& box, const std::vector<int>& facets);

  const PhiFunction& phi_;
  int levels_ = 0, side_ = 1;
  Vector low_, scale_;
  double margin_ = 0;
  std::vector<Cell> cells_;
  std::vector<PlaneBlock> blocks_;
  std::vector<int> facets_, all_facets_;
  CellPlanes everywhere_;
};

void scan_cells(const DepthGrid& grid, std::span<const Vector> at, std::span<double> values, std::span<int> facets);

}  // namespace findspace::space
