// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What rings mean that touch, or cross themselves and each other by a little, as drawings hold them: arcs joined badly,
// cusps, arcs that touched before their ends were rounded. Each ring runs counter-clockwise where an even number of
// others goes round it, else clockwise, and
//     the set = {p : the rings wind around p once or more},
// of each outer ring with its holes. So overlaps are joined and loops that stick out are left out.
// Guarantee: exact. How far the rings are from being valid is bounded from above: every face where the number is
// neither 0 nor 1 lies between two parallel lines, or two circles about one point, that are width() apart; what runs
// out and back, and what runs along another ring, lies in squares of side spike(). Only two outer rings may share a
// side. It is for the user to say how much is a little. Cost: one arrangement of the edges, and one more for each outer
// ring concerned. Keywords: polygon repair, make valid, winding number, self-intersection.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "plane/build/wound_loops.h"

namespace findspace::plane {

/// An outer ring with its holes: as they were drawn, if no other ring meets them, else as a set.
struct MendedPart {
  std::vector<Contour> rings;
  std::optional<Region> cells;
};

struct MendedRings {
  std::vector<MendedPart> parts;
  std::size_t places = 0;         // overlaps, loops and spikes; 0 where rings only touch
  double longest = 0;             // the longest of them
  std::array<double, 2> place{};  // a point of that one
};

class RingMender {
 public:
  explicit RingMender(std::span<const Contour> rings);

  /// In grid steps; infinite where rings lie in no order.
  double width() const { return width_; }
  double spike() const { return spike_; }
  MendedRings mended() const;
  /// What runs out and back, or along another ring: lines.
  const Region& spikes() const { return spikes_; }

  /// Whether the set lies to the left of the ring, as it was given; nothing where it lies on either side of parts of
  /// it.
  std::optional<bool> set_on_left(std::size_t ring) const;
  bool is_hole(std::size_t ring) const;
  bool winds_round_nothing() const;

 private:
  std::vector<Loop> loops_;
  WoundLoops all_;
  Region excess_, spikes_;
  double width_ = 0, spike_ = 0;
};

}  // namespace findspace::plane
