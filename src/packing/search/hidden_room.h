// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Room for an item farther back in the row, in holes of parts and in pockets that are closed off: small moves never
// reach it. The free positions of a variant are what the no-fit polygons about all other items leave of its box of
// positions. Each piece of them has its least x at a corner of a polygon, where two of them cross, or on the box; all
// these places are looked at from the back on. Guarantee: what is found is free, in doubles. Cost: pairs of edges that
// share an x, and a look at each place up to the one that is found. Keywords: hole filling, bottom-left fill,
// arrangement of no-fit polygons.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "packing/search/arrangement.h"

namespace findspace::packing {

class HiddenRoom {
 public:
  explicit HiddenRoom(const Row& row) : row_(row) {}

  /// In a layout without overlaps, the free pose of the item that ends farthest back, if it ends before the item begins
  /// now.
  std::optional<Pose> find(const Arrangement& arrangement, std::size_t item);
  /// Pairs of edges so far.
  std::uint64_t looked_at() const { return looked_at_; }

 private:
  struct Range {
    Vec low, high;
    bool holds(Vec at) const { return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y; }
  };
  /// Of a no-fit polygon, as positions of the item; `from` has the lesser x.
  struct Side {
    Vec from, to;
  };

  std::optional<Vec> rearmost(const Arrangement& arrangement, std::size_t item, std::size_t variant,
                              const Range& range);
  void add_sides(const FieldTable& table, std::size_t variant, const Pose& other, const Range& range);
  void add_crossings(const Range& range);
  void offer(const Range& range, Vec at) {
    if (range.holds(at)) places_.push_back(at);
  }

  const Row& row_;
  std::vector<Side> sides_;
  std::vector<Vec> places_;
  std::uint64_t looked_at_ = 0;
};

}  // namespace findspace::packing
