// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bounds between instants of a distance f that is taken by a pair of points: the least over all pairs (the gap of
// shapes that are apart), or the greatest (reach, diameter). While the shapes move by q(t) against each other, the
// square of the distance of a pair has a second derivative from -2 |q||q''| to 2 (|q'|^2 + |q||q''|). So the least of
// all squares, less a parabola, is concave, and the greatest, plus one, convex. Such a function lies on one side of its
// chord between two instants, and on the other side of the chord beyond them. Guarantee: the bounds hold where each
// value is off by at most `off`. They come near f with the square of the time between, where a rate comes near it with
// the time. Keywords: semi-concave function, second-order bound, alpha-BB.
#pragma once

#include <optional>

namespace findspace::distance {

/// Of which pairs of points f is the distance.
enum class PairsTaken { kNone, kNearest, kFarthest };

/// f at an instant, a part of a leg.
struct SquaredSample {
  double s, f;
};

/// At most how fast points of the shapes move against each other over a leg, and how much faster they become.
struct PairMotion {
  double speed, acceleration;
};

/// No f (least), or no -f, is less between a and b. `before`, `after`: instants of the same leg beyond, where known.
/// Nothing where the bound says less than 0 (least), or nothing is known.
std::optional<double> squared_bound(PairsTaken taken, bool least, const PairMotion& motion, const SquaredSample& a,
                                    const SquaredSample& b, const std::optional<SquaredSample>& before,
                                    const std::optional<SquaredSample>& after, double off);

}  // namespace findspace::distance
