// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is said about positions, the same in the plane and in space: distances and atoms at one, and the nearest one
// that is feasible. Values only; lengths and places are in the scene's unit. Keywords: report, result, measurement.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "distance/answer/answer.h"
#include "exact/number/tried.h"
#include "formula/language/formula.h"

namespace findspace::formula {

/// What a point of a witness lies on, in the plane: which vertex, edge or arc of which shape, and of which part of a
/// collection.
struct FeatureAt {
  enum class Kind { kVertex, kEdge, kArc, kInside };
  Kind kind = Kind::kVertex;
  std::string shape, part;  // the part of a collection, else empty
  // In the shape's own coordinates: a vertex; the ends of an edge; the centre of an arc.
  std::vector<distance::Coordinates> points;
  exact::Real radius;  // of an arc
};

/// One distance at one position.
struct DistanceAt {
  std::string text;                             // canonical: "gamma1(B, A)"
  std::optional<distance::SceneAnswer> answer;  // nothing: undefined, +infinity, or refused
  std::vector<FeatureAt> features;              // those that the points of the witness lie on, or none
  std::string refused;                          // why the value is not computed
  distance::Way way = distance::Way::kNone;     // how the value, or else the sign, was found
  bool in_degrees = false;                      // of a distance in rotation, not in the scene's unit

  /// Rounded, perhaps -infinity.
  std::optional<double> value() const;
  /// "(1+2*sqrt(5))/3": of an exact value that has one.
  std::optional<std::string> closed_form() const;
};

/// A distance that has this answer.
DistanceAt distance_at(std::string text, std::optional<distance::SceneAnswer> answer);

/// Whether the distance of a text is wanted; without a function all are.
using WantedText = std::function<bool(const std::string& text)>;
/// Minus the distance: -infinity where that is undefined, and undefined where that is -infinity. Refused it stays so.
DistanceAt minus(DistanceAt d);

struct AtomAt {
  Atom atom;
  DistanceAt distance;
  bool holds = false;           // exact, also on a boundary
  std::optional<double> lacks;  // how far the value is from holding, if it does not (of a strict relation the infimum)
  distance::Way way = distance::Way::kNone;  // which way decided it
  double milliseconds = 0;                   // that this and the value took, with what was made for it first
};

/// The atom where its distance has that sign against the level.
AtomAt atom_at(const Atom& atom, DistanceAt distance, int sign);

/// Every atom of a formula at a position, and whether the formula holds there.
struct Check {
  bool holds = false;
  std::vector<AtomAt> atoms;
};

/// The point of the closure of a region that is nearest to a position.
struct NearestFeasible {
  distance::Coordinates at;
  exact::Real distance;
  bool attained = false;  // `at` itself is feasible, not only others as near to it as you like
};
/// Nothing where no position is feasible. Refused where it is not computed.
using TriedNearest = exact::Tried<std::optional<NearestFeasible>>;
/// Nothing where it was not asked for, as at a feasible position.
using AskedNearest = std::optional<TriedNearest>;
/// The position, where there is one; else null.
inline const NearestFeasible* found(const AskedNearest& nearest) {
  return nearest && *nearest && **nearest ? &***nearest : nullptr;
}

}  // namespace findspace::formula
