// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/solid_search.h"

#include <algorithm>
#include <ctime>

#include "packing/solid_moves/solid_finish.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_search/solid_first_layout.h"
#include "packing/solid_search/solid_kit.h"

namespace findspace::packing {
namespace {

constexpr std::uint64_t kSolidRound = 4'000'000;  // boxes and planes looked at: about a tenth of a second
constexpr std::size_t kIslands = 2;

class SolidSearch {
 public:
  SolidSearch(const SolidProblem& problem, const SolidSearchOptions& options, const SolidSearchEvents& events,
              const std::atomic<bool>& stop)
      : problem_(problem),
        options_(options),
        events_(events),
        limits_(options.seconds, options.work, stop),
        table_(problem),
        column_(table_),
        bound_(lower_bound(problem)) {}

  std::optional<SolidLayout> run() {
    LayoutInDoubles<SolidPose> first;
    if (options_.start == nullptr) {
      first = first_layout(problem_, table_, options_.seed);
    } else {
      first = {poses_of(table_, *options_.start), (options_.start->height - problem_.edge - problem_.edge).to_double()};
    }
    offer(first);
    if (!best_) keep(tower_of(problem_, table_));
    team_.settle(table_, column_, first, options_.seed, kIslands, options_.peers);
    for (std::uint64_t work = kSolidRound; !any_of(options_.peers, is_over()); work += kSolidRound) round(work);
    return std::move(best_);
  }

 private:
  bool is_over() const { return best_->height <= bound_ || limits_.is_over(double(work_), better_at_); }

  void round(std::uint64_t until) {
    const LayoutInDoubles<SolidPose>& best = team_.round(until, limits_);
    work_ = until;
    if (best.length < offered_) offer(best);
    if (events_.progress) events_.progress(state());
  }

  void offer(const LayoutInDoubles<SolidPose>& layout) {
    offered_ = layout.length;
    if (std::optional<SolidLayout> proved = finished(problem_, table_, layout.poses, layout.length))
      if (!best_ || proved->height < best_->height) keep(std::move(*proved));
  }

  void keep(SolidLayout layout) {
    best_ = std::move(layout);
    better_at_ = limits_.seconds();
    if (events_.better) events_.better(*best_, state());
  }

  SearchState state() const {
    SearchState s;
    s.seconds = limits_.seconds();
    s.processor = double(std::clock()) / CLOCKS_PER_SEC;
    s.since_better = s.seconds - better_at_;
    s.length = best_->height.to_double();
    s.density = volume_ / (problem_.width.to_double() * problem_.depth.to_double() * s.length);
    s.overlap = team_.overlap();
    return s;
  }

  const SolidProblem& problem_;
  const SolidSearchOptions& options_;
  const SolidSearchEvents& events_;
  SearchLimits limits_;
  SolidTable table_;
  SolidColumn column_;
  Fraction bound_;
  double volume_ = volume(problem_);
  IslandTeam<SolidKit> team_;
  std::optional<SolidLayout> best_;
  double offered_ = 0, better_at_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace

std::optional<SolidLayout> search_solids(const SolidProblem& problem, const SolidSearchOptions& options,
                                         const SolidSearchEvents& events, const std::atomic<bool>& stop) {
  if (problem.items() == 0) return std::nullopt;
  return SolidSearch(problem, options, events, stop).run();
}

}  // namespace findspace::packing
