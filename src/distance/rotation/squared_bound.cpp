// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/rotation/squared_bound.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/number/interval.h"

namespace findspace::distance {

namespace {

/// u = f^2 for a least f, -f^2 for a greatest one.
struct Square {
  double s, u;
};

/// u is at least its chord less the parabola over it.
double over_chord(const Square& a, const Square& b, double bend) {
  const double d = b.s - a.s, rise = b.u - a.u;
  const double lowest = std::clamp(d / 2 - rise / (bend * d), 0.0, d);
  return std::min({a.u, b.u, a.u + rise * lowest / d - bend / 2 * lowest * (d - lowest)});
}

/// At `there`, by the chord of two instants on one side of it.
double beyond(const Square& near, const Square& far, double there, double bend) {
  const double slope = (far.u - near.u) / (far.s - near.s);
  return near.u + slope * (there - near.s) - bend / 2 * (there - near.s) * (there - far.s);
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
                                    const std::optional<SquaredSample>& after, double off) {
  if (taken == PairsTaken::kNone) return std::nullopt;
  const bool chord = least == (taken == PairsTaken::kNearest);
  const bool left = !chord && before, right = !chord && after;
  if (!chord && !left && !right) return std::nullopt;
  const double from = left ? before->s : a.s, to = right ? after->s : b.s;
  const double span = to - from;
  // Of the distance of any pair that is taken at some instant, at all of them.
  const double most = std::max({a.f, b.f, left ? before->f : 0, right ? after->f : 0}) + 2 * motion.speed * span;
  const double of_speed = taken == PairsTaken::kNearest ? motion.speed * motion.speed : 0;
  const double bend = 2 * (of_speed + most * motion.acceleration) * margin::kUpward;
  if (!(bend > 0) || !(a.s < b.s)) return std::nullopt;
  const auto square = [least](const SquaredSample& x) { return Square{x.s, least ? x.f * x.f : -x.f * x.f}; };
  const Square u = square(a), v = square(b);
  double low = 0;
  if (chord) {
    low = over_chord(u, v, bend);
  } else {
    // Concave on the way, so above the lines that join their ends.
    const double by_right = right ? beyond(v, square(*after), u.s, bend) : -exact::kInfinity;
    const double by_left = left ? beyond(u, square(*before), v.s, bend) : -exact::kInfinity;
    low = right && left ? over_both(by_right, v.u, u.u, by_left)
          : right       ? std::min(by_right, v.u)
                        : std::min(u.u, by_left);
  }
  // Chords beyond carry at most three times what their ends are off.
  constexpr double kCarried = 3;
  low -= kCarried * (2 * most + off) * off;
  low -= 16 * (most * most + bend * span * span) * margin::kFewRoundings;
  if (least) return low > 0 ? std::optional(std::sqrt(low)) : std::nullopt;
  return low < 0 ? -std::sqrt(-low) * margin::kUpward : 0;
}

}  // namespace findspace::distance
