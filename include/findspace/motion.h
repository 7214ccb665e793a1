// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of the plane that move in time, and the poses of one that may turn (docs/scene.md, "Motion", "Poses"). A shape
// runs through its way points on straight legs at even speed, and turns evenly; it stands still before its first and
// after its last one. Guarantee: what is asked of shapes that do not turn is exact; of those that turn a set that
// certainly belongs and one that possibly does. Cost: that of a map for each leg, or for each angle. Source:
// distances.md 7. Keywords: trajectory, continuous collision detection, configuration space slices.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "findspace/number.h"
#include "findspace/region.h"
#include "findspace/values.h"

namespace findspace {

/// Where a shape is at a time: turned about its own origin, then moved by `at` from where it is drawn.
struct WayPoint {
  Number time;         // in the time of the motion, ascending along a path
  Point at;            // put on the grid of the shapes
  Number degrees = 0;  // counter-clockwise
};

/// Paths by shape over a time; the others stand still.
struct Motion {
  /// The time: start < end.
  Number start = 0, end = 1;
  /// Way points of the shapes that move.
  std::map<std::string, std::vector<WayPoint>> paths;
};

/// Positions that certainly belong to a region, and those that possibly do; the same where it is known exactly.
struct RegionBounds {
  /// Some of the region, and more than it.
  Region inner, outer;
};

/// The instants of a motion at which a formula holds.
struct Instants {
  std::vector<Interval> certain;   // in order
  std::vector<Interval> possible;  // a set that holds them all; the same where `exact`
  bool exact = true;               // no shape turns, or all instants are decided
};

/// Positions at some angles of the moving shape, and between neighbouring ones.
struct PoseMap {
  /// At one angle.
  struct Slice {
    double degrees = 0;           // counter-clockwise
    Region region;                // exact where there is no `outer`, else positions that certainly belong
    std::optional<Region> outer;  // positions that possibly do
  };
  /// From one angle to the next.
  struct Sector {
    double from = 0, to = 0;  // degrees, from < to; the last may go across 360
    double bound = 0;         // how far a point of the shape can be from where the nearer end has it
    Region inner;             // feasible at every angle of the sector
    Region outer;             // holds every position that is feasible at some
  };
  /// In the order of the angles.
  std::vector<Slice> slices;
  std::vector<Sector> sectors;  // between neighbours at most 180 degrees apart
};

}  // namespace findspace
