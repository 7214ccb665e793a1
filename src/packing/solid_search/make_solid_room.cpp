// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/solid_search/make_solid_room.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "exact/margins/packing.h"
#include "packing/solid_moves/solid_finish.h"
#include "packing/solid_moves/solid_linear_moves.h"
#include "packing/solid_proof/verify_solids.h"
#include "packing/solid_search/solid_arrangement.h"

namespace findspace::packing {
namespace {

class SolidRoom {
 public:
  SolidRoom(const SolidProblem& problem, const SolidLayout& layout)
      : problem_(problem),
        table_(problem),
        column_(problem, table_, layout.containers),
        given_(poses_of(problem, table_, column_, layout)),
        height_(column_.fixed_end()) {
    for (const SolidPose& pose : given_) height_ = std::max(height_, top_of(pose));
  }

  /// The layout with its overlaps taken out, at a height as much greater as that needs.
  std::optional<SolidLayout> separated() const {
    constexpr std::array<double, 7> kHigher{1, 1.02, 1.05, 1.1, 1.25, 1.5, 2};
    for (const double higher : kHigher) {
      const double most =
          problem_.in_containers() ? std::min(height_ * higher, column_.rooms().end()) : height_ * higher;
      std::vector<SolidPose> poses = within(most);
      double reached = most;
      if (!SolidLinearMoves(table_, column_).separate(poses, reached, most)) continue;
      if (auto made = finished_of(poses, reached)) return made;
    }
    return std::nullopt;
  }

  /// Upon a floor: what overlaps an item is set upon all others, then the layout is lowered.
  std::optional<SolidLayout> set_aside(std::size_t item) const {
    if (problem_.in_containers()) return std::nullopt;
    std::vector<SolidPose> poses = within(height_);
    double height = height_;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (k == item || !overlap(poses[item], poses[k])) continue;
      poses[k].at.z = height + table_.gap() - table_.variants()[poses[k].variant].low.z;
      height = top_of(poses[k]);
    }
    const double reached = SolidLinearMoves(table_, column_).shorten(poses, height);
    return finished_of(poses, reached);
  }

 private:
  double top_of(const SolidPose& pose) const { return pose.at.z + table_.variants()[pose.variant].high.z; }

  std::vector<SolidPose> within(double height) const {
    std::vector<SolidPose> poses = given_;
    const SolidArrangement all(table_, column_, poses, height);
    for (SolidPose& pose : poses) pose.at = all.inside(pose.variant, pose.at);
    return poses;
  }

  bool overlap(const SolidPose& a, const SolidPose& b) const {
    const double touching = table_.size() * margin::kNoOverlap;
    const auto [pair, sign] = table_.link(a.variant, b.variant);
    return pair.depth(sign * (b.at - a.at), touching) > touching;
  }

  /// With all solids.
  std::optional<SolidLayout> finished_of(std::vector<SolidPose>& poses, double height) const {
    auto made = finished(problem_, table_, column_, poses, height);
    return made && made->items.size() == given_.size() + problem_.fixed.size() ? std::move(made) : std::nullopt;
  }

  const SolidProblem& problem_;
  SolidTable table_;
  SolidColumn column_;
  std::vector<SolidPose> given_;
  double height_;
};

/// Its number among the items that may move.
std::size_t number_among_free(const SolidProblem& problem, const SolidLayout& layout, std::size_t item) {
  const auto end = layout.items.begin() + std::ptrdiff_t(item);
  const auto is_fixed = [&](const SolidPlaced& placed) { return is_fixed_solid(problem, layout, placed); };
  return item - std::size_t(std::count_if(layout.items.begin(), end, is_fixed));
}

}  // namespace

std::optional<SolidLayout> with_room(const SolidProblem& problem, const SolidLayout& layout, std::size_t item,
                                     const std::array<Fraction, 3>& at) {
  if (is_fixed_solid(problem, layout, layout.items[item])) return std::nullopt;
  SolidLayout moved = layout;
  moved.items[item].at = at;
  const Fraction top = at[2] + box_of(problem, form_of(problem, moved.items[item])).high[2];
  moved.height = std::max(moved.height, top + problem.edge);
  const SolidVerdict verdict = verify(problem, moved);
  const auto is_missing = [](const SolidFault& fault) { return fault.kind == SolidFault::Kind::kFixed; };
  if (std::any_of(verdict.faults.begin(), verdict.faults.end(), is_missing)) return std::nullopt;
  if (!verdict.is_feasible()) {
    const SolidRoom room(problem, moved);
    auto made = room.separated();
    return made ? made : room.set_aside(number_among_free(problem, moved, item));
  }
  moved.height = verdict.used + problem.edge;
  return moved;
}

}  // namespace findspace::packing
