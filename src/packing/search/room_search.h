// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The search for a short strip, or for few containers, on several islands. Containers are a strip with walls (rooms.h).
// Where they cannot hold all parts, it first seeks a more valuable choice of parts, for half of the work. After rounds
// of the same work the islands meet, and those far behind go on from the best layout. Every better layout is
// proved and given away at once. A layout to start with that is not feasible is separated first, or given up.
// Guarantee: layouts given are feasible, exactly; what is not in them is left out with a reason. With a limit of work
// alone the result depends on the seed and the number of islands only; a limit of time only ends the search. Other
// processes may take part; all of them give the same layouts. Cost: as long as allowed. Keywords: strip packing, bin
// packing, knapsack.
//
// The kit has the type Core, which is the kit of the islands, Problem, Layout and kRound. Its functions make a first
// layout, poses of a layout and a proved layout of poses, which may drop some of them (finished). They tell what a
// layout uses and what the problem has: containers, values, a least length.
#pragma once

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "packing/search/filling.h"
#include "packing/search/island_team.h"
#include "packing/search/search_options.h"
#include "plane/base/parallel.h"

namespace findspace::packing {

inline constexpr double kFillingShare = 0.5;
inline constexpr std::array<double, 5> kLonger{1, 1.25, 1.5, 2, 4};  // strips for a first layout
inline constexpr Patience kFirstPatience{100, 2};

template <class Kit>
class RoomSearch {
 public:
  using Core = typename Kit::Core;
  using Problem = typename Kit::Problem;
  using Layout = typename Kit::Layout;
  using Pose = typename Core::Pose;
  using Found = LayoutInDoubles<Pose>;
  using First = FirstLayoutOf<Pose>;

  /// All must live as long.
  RoomSearch(const Problem& problem, const SearchOptionsOf<Layout>& options, const SearchEventsOf<Layout>& events,
             const StopWish& stop)
      : problem_(problem),
        options_(options),
        events_(events),
        limits_(options.seconds, options.work, stop),
        table_(problem),
        row_(problem, table_, options.start != nullptr ? containers_from(*options.start) : Kit::cheapest(problem)) {}

  /// Nothing where no part fits a container, or no layout was found in which all conditions hold. A layout without
  /// items where parts would fit, and no place was found for any.
  std::optional<Layout> run() {
    First first;
    const bool is_found = find_first(first);
    if (!agree(first, is_found)) return std::nullopt;
    std::erase_if(first.left, [&](std::size_t part) { return table_.variants_of(part).empty(); });
    if (!first.layout.poses.empty() || Kit::has_fixed(problem_)) offer_first(first);
    fill(first);
    std::vector<Pose>& poses = first.layout.poses;
    if (options_.peers != nullptr && agree(first, true) && !poses.empty()) offer(first.layout);
    if (poses.empty() && !best_ && !first.left.empty()) return Kit::finished(problem_, table_, row_, poses, 0);
    if (poses.empty()) return std::move(best_);
    team_.settle(table_, row_, first.layout, options_.seed, Kit::islands(options_.threads), options_.peers);
    for (std::uint64_t work = work_ + Kit::kRound; !any_of(options_.peers, is_over()); work += Kit::kRound) round(work);
    return std::move(best_);
  }

 private:
  /// Those of the layout, then the others.
  std::vector<std::size_t> containers_from(const Layout& start) const {
    std::vector<std::size_t> kinds = Kit::containers(start), others = Kit::cheapest(problem_);
    for (const std::size_t kind : Kit::containers(start))
      if (const auto known = std::find(others.begin(), others.end(), kind); known != others.end()) others.erase(known);
    kinds.insert(kinds.end(), others.begin(), others.end());
    return kinds;
  }

  /// The layout to start with where it is free, or becomes so; else a new one. False where that is not free.
  bool find_first(First& first) {
    if (options_.start != nullptr) {
      first = start_layout();
      if (!first.overlaps || separated(first.layout, kLonger.size(), kFirstPatience.passes)) return true;
    }
    first = Kit::first_layout(problem_, table_, row_, options_.seed);
    return !first.overlaps || separated(first.layout, std::numeric_limits<std::size_t>::max(), Core::kFirstPasses);
  }

  /// It overlaps where it cannot be proved. On a strip nothing is left out.
  First start_layout() const {
    First result;
    result.layout.length = row_.fixed_end();
    std::vector<Pose>& poses = result.layout.poses;
    poses = Kit::poses_of(problem_, table_, row_, *options_.start);
    for (const LeftOut& out : options_.start->left_out)
      if (Kit::has_containers(problem_))
        result.left.insert(result.left.end(), std::size_t(out.copies), out.part);
      else if (out.copies > 0)
        poses.insert(poses.end(), std::size_t(out.copies), Pose{table_.variants_of(out.part)[0], {}});
    for (const Pose& p : poses)
      result.layout.length = std::max(result.layout.length, along(p.at) + along(table_.variants()[p.variant].high));
    std::vector<Pose> proved = poses;
    result.overlaps = !Kit::finished(problem_, table_, row_, proved, result.layout.length);
    return result;
  }

  /// All processes go on from the best of their layouts; false where none has one.
  bool agree(First& layout, bool is_found) const {
    if (options_.peers == nullptr) return is_found;
    double missing = 0;
    for (const std::size_t part : layout.left) missing += values_[part];
    const double cost[] = {is_found ? 0.0 : 1.0, missing, layout.layout.length};
    plane::ByteWriter own;
    own.put(std::int8_t(is_found));
    put_layout(layout.layout, own);
    own.put_all(std::span<const std::size_t>(layout.left));
    const std::string best = options_.peers->best_of(cost, std::move(own).take());
    plane::ByteReader in(best);
    const bool found = in.take<std::int8_t>() != 0;
    layout.layout = take_layout<Pose>(in);
    layout.left = in.take_all<std::size_t>();
    return found;
  }

  /// Moves parts until none overlap and the conditions of pairs hold, in a strip as much longer as that needs. So many
  /// passes without progress end a try; twice as many after each round of the lengths, up to the usual patience.
  bool separated(Found& layout, std::size_t most, int passes) {
    Random random(options_.seed);
    SeparationOf<Core> separation(table_, row_, layout.poses, kLonger.back() * layout.length, random);
    using State = typename SeparationOf<Core>::State;
    for (std::size_t tried = 0; tried < most && !is_over(); ++tried) {
      const double length = kLonger[tried % kLonger.size()] * layout.length;
      separation.begin(tried == 0 ? layout.poses : separation.nearest(), length, kLonger.back() * layout.length);
      if (tried > 0 && tried % kLonger.size() == 0) passes = std::min(2 * passes, kFirstPatience.passes);
      const Patience patience = passes < kFirstPatience.passes ? Patience{passes, 0} : kFirstPatience;
      State state = State::kUnderWay;
      while (state == State::kUnderWay && !is_over()) {
        state = separation.pass(patience);
        work_ = separation.work();
      }
      if (state != State::kFree) continue;
      layout = separation.free();
      return true;
    }
    return false;
  }

  /// Adds what was left out, or exchanges for it what is worth less.
  void fill(First& layout) {
    const std::size_t islands = Kit::islands(options_.threads);
    std::uint64_t number = options_.seed * 7000003 + number_of(options_.peers) * 1000000007;
    while (!layout.left.empty() && !limits_.is_stopped() && limits_.progress(double(work_)) < kFillingShare) {
      std::vector<std::optional<First>> tried(islands);
      std::vector<std::uint64_t> work(islands);
      plane::parallel_for(
          islands, [&](std::size_t k) { tried[k] = filled<Core>(table_, row_, values_, layout, number + k, work[k]); });
      number += islands;
      work_ += *std::max_element(work.begin(), work.end());
      const auto better = std::find_if(tried.begin(), tried.end(), [](const auto& t) { return t.has_value(); });
      if (better != tried.end()) {
        layout = std::move(**better);
        offer(layout.layout);
      }
    }
  }

  bool is_over() const {
    if (bound_ && best_ && best_->left_out.empty() && Kit::length(*best_) <= *bound_) return true;
    return limits_.is_over(double(work_));
  }

  void round(std::uint64_t until) {
    const Found& best = team_.round(until, limits_);
    work_ = until;
    if (best.length < offered_) offer(best);
    if (events_.progress) events_.progress(state());
  }

  /// What cannot be proved in it is left, so that it is added anew.
  void offer_first(First& first) {
    std::vector<Pose> kept = offer(first.layout);
    if (kept.size() == first.layout.poses.size()) return;
    std::vector<std::size_t> missing(problem_.parts.size());
    for (const Pose& p : first.layout.poses) ++missing[Core::part_of(table_, p)];
    for (const Pose& p : kept) --missing[Core::part_of(table_, p)];
    for (std::size_t part = 0; part < missing.size(); ++part) first.left.insert(first.left.end(), missing[part], part);
    first.layout.poses = std::move(kept);
  }

  /// What of it is proved.
  std::vector<Pose> offer(const Found& layout) {
    std::vector<Pose> poses = layout.poses;
    offered_ = layout.length;
    std::optional<Layout> proved = Kit::finished(problem_, table_, row_, poses, layout.length);
    if (!proved && !best_ && !Kit::has_containers(problem_)) proved = safe_layout();
    if (!proved || (best_ && !is_better(*proved, *best_))) return poses;
    best_ = std::move(proved);
    limits_.note_better();
    if (events_.better) events_.better(*best_, state());
    return poses;
  }

  std::optional<Layout> safe_layout() const {
    Layout layout = Kit::safe_layout(problem_, table_);
    return Kit::is_feasible(problem_, layout) ? std::optional(std::move(layout)) : std::nullopt;
  }

  /// More parts or more valuable ones; fewer containers; a shorter strip or last container.
  bool is_better(const Layout& layout, const Layout& than) const {
    const double value = value_of(layout), other = value_of(than);
    if (value != other) return value > other;
    const std::size_t used = Kit::containers(layout).size(), before = Kit::containers(than).size();
    return used != before ? used < before : Kit::length(layout) < Kit::length(than);
  }

  double value_of(const Layout& layout) const {
    double sum = 0;
    for (const LeftOut& out : layout.left_out) sum -= out.copies * values_[out.part];
    return sum;
  }

  PackProgress state() const {
    PackProgress s;
    s.seconds = limits_.seconds();
    s.processor = double(std::clock()) / CLOCKS_PER_SEC;
    s.since_better = s.seconds - limits_.better_at();
    if (best_) {
      s.length = Kit::length(*best_).to_double();
      s.density = Kit::density(problem_, *best_);
    }
    s.overlap = team_.overlap();
    return s;
  }

  const Problem& problem_;
  const SearchOptionsOf<Layout>& options_;
  const SearchEventsOf<Layout>& events_;
  SearchLimits limits_;
  typename Core::Table table_;
  typename Core::Row row_;
  std::vector<double> values_ = Kit::values_of(problem_);
  std::optional<Fraction> bound_ = Kit::least_length(problem_);
  IslandTeam<Core> team_;
  std::optional<Layout> best_;
  double offered_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace findspace::packing
