// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Minkowski sums, differences and offsets of plain sets: open, closed, half open, bounded or not, each point of the
// boundary decided.
//     plain_sum(A, B)        = {a + b}
//     plain_difference(A, B) = {p : p - B in A} = complement of (complement of A (+) B)
//     plain_offset(A, d)     = {p : distance to A <= d} for d > 0;  {p : the closed ball about p with radius |d| in A}
//     for d < 0
// One open operand makes the sum open and equal to the sum with the closure of the other, which is the kernel's open
// sum U; two closed ones give the closed sum. Otherwise A (+) B is the union of
//     int A (+) cl B,  cl A (+) int B,  the sums of boundary cells (curve_sums.h),
//     int(e (+) f) for edges e, f of A, B with no face beside them.
// Guarantee: exact. Cost: one convolution; in the last case besides one curve for each pair of edges that belong to A
// and B. Source: distances.md 1.3, 2.1, 2.2. Keywords: dilation, erosion, buffer, open set, half-open.
#pragma once

#include "plane/complex/cell_complex.h"

namespace findspace::plane {

Region plain_sum(const Region& a, const Region& b);
/// The whole plane if b is empty.
Region plain_difference(const Region& a, const Region& b);
Region plain_offset(const Region& a, const exact::Real& distance);

}  // namespace findspace::plane
