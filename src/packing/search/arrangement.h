// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Parts in a strip of a given length, perhaps overlapping: depths, weighted costs of positions, and the weights that
// grow where an overlap persists. Cost of a position: the weighted sum of the depths. Overlaps of large parts weigh
// more. Where a part is longer than the strip at its angle, the excess counts as an overlap with the strip. Obstacles
// of sheets are parts that never move. Guarantee: none; it is a search's state. Keywords: guided local search, overlap
// minimisation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "packing/nfp/row.h"
#include "packing/search/box_list.h"
#include "packing/search/position_ranges.h"

namespace findspace::packing {

class Arrangement {
 public:
  /// The table and the row must live as long.
  Arrangement(const FieldTable& table, const Row& row, std::vector<Pose> poses, double length);

  /// Of parts; obstacles have numbers from here on.
  std::size_t size() const { return size_; }
  const FieldTable& table() const { return *table_; }
  std::vector<Pose> poses() const { return {poses_.begin(), poses_.begin() + std::ptrdiff_t(size_)}; }
  const Pose& pose(std::size_t i) const { return poses_[i]; }
  double length() const { return length_; }
  /// Parts that protrude are moved in.
  void set_length(double length);
  void set_poses(const std::vector<Pose>& poses);
  void move(std::size_t i, const Pose& pose);
  /// The nearest position of the variant within a room.
  Vec inside(std::size_t variant, Vec at) const { return ranges_.inside(variant, at); }
  Vec random_position(std::size_t variant, Random& random) const { return ranges_.random_position(variant, random); }

  /// The weighted cost of an item at a pose, or something not below `bound` where it is not below. Lower bounds of the
  /// depths come first, and exact ones only while the pose can still be better than `bound`.
  double cost(std::size_t i, const Pose& pose, double bound) const;
  /// The other items whose boxes meet that of the item at this pose.
  std::span<const std::uint32_t> near(std::size_t i, const Pose& pose) const;
  /// How the item at this pose overlaps item j: the boundary point as a move of the item, and the line of its edge.
  struct Exit {
    double depth = 0;
    Vec move, line;  // to the nearest free position with respect to j; along the edge there
  };
  Exit exit(const Pose& pose, std::size_t j) const;
  double weight(std::size_t i, std::size_t j) const { return weights_[i * poses_.size() + j]; }

  /// The sum of all depths by their least weights; fills depth_of(i), the sum of those of an item.
  double loss();
  double depth_of(std::size_t i) const { return depths_[i]; }
  /// After loss(): weights of overlaps grow, by more the deeper they are; others decay.
  void update_weights();
  void reset_weights();
  /// Pairs of items looked at since the beginning.
  std::uint64_t looked_at() const { return looked_at_; }

 private:
  struct Overlap {
    std::uint32_t i, j;
    double depth;
  };

  /// A pair while its cost is summed up.
  struct Look {
    const FieldTable::Link* link;
    Vec at;
    int cell;
    double least, weight;
  };

  /// Calls meet(j) for the other items whose boxes meet that of the pose, in order, then for those tied to it that are
  /// farther away, until it says false.
  template <class Meet>
  void for_each_near(std::size_t i, const Pose& pose, const Meet& meet) const;
  void find_ties();
  void find_sizes();
  double least_weight(std::size_t i, std::size_t j) const { return sizes_[i] * sizes_[j]; }

  const FieldTable* table_;
  const Row* row_;
  std::size_t size_;
  std::vector<Pose> poses_;
  PositionRanges<Vec> ranges_;
  double length_, shallow_, slack_;
  BoxList<2> boxes_;
  std::vector<std::vector<std::uint32_t>> tied_;  // to each item by conditions; empty where there is none
  std::vector<double> sizes_, weights_, strip_weights_, depths_;
  std::vector<Overlap> overlaps_;
  mutable std::vector<std::uint32_t> near_;
  mutable std::vector<Look> looks_;
  mutable std::uint64_t looked_at_ = 0;
};

}  // namespace findspace::packing
