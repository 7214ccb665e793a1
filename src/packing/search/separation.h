// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One question: can these parts stand in a row of this length? Overlapping parts are moved by guided local search, and
// what is nearly free is repaired by a linear program, which may take any length up to another. Guarantee: what is free
// has no overlaps, in doubles; a failure proves nothing. Cost: passes over the overlapping parts, until some have
// brought no progress. Source: Gardeyn & Wauters 2024. Keywords: guided local search, overlap minimisation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "exact/margins/packing.h"
#include "packing/compaction/linear_moves.h"
#include "packing/search/arrangement.h"
#include "packing/search/hidden_room.h"
#include "packing/search/mover.h"
#include "packing/search/random.h"

namespace findspace::packing {

/// Parts at poses in doubles.
template <class Pose>
struct LayoutInDoubles {
  std::vector<Pose> poses;
  double length = 0;
};
using DoubleLayout = LayoutInDoubles<Pose>;

/// A layout to begin with.
template <class Pose>
struct FirstLayoutOf {
  LayoutInDoubles<Pose> layout;
  std::vector<std::size_t> left;  // a part for each copy that found no place
  bool overlaps = false;          // where conditions of pairs left no place at once
};

inline constexpr double kExploreShrink = 0.001;  // of the length

/// How many of as many attempts as all together change a near solution so: a part is put anywhere, which on a strip is
/// behind all others; two of nearly the same size are exchanged, or two large ones.
struct Changes {
  std::size_t anywhere, like_sizes, two_large;
};

/// What the search is made of: in the plane here, in space in solid_search/solid_kit.h.
struct PlaneKit {
  using Pose = packing::Pose;
  using Table = FieldTable;
  using Row = packing::Row;
  using Arrangement = packing::Arrangement;
  using Mover = packing::Mover;
  using LinearMoves = packing::LinearMoves;
  using HiddenRoom = packing::HiddenRoom;

  static constexpr double kMostShrink = kExploreShrink;
  static constexpr double kExploration = 0.95;  // of the whole search
  static constexpr double kApart = 0.005;       // of the length: so much islands that explore may differ
  static constexpr Changes kChanges{2, 3, 2};
  static constexpr int kFirstPasses = 100;  // of a first try to keep conditions
  static constexpr int kRepairAfter = 20;   // so many passes without progress a linear program tries

  static std::size_t part_of(const FieldTable& table, const Pose& pose) { return table.variants()[pose.variant].part; }
  static Vec middle(const FieldTable& table, const Pose& pose) {
    const Variant& v = table.variants()[pose.variant];
    return pose.at + 0.5 * (v.low + v.high);
  }
  /// Of its box.
  static double size_of(const FieldTable& table, const Pose& pose) {
    const Variant& v = table.variants()[pose.variant];
    return (v.high.x - v.low.x) * (v.high.y - v.low.y);
  }
  /// A position to begin with, of a part that is moved into a room afterwards: anywhere in a row of sheets. The room of
  /// a strip is endless, so there it is behind all others. A place between them came out no better.
  static Vec anywhere(const FieldTable& table, const packing::Row& row, Random& random) {
    const double x = random.between(0, row.rooms().end());
    return {x, random.between(0, table.height())};
  }
  static Vec moved_back(Vec at, double by) { return {at.x - by, at.y}; }
  static Vec exchanged(Vec at, Vec from, Vec to) { return at + (to - from); }
};

/// Passes without progress, and how often the best is tried again.
struct Patience {
  int passes, strikes;
};

template <class Kit>
class SeparationOf {
 public:
  using Pose = typename Kit::Pose;

  SeparationOf(const typename Kit::Table& table, const typename Kit::Row& row, std::vector<Pose> poses, double length,
               Random& random);

  /// Begins anew at this length; a repair may end at any length up to `most`.
  void begin(const std::vector<Pose>& poses, double length, double most);
  enum class State { kUnderWay, kFree, kStuck };
  State pass(const Patience& patience);
  /// Where it is free.
  const LayoutInDoubles<Pose>& free() const { return free_; }
  /// The layout that overlapped least, and by how much.
  const std::vector<Pose>& nearest() const { return nearest_; }
  double least_loss() const { return least_loss_; }
  double loss() const { return loss_; }
  std::uint64_t work() const { return arrangement_.looked_at() + extra_work_; }
  /// By linear programs; the new length.
  double shorten(std::vector<Pose>& poses, double length);
  /// Moves an item of a layout without overlaps into hidden room, if there is some.
  bool move_back(LayoutInDoubles<Pose>& layout, std::size_t item);

 private:
  State strike(const Patience& patience);
  bool repair();

  const typename Kit::Row& row_;
  Random& random_;
  typename Kit::Arrangement arrangement_;
  typename Kit::Mover mover_;
  typename Kit::LinearMoves linear_;
  LayoutInDoubles<Pose> free_;
  std::vector<Pose> nearest_;
  std::vector<std::size_t> order_;
  double most_ = 0, loss_ = 0, least_loss_ = 0, first_loss_ = 0, repaired_loss_ = 0;
  int idle_ = 0, strikes_ = 0;
  std::uint64_t extra_work_ = 0;
};

inline constexpr double kProgress = 0.98;                // a loss below this times the last counts as progress
inline constexpr std::uint64_t kWorkOfProgram = 100000;  // pairs that take about as long as a linear program

template <class Kit>
SeparationOf<Kit>::SeparationOf(const typename Kit::Table& table, const typename Kit::Row& row, std::vector<Pose> poses,
                                double length, Random& random)
    : row_(row),
      random_(random),
      arrangement_(table, row, std::move(poses), length),
      mover_(arrangement_, random_),
      linear_(table, row) {}

template <class Kit>
void SeparationOf<Kit>::begin(const std::vector<Pose>& poses, double length, double most) {
  arrangement_.set_length(length);
  arrangement_.set_poses(poses);
  arrangement_.reset_weights();
  most_ = most;
  idle_ = strikes_ = 0;
  least_loss_ = first_loss_ = repaired_loss_ = std::numeric_limits<double>::infinity();
  nearest_ = arrangement_.poses();
}

template <class Kit>
typename SeparationOf<Kit>::State SeparationOf<Kit>::pass(const Patience& patience) {
  loss_ = arrangement_.loss();
  if (loss_ <= 0) {
    free_ = {arrangement_.poses(), arrangement_.length()};
    return State::kFree;
  }
  if (loss_ < least_loss_) {
    if (loss_ < kProgress * least_loss_) idle_ = 0;
    least_loss_ = loss_;
    nearest_ = arrangement_.poses();
  }
  if (++idle_ > patience.passes) return strike(patience);
  if (idle_ % Kit::kRepairAfter == 0 && repair()) return State::kFree;
  arrangement_.update_weights();
  order_.clear();
  for (std::size_t i = 0; i < arrangement_.size(); ++i)
    if (arrangement_.depth_of(i) > 0) order_.push_back(i);
  for (std::size_t k = order_.size(); k > 1; --k) std::swap(order_[k - 1], order_[random_.below(k)]);
  for (const std::size_t i : order_) mover_.improve(i);
  return State::kUnderWay;
}

template <class Kit>
typename SeparationOf<Kit>::State SeparationOf<Kit>::strike(const Patience& patience) {
  if (repair()) return State::kFree;
  strikes_ = least_loss_ < kProgress * first_loss_ ? 0 : strikes_ + 1;
  first_loss_ = std::min(first_loss_, least_loss_);
  if (strikes_ >= patience.strikes) return State::kStuck;
  arrangement_.set_poses(nearest_);
  idle_ = 0;
  return State::kUnderWay;
}

/// Any length up to the most will do.
template <class Kit>
bool SeparationOf<Kit>::repair() {
  if (least_loss_ >= repaired_loss_) return false;
  repaired_loss_ = least_loss_;
  std::vector<Pose> poses = nearest_;
  const double target = arrangement_.length();
  double length = target;
  const int before = linear_.solved();
  const bool separated = linear_.separate(poses, length, most_);
  if (separated) length = linear_.shorten(poses, length);
  extra_work_ += std::uint64_t(linear_.solved() - before) * kWorkOfProgram;
  if (!separated || length > most_ * (1 - margin::kCompactionGain)) return false;
  arrangement_.set_length(length);
  arrangement_.set_poses(poses);
  if (arrangement_.loss() > 0) {
    arrangement_.set_length(target);
    return false;
  }
  free_ = {std::move(poses), length};
  return true;
}

template <class Kit>
double SeparationOf<Kit>::shorten(std::vector<Pose>& poses, double length) {
  const int before = linear_.solved();
  const double shorter = linear_.shorten(poses, length);
  extra_work_ += std::uint64_t(linear_.solved() - before) * kWorkOfProgram;
  return shorter;
}

/// In space there is none: solids are searched for along lines all over the container.
template <class Kit>
bool SeparationOf<Kit>::move_back(LayoutInDoubles<Pose>& layout, std::size_t item) {
  if constexpr (requires { typename Kit::HiddenRoom; }) {
    arrangement_.set_length(layout.length);
    arrangement_.set_poses(layout.poses);
    typename Kit::HiddenRoom room(row_);
    const auto pose = room.find(arrangement_, item);
    extra_work_ += room.looked_at();
    if (pose) layout.poses[item] = *pose;
    return pose.has_value();
  } else {
    return false;
  }
}

using Separation = SeparationOf<PlaneKit>;
extern template class SeparationOf<PlaneKit>;

}  // namespace findspace::packing
