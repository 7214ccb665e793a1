// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// One searcher for a shorter strip, with its own random numbers. It shrinks the strip, separates the overlapping parts
// by guided local search, repairs what is nearly free by a linear program, and shortens every success by another. It
// goes on from a near solution, a part moved or two exchanged, where a separation fails (exploration), or from the best
// layout in ever smaller steps (compression). Work is counted in pairs of parts looked at, so that a search can be
// repeated. Guarantee: its best layout has no overlaps, in doubles. Source: Gardeyn & Wauters 2024 (phases, pool).
// Keywords: guided local search, strip packing, open dimension.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "packing/search/separation.h"

namespace findspace::packing {

template <class Kit>
class IslandOf {
 public:
  using Pose = typename Kit::Pose;
  using Found = LayoutInDoubles<Pose>;

  IslandOf(const typename Kit::Table& table, const typename Kit::Row& row, Found start, std::uint64_t seed);

  /// One pass over the overlapping parts, or one step between two separations. `progress`: how much of the whole
  /// search is over, from 0 to 1; less than before where a search without limits found a better layout.
  void step(double progress);
  const Found& best() const { return best_; }
  /// Goes on from a better layout of another island.
  void adopt(const Found& better) { keep(better); }
  std::uint64_t work() const { return separation_.work(); }
  /// Overlapping depth at the last pass.
  double overlap() const { return separation_.loss(); }

 private:
  struct Near {
    std::vector<Pose> poses;
    double loss;
  };
  enum class Phase { kExplore, kCompress };

  void begin();                            // a separation
  std::vector<Pose> shrunk(double ratio);  // the best layout, moved together
  std::vector<Pose> from_pool();
  void exchange(std::vector<Pose>& poses, std::size_t i, std::size_t j) const;
  void exchange_two_large(std::vector<Pose>& poses);
  void exchange_like_sizes(std::vector<Pose>& poses);
  bool fill_hidden_room(Found& layout);
  void keep(Found better);
  void fail();

  const typename Kit::Table& table_;
  const typename Kit::Row& row_;
  Random random_;
  SeparationOf<Kit> separation_;
  Found best_;
  std::vector<std::size_t> by_size_;  // items, the largest first
  std::size_t large_ = 0;             // how many of them are large
  std::size_t next_small_ = 0;        // of the others, whose turn it is to go into hidden room
  std::uint64_t hidden_work_ = 0;     // what looking for that has cost
  Phase phase_ = Phase::kExplore;
  double progress_ = 0, target_ = 0;
  double shrink_ = Kit::kMostShrink;  // of exploration: half as much after a failure, twice as much after a success
  bool separating_ = false;
  std::vector<Near> pool_;
};

inline constexpr double kFirstCompression = 0.0005, kLastCompression = 0.00001;
inline constexpr std::size_t kPool = 12;
inline constexpr std::uint64_t kHiddenShare = 50;  // hidden room is sought with one part of so many of the work
inline constexpr Patience kExplorePatience{120, 3}, kCompressPatience{80, 3};

template <class Kit>
IslandOf<Kit>::IslandOf(const typename Kit::Table& table, const typename Kit::Row& row, Found start, std::uint64_t seed)
    : table_(table),
      row_(row),
      random_(seed),
      separation_(table, row, start.poses, start.length, random_),
      best_(std::move(start)) {
  for (std::size_t i = 0; i < best_.poses.size(); ++i) by_size_.push_back(i);
  const auto larger = [&](std::size_t i, std::size_t j) {
    return Kit::size_of(table_, best_.poses[i]) > Kit::size_of(table_, best_.poses[j]);
  };
  std::stable_sort(by_size_.begin(), by_size_.end(), larger);
  large_ = std::max<std::size_t>(std::min<std::size_t>(by_size_.size(), 2), by_size_.size() * 2 / 3);
  best_.length = separation_.shorten(best_.poses, best_.length);
}

template <class Kit>
void IslandOf<Kit>::step(double progress) {
  progress_ = progress;
  const Phase phase = progress >= Kit::kExploration ? Phase::kCompress : Phase::kExplore;
  if (phase != phase_) separating_ = false;
  phase_ = phase;
  if (!separating_) return begin();
  using State = typename SeparationOf<Kit>::State;
  const State state = separation_.pass(phase_ == Phase::kCompress ? kCompressPatience : kExplorePatience);
  if (state == State::kStuck) fail();
  if (state != State::kFree) return;
  shrink_ = std::min(2 * shrink_, Kit::kMostShrink);
  Found better = separation_.free();
  better.length = separation_.shorten(better.poses, better.length);
  if (fill_hidden_room(better)) better.length = separation_.shorten(better.poses, better.length);
  keep(std::move(better));
}

/// With some of the small items, in turn.
template <class Kit>
bool IslandOf<Kit>::fill_hidden_room(Found& layout) {
  const std::size_t small = by_size_.size() - large_;
  bool moved = false;
  for (std::size_t k = 0; k < small && hidden_work_ * kHiddenShare <= work(); ++k) {
    const std::uint64_t before = work();
    moved |= separation_.move_back(layout, by_size_[large_ + next_small_++ % small]);
    hidden_work_ += work() - before;
  }
  return moved;
}

template <class Kit>
void IslandOf<Kit>::begin() {
  std::vector<Pose> poses;
  if (phase_ == Phase::kCompress) {
    const double over = (progress_ - Kit::kExploration) / (1 - Kit::kExploration);
    poses = shrunk(kFirstCompression + (kLastCompression - kFirstCompression) * std::clamp(over, 0.0, 1.0));
  } else {
    poses = pool_.empty() ? shrunk(shrink_) : from_pool();
  }
  separation_.begin(poses, target_, best_.length);
  separating_ = true;
}

/// What lies behind a random place moves up by what is cut off.
template <class Kit>
std::vector<typename Kit::Pose> IslandOf<Kit>::shrunk(double ratio) {
  const double cut = ratio * best_.length, split = random_.between(0, best_.length);
  std::vector<Pose> poses = best_.poses;
  for (Pose& p : poses)
    if (along(Kit::middle(table_, p)) > split) p.at = Kit::moved_back(p.at, cut);
  target_ = std::max(best_.length - cut, row_.fixed_end());
  return poses;
}

template <class Kit>
std::vector<typename Kit::Pose> IslandOf<Kit>::from_pool() {
  const double place = std::min(random_.half_normal() * 0.25, 0.999);
  std::vector<Pose> poses = pool_[std::size_t(place * double(pool_.size()))].poses;
  constexpr Changes kShares = Kit::kChanges;
  const std::size_t kind = random_.below(kShares.anywhere + kShares.like_sizes + kShares.two_large);
  if (kind < kShares.anywhere)
    poses[random_.below(poses.size())].at = Kit::anywhere(table_, row_, random_);
  else if (kind < kShares.anywhere + kShares.like_sizes)
    exchange_like_sizes(poses);
  else
    exchange_two_large(poses);
  return poses;
}

template <class Kit>
void IslandOf<Kit>::exchange(std::vector<Pose>& poses, std::size_t i, std::size_t j) const {
  const auto first = Kit::middle(table_, poses[i]), second = Kit::middle(table_, poses[j]);
  poses[i].at = Kit::exchanged(poses[i].at, first, second);
  poses[j].at = Kit::exchanged(poses[j].at, second, first);
}

/// Two that follow each other by size, of different parts: little else has to move.
template <class Kit>
void IslandOf<Kit>::exchange_like_sizes(std::vector<Pose>& poses) {
  const std::size_t count = by_size_.size(), first = random_.below(count);
  const std::size_t step = random_.below(2) == 0 ? 1 : count - 1;
  const auto part_of = [&](std::size_t k) { return Kit::part_of(table_, poses[by_size_[k]]); };
  std::size_t second = (first + step) % count;
  while (second != first && part_of(second) == part_of(first)) second = (second + step) % count;
  if (second != first) exchange(poses, by_size_[first], by_size_[second]);
}

template <class Kit>
void IslandOf<Kit>::exchange_two_large(std::vector<Pose>& poses) {
  if (large_ < 2) return;
  const std::size_t i = by_size_[random_.below(large_)];
  const auto part_of = [&](std::size_t k) { return Kit::part_of(table_, poses[k]); };
  std::size_t j = i;
  for (int tries = 0; tries < 20 && part_of(j) == part_of(i); ++tries) j = by_size_[random_.below(large_)];
  exchange(poses, i, j);
}

template <class Kit>
void IslandOf<Kit>::keep(Found better) {
  best_ = std::move(better);
  pool_.clear();
  separating_ = false;
}

template <class Kit>
void IslandOf<Kit>::fail() {
  separating_ = false;
  if (phase_ == Phase::kCompress) return;
  if (shrink_ > kExploreShrink) {
    shrink_ = std::max(0.5 * shrink_, kExploreShrink);
    return;
  }
  const double loss = separation_.least_loss();
  const auto above = [](double least, const Near& near) { return least < near.loss; };
  pool_.insert(std::upper_bound(pool_.begin(), pool_.end(), loss, above), {separation_.nearest(), loss});
  if (pool_.size() > kPool) pool_.pop_back();
}

using Island = IslandOf<PlaneKit>;
extern template class IslandOf<PlaneKit>;

}  // namespace findspace::packing
