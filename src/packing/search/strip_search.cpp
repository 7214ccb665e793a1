// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/strip_search.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <vector>

#include "packing/compaction/finish.h"
#include "packing/proof/verify.h"
#include "packing/search/filling.h"
#include "packing/search/island_team.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace {

constexpr std::uint64_t kRound = 10'000'000;  // pairs looked at: about a tenth of a second
constexpr double kFillingShare = 0.5;
constexpr std::array<double, 5> kLonger{1, 1.25, 1.5, 2, 4};  // strips for a first layout
constexpr Patience kFirstPatience{100, 2};

class Search {
 public:
  Search(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
         const std::atomic<bool>& stop)
      : problem_(problem),
        options_(options),
        events_(events),
        limits_(options.seconds, options.work, stop),
        table_(problem),
        row_(problem, table_, options.start != nullptr ? sheets_from(*options.start) : cheapest_sheets(problem)) {}

  std::optional<Layout> run() {
    FirstLayout first;
    if (options_.start == nullptr)
      first = first_layout(problem_, table_, row_);
    else
      first = start_layout();
    if (first.layout.poses.empty() && problem_.fixed.empty()) return std::nullopt;
    const bool is_free = !first.overlaps || separated(first.layout);
    if (!agree(first, is_free)) return std::nullopt;
    std::erase_if(first.left, [&](std::size_t part) { return table_.variants_of(part).empty(); });
    offer(first.layout);
    if (first.layout.poses.empty()) return std::move(best_);
    fill(first);
    if (options_.peers != nullptr && agree(first, true)) offer(first.layout);
    team_.settle(table_, row_, first.layout, options_.seed, std::max(1u, options_.threads), options_.peers);
    for (std::uint64_t work = work_ + kRound; !any_of(options_.peers, over()); work += kRound) round(work);
    return std::move(best_);
  }

 private:
  /// Those of the layout, then the others.
  std::vector<std::size_t> sheets_from(const Layout& start) const {
    std::vector<std::size_t> kinds = start.sheets, others = cheapest_sheets(problem_);
    for (const std::size_t kind : start.sheets)
      if (const auto known = std::find(others.begin(), others.end(), kind); known != others.end()) others.erase(known);
    kinds.insert(kinds.end(), others.begin(), others.end());
    return kinds;
  }

  FirstLayout start_layout() const {
    FirstLayout result;
    result.layout.length = row_.fixed_end();
    result.layout.poses = poses_of(problem_, table_, row_, *options_.start);
    for (const Pose& p : result.layout.poses)
      result.layout.length = std::max(result.layout.length, p.at.x + table_.variants()[p.variant].high.x);
    for (const LeftOut& out : options_.start->left_out)
      result.left.insert(result.left.end(), std::size_t(out.copies), out.part);
    return result;
  }

  /// All processes go on from the best of their layouts; false where none has one.
  bool agree(FirstLayout& layout, bool is_found) const {
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

  /// Moves parts until the conditions of pairs hold, in a strip as much longer as that needs.
  bool separated(DoubleLayout& layout) {
    Random random(options_.seed);
    Separation separation(table_, row_, layout.poses, kLonger.back() * layout.length, random);
    for (std::size_t tried = 0; !over(); ++tried) {
      const double length = kLonger[tried % kLonger.size()] * layout.length;
      separation.begin(tried == 0 ? layout.poses : separation.nearest(), length, kLonger.back() * layout.length);
      Separation::State state = Separation::State::kUnderWay;
      while (state == Separation::State::kUnderWay && !over()) {
        state = separation.pass(kFirstPatience);
        work_ = separation.work();
      }
      if (state != Separation::State::kFree) continue;
      layout = separation.free();
      return true;
    }
    return false;
  }

  /// Adds what was left out, or exchanges for it what is worth less.
  void fill(FirstLayout& layout) {
    const std::size_t threads = std::max(1u, options_.threads);
    std::uint64_t number = options_.seed * 7000003 + number_of(options_.peers) * 1000000007;
    while (!layout.left.empty() && !limits_.is_stopped() && limits_.progress(double(work_)) < kFillingShare &&
           (limits_.is_limited() || !over())) {
      std::vector<std::optional<FirstLayout>> tried(threads);
      std::vector<std::uint64_t> work(threads);
      plane::parallel_for(
          threads, [&](std::size_t k) { tried[k] = filled(table_, row_, values_, layout, number + k, work[k]); });
      number += threads;
      work_ += *std::max_element(work.begin(), work.end());
      const auto better = std::find_if(tried.begin(), tried.end(), [](const auto& t) { return t.has_value(); });
      if (better != tried.end()) {
        layout = std::move(**better);
        offer(layout.layout);
      }
    }
  }

  double seconds() const { return limits_.seconds(); }
  bool over() const { return limits_.is_over(double(work_), better_at_); }

  void round(std::uint64_t until) {
    const DoubleLayout& best = team_.round(until, limits_);
    work_ = until;
    if (best.length < offered_) offer(best);
    if (events_.progress) events_.progress(state());
  }

  void offer(const DoubleLayout& layout) {
    offered_ = layout.length;
    std::optional<Layout> proved = finished(problem_, table_, row_, layout.poses, layout.length);
    if (!proved && !best_ && !problem_.on_sheets()) proved = boxes();
    if (!proved || (best_ && !is_better(*proved, *best_))) return;
    best_ = std::move(proved);
    better_at_ = seconds();
    if (events_.better) events_.better(*best_, state());
  }

  std::optional<Layout> boxes() const {
    Layout layout = layout_of_boxes(problem_, table_);
    return verify(problem_, layout).feasible() ? std::optional(std::move(layout)) : std::nullopt;
  }

  /// More parts or more valuable ones; fewer sheets; a shorter strip or last sheet.
  bool is_better(const Layout& layout, const Layout& than) const {
    const double value = value_of(layout), other = value_of(than);
    if (value != other) return value > other;
    if (layout.sheets.size() != than.sheets.size()) return layout.sheets.size() < than.sheets.size();
    return layout.length < than.length;
  }

  double value_of(const Layout& layout) const {
    double sum = 0;
    for (const LeftOut& out : layout.left_out) sum -= out.copies * values_[out.part];
    return sum;
  }

  SearchState state() const {
    SearchState s;
    s.seconds = seconds();
    s.processor = double(std::clock()) / CLOCKS_PER_SEC;
    s.since_better = s.seconds - better_at_;
    if (best_) {
      s.length = best_->length.to_double();
      s.density = area(problem_, *best_) / container_area(problem_, *best_);
    }
    s.overlap = team_.overlap();
    return s;
  }

  const Problem& problem_;
  const SearchOptions& options_;
  const SearchEvents& events_;
  SearchLimits limits_;
  FieldTable table_;
  Row row_;
  std::vector<double> values_ = values_of(problem_);
  IslandTeam<PlaneKit> team_;
  std::optional<Layout> best_;
  double offered_ = 0, better_at_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace

std::optional<Layout> search_strip(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                   const std::atomic<bool>& stop) {
  if (problem.items() == 0) return std::nullopt;
  return Search(problem, options, events, stop).run();
}

}  // namespace findspace::packing
