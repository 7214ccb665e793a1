// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances while shapes are translated and turn: f(t) at a position p, B being rotated about its own origin by an
// angle and moved to b(t) + p, A likewise. At an instant the rotated vertices are rounded to a grid finer than the
// scene's by up to 2^20, so values are right to about 1e-9 of a grid step of the scene. Over time f changes at most at
// the rate
//     |speed of b - a| + (rotating rate of B, A in radians) * (greatest distance of B, A from its origin),
// which bounds it between instants (Piyavskii): the least or greatest value is bracketed and then refined where it was
// found. Guarantee: bounds, one of them (to the rounding) a value that f takes. For eta2, delta2, and eta1, delta1
// where they are positive, there is no such rate: below they are bounded by mu, above not at all over time; at an
// instant by the places that are certain whatever was rounded, and those that are possible. Nor has a gap below 0 (a
// penetration above), except between convex shapes or where none turns: rated_gap.h bounds the greatest over time and
// the one at an instant, discs about both shapes the least. Not exact. Cost: up to 400 pairs of rotated shapes (a fine
// search: 4000 of few edges), and 60 for the refinement. Source: distances.md 7.3; Piyavskii 1972, Shubert 1972.
// Keywords: rotating obstacle, Lipschitz optimisation, continuous collision detection.
#pragma once

#include <optional>
#include <vector>

#include "distance/planar/shape_pair.h"
#include "distance/planar_least/best_position.h"

namespace findspace::distance {

/// Where and how rotated both shapes are at one time: `at` = b - a, angles in degrees; `fixed_at` = a, which distances
/// in rotation ask for, since their centre stands still.
struct RotatingPose {
  exact::RealPoint at;
  exact::Real moving, fixed;
  exact::RealPoint fixed_at{};
};

inline exact::Real between(const exact::Real& from, const exact::Real& to, const exact::Real& s) {
  return from + s * (to - from);
}
inline exact::RealPoint between(const exact::RealPoint& from, const exact::RealPoint& to, const exact::Real& s) {
  return {between(from.x, to.x, s), between(from.y, to.y, s)};
}

inline RotatingPose between(const RotatingPose& p, const RotatingPose& q, const exact::Real& s) {
  return {between(p.at, q.at, s), between(p.moving, q.moving, s), between(p.fixed, q.fixed, s),
          between(p.fixed_at, q.fixed_at, s)};
}

/// At least the greatest distance of a point of the set from the origin, in grid steps.
double reach(const plane::Region& r);

class RotatingMotion {
 public:
  /// Closed shapes. `poses`: at the way points, straight and even between. `step`: size of a grid step, for the place
  /// of an error.
  RotatingMotion(const plane::Region& b, const plane::Region& a, Which which, std::vector<RotatingPose> poses,
                 double step = 1);

  /// At part `s` (0 to 1) of leg `k`; nothing where undefined whatever was rounded; from -infinity where f is.
  std::optional<ValueRange> instant(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const;
  /// Of the rounded shapes, in numbers that may be off by `off`; of a penetration those of the gap.
  struct Look {
    double f, rated, off;  // rated: what changes at the rate; f, but in place of a gap below 0 that of rated_gap.h
  };
  std::optional<Look> look(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const;
  /// `rated` is f where it is negative as well.
  bool rated_below_zero() const { return which_ != Which::kGamma1 || keeps_rate_; }
  /// Over the whole time, until its bounds are as near as `enough`: of one end a value that f takes is known, or of eta
  /// and delta none. A supremum is undefined where f is at some instant that was looked at, whatever was rounded.
  enum class Effort { kCoarse, kFine };
  std::optional<ValueRange> extremum(const exact::RealPoint& p, Sense sense, double enough = 0,
                                     Effort effort = Effort::kCoarse) const;

  /// By how much f may change over the whole of a leg, in proportion to its part.
  double rate(std::size_t leg) const;

 private:
  /// Both shapes as they stand at an instant.
  struct Standing {
    ShapePair pair;
    exact::RealPoint at;
    double rounding;  // by how much a point of either is off, in steps of the fine grid
  };
  Standing standing(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const;
  std::optional<Look> look(const Standing& standing) const;
  /// The container made larger or smaller by the rounding: all the places where the other fits; some that are certain.
  ShapePair with_container(const ShapePair& pair, double grown) const;
  /// Of eta1, delta1 at least `least`; of eta2, delta2. Undefined only where nothing can fit.
  std::optional<ValueRange> nearest_fit(const Standing& here, double least) const;
  std::optional<ValueRange> farthest_fit(const Standing& here) const;
  /// Of a penetration that of the gap.
  std::optional<ValueRange> plain_instant(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const;
  /// The least or the greatest value; of a penetration that of the gap.
  std::optional<ValueRange> plain_extremum(const exact::RealPoint& p, bool least, double enough, Effort effort) const;
  /// No eta or delta is less over the time.
  double least_protrusion(const exact::RealPoint& p, double enough) const;
  /// No gap is less, as both shapes lie in discs.
  double least_gap() const;

  plane::Region b_, a_;  // on the fine grid
  double b_reach_, a_reach_, factor_;
  double step_;      // of the scene's grid
  Which which_;      // kGamma1 for a penetration
  bool negated_;     // a penetration: max(0, -gamma1)
  bool keeps_rate_;  // known of a gap: below 0 too, as both shapes are convex, or as none turns or is rounded
  std::vector<RotatingPose> poses_;
};

}  // namespace findspace::distance
