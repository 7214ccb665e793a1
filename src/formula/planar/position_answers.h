// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is said about positions: distances and atoms at one, the nearest one that is feasible, and regions and instants
// that are known between bounds. Values only. Keywords: report, result.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formula/language/formula.h"
#include "formula/planar/witness.h"
#include "plane/query/section.h"

namespace findspace::formula {

/// One distance at one position.
struct DistanceAt {
  std::string text;                          // canonical: "gamma1(B, A)"
  std::optional<double> value;               // in the scene's unit, may be -infinity; nothing: undefined, +infinity
  std::optional<exact::RealPoint> nearest;   // in grid steps: the nearest position where it is 0, if that is known
  std::optional<exact::RealPoint> farthest;  // in grid steps: of eta2 and delta2 the position of the farthest touching
  std::vector<FeatureAt> witness;            // two features that attain it, in the order of the arguments; or none
  std::optional<double> bound{};             // not exact: how far the true value may be, of shapes that turn in time
  bool in_degrees = false;                   // of a distance in rotation, not in the scene's unit
};

struct AtomAt {
  Atom atom;
  DistanceAt distance;
  bool holds = false;           // exact, also on a boundary
  std::optional<double> lacks;  // how far the value is from holding, if it does not (of a strict relation the infimum)
};

/// Every atom of a formula at a position, and whether the formula holds there.
struct Check {
  bool holds = false;
  std::vector<AtomAt> atoms;
};

/// The point of the closure of a region that is nearest to a position.
struct NearestFeasible {
  exact::RealPoint at;    // in grid steps
  exact::Real distance;   // in the scene's unit
  bool attained = false;  // `at` itself is feasible
};

/// Positions that certainly and that possibly belong to a region.
struct RegionBounds {
  plane::Region inner, outer;
};

/// Instants that certainly and that possibly belong.
struct InstantBounds {
  plane::Section inner, outer;
};

}  // namespace findspace::formula
