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
// the one at an instant, discs about both shapes the least. Not exact. Where shapes are apart the gap is taken from
// their boundaries alone, and an eta1 or delta1 that is nowhere above 0 from mu, which it equals. Cost: a stated amount
// of work (instant_search.h): some thousand instants where boundaries tell the distance, some dozen where maps of
// positions do. Source: distances.md 7.3; Piyavskii 1972, Shubert 1972. Keywords: rotating obstacle, Lipschitz
// optimisation, continuous collision detection.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "distance/planar_least/best_position.h"
#include "distance/rotation/squared_bound.h"
#include "distance/rotation/turning_shapes.h"

namespace findspace::distance {

class RotatingMotion {
 public:
  /// Closed shapes. `poses`: at the way points, straight and even between. `step`: size of a grid step, for the place
  /// of an error.
  RotatingMotion(const plane::Region& b, const plane::Region& a, Which which, std::vector<RotatingPose> poses,
                 double step = 1);
  /// Of shapes that questions share.
  RotatingMotion(std::shared_ptr<const TurningShapes> shapes, Which which);

  /// At part `s` (0 to 1) of leg `k`; nothing where undefined whatever was rounded; from -infinity where f is.
  std::optional<ValueRange> instant(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const;
  /// Of the rounded shapes, in numbers that may be off by `off`; of a penetration those of the gap.
  struct Look {
    double f, rated, off;  // rated: what changes at the rate; f, but in place of a gap below 0 that of rated_gap.h
  };
  /// Which bound of f a look is for. Only one above needs `rated` where it is not f.
  enum class Bounded { kBelow, kAbove };
  /// f may be given as `rated`, which is not less, where it is not more than this.
  struct Need {
    Bounded bounded = Bounded::kAbove;
    double more_than = -exact::kInfinity;
  };
  struct Looked {
    std::optional<Look> look;
    long work;  // cells (search_work.h)
  };
  Looked look(const exact::RealPoint& p, std::size_t leg, const exact::Real& s, const Need& need) const;
  /// `rated` alone is asked for.
  std::optional<Look> look(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const {
    return look(p, leg, s, {Bounded::kAbove, exact::kInfinity}).look;
  }
  /// `rated` is f where it is negative as well.
  bool rated_below_zero() const { return which_ != Which::kGamma1 || keeps_rate_; }
  /// Over the whole time, until its bounds are as near as `enough`: of one end a value that f takes is known, or of eta
  /// and delta none. A supremum is undefined where f is at some instant that was looked at, whatever was rounded.
  enum class Effort { kCoarse, kFine };
  std::optional<ValueRange> extremum(const exact::RealPoint& p, Sense sense, double enough = 0,
                                     Effort effort = Effort::kCoarse) const;

  /// By how much f may change over the whole of a leg, in proportion to its part.
  double rate(std::size_t leg) const;
  /// For squared_bound.h.
  PairsTaken pairs_taken() const { return pairs_taken_; }
  PairMotion pair_motion(const exact::RealPoint& at, std::size_t leg) const;

 private:
  using Standing = TurningShapes::Standing;
  struct Searched {
    bool least;
    double enough;
    Effort effort;
  };

  PairsTaken pairs_of(Which which) const;
  /// The same shapes for another distance.
  RotatingMotion of(Which which) const;
  Look look_of(const Standing& standing, const PlanarAnswer& v) const;
  /// Of a gap below 0.
  Look look_of_depth(const Standing& standing, const exact::RealPoint& at, const Need& need) const;
  /// The container made larger or smaller by the rounding: all the places where the other fits; some that are certain.
  ShapePair with_container(const ShapePair& pair, double grown) const;
  /// Of eta1, delta1 at least `least`; of eta2, delta2. Undefined only where nothing can fit.
  std::optional<ValueRange> nearest_fit(const Standing& here, const exact::RealPoint& at, double least) const;
  std::optional<ValueRange> farthest_fit(const Standing& here, const exact::RealPoint& at) const;
  /// Of a penetration that of the gap.
  std::optional<ValueRange> plain_instant(const exact::RealPoint& p, std::size_t leg, const exact::Real& s) const;
  /// The least or the greatest value; of a penetration that of the gap.
  std::optional<ValueRange> plain_extremum(const exact::RealPoint& p, const Searched& search) const;
  std::optional<ValueRange> searched_extremum(const exact::RealPoint& p, const Searched& search) const;
  /// Of what is made of other distances, where they have values.
  std::optional<ValueRange> composed_extremum(const exact::RealPoint& p, const Searched& search) const;
  /// Where boundaries alone tell it: a gap of shapes that are apart, an eta1 or delta1 that is not above 0.
  std::optional<ValueRange> extremum_by_boundaries(const exact::RealPoint& p, const Searched& search) const;
  std::optional<ValueRange> extremum_apart(const exact::RealPoint& p, const Searched& search) const;
  std::optional<ValueRange> extremum_of_all(const exact::RealPoint& p, const Searched& search) const;
  /// No eta or delta is less over the time.
  double least_protrusion(const exact::RealPoint& p, double enough) const;
  /// No gap is less, as both shapes lie in discs.
  double least_gap() const;
  std::size_t legs() const { return shapes_->poses().size() - 1; }

  std::shared_ptr<const TurningShapes> shapes_;
  Which which_;      // kGamma1 for a penetration
  bool negated_;     // a penetration: max(0, -gamma1)
  bool keeps_rate_;  // known of a gap: below 0 too, as both shapes are convex, or as none turns or is rounded
  PairsTaken pairs_taken_;
};

}  // namespace findspace::distance
