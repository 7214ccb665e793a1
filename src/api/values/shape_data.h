// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public Shape: a tree on a grid (plane/contour/shape.h), and the set it stands for once somebody
// has looked at it. Threads: safe.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "findspace/region.h"
#include "findspace/shape.h"
#include "plane/base/work_budget.h"
#include "plane/build/transform.h"
#include "plane/contour/decimal_grid.h"
#include "plane/contour/shape.h"

namespace findspace {

struct Shape::Data {
  plane::ShapePtr tree;
  plane::Grid grid;
  int dimension = 2;
  plane::RoundingLog rounding;                   // of the points given
  std::uint64_t work = plane::kUsualWorkBudget;  // that the region may cost
  std::string unit{};                            // of the region, or empty
  mutable std::once_flag made{};
  mutable std::optional<Region> region{};
  mutable plane::Rounding rotated{};  // what its rotations put on the grid

  Data(plane::ShapePtr t, plane::Grid g, int d, const plane::RoundingLog& r = {},
       std::uint64_t limit = plane::kUsualWorkBudget, std::string u = {})
      : tree(std::move(t)), grid(g), dimension(d), rounding(r), work(limit), unit(std::move(u)) {}
};

namespace api {

Shape make_shape(plane::ShapePtr tree, const plane::Grid& grid, int dimension, const plane::RoundingLog& rounding = {},
                 std::uint64_t work = plane::kUsualWorkBudget, std::string unit = {});
inline const plane::ShapePtr& tree_of(const Shape& shape) { return shape.data().tree; }

exact::Real real_of(const Number& number);
/// Error(kBadValue) for a step that is not more than 0.
plane::Grid grid_of(const Grid& grid);
/// The decimal, or the fraction, that a step is.
Grid public_grid(const plane::Grid& grid);

/// A grid that holds the points of both. Error(kOutOfRange) where it would be too fine for 2^40 steps a unit.
plane::Grid common_grid(const plane::Grid& a, const plane::Grid& b);
/// The tree of a shape on a grid that holds its own. Error(kOutOfRange) where a coordinate leaves the grid.
plane::ShapePtr tree_on(const Shape& shape, const plane::Grid& grid);

}  // namespace api
}  // namespace findspace
