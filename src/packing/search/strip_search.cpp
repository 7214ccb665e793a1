// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/search/strip_search.h"

#include "packing/compaction/finish.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/first_layout.h"
#include "packing/search/room_search.h"

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
  static std::optional<Fraction> least_length(const Problem& problem) {
    return problem.on_sheets() ? std::nullopt : std::optional(lower_bound(problem));
  }
  static bool has_containers(const Problem& problem) { return problem.on_sheets(); }
  static bool has_fixed(const Problem& problem) { return !problem.fixed.empty(); }
};

}  // namespace

std::optional<Layout> search_strip(const Problem& problem, const SearchOptions& options, const SearchEvents& events,
                                   const StopWish& stop) {
  if (problem.items() == 0) return std::nullopt;
  return RoomSearch<StripKit>(problem, options, events, stop).run();
}

}  // namespace findspace::packing
