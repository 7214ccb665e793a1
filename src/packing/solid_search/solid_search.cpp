// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/solid_search.h"

#include "packing/search/room_search.h"
#include "packing/solid_moves/solid_finish.h"
#include "packing/solid_proof/solid_bound.h"
#include "packing/solid_proof/verify_solids.h"
#include "packing/solid_search/solid_first_layout.h"
#include "packing/solid_search/solid_kit.h"

namespace findspace::packing {
namespace {

struct ColumnKit {
  using Core = SolidKit;
  using Problem = SolidProblem;
  using Layout = SolidLayout;

  static constexpr std::uint64_t kRound = 4'000'000;  // boxes and planes looked at: about a tenth of a second
  static constexpr std::size_t kIslands = 2;

  static std::size_t islands(unsigned) { return kIslands; }
  static FirstLayoutOf<SolidPose> first_layout(const SolidProblem& problem, const SolidTable& table,
                                               const SolidColumn& column, std::uint64_t seed) {
    return packing::first_layout(problem, table, column, seed);
  }
  static std::vector<double> values_of(const SolidProblem& problem) { return packing::values_of(problem); }
  static std::vector<SolidPose> poses_of(const SolidProblem& problem, const SolidTable& table,
                                         const SolidColumn& column, const SolidLayout& layout) {
    return packing::poses_of(problem, table, column, layout);
  }
  static std::optional<SolidLayout> finished(const SolidProblem& problem, const SolidTable& table,
                                             const SolidColumn& column, std::vector<SolidPose>& poses, double height) {
    return packing::finished(problem, table, column, poses, height);
  }
  static SolidLayout safe_layout(const SolidProblem& problem, const SolidTable& table) {
    return tower_of(problem, table);
  }
  static bool is_feasible(const SolidProblem& problem, const SolidLayout& layout) {
    return verify(problem, layout).is_feasible();
  }
  static std::vector<std::size_t> cheapest(const SolidProblem& problem) { return cheapest_containers(problem); }
  static const std::vector<std::size_t>& containers(const SolidLayout& layout) { return layout.containers; }
  static const Fraction& length(const SolidLayout& layout) { return layout.height; }
  static double density(const SolidProblem& problem, const SolidLayout& layout) {
    return volume(problem, layout) / container_volume(problem, layout);
  }
  static std::optional<Fraction> least_length(const SolidProblem& problem) {
    return problem.in_containers() ? std::nullopt : std::optional(lower_bound(problem));
  }
  static bool has_containers(const SolidProblem& problem) { return problem.in_containers(); }
  static bool has_fixed(const SolidProblem& problem) { return !problem.fixed.empty(); }
};

}  // namespace

std::optional<SolidLayout> search_solids(const SolidProblem& problem, const SolidSearchOptions& options,
                                         const SolidSearchEvents& events, const StopWish& stop) {
  if (problem.items() == 0) return std::nullopt;
  return RoomSearch<ColumnKit>(problem, options, events, stop).run();
}

}  // namespace findspace::packing
