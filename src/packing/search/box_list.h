// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes of the plane or of space, side by side in single precision, and those whose interiors meet a given one, four at
// a time. Boxes are put in larger than they are, so that rounding misses none. Cost: linear. Keywords: axis-aligned
// bounding boxes, broad phase.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace findspace::packing {

template <std::size_t kAxes>
class BoxList {
 public:
  static constexpr std::size_t kLanes = 4;
  struct Box {
    std::array<float, kAxes> low, high;
  };

  /// Boxes that meet none.
  explicit BoxList(std::size_t count) {
    Block far;
    for (std::size_t k = 0; k < kAxes; ++k) {
      far.low[k] = Lanes{} + std::numeric_limits<float>::infinity();
      far.high[k] = Lanes{} - std::numeric_limits<float>::infinity();
    }
    blocks_.assign((count + kLanes - 1) / kLanes, far);
  }

  void put(std::size_t i, const Box& box) {
    for (std::size_t k = 0; k < kAxes; ++k) {
      blocks_[i / kLanes].low[k][i % kLanes] = box.low[k];
      blocks_[i / kLanes].high[k][i % kLanes] = box.high[k];
    }
  }
  bool meets(std::size_t i, const Box& box) const { return meet(blocks_[i / kLanes], box)[i % kLanes] != 0; }

  /// Calls visit(i) in order until it says false; whether it never did. `looked_at` counts boxes.
  template <class Visit>
  bool for_each_meeting(const Box& box, std::uint64_t& looked_at, const Visit& visit) const {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const auto met = meet(blocks_[b], box);
      looked_at += kLanes;
      std::array<std::uint64_t, 2> halves;
      std::memcpy(halves.data(), &met, sizeof halves);
      if ((halves[0] | halves[1]) == 0) continue;
      for (std::size_t lane = 0; lane < kLanes; ++lane)
        if (met[lane] != 0 && !visit(b * kLanes + lane)) return false;
    }
    return true;
  }

 private:
  using Lanes [[gnu::vector_size(16)]] = float;
  using Met [[gnu::vector_size(16)]] = int;
  struct Block {
    std::array<Lanes, kAxes> low, high;
  };

  static Met meet(const Block& block, const Box& box) {
    Met met = (box.low[0] < block.high[0]) & (block.low[0] < box.high[0]);
    for (std::size_t k = 1; k < kAxes; ++k) met &= (box.low[k] < block.high[k]) & (block.low[k] < box.high[k]);
    return met;
  }

  std::vector<Block> blocks_;
};

}  // namespace findspace::packing
