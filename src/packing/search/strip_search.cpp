// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/search/strip_search.h"

#include "packing/compaction/finish.h"
#include "packing/proof/verify.h"
#include "packing/search/first_layout.h"
#include "packing/search/room_search.h"
#include "packing/search/tilting.h"

namespace findspace::packing {
namespace {

struct StripKit {
  using Core = PlaneKit;
  using Problem = packing::Problem;
  using Layout = packing::Layout;

  static constexpr std::uint64_t kRound = 10'000'000;  // pairs looked at: about a tenth of a second

  static std::size_t islands(unsigned threads) { return std::max(1u, threads); }
  static FirstLayout first_layout(const Problem& problem, const FieldTable& table, const packing::Row& row,
                                  std::uint64_t) {
    return packing::first_layout(problem, table, row);
  }
  static std::vector<double> values_of(const Problem& problem) { return packing::values_of(problem); }
  static std::vector<Pose> poses_of(const Problem& problem, const FieldTable& table, const packing::Row& row,
                                    const Layout& layout) {
    return packing::poses_of(problem, table, row, layout);
  }
  static std::optional<Layout> finished(const Problem& problem, const FieldTable& table, const packing::Row& row,
                                        std::vector<Pose>& poses, double length) {
    return packing::finished(problem, table, row, poses, length);
  }
  static Layout safe_layout(const Problem& problem, const FieldTable& table) { return layout_of_boxes(problem, table); }
  static bool is_feasible(const Problem& problem, const Layout& layout) { return verify(problem, layout).feasible(); }
  static std::vector<std::size_t> cheapest(const Problem& problem) { return cheapest_sheets(problem); }
  static const std::vector<std::size_t>& containers(const Layout& layout) { return layout.sheets; }
  static const Fraction& length(const Layout& layout) { return layout.length; }
  static double density(const Problem& problem, const Layout& layout) {
    return area(problem, layout) / container_area(problem, layout);
  }
  /// The search goes on where it is reached.
  static std::optional<Fraction> least_length(const Problem&) { return std::nullopt; }
  static bool has_containers(const Problem& problem) { return problem.on_sheets(); }
  static bool has_fixed(const Problem& problem) { return !problem.fixed.empty(); }
};

constexpr double kTiltShare = 0.1;  // of the time

/// A search, then tilts of its layout.
class SearchAndTilt {
 public:
  SearchAndTilt(const SearchOptions& options, const SearchEvents& events, const std::atomic<bool>& stop)
      : options_(options), events_(events), limits_(options.seconds, 0, stop) {}

  std::optional<Layout> run(const Problem& problem, const std::atomic<bool>& stop) {
    SearchOptions options = options_;
    options.seconds *= 1 - kTiltShare;
    const Problem begun = options_.start != nullptr ? with_angles_of(problem, *options_.start) : problem;
    std::optional<Layout> layout = RoomSearch<StripKit>(begun, options, events_, stop).run();
    if (!layout) return layout;
    return tilted(
        problem, *std::move(layout), [&](const Layout& better) { tell(problem, better); },
        [&] { return any_of(options_.peers, limits_.is_out_of_time()); });
  }

 private:
  void tell(const Problem& problem, const Layout& layout) const {
    if (!events_.better) return;
    SearchState state;
    state.seconds = limits_.seconds();
    state.processor = double(std::clock()) / CLOCKS_PER_SEC;
    state.length = layout.length.to_double();
    state.density = StripKit::density(problem, layout);
    events_.better(layout, state);
  }

  const SearchOptions& options_;
  const SearchEvents& events_;
  const SearchLimits limits_;
};

}  // namespace

std::optional<Layout> search_strip(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                   const std::atomic<bool>& stop) {
  if (problem.items() == 0) return std::nullopt;
  if (may_tilt(problem)) return SearchAndTilt(options, events, stop).run(problem, stop);
  return RoomSearch<StripKit>(problem, options, events, stop).run();
}

}  // namespace findspace::packing
