// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far solids protrude from the union of sets of places (position_set.h): the greatest distance of a point of them
// to the nearest place. The search is tetrahedral_max_min.h, and what bounds a cell are such places alone: the
// distance to one of them is convex, nowhere less than that to the sets, and where it is the nearest place it has the
// slope of that, so the bound is off by the square of the cell's size. Such places are found when a cell is first
// looked at, and kept. Guarantee: doubles; no point of the solids is farther out than `bound`, which is as
// near as asked for, where the limit of cells allows it. Refused where no nearest place is found, nor known. Cost: some
// hundred cells, each a nearest place of 0.1 to 3 ms. Keywords: directed Hausdorff distance, branch and bound.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "distance/search/position_set.h"
#include "distance/search/round_solid.h"

namespace findspace::distance {

/// A set of places; some of the planes and balls that hold it, and of the balls and grown sets that it is out of, say
/// without a search which place is nearest, mostly.
struct NearSet {
  struct Ball {
    space::Vector center;
    double radius;
  };
  /// A convex set: the signed distance to its boundary, and the planes of its core.
  struct Cut {
    TouchingConstraint boundary;
    std::vector<space::HalfSpace> planes;
    std::optional<RoundSolid> drill{};  // a ball along a segment
  };
  const PositionSet* places = nullptr;
  /// Some place of the set, as near as is known without a search; nothing where none is.
  std::function<std::optional<space::Vector>(const space::Vector&)> known{};
  /// To convex sets that hold the set, beside those of its constraints.
  std::vector<std::function<space::Vector(const space::Vector&)>> ways{};
  std::vector<space::HalfSpace> planes{};
  std::vector<Ball> outer{}, balls{};
  std::vector<Cut> cuts{};

  static Ball ball(const space::BodyPart& part) { return {exact::approx(part.center), part.radius.to_double()}; }
  /// What the set is out of.
  void take_away(const space::BodyPart& part);
};

struct SetProtrusion {
  SolidMaxMin found;
  space::Vector nearest;  // place to that point
  std::size_t set = 0;    // that it belongs to

  /// `size`: of the coordinates.
  Answer answer(double size) const;
};

/// Why: the search ended, or found no place of a set.
exact::Refusal not_protruding();
/// Where the search ends, beside where value and bound are so near, and where the question has no more cells
/// (search_work.h).
struct ProtrusionEnd {
  int most = 4000;                          // cells
  double ceiling = exact::kInfinity;        // no point of the solids is farther out
  std::optional<space::Vector> first = {};  // a point of them to look at first
};
/// At least one set. `known`: what an earlier search of the same found.
exact::Tried<SetProtrusion> set_protrusion(const Solids& solids, const std::vector<NearSet>& sets, double size,
                                           double near, const SolidMaxMin* known = nullptr,
                                           const ProtrusionEnd& end = {});

}  // namespace findspace::distance
