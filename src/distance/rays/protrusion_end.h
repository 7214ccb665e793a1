// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Of a convex part B that moves along a line, and a set A of which a place is known that is farther than `target` from
// A while B holds it: the place nearby that is so on the most of the line. There as many distances to features of A and
// planes of B hold it as there are unknowns (an edge of B in a crease, a corner, a face at a tip), so it is found as
// the best corner of the planes that touch at the last one (Newton). Guarantee: none; what is found has to be tested.
// Cost: some ten microseconds a step, of which a few are enough. Keywords: sequential linear programming.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "distance/search/convex_distance.h"

namespace findspace::distance {

/// A function near a place.
struct Tangent {
  double value = 0;
  space::Vector slope;
};

class EndField {
 public:
  virtual ~EndField() = default;
  /// Of distances from features of A at x, of values from -within to within, the least ones.
  virtual std::vector<Tangent> tangents(const space::Vector& x, double least, double most) const = 0;
};

struct EndQuestion {
  std::span<const NearPlane> planes;  // of B at place 0
  space::Vector start, unit;          // B is at start + s * unit
  double target = 0;
  double room = 0;  // so far within the planes
  int way = 1;      // +: the greatest s
  double reach = 0, noise = 0;
};

struct EndPlace {
  space::Vector x;
  double at = 0;  // B holds it there
  /// Along this way, with the places along it, the distances that end it grow by the length of 1 at least, and the
  /// planes that do hold it.
  space::Vector inward;
  double inward_at = 0;
};

/// From x, which B holds at place `at`.
std::optional<EndPlace> outermost_place(const EndField& a, const EndQuestion& q, space::Vector x, double at);

}  // namespace findspace::distance
