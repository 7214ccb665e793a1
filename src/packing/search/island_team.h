// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Islands that search side by side, and the limits of a search. After rounds of the same work they meet, and those that
// are far behind go on from the best layout. Those that are near it keep their own, which may lead to a better one;
// when exploration is over all take the best. Islands of other processes take part where there are some. Guarantee:
// without a limit of time the result depends on the seed and the number of islands only. Keywords: island model,
// parallel search.
#pragma once

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "packing/search/island.h"
#include "packing/search/island_peers.h"
#include "packing/search/stop_wish.h"
#include "plane/base/bytes.h"
#include "plane/base/parallel.h"

namespace findspace::packing {

/// When a search is over. Times are in seconds, work is that of an island.
class SearchLimits {
 public:
  /// 0: no limit. `stop` must live as long.
  SearchLimits(double seconds, double work, const StopWish& stop)
      : most_seconds_(seconds), most_work_(work), stop_(stop) {}

  bool is_limited() const { return most_seconds_ > 0 || most_work_ > 0; }
  bool is_stopped() const { return stop_; }
  bool is_out_of_time() const { return stop_ || (most_seconds_ > 0 && seconds() >= most_seconds_); }
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
  /// A better layout has come: without limits the waiting for the next one begins.
  void note_better() { better_at_ = seconds(); }
  double better_at() const { return better_at_; }
  /// How much of the search is over, from 0 to 1. Without limits: how much of the waiting for a better layout.
  double progress(double work) const {
    if (!is_limited()) return (seconds() - better_at_) / (kLeastWaiting + kWaiting * better_at_);
    return std::max(most_seconds_ > 0 ? seconds() / most_seconds_ : 0, most_work_ > 0 ? work / most_work_ : 0);
  }
  bool is_over(double work) const { return stop_ || progress(work) >= 1; }

 private:
  static constexpr double kLeastWaiting = 30;
  static constexpr double kWaiting = 0.5;  // of the time so far

  double most_seconds_, most_work_, better_at_ = 0;
  const StopWish stop_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A layout as bytes for another process, and back.
template <class Pose>
void put_layout(const LayoutInDoubles<Pose>& layout, plane::ByteWriter& out) {
  out.put(layout.length);
  out.put(std::uint64_t(layout.poses.size()));
  for (const Pose& p : layout.poses) {
    out.put(p.variant);
    for (const double c : coordinates(p.at)) out.put(c);
  }
}

template <class Pose>
LayoutInDoubles<Pose> take_layout(plane::ByteReader& in) {
  LayoutInDoubles<Pose> layout;
  layout.length = in.take<double>();
  for (std::uint64_t n = in.take_count(sizeof(double)); n > 0; --n) {
    const auto variant = in.take<std::size_t>();
    Coordinates<decltype(Pose::at)> at{};
    for (double& c : at) c = in.take<double>();
    layout.poses.push_back({variant, std::bit_cast<decltype(Pose::at)>(at)});
  }
  return layout;
}

template <class Kit>
class IslandTeam {
 public:
  using Found = typename IslandOf<Kit>::Found;

  /// The table and the row must live as long; so must the other processes, which have as many islands each.
  void settle(const typename Kit::Table& table, const typename Kit::Row& row, const Found& start, std::uint64_t seed,
              std::size_t count, PackPeers* peers) {
    peers_ = peers;
    const std::uint64_t first = seed * 1000003 + number_of(peers) * count;
    for (std::size_t k = 0; k < count; ++k)
      islands_.push_back(std::make_unique<IslandOf<Kit>>(table, row, start, first + k));
    best_ = start;
  }

  /// All islands work up to the same amount; time and a wish to stop end it anywhere. The best layout, which those that
  /// are far behind go on from.
  const Found& round(std::uint64_t until, const SearchLimits& limits) {
    plane::parallel_for(islands_.size(), [&](std::size_t k) {
      IslandOf<Kit>& island = *islands_[k];
      while (island.work() < until && !limits.is_out_of_time()) island.step(limits.progress(double(island.work())));
    });
    const auto shorter = [](const auto& a, const auto& b) { return a->best().length < b->best().length; };
    best_ = (*std::min_element(islands_.begin(), islands_.end(), shorter))->best();
    if (peers_ != nullptr) exchange();
    const double apart = limits.progress(double(until)) < Kit::kExploration ? Kit::kApart : 0;
    for (const auto& island : islands_)
      if (island->best().length > (1 + apart) * best_.length) island->adopt(best_);
    return best_;
  }

  /// Left in the separations under way.
  double overlap() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& island : islands_) least = std::min(least, island->overlap());
    return least;
  }

 private:
  void exchange() {
    plane::ByteWriter own;
    put_layout(best_, own);
    const double cost[] = {best_.length};
    const std::string best = peers_->best_of(cost, std::move(own).take());
    plane::ByteReader in(best);
    best_ = take_layout<typename Kit::Pose>(in);
  }

  PackPeers* peers_ = nullptr;
  std::vector<std::unique_ptr<IslandOf<Kit>>> islands_;
  Found best_;
};

}  // namespace findspace::packing
