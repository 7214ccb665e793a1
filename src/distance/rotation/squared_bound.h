// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bounds between instants of a distance f that is taken by a pair of points: the least over all pairs (the gap of
// shapes that are apart), or the greatest (reach, diameter). While the shapes move by q(t) against each other, the
// square of the distance of a pair has a second derivative from -2 |q||q''| to 2 (|q'|^2 + |q||q''|). So the least of
// all squares, less a parabola, is concave, and the greatest, plus one, convex. Such a function lies on one side of its
// chord between two instants, and on the other side of the chord beyond them. How far a shape protrudes from a convex
// one is the greatest distance of a point beyond a line that supports that, whose second derivative is at most |q''|:
// there f itself, plus a parabola, is convex. Guarantee: the bounds hold though values are off as stated. They come
// near f with the square of the time between, where a rate comes near it with the time. Keywords: semi-concave
// function, second-order bound, alpha-BB.
#pragma once

#include <optional>

namespace findspace::distance {

/// Of which pairs of points f is the distance; or of points and lines, negative on the inner side of the line.
enum class PairsTaken { kNone, kNearest, kFarthest, kFarthestLine };

/// f at an instant, a part of a leg, which may be off by as much.
struct SquaredSample {
  double s, f, off;
};

/// At most how fast points of the shapes move against each other over a leg, and how much faster they become; where
/// lines are taken, as seen from these.
struct PairMotion {
  double speed, acceleration;
};

/// No f (least), or no -f, is less between a and b. `before`, `after`: instants of the same leg beyond, where known, at
/// least as far from a, b as these are from each other. Nothing where the bound of pairs says less than 0 (least), or
/// nothing is known.
std::optional<double> squared_bound(PairsTaken taken, bool least, const PairMotion& motion, const SquaredSample& a,
                                    const SquaredSample& b, const std::optional<SquaredSample>& before,
                                    const std::optional<SquaredSample>& after);

}  // namespace findspace::distance
