// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A rotational distance f(t) (rotational_distance.h) at one position while the shapes are translated and turn: how far
// B has to turn about a point that stands still until the answer at that time changes. f jumps; but over a short time
// the plain distance at any turn changes by at most the way of the shapes, so that the circles of signs at the middle
// of the time, taken at levels off by that way, bound f over the whole of it. Guarantee: certified bounds; at an
// instant between two rotated shapes exact but for the rounding of rotated vertices. Extrema over time: by halving the
// time where the bound is worst. Cost: two maps as rotated_pair.h for a piece of time, up to 150 of those. Source:
// distances.md 7.2, 7.3. With a radius all of this holds at every position that is not farther from p. Keywords:
// angular clearance over time.
#pragma once

#include <vector>

#include "distance/planar_least/best_position.h"
#include "distance/rotation/rotation_motion.h"
#include "distance/rotation/rotational_levels.h"

namespace findspace::distance {

/// A part of a leg, from 0 to 1; a single instant where they are the same.
struct PartOfLeg {
  std::size_t leg;
  exact::Real from, to;
};

class RotationInTime {
 public:
  /// Closed shapes; `which`: gamma, eta or delta; `centre` and the position `p` in grid steps. `step`: size of one, for
  /// the place of an error.
  RotationInTime(plane::Region b, plane::Region a, Which which, exact::RealPoint centre, exact::RealPoint p,
                 std::vector<RotatingPose> poses, double step = 1);

  /// The signs that f minus a level (degrees) may have.
  SignRange signs(const PartOfLeg& part, const exact::Real& level) const;
  /// Bounds of all values in a part of the time, in degrees; +infinity where undefined.
  ValueRange values(const PartOfLeg& part) const;
  ValueRange instant(std::size_t leg, const exact::Real& s) const;
  /// Bounds of inf or sup: of one end a value that f takes is known.
  ValueRange extremum(Sense sense) const;
  /// The same at all positions that are not farther than `radius` from p.
  RotationInTime around(exact::RealPoint p, double radius) const;

 private:
  BoundedRotations circles(const PartOfLeg& part) const;

  static constexpr int kMostParts = 150, kFirstParts = 8;  // of all the time; of it around a position less will do

  plane::Region b_, a_;
  Which which_;
  exact::RealPoint centre_, p_;
  std::vector<RotatingPose> poses_;
  double b_reach_, a_reach_, step_, radius_ = 0;
  int first_parts_ = kFirstParts, most_parts_ = kMostParts;
};

}  // namespace findspace::distance
