// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Solids in a container of a given height, perhaps overlapping: depths, weighted costs of positions and of lines of
// them, and the weights that grow where an overlap persists. Cost of a position: the weighted sum of the depths, and of
// what conditions of pairs lack. Overlaps of large solids weigh more. Obstacles of the column are solids that never
// move. Guarantee: none; it is a search's state. Keywords: guided local search, overlap minimisation.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "packing/search/box_list.h"
#include "packing/search/position_ranges.h"
#include "packing/solid_depth/solid_table.h"
#include "packing/solid_moves/solid_linear_moves.h"

namespace findspace::packing {

class SolidArrangement {
 public:
  /// Both must live as long.
  SolidArrangement(const SolidTable& table, const SolidColumn& column, std::vector<SolidPose> poses, double height);

  /// Of parts; obstacles have numbers from here on.
  std::size_t size() const { return size_; }
  const SolidTable& table() const { return table_; }
  std::vector<SolidPose> poses() const { return {poses_.begin(), poses_.begin() + std::ptrdiff_t(size_)}; }
  const SolidPose& pose(std::size_t i) const { return poses_[i]; }
  double length() const { return height_; }
  /// Parts that protrude are moved in. Where one is higher at its form, the excess counts as an overlap.
  void set_length(double height);
  void set_poses(const std::vector<SolidPose>& poses);
  void move(std::size_t i, const SolidPose& pose);
  /// The nearest position within a room.
  Vector inside(std::size_t variant, const Vector& at) const { return ranges_.inside(variant, at); }
  Vector random_position(std::size_t variant, Random& random) const { return ranges_.random_position(variant, random); }

  /// The weighted cost of an item at a pose, or something not below `bound` where it is not below.
  double cost(std::size_t i, const SolidPose& pose, double bound) const;
  /// How the item at this pose overlaps another.
  struct Touch {
    double cost;    // 0 in contact
    Vector normal;  // out of it, of length 1
  };
  /// Overlaps and contacts of convex parts.
  void touches(std::size_t i, const SolidPose& pose, std::vector<Touch>& result) const;
  /// The place at + t way within its room that costs least, exactly: the ends of all intervals are tried. Of
  /// places that cost nothing the one next to the beginning of the line, or to its end. Where none costs less than
  /// `bound` that is returned.
  struct LinePlace {
    double t = 0, cost = 0;
  };
  LinePlace best_on_line(std::size_t i, const SolidPose& pose, const Vector& way, double bound, bool from_end) const;

  /// The sum of all depths by their least weights; fills depth_of(i), the sum of those of an item.
  double loss();
  double depth_of(std::size_t i) const { return depths_[i]; }
  /// After loss(): weights of overlaps grow, by more the deeper they are; others decay.
  void update_weights();
  void reset_weights();
  /// Boxes, and planes in blocks, looked at since the beginning.
  std::uint64_t looked_at() const { return looked_at_; }

 private:
  struct Overlap {
    std::uint32_t i, j;
    double depth;
  };
  static constexpr std::uint32_t kNoStretch = std::uint32_t(-1);
  /// Where the line lies in the overlap of two convex parts.
  struct Stretch {
    double from, to, weight;
    const ConvexOverlap* overlap;
    Vector u, way;
  };
  struct Event {
    double t;
    std::uint32_t stretch;  // kNoStretch: a place to look at
    bool begins;
  };

  BoxList<3>::Box box_at(const SolidPose& pose, double wider) const;
  /// The stretch of the line within the room.
  space::LineStretch within(const SolidPose& pose, const Vector& way) const;
  void collect_stretches(std::size_t i, const SolidPose& pose, const Vector& way,
                         const space::LineStretch& within_box) const;
  double cost_at(double t, double bound) const;
  void find_ties();
  void find_sizes();
  void add_overlap(std::size_t i, std::size_t j, double depth);
  /// What the conditions of item i lack at a pose, weighted.
  double cost_of_ties(std::size_t i, const SolidPose& pose, double bound) const;
  /// How far those with item j are from holding.
  double lacks(std::size_t i, const SolidPose& pose, std::size_t j) const;
  /// The places of a line at which conditions begin to hold.
  void add_ends_of_ties(std::size_t i, const SolidPose& pose, const Vector& way, double start, double end,
                        double sense) const;
  const std::vector<double>& weights_of(std::size_t i) const;
  void grow_weight(std::size_t i, std::size_t j, double factor);

  const SolidTable& table_;
  const SolidColumn& column_;
  std::size_t size_;
  std::vector<SolidPose> poses_;  // obstacles last
  PositionRanges<Vector> ranges_;
  double height_, shallow_, slack_;
  BoxList<3> boxes_;
  /// Of pairs whose weight is not the least one, by the first item: how many times as large it is.
  std::vector<std::vector<std::pair<std::uint32_t, double>>> weights_;
  std::vector<double> sizes_, height_weights_, depths_;
  mutable std::vector<double> row_;  // the weights of one item with all others, without its own size
  mutable std::size_t row_of_ = 0;
  std::vector<Overlap> overlaps_;
  std::vector<std::vector<std::uint32_t>> tied_;  // to each item by conditions; empty where there is none
  mutable std::vector<Stretch> stretches_;
  mutable std::vector<double> lowest_;  // places of a line that never leaves a wall
  mutable std::vector<Event> events_;
  mutable std::vector<std::uint32_t> active_;
  mutable std::uint64_t looked_at_ = 0;
};

}  // namespace findspace::packing
