// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_moves/solid_finish.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "packing/compaction/decimal_steps.h"
#include "packing/solid_moves/solid_linear_moves.h"
#include "packing/solid_proof/verify_solids.h"

namespace findspace::packing {
namespace {

constexpr double kSolidSnap = 8;  // fine steps
/// Gaps in steps of the fine grid, and whether contacts along an axis stay.
constexpr std::pair<double, bool> kSolidLoosenings[] = {{0, true},   {4, true},   {4, false},   {32, true},
                                                        {32, false}, {512, true}, {4096, false}};

constexpr int kMostLeavings = 4;

class SolidFinisher {
 public:
  SolidFinisher(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column)
      : problem_(problem), table_(table), column_(column), steps_(problem.digits, table.size(), problem.digits) {
    for (const SolidVariant& v : table.variants())
      boxes_.push_back(v.part == kWallPart ? SolidBox() : box_of(problem, problem.parts[v.part].forms[v.form]));
  }

  double step() const { return steps_.step(); }

  SolidLayout rounded(const std::vector<SolidPose>& poses, double snap) const {
    SolidLayout layout;
    std::vector<std::size_t> rooms;
    for (const SolidPose& pose : poses) rooms.push_back(column_.room_of(table_.variants()[pose.variant], pose.at));
    std::vector<std::size_t> all = rooms;
    all.insert(all.end(), column_.fixed_rooms().begin(), column_.fixed_rooms().end());
    const UsedRooms used(std::move(all));
    if (problem_.in_containers())
      for (const std::size_t room : used.all()) layout.containers.push_back(column_.rooms()[room].kind);
    std::vector<int> copies(problem_.parts.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const SolidVariant& v = table_.variants()[poses[i].variant];
      layout.items.push_back({v.part, ++copies[v.part], v.form, {}, used.number_of(rooms[i])});
      put(layout, boxes_[poses[i].variant], poses[i].at - Vector{0, 0, column_.rooms()[rooms[i]].low.z}, snap);
    }
    for (std::size_t k = 0; k < problem_.fixed.size(); ++k)
      put_fixed(layout, k, used.number_of(column_.fixed_rooms()[k]), copies);
    const auto fits = [&](std::size_t part) { return !table_.variants_of(part).empty(); };
    layout.left_out = left_out_of(problem_.parts, copies, fits, "it is larger than every container");
    return layout;
  }

 private:
  /// The last item's position: on the grid, within the walls of its container.
  void put(SolidLayout& layout, const SolidBox& box, const Vector& pose, double snap) const {
    SolidPlaced& item = layout.items.back();
    const std::array<double, 3> at = coordinates(pose);
    const std::array<Fraction, 3> size = size_of(layout, item);
    for (std::size_t k = 0; k < 3; ++k) {
      int128 place = steps_.nearest(at[k] + table_.edge(), snap);
      if (k < 2 || problem_.in_containers())
        place = std::min(place, steps_.below(size[k] - problem_.edge - box.high[k]));
      item.at[k] = Fraction(std::max(place, steps_.above(problem_.edge - box.low[k])), steps_.in_one());
    }
    count_height(layout, box);
  }

  /// Behind the others.
  void put_fixed(SolidLayout& layout, std::size_t k, std::size_t container, std::vector<int>& copies) const {
    SolidPlaced& item = layout.items.emplace_back(problem_.fixed[k].placed);
    item.container = container;
    item.copy = ++copies[item.part];
    count_height(layout, boxes_[table_.fixed_variants()[k]]);
  }

  /// Of the last item, where it stands in the last container.
  void count_height(SolidLayout& layout, const SolidBox& box) const {
    const SolidPlaced& item = layout.items.back();
    if (item.container + 1 < layout.containers.size()) return;
    layout.height = std::max(layout.height, item.at[2] + box.high[2] + problem_.edge);
  }

  std::array<Fraction, 3> size_of(const SolidLayout& layout, const SolidPlaced& item) const {
    if (!problem_.in_containers()) return {problem_.width, problem_.depth, 0};
    const SolidContainer& container = problem_.containers[layout.containers[item.container]];
    return {container.width, container.depth, container.height};
  }

  const SolidProblem& problem_;
  const SolidTable& table_;
  const SolidColumn& column_;
  std::vector<SolidBox> boxes_;  // of variants
  DecimalSteps steps_;
};

/// The second item of each pair that stays too near is left out, unless it is fixed.
std::optional<SolidLayout> without_faults(const SolidProblem& problem, const SolidFinisher& finisher,
                                          std::vector<SolidPose>& poses) {
  using Kind = SolidFault::Kind;
  for (int k = 0; k < kMostLeavings; ++k) {
    SolidLayout layout = finisher.rounded(poses, kSolidSnap);
    const SolidVerdict verdict = verify(problem, layout);
    if (verdict.is_feasible()) return layout;
    std::vector<char> leaves(poses.size());
    for (const SolidFault& fault : verdict.faults) {
      if (fault.kind == Kind::kCount || fault.kind == Kind::kContainers) continue;
      if (fault.kind == Kind::kOutside || fault.second >= poses.size())
        leaves[fault.first] = 1;
      else if (leaves[fault.first] == 0)
        leaves[fault.second] = 1;
    }
    std::size_t i = 0;
    std::erase_if(poses, [&](const SolidPose&) { return leaves[i++] != 0; });
    if (poses.empty()) break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SolidLayout> finished(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column,
                                    std::vector<SolidPose>& poses, double height) {
  const SolidFinisher finisher(problem, table, column);
  std::vector<SolidPose> nearest;
  std::size_t least_faults = std::numeric_limits<std::size_t>::max();
  for (const auto& [steps, keep_contacts] : kSolidLoosenings) {
    std::vector<SolidPose> moved = poses;
    if (steps > 0) SolidLinearMoves(table, column).loosen(moved, height, steps * finisher.step(), keep_contacts);
    SolidLayout layout = finisher.rounded(moved, kSolidSnap + 2 * steps);
    const SolidVerdict verdict = verify(problem, layout);
    if (verdict.is_feasible()) return layout;
    if (verdict.faults.size() >= least_faults) continue;
    least_faults = verdict.faults.size();
    nearest = std::move(moved);
  }
  if (!problem.in_containers()) return std::nullopt;
  poses = std::move(nearest);
  return without_faults(problem, finisher, poses);
}

SolidLayout tower_of(const SolidProblem& problem, const SolidTable& table) {
  SolidLayout layout = layout_of_fixed(problem);
  layout.left_out.clear();
  Fraction z = problem.fixed.empty() ? problem.edge : layout.height - problem.edge + problem.widest_gap_of_all();
  for (std::size_t part = 0; part < problem.parts.size(); ++part) {
    if (problem.free_copies(part) == 0) continue;
    const std::size_t form = table.variants()[table.variants_of(part)[0]].form;
    const SolidBox box = box_of(problem, problem.parts[part].forms[form]);
    for (int copy = problem.parts[part].demand - problem.free_copies(part) + 1; copy <= problem.parts[part].demand;
         ++copy) {
      layout.items.push_back(
          {part, copy, form, {problem.edge - box.low[0], problem.edge - box.low[1], z - box.low[2]}});
      const Fraction top = z + box.high[2] - box.low[2];
      layout.height = top + problem.edge;
      z = top + problem.widest_gap_of_all();
    }
  }
  return layout;
}

std::vector<SolidPose> poses_of(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column,
                                const SolidLayout& layout) {
  std::vector<SolidPose> poses;
  for (const SolidPlaced& item : layout.items) {
    if (table.variants_of(item.part).empty() || is_fixed_solid(problem, layout, item)) continue;
    poses.push_back(table.pose_of(item));
    poses.back().at.z += column.rooms()[layout.containers.empty() ? 0 : item.container].low.z;
  }
  return poses;
}

}  // namespace findspace::packing
