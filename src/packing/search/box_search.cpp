// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/box_search.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "packing/proof/verify.h"
#include "packing/search/island_peers.h"
#include "packing/search/refined_search.h"

namespace findspace::packing {
namespace {

constexpr double kUsualSeconds = 30, kUsualDensity = 0.7;
constexpr double kAspects[] = {0.4, 0.55, 0.7, 0.85, 1, 1.2, 1.45, 1.8, 2.5};
constexpr double kBesides[] = {0.94, 0.97, 1.03, 1.06};

class BoxSearch {
 public:
  BoxSearch(const Problem& problem, const SearchOptions& options, const SearchEvents& events, const StopWish& stop)
      : problem_(problem),
        options_(options),
        start_(std::exchange(options_.start, nullptr)),
        events_(events),
        stop_(stop) {
    if (options_.seconds <= 0 && options_.work <= 0) options_.seconds = kUsualSeconds;
  }

  std::optional<Layout> run() {
    if (start_ != nullptr) offer_start();
    const double side = std::sqrt(area(problem_) / kUsualDensity);
    for (const double aspect : kAspects) try_height(on_grid(aspect * side), 0.5 / std::size(kAspects));
    if (!best_) return std::nullopt;
    const double near = best_->height.to_double();
    for (const double besides : kBesides) try_height(on_grid(besides * near), 0.25 / std::size(kBesides));
    try_height(best_->height, 0.25);
    return std::move(best_);
  }

 private:
  Fraction on_grid(double height) const {
    const Fraction wanted(int128(std::ceil(height * double(problem_.steps()))), problem_.steps());
    return std::max(wanted, least_height());
  }

  /// At which every part has an angle that fits.
  Fraction least_height() const {
    int128 least = 0;
    for (const Part& part : problem_.parts) {
      if (part.demand == 0) continue;
      int128 lowest = -1;
      for (const Fraction& angle : part.angles) {
        const LatticeBox box = box_of(part, angle, false);
        if (lowest < 0 || box.high.y - box.low.y < lowest) lowest = box.high.y - box.low.y;
      }
      least = std::max(least, lowest);
    }
    return Fraction(least, problem_.steps()) + problem_.edge + problem_.edge;
  }

  void try_height(const Fraction& height, double share) {
    if (any_of(options_.peers, stop_) && best_) return;
    Problem strip = problem_;
    strip.box = false;
    strip.height = height;
    SearchOptions options = options_;
    options.seconds *= share;
    options.work *= share;
    SearchEvents events;
    events.progress = events_.progress;
    events.better = [&](const Layout& layout, const PackProgress& state) { offer(layout, state); };
    search_refined(strip, options, events, stop_);
  }

  /// Where it is feasible and has all parts.
  void offer_start() {
    const Verdict verdict = verify(problem_, *start_);
    if (!verdict.feasible() || start_->items.size() < problem_.items()) return;
    Layout layout = *start_;
    layout.length = std::min(layout.length, verdict.used + problem_.edge);
    PackProgress state;
    state.length = layout.length.to_double();
    offer(std::move(layout), state);
  }

  /// The box ends where its parts end.
  void offer(Layout layout, const PackProgress& state) {
    layout.height = top_of(problem_, layout);
    if (best_ && container_area(problem_, layout) >= container_area(problem_, *best_)) return;
    best_ = std::move(layout);
    PackProgress of_box = state;
    of_box.density = area(problem_) / container_area(problem_, *best_);
    if (events_.better) events_.better(*best_, of_box);
  }

  const Problem& problem_;
  SearchOptions options_;
  const Layout* const start_;
  const SearchEvents& events_;
  const StopWish stop_;
  std::optional<Layout> best_;
};

}  // namespace

std::optional<Layout> search_box(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                 const StopWish& stop) {
  if (problem.items() == 0) return std::nullopt;
  return BoxSearch(problem, options, events, stop).run();
}

}  // namespace findspace::packing
