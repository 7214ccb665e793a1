// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/strip_search.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <limits>
#include <memory>
#include <vector>

#include "packing/compaction/finish.h"
#include "packing/proof/verify.h"
#include "packing/search/filling.h"
#include "packing/search/island.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace {

constexpr std::uint64_t kRound = 10'000'000;  // pairs looked at: about a tenth of a second
constexpr double kLeastWaiting = 30;          // seconds without a better layout, and
constexpr double kFillingShare = 0.5;
constexpr std::array<double, 5> kLonger{1, 1.25, 1.5, 2, 4};  // strips for a first layout
constexpr Patience kFirstPatience{100, 2};
constexpr double kWaiting = 0.5;  // of the time so far: then a search without limits ends

class Search {
 public:
  Search(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
         const std::atomic<bool>& stop)
      : problem_(problem),
        options_(options),
        events_(events),
        stop_(stop),
        table_(problem),
        row_(problem, table_, options.start != nullptr ? sheets_from(*options.start) : cheapest_sheets(problem)) {}

  std::optional<Layout> run() {
    FirstLayout first;
    if (options_.start == nullptr)
      first = first_layout(problem_, table_, row_);
    else
      first = start_layout();
    if (first.layout.poses.empty() && problem_.fixed.empty()) return std::nullopt;
    if (first.overlaps && !separated(first.layout)) return std::nullopt;
    std::erase_if(first.left, [&](std::size_t part) { return table_.variants_of(part).empty(); });
    offer(first.layout);
    if (first.layout.poses.empty()) return std::move(best_);
    fill(first);
    for (unsigned t = 0; t < std::max(1u, options_.threads); ++t)
      islands_.push_back(std::make_unique<Island>(table_, row_, first.layout, options_.seed * 1000003 + t));
    for (std::uint64_t work = work_ + kRound; !over(); work += kRound) round(work);
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
    std::uint64_t number = options_.seed * 7000003;
    while (!layout.left.empty() && !stop_ && progress(double(work_)) < kFillingShare && (limited() || !over())) {
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

  bool limited() const { return options_.seconds > 0 || options_.work > 0; }

  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  double progress(double work) const {
    const double by_time = options_.seconds > 0 ? seconds() / options_.seconds : 0;
    const double by_work = options_.work > 0 ? work / options_.work : 0;
    return std::max(by_time, by_work);
  }

  bool over() const {
    if (stop_) return true;
    if (limited()) return progress(double(work_)) >= 1;
    return seconds() - better_at_ > kLeastWaiting + kWaiting * better_at_;
  }

  /// All islands do the same work; time and a wish to stop end it anywhere.
  void round(std::uint64_t until) {
    plane::parallel_for(islands_.size(), [&](std::size_t k) {
      Island& island = *islands_[k];
      while (island.work() < until && !stop_ && (options_.seconds <= 0 || seconds() < options_.seconds))
        island.step(progress(double(island.work())));
    });
    work_ = until;
    exchange();
    if (events_.progress) events_.progress(state());
  }

  void exchange() {
    const auto shorter = [](const auto& a, const auto& b) { return a->best().length < b->best().length; };
    const DoubleLayout best = (*std::min_element(islands_.begin(), islands_.end(), shorter))->best();
    for (const auto& island : islands_)
      if (island->best().length > best.length) island->adopt(best);
    if (best.length < offered_) offer(best);
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
      s.density = area(problem_, *best_) / room(problem_, *best_);
    }
    s.overlap = std::numeric_limits<double>::infinity();
    for (const auto& island : islands_) s.overlap = std::min(s.overlap, island->overlap());
    return s;
  }

  const Problem& problem_;
  const SearchOptions& options_;
  const SearchEvents& events_;
  const std::atomic<bool>& stop_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  FieldTable table_;
  Row row_;
  std::vector<double> values_ = values_of(problem_);
  std::vector<std::unique_ptr<Island>> islands_;
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
