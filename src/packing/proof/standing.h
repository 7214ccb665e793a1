// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The parts of a layout where they stand, on one lattice as fine as all their coordinates, and whether two of them meet
// or come too near. Guarantee: exact. Polygons are decided by signs of lattice points (interiors.h). Parts with arcs
// are decided by polygons about them where these are apart, else by the formula of their gap (pair_formula.h). Cost:
// linear in the corners; a contact that of its pair. Keywords: collision test.
#pragma once

#include <functional>
#include <vector>

#include "packing/problem/round_part.h"

namespace findspace::packing {

/// A part or an obstacle where it stands, in common steps; and as a set of the problem's grid about its origin.
struct Standing {
  Polygon shape;  // of a round part one about it
  LatticeBox box;
  const RoundPart::Form* round = nullptr;
  std::function<plane::SharedRegion()> set = {};
  Fraction x = {}, y = {};
};

enum class Contact { kNone, kGap, kOverlap };

class StandingParts {
 public:
  /// Both must live as long. The lattice has at least so many digits after the point.
  StandingParts(const Problem& problem, const Layout& layout, int digits = 0);

  /// All coordinates are integers over this.
  int128 common() const { return common_; }
  const std::vector<Standing>& items() const { return items_; }
  /// What does not move with the layout, from the problem's grid.
  Standing obstacle(const Part& part) const;
  LatticePoint scaled(const LatticePoint& p) const;
  LatticeBox scaled(const LatticeBox& box) const { return {scaled(box.low), scaled(box.high)}; }
  /// How far a part with arcs may reach beyond the polygon about it.
  int128 slack() const { return RoundPart::kSlack * (common_ / problem_.steps()); }

  /// Whether the interiors meet, or two shapes come nearer than a gap.
  Contact contact(const Standing& a, const Standing& b, const Fraction& gap) const;
  /// Whether a polygon of common steps keeps the gap of a part for certain; near an arc it may be said not to.
  bool keeps_gap(const Standing& part, const Polygon& polygon, const Fraction& gap) const;

 private:
  Standing standing(const Part& part, const Placed& at) const;
  Polygon scaled(Polygon shape, const LatticePoint& at) const;
  Contact round_contact(const Standing& a, const Standing& b, const Fraction& gap) const;

  const Problem& problem_;
  int128 common_ = 1;
  std::vector<Standing> items_;
};

}  // namespace findspace::packing
