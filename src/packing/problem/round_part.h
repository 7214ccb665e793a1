// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A part, sheet or zone that is not one polygon of the grid: arcs, several pieces, or corners off the grid. At any
// angle: the exact set, its exact box, and a polygon about it for what is quick. Arcs become tangents where the part
// lies within the circle, chords where it lies without. Guarantee: set and box are exact (angles that are not multiples
// of 90 degrees round each vertex once, arcs keep their radius). Every point of the set lies in the polygon, or no
// farther than kSlack steps from it; a point in the polygon may have a winding number above 1. Cost: an arrangement an
// angle, made once. Threads: safe. Keywords: circular arcs, curved nesting.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "packing/problem/problem.h"
#include "plane/complex/shared_region.h"

namespace findspace::packing {

class RoundPart {
 public:
  /// At an angle, in steps of the grid.
  struct Form {
    plane::SharedRegion region;
    exact::RealPoint low, high;  // the least box
    LatticeBox box;              // the least box of grid points about it
    Polygon about;
  };
  static constexpr int kSlack = 2;

  /// A closed bounded set that is the closure of its interior, in grid steps. Error(kGeometry) where it is not. `step`:
  /// the size of one, for the place of an error.
  explicit RoundPart(plane::Region region, double step = 1);

  /// Throws Error(kGeometry) where the rounded vertices make curves cross.
  const Form& at(const Fraction& angle, bool mirrored) const;
  /// In grid steps, of the set as it is stated.
  double twice_area() const { return twice_area_; }
  /// Of what of it lies at x <= most.
  double area_left_of(double most) const;
  double step() const { return step_; }

 private:
  plane::SharedRegion region_;
  double step_, twice_area_ = 0;
  mutable std::mutex guard_;
  mutable std::map<std::pair<Fraction, bool>, std::unique_ptr<const Form>> forms_;
};

/// The closure of what of a polygon is not in the set. Throws Error(kGeometry) where nothing is.
std::shared_ptr<const RoundPart> what_is_about(const RoundPart& inner, const Polygon& polygon);

/// The rings of a set that is one polygon of the grid.
std::optional<std::vector<Ring>> rings_of(const plane::Region& region);

/// The closed set of a part at an angle, and that of a polygon, on the grid. Error(kOutOfRange) beyond 2^40 steps.
plane::SharedRegion region_of(const Part& part, const Fraction& angle, bool mirrored);
plane::Region region_of(const Polygon& shape);

}  // namespace findspace::packing
