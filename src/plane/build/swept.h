// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a moving window sees of a marked complex M. For every position p the window is the segment from p + from to p +
// to, and
//     swept(M, window, rule)(p) = rule(M(p + from), M(p + to), least mark of M strictly between).
// With marks 0 and 1 turned round, and every choice of the ends, these are the plain Minkowski sums of any set with a
// segment, closed, open or half open: S (+) [a, b] = {p : the window from p - b to p - a meets S}. S may be open,
// closed or neither, unbounded, with curves and points without interior; M may be a sign map, whose levels are then
// swept at once. Guarantee: exact. Cost: one arrangement of two copies of M and one segment for each place where M
// turns back against the window. Source: distances.md 7.1 (partial Minkowski operations), 7.3. Keywords: sweep, swept
// area, partial Minkowski sum, dilation.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "plane/build/sweep_strips.h"
#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// What a window sees: at its two ends, and the least mark strictly between them.
struct Sight {
  Mark start = 0, end = 0, inside = 0;
  Mark least() const { return std::min(inside, std::min(start, end)); }
};

/// The primitive integer vector of a direction other than (0, 0), if there is one below 2^53.
std::optional<GridPoint> primitive_direction(const RealVector& d);

/// The window from p + from to p + to. The ends differ; their coordinates are rational. Throws Error(kOutOfRange) where
/// the direction is not a ratio of integers below 2^53.
Window window_between(const RealVector& from, const RealVector& to);
/// The window from p + from * u to p + to * u, u of length 1 in the direction (dx, dy), from < to.
Window window_along(std::int64_t dx, std::int64_t dy, const exact::Real& from, const exact::Real& to);

CellComplex swept(const CellComplex& m, const Window& window, const std::function<Mark(const Sight&)>& rule);

/// The least mark of M on the chain from p + path[0] over p + path[1] ... to its end, for every p; rational way points.
CellComplex least_along(const CellComplex& m, std::span<const RealVector> path);

}  // namespace findspace::plane
