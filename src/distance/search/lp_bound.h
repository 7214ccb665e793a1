// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The value of a matrix game of four rows: min over weights of the columns of max over the rows, and the row
// player's weights. Simplex method in doubles: numbers to about 2^-46 of the largest entry. Keywords: linear
// programming, minimax.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace findspace::distance {

/// Numbers at the four corners of a tetrahedron.
using Column = std::array<double, 4>;

struct LpBound {
  double value = 0;
  std::array<double, 4> rows{};  // weights, sum 1
};

/// Columns of entries >= 0; at least one.
LpBound lp_bound(const std::vector<Column>& columns);

/// Of the distances at four corners, and of these less what the corners are beyond a plane; entries of any sign.
LpBound bounding_lp(std::vector<Column> columns, const std::optional<Column>& beyond);

}  // namespace findspace::distance
