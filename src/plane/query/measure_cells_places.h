// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the vertices of a complex are, as numbers of about 94 bits: the formulas of the crossings evaluated in Twofold
// arithmetic with a bound of the error beside each result, and from the exact coordinates where that bound is too large
// (crossings under a small angle, far from the origin). Guarantee: the error of a coordinate is below 2^-94 of the
// larger of it and one grid step. Cost: about a thousand instructions a crossing; exact coordinates take forty times
// as many. Source: running error analysis, Higham, "Accuracy and Stability of Numerical Algorithms", 3.3.
// Keywords: running error bound, double-double.
#pragma once

#include <array>
#include <vector>

#include "plane/complex/cell_complex.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::plane {

/// A number with a bound of its error.
struct BoundedTwofold {
  Twofold value;
  double error = 0;
};
BoundedTwofold operator+(const BoundedTwofold& p, const BoundedTwofold& q);
BoundedTwofold operator-(const BoundedTwofold& p, const BoundedTwofold& q);
BoundedTwofold operator*(const BoundedTwofold& p, const BoundedTwofold& q);
BoundedTwofold operator/(const BoundedTwofold& p, const BoundedTwofold& q);

class VertexPlaces {
 public:
  /// Keeps a reference to the geometry.
  explicit VertexPlaces(const exact::Geometry& geometry);

  /// In grid steps.
  std::array<Twofold, 2> at(Index point);

 private:
  /// A line: its normal and offset; a circle: its centre and radius.
  struct Numbers {
    BoundedTwofold a, b, c;
  };
  using Crossing = std::array<BoundedTwofold, 2>;

  Numbers numbers(Index supporting_curve);
  Numbers computed(const exact::SupportingCurve& k) const;
  Crossing crossing(const exact::Point& p);

  const exact::Geometry& geometry_;
  struct Known {
    Index supporting_curve = kNone;
    Numbers numbers;
  };
  std::vector<Known> known_;  // the last of the curves that share a place; made when first needed
};

}  // namespace findspace::plane
