// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a convex part covers on its way along a stretch of a line: its sum with a segment. The planes of the sum are
// those of the part and those along the way through its edges. So a search finds what comes near the part anywhere on
// a stretch at once. Guarantee: doubles, as convex_distance.h; of rounding the sum is rather too large. Cost: a plane
// for each outermost edge. Keywords: swept volume, Minkowski sum with a segment, silhouette.
#pragma once

#include <vector>

#include "distance/search/boundary_search.h"
#include "distance/search/convex_distance.h"
#include "space/body/body.h"

namespace findspace::distance {

class SweptPart {
 public:
  /// `unit`: the direction of the way, of length 1.
  SweptPart(const space::BodyPart& part, const space::Vector& unit);

  /// The distance to the part on its way from start + from * unit to start + to * unit, less its radius; inside a part
  /// without one minus how deep.
  TouchingConstraint gap(const space::Vector& start, double from, double to) const;

 private:
  void add_silhouette(std::span<const space::Point> corners, const space::Vector& corner, const space::Vector& edge);

  space::Vector unit_, center_;
  double radius_ = 0;
  bool point_ = false;
  std::vector<NearPlane> planes_, along_;  // along: those that only the way has
};

/// The distance to the segment from start + from * unit to start + to * unit.
TouchingConstraint distance_to_segment(const space::Vector& start, const space::Vector& unit, double from, double to);

}  // namespace findspace::distance
