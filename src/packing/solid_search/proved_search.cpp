// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/proved_search.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "packing/search/island_team.h"
#include "packing/solid_moves/solid_finish.h"
#include "packing/solid_proof/least_height.h"
#include "packing/solid_proof/solid_bound.h"

namespace findspace::packing {
namespace {

constexpr double kFirstShare = 0.1, kProofShare = 0.6;  // of the limits
constexpr double kFirstWork = 4e7;                      // of the first search at most: about a second
constexpr std::uint64_t kMostPrograms = 20'000'000;     // without limits: some minutes
constexpr double kWorkOfProgram = 500;                  // planes and boxes that take as long

/// The greatest decimal of nine digits that is not above the value.
Fraction rounded_down(double value) {
  constexpr double kDecimals = 1e9;
  return Fraction(int128(std::floor(std::nextafter(value, 0) * kDecimals)) - 1, int128(kDecimals));
}

class ProvedSearch {
 public:
  ProvedSearch(const SolidProblem& problem, const SolidSearchOptions& options, const SolidSearchEvents& events,
               const StopWish& stop)
      : problem_(problem),
        options_(options),
        events_(events),
        stop_(stop),
        limits_(options.seconds, 0, stop),
        bound_(lower_bound(problem)) {}

  std::optional<SolidLayout> run() {
    SolidSearchOptions first = of_share(kFirstShare);
    first.work = options_.work > 0 ? std::min(first.work, kFirstWork) : kFirstWork;
    search(first);
    if (!layout_) return found_late(first.work);
    if (is_done()) return layout_;
    const bool is_proved = prove();
    if (is_proved || is_done()) return layout_;
    SolidSearchOptions rest = of_share(1 - kFirstShare - kProofShare);
    set_seconds_left(rest);
    const SolidLayout start = *layout_;
    rest.start = &start;
    search(rest);
    return layout_;
  }

 private:
  bool is_unlimited() const { return options_.seconds <= 0 && options_.work <= 0; }
  bool is_done() const { return limits_.is_out_of_time() || layout_->height <= bound_; }

  /// Where conditions are hard to keep, all that is left goes into the search.
  std::optional<SolidLayout> found_late(double work) {
    if (limits_.is_out_of_time()) return layout_;
    SolidSearchOptions rest = options_;
    if (options_.work > 0) rest.work -= work;
    set_seconds_left(rest);
    search(rest);
    return layout_;
  }

  void set_seconds_left(SolidSearchOptions& options) const {
    if (options_.seconds > 0) options.seconds = std::max(0.001, options_.seconds - limits_.seconds());
  }

  SolidSearchOptions of_share(double share) const {
    SolidSearchOptions result = options_;
    result.seconds *= share;
    result.work *= share;
    return result;
  }

  /// Times count from the beginning of the whole.
  void search(const SolidSearchOptions& options) {
    const double before = limits_.seconds();
    const auto since_begin = [&](PackProgress state) {
      state.seconds += before;
      return state;
    };
    SolidSearchEvents events;
    events.better = [&](const SolidLayout& layout, const PackProgress& state) {
      if (!layout_ || layout.height < layout_->height) take(layout, since_begin(state));
    };
    if (events_.progress) events.progress = [&](const PackProgress& state) { events_.progress(since_begin(state)); };
    std::optional<SolidLayout> found = search_solids(problem_, options, events, stop_);
    if (!layout_) layout_ = std::move(found);
  }

  void take(SolidLayout layout, const PackProgress& state) {
    layout.lower_bound = bound_;
    layout_ = std::move(layout);
    if (events_.better) events_.better(*layout_, state);
  }

  bool may_go_on(const LeastHeight& proof) const {
    const auto programs = proof.programs();
    if (limits_.is_out_of_time() || (is_unlimited() && programs > kMostPrograms)) return false;
    if (options_.seconds > 0 && limits_.seconds() > (kFirstShare + kProofShare) * options_.seconds) return false;
    return options_.work <= 0 || kWorkOfProgram * double(programs) < kProofShare * options_.work;
  }

  /// Whether no layout is lower. Where gaps or conditions are not part of the proof it may end without that.
  bool prove() {
    const SolidTable table(problem_);
    const SolidColumn column(problem_, table, {});
    LeastHeight proof(problem_, table, layout_->height.to_double());
    while (!proof.is_over() && may_go_on(proof)) {
      if (std::optional<std::vector<SolidPose>> poses = proof.search()) {
        offer(finished(problem_, table, column, *poses, top_of(table, *poses)));
        proof.set_height(layout_->height.to_double());
      }
      if (events_.progress) events_.progress(state());
    }
    bound_ = std::max(bound_, rounded_down(proof.bound()));
    layout_->lower_bound = bound_;
    return proof.is_proved();
  }

  static double top_of(const SolidTable& table, const std::vector<SolidPose>& poses) {
    double result = 0;
    for (const SolidPose& pose : poses) result = std::max(result, pose.at.z + table.variants()[pose.variant].high.z);
    return result;
  }

  void offer(std::optional<SolidLayout> better) {
    if (!better || !(better->height < layout_->height)) return;
    const PackProgress reached = state(better->height);
    take(*std::move(better), reached);
  }

  PackProgress state() const { return state(layout_->height); }
  PackProgress state(const Fraction& height) const {
    PackProgress result;
    result.seconds = limits_.seconds();
    result.processor = double(std::clock()) / CLOCKS_PER_SEC;
    result.length = height.to_double();
    result.density = volume(problem_) / (result.length * problem_.width.to_double() * problem_.depth.to_double());
    return result;
  }

  const SolidProblem& problem_;
  const SolidSearchOptions& options_;
  const SolidSearchEvents& events_;
  const StopWish stop_;
  const SearchLimits limits_;
  Fraction bound_;
  std::optional<SolidLayout> layout_;
};

}  // namespace

std::optional<SolidLayout> search_solids_to_proof(const SolidProblem& problem, const SolidSearchOptions& options,
                                                  const SolidSearchEvents& events, const StopWish& stop) {
  if (options.peers != nullptr || problem.items() == 0 || !is_provable(problem, SolidTable(problem)))
    return search_solids(problem, options, events, stop);
  return ProvedSearch(problem, options, events, stop).run();
}

}  // namespace findspace::packing
