// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is said about one position of the plane or of space: values of distances with their bounds and witnesses, the
// atoms of a formula, the nearest feasible position. Plain values in the unit of the world. Guarantee: the true value
// lies from `lower` to `upper`. Keywords: enclosure, error bound, closest features, contact.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "findspace/number.h"

namespace findspace {

/// Coordinates of a place: two in the plane, three in space.
using Place = std::vector<double>;

/// What a point of a witness lies on, in the plane: which vertex, edge or arc of which shape.
struct Feature {
  /// What the point lies on; kInside: no boundary.
  enum class Kind { kVertex, kEdge, kArc, kInside };
  /// Of the point.
  Kind kind = Kind::kVertex;
  std::string shape, part;    // the part of a collection, else empty
  std::vector<Place> points;  // in the shape's own coordinates: a vertex; the ends of an edge; the centre of an arc
  double radius = 0;          // of an arc
};

/// The value of a distance at a position, and where it is attained.
struct DistanceValue {
  std::optional<double> value;    // nothing: undefined, +infinity; may be -infinity
  bool exact = false;             // the number is known exactly, `value` is that rounded
  double lower = 0, upper = 0;    // of a value: what the true one lies between
  std::string closed_form;        // "(1+2*sqrt(5))/3": of an exact value that has one; else empty
  bool in_degrees = false;        // of distances in rotation
  std::optional<Place> nearest;   // of signed distances: the nearest position where they are 0
  std::vector<Place> points;      // two points that take the distance, in the order of its shapes; or none
  std::vector<Feature> features;  // what these lie on, in the plane; or none
  /// "vertex (1, 2) of B and edge (0, 0) to (4, 0) of A", or empty.
  std::string witness() const;
};

/// One comparison of a formula at a position.
struct AtomValue {
  std::string text;  // "gap(B, A) >= 1"
  /// Exact, also on a boundary.
  bool holds = false;
  /// The value that is compared.
  DistanceValue distance;
  std::optional<double> lacks;  // how far the value is from holding, if it does not
};

/// A formula at a position, atom by atom.
struct Check {
  /// Exact, also on a boundary.
  bool holds = false;
  /// Its comparisons, from left to right.
  std::vector<AtomValue> atoms;
};

/// The feasible position that is nearest to one of space, or such a one of the closure.
struct Nearest3 {
  /// Where it is.
  Position3 at{};
  /// How far that is.
  double distance = 0;
  /// Whether it is feasible itself, not only others as near to it as you like.
  bool attained = false;
};

/// A part of a line of positions through + t * direction, by the length gone.
struct Interval {
  std::optional<double> from, to;  // nothing: it goes on for ever
  /// Whether the ends are in the set.
  bool from_belongs = false, to_belongs = false;
};

/// Where a formula holds along a line.
struct OnLine {
  std::vector<Interval> intervals;  // in order
  bool exact = true;                // else found by a search: ends may be off by 2^-30 of the sizes
};

}  // namespace findspace
