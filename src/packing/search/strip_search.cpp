// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/strip_search.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <memory>
#include <vector>

#include "packing/compaction/finish.h"
#include "packing/proof/verify.h"
#include "packing/search/first_layout.h"
#include "packing/search/island.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace {

constexpr std::uint64_t kRound = 10'000'000;  // pairs looked at: about a tenth of a second
constexpr double kLeastPatience = 30;         // seconds without a better layout, and
constexpr double kPatience = 0.5;             // of the time so far: then a search without limits ends

class Search {
 public:
  Search(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
         const std::atomic<bool>& stop)
      : problem_(problem), options_(options), events_(events), stop_(stop), table_(problem), area_(area(problem)) {}

  std::optional<Layout> run() {
    DoubleLayout start = options_.start == nullptr
                             ? first_layout(problem_, table_)
                             : DoubleLayout{poses_of(problem_, table_, *options_.start),
                                            (options_.start->length - problem_.edge - problem_.edge).to_double()};
    offer(start);
    for (unsigned t = 0; t < std::max(1u, options_.threads); ++t)
      islands_.push_back(std::make_unique<Island>(table_, start, options_.seed * 1000003 + t));
    for (std::uint64_t work = kRound; !over(); work += kRound) round(work);
    return std::move(best_);
  }

 private:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

  double progress(double work) const {
    const double by_time = options_.seconds > 0 ? seconds() / options_.seconds : 0;
    const double by_work = options_.work > 0 ? work / options_.work : 0;
    return std::max(by_time, by_work);
  }

  bool over() const {
    if (stop_) return true;
    if (options_.seconds > 0 || options_.work > 0) return progress(double(work_)) >= 1;
    return seconds() - better_at_ > kLeastPatience + kPatience * better_at_;
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
    std::optional<Layout> proved = finished(problem_, table_, layout.poses, layout.length);
    if (!proved && !best_) proved = layout_of_boxes(problem_, table_);
    if (!proved || (best_ && best_->length <= proved->length)) return;
    best_ = std::move(proved);
    better_at_ = seconds();
    if (events_.better) events_.better(*best_, state());
  }

  SearchState state() const {
    SearchState s;
    s.seconds = seconds();
    s.processor = double(std::clock()) / CLOCKS_PER_SEC;
    s.since_better = s.seconds - better_at_;
    if (best_) {
      s.length = best_->length.to_double();
      s.density = area_ / (s.length * table_.height());
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
  double area_;
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
