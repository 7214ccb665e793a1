// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Minkowski sums and differences of plane sets in any shape: holes, several components, arcs, curves and points without
// interior; with the true sign on every vertex, edge and face (distances.md 1.3, 1.4, 3.9).
//
// For closed sets A, B, each bounded or with a bounded complement, and positions p, with X = A (+) -B and
// U = (int A (+) -B) u (A (+) -int B):
//   contact_map(A, B):     - on U (interiors meet), 0 on X \ U (touching), + elsewhere: sign of gamma1 at level 0;
//   containment_map(A, B): - where B + p lies in int A, 0 where it lies in A but not in int A, + elsewhere: sign of
//   eta1.
// Guarantee: exact, including zero-width slots (segments of 0 inside -) and exact fits (single points of 0). Cost: one
// arrangement of the signed convolution (convolution.h). Source: docs/decisions/0002-displaced-winding-numbers.md; Wein
// 2006. Keywords: Minkowski sum, no-fit polygon, inner-fit polygon, configuration-space obstacle, erosion, dilation.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plane/base/lazy.h"
#include "plane/complex/cell_complex.h"
#include "plane/grid/grid_faces.h"

namespace findspace::plane {

SignMap contact_map(const Region& a, const Region& b);
/// The same; a large `a` is given back where only the pairs of its curves with those of `b` are needed any more.
SignMap contact_map(Region&& a, const Region& b);

/// A set that is summed with many others: what a sum needs of it alone is found once, when it is asked for first.
/// Guarantee: the same sums. Threads may ask at once.
class SumOperand {
 public:
  /// Keeps a reference.
  explicit SumOperand(const Region& region) : region_(region) {}

  const Region& region() const { return region_; }
  /// Of the set, or of its reflection through the origin; nothing where a sum needs more than these.
  const std::optional<GridFaces>& faces(bool mirrored) const;

 private:
  const Region& region_;
  std::array<Lazy<std::optional<GridFaces>>, 2> faces_;
};
SignMap contact_map(const SumOperand& a, const SumOperand& b);

SignMap containment_map(const Region& a, const Region& b);

/// A (+) B = {a + b} of closed sets, closed.
Region minkowski_sum(const Region& a, const Region& b);
/// A (-) B = AND_{q in B} (A + q) = {p : p - B in A}, closed; everything if B is empty. (Not {p : p + B in A}.)
Region minkowski_difference(const Region& a, const Region& b);

/// The set reflected through the origin.
CellComplex mirrored(const CellComplex& complex);

}  // namespace findspace::plane
