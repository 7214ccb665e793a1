// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/squared_bound.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/number/interval.h"

namespace findspace::distance {

namespace {

/// Between which u is: f^2, or f where lines are taken; of a greatest f minus that.
struct SquareEnds {
  double s, low, high;
};

/// u is at least its chord less the parabola over it.
double over_chord(const SquareEnds& a, const SquareEnds& b, double bend) {
  const double d = b.s - a.s, rise = b.low - a.low;
  const double lowest = std::clamp(d / 2 - rise / (bend * d), 0.0, d);
  return std::min({a.low, b.low, a.low + rise * lowest / d - bend / 2 * lowest * (d - lowest)});
}

/// At `there`, by the chord of two instants on one side of it.
double beyond(const SquareEnds& near, const SquareEnds& far, double there, double bend) {
  const double part = (there - near.s) / (near.s - far.s);
  return near.low + part * (near.low - far.high) - bend / 2 * (there - near.s) * (there - far.s);
}

/// u is at least one line and at least another between a and b, of which the values at both are given.
double over_both(double first_a, double first_b, double second_a, double second_b) {
  const double at_a = std::max(first_a, second_a), at_b = std::max(first_b, second_b);
  const double da = first_a - second_a, db = first_b - second_b;
  if ((da < 0) == (db < 0)) return std::min(at_a, at_b);
  const double part = da / (da - db);
  return std::min({at_a, at_b, first_a + part * (first_b - first_a)});
}

}  // namespace

std::optional<double> squared_bound(PairsTaken taken, bool least, const PairMotion& motion, const SquaredSample& a,
                                    const SquaredSample& b, const std::optional<SquaredSample>& before,
                                    const std::optional<SquaredSample>& after) {
  if (taken == PairsTaken::kNone) return std::nullopt;
  const bool lines = taken == PairsTaken::kFarthestLine, chord = least == (taken == PairsTaken::kNearest);
  const bool left = !chord && before, right = !chord && after;
  if (!chord && !left && !right) return std::nullopt;
  const double span = (right ? after->s : b.s) - (left ? before->s : a.s);
  const auto size = [](const SquaredSample& x) { return std::abs(x.f) + x.off; };
  // Of the distance of any pair that is taken at some instant, at all of them.
  const double most = std::max({size(a), size(b), left ? size(*before) : 0, right ? size(*after) : 0}) +
                      (lines ? 0 : 2 * motion.speed * span);
  const double of_speed = taken == PairsTaken::kNearest ? motion.speed * motion.speed : 0;
  const double bend = (lines ? motion.acceleration : 2 * (of_speed + most * motion.acceleration)) * margin::kUpward;
  if (!(bend > 0) || !(a.s < b.s)) return std::nullopt;
  const auto power = [lines](double f) { return lines ? f : f * f; };
  const auto bounded = [&](const SquaredSample& x) {
    const double low = power(lines ? x.f - x.off : std::max(x.f - x.off, 0.0)), high = power(x.f + x.off);
    return least ? SquareEnds{x.s, low, high} : SquareEnds{x.s, -high, -low};
  };
  const SquareEnds u = bounded(a), v = bounded(b);
  double low = 0;
  if (chord) {
    low = over_chord(u, v, bend);
  } else {
    // Concave on the way, so above the lines that join their ends.
    const double by_right = right ? beyond(v, bounded(*after), u.s, bend) : -exact::kInfinity;
    const double by_left = left ? beyond(u, bounded(*before), v.s, bend) : -exact::kInfinity;
    low = right && left ? over_both(by_right, v.low, u.low, by_left)
          : right       ? std::min(by_right, v.low)
                        : std::min(u.low, by_left);
  }
  low -= 16 * (power(most) + bend * span * span) * margin::kFewRoundings;
  if (lines) return low;
  if (least) return low > 0 ? std::optional(std::sqrt(low)) : std::nullopt;
  return low < 0 ? -std::sqrt(-low) * margin::kUpward : 0;
}

}  // namespace findspace::distance
