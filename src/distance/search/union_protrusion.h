// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a body B, drawn at a position x, protrudes from the union of the parts of A, each a convex core grown by a
// radius: the greatest, over B's points, of the least signed distance to a part; B + x lies in A where it is at most 0.
// And why nothing of a cell of positions, or only a half of it, can be such: a point of B that moves linearly with the
// position, along a crease of A where it protrudes from two parts at once, so that the tangents of the distances there
// are off by the square of the cell's size only. Guarantee: doubles; bounds hold but for rounding. Cost: a
// branch-and-bound search (solid_max_min.h) for each position, some tens of microseconds for each point and cell.
// Keywords: directed Hausdorff distance, containment, witness, reverse convex constraint.
#pragma once

#include <optional>
#include <vector>

#include "distance/search/boundary_search.h"
#include "distance/search/lp_bound.h"
#include "distance/search/round_solid.h"
#include "space/body/body.h"

namespace findspace::distance {

/// The signed distance to a core grown by a radius, with what touches it from below.
TouchingConstraint signed_touching(const space::BodyPart& part);

class UnionProtrusion {
 public:
  UnionProtrusion(const space::Body& b, const space::Body& a);

  /// A point of B, drawn at 0, that protrudes at a position.
  struct Witness {
    space::Vector point, at;
    std::size_t piece = 0;  // of B, that holds it
  };
  struct Farthest {
    double value = 0, bound = 0;  // nothing protrudes farther than the bound
    Witness witness;
  };
  /// That protrudes farthest, but for so much, or as far as so many cells tell.
  Farthest farthest(const space::Vector& x, double precision, int most) const;
  /// Whether all of B is deeper than that, as far as so many cells tell; if not, perhaps a point that is not.
  bool deeper(const space::Vector& x, double than, int most, std::optional<Witness>& out) const;

  /// How far a point is out of A.
  double beyond(const space::Vector& y) const;
  /// To another position, and the point to where it protrudes farther there, nearby.
  void follow(Witness& witness, const space::Vector& to, double reach) const;
  /// For each part of A that can hold the point at some position of the cell: at most its signed distance there, linear
  /// between the cell's corners. No part: B lies in A nowhere in the cell. The point may go so far from corner to
  /// corner, to protrude farther.
  std::vector<Column> holders(const Witness& witness, const Tetrahedron& cell, double reach = 0) const;

  /// Of the coordinates of both.
  double size() const { return size_; }

 private:
  SolidMaxMin max_min(const space::Vector& x, double slack, double share, int most) const;
  Tetrahedron around(const Witness& witness, double reach) const;
  space::Vector farthest_out(const Tetrahedron& among, const space::Vector& x, std::span<const Touching> touching,
                             const space::Vector& at) const;
  std::vector<Touching> touching(const space::Vector& y) const;
  std::size_t piece_of(const space::Vector& point) const;

  std::vector<TouchingConstraint> parts_;  // of A
  Solids b_;                               // the round ones are numbered after the cells
  double size_ = 1;
};

}  // namespace findspace::distance
