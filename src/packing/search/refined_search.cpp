// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/search/refined_search.h"

#include <algorithm>
#include <ctime>
#include <utility>

#include "packing/search/island_peers.h"
#include "packing/search/island_team.h"
#include "packing/search/last_sheet.h"
#include "packing/search/tilting.h"

namespace findspace::packing {
namespace {

constexpr double kShare = 0.1;  // of the limits, for each refinement

class RefinedSearch {
 public:
  RefinedSearch(const Problem& problem, const SearchOptions& options, const SearchEvents& events, const StopWish& stop)
      : problem_(problem),
        options_(options),
        events_(events),
        stop_(stop),
        limits_(options.seconds, 0, stop),
        tilts_(may_tilt(problem)) {}

  std::optional<Layout> run() {
    SearchOptions first = of_share(1 - kShare * (tilts_ + problem_.on_sheets()));
    const Problem begun = options_.start != nullptr ? with_angles_of(problem_, *options_.start) : problem_;
    layout_ = search_strip(begun, first, events_, stop_);
    if (!layout_ || layout_->items.empty()) return layout_;
    if (tilts_) {
      const auto take = [&](const Layout& better) { offer(better); };
      tilted(problem_, *layout_, take, [&] { return any_of(options_.peers, limits_.is_out_of_time()); });
    }
    if (problem_.on_sheets() && !any_of(options_.peers, limits_.is_out_of_time()))
      if (auto better = with_larger_remnant(problem_, *layout_, of_last_sheet(), stop_)) offer(*std::move(better));
    return layout_;
  }

 private:
  SearchOptions of_share(double share) const {
    SearchOptions result = options_;
    result.seconds *= share;
    result.work *= share;
    return result;
  }

  /// Without limits as long as a tenth of the time so far.
  SearchOptions of_last_sheet() const {
    SearchOptions result = of_share(kShare);
    if (options_.seconds > 0)
      result.seconds = std::max(0.001, std::min(result.seconds, options_.seconds - limits_.seconds()));
    if (!limits_.is_limited() && options_.work <= 0) result.seconds = std::max(1.0, kShare * limits_.seconds());
    return result;
  }

  void offer(Layout better) {
    layout_ = std::move(better);
    if (!events_.better) return;
    PackProgress state;
    state.seconds = limits_.seconds();
    state.processor = double(std::clock()) / CLOCKS_PER_SEC;
    state.length = layout_->length.to_double();
    state.density = area(problem_, *layout_) / container_area(problem_, *layout_);
    events_.better(*layout_, state);
  }

  const Problem& problem_;
  const SearchOptions& options_;
  const SearchEvents& events_;
  const StopWish stop_;
  const SearchLimits limits_;
  const bool tilts_;
  std::optional<Layout> layout_;
};

}  // namespace

std::optional<Layout> search_refined(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                     const StopWish& stop) {
  if (!may_tilt(problem) && !problem.on_sheets()) return search_strip(problem, options, events, stop);
  return RefinedSearch(problem, options, events, stop).run();
}

}  // namespace findspace::packing
