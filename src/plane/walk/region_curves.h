// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The edges of closed sets, bounded by rings of segments of grid lines, as directed curves; which of them may meet; and
// whether a point lies inside one of the sets. Guarantee: exact; boxes only choose. Cost: linear, and the edges of two
// sets in the box that both share, for all pairs of sets whose boxes meet. Used by unite.cpp only.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plane/base/arena.h"
#include "plane/complex/broad_phase.h"
#include "plane/complex/primitives.h"
#include "plane/walk/coarse_box.h"
#include "plane/walk/directed_curves.h"

namespace findspace::plane {

class RegionCurves {
 public:
  using Pairs = ArenaVector<std::pair<Index, Index>>;

  /// Nothing where a set is not bounded, not closed or not regular, its rings touch, or an edge is no segment of a grid
  /// line.
  static std::optional<RegionCurves> of(std::span<const Region* const> regions, Memory memory);
  /// Of valid rings; nothing where there are arcs or straight corners. Their lines are unreduced (unreduced_lines.h).
  static std::optional<RegionCurves> of(Polygons polygons, Memory memory);

  /// Curves of different sets that may meet; nothing where sets overlap so much that an arrangement may cost less.
  std::optional<Pairs> pairs();

  /// Allows as many looks at curves as an arrangement of so many parts of curves costs.
  void allow_looks(std::size_t parts);
  /// Takes a look at all curves near those of the set from what is allowed; false where that is used up.
  bool look_near(Index set);

  /// Is the point, which lies on the boundary of sets a and b alone, inside another one? It is on a curve of a.
  bool is_inside_another(Index point, Index a, Index b) const;
  /// Is the outer side of a curve inside a set, near a point that lies on no boundary but along the curve?
  bool is_covered(Index point, Index curve) const;

  DirectedCurves curves;  // a set after the other; each has the number of its set as group

 private:
  explicit RegionCurves(Memory memory)
      : first_(memory),
        boxes_(memory),
        region_boxes_(memory),
        near_(memory),
        first_near_(memory),
        near_curves_(memory),
        of_a_(memory),
        of_b_(memory) {}

  void reserve(std::span<const Region* const> regions);
  bool add(const Region& region);
  /// The curves of a ring from `first` on, a point and a line for each; false where it has arcs or straight corners.
  bool set_curves(const Contour& ring, Index first, Index number);
  void set_boxes();
  /// From what is allowed; false where there is too little.
  bool take_looks(std::size_t count);
  /// Of two sets, those of their edges that reach into the box of both; false where that takes too many looks.
  bool add_pairs(Index a, Index b, Pairs& to);
  /// The curves of a set that reach into the box of another one, in a list with enough room.
  std::span<const Index> meeting(Index region, Index other, std::span<Index> list) const;
  void set_near(std::span<const std::pair<Index, Index>> met);
  CoarseBox box_at(Index point) const;
  /// `at`: the box of the point.
  bool holds(Index region, Index point, const CoarseBox& at) const;
  /// The curve of a set that runs along another curve at the point, or kNone.
  Index along(Index region, Index point, Index curve) const;

  Index set_count() const { return Index(first_.size()) - 1; }

  ArenaVector<Index> first_;  // set -> its first curve
  CoarseGrid grid_;
  ArenaVector<CoarseBox> boxes_;  // of curves, then of sets
  ArenaVector<PieceBox> region_boxes_;
  ArenaVector<Index> near_, first_near_;  // set -> those whose boxes meet its box
  ArenaVector<std::size_t> near_curves_;  // set -> how many curves those have
  std::size_t looks_ = 0;
  ArenaVector<Index> of_a_, of_b_;  // room for the curves of one set
  double slack_ = 0;
};

}  // namespace findspace::plane
