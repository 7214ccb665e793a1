// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_moves/solid_finish.h"

#include <algorithm>
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

class SolidFinisher {
 public:
  SolidFinisher(const SolidProblem& problem, const SolidTable& table)
      : problem_(problem), table_(table), steps_(problem.digits, table.size(), problem.digits) {
    for (const SolidVariant& v : table.variants())
      boxes_.push_back(box_of(problem, problem.parts[v.part].forms[v.form]));
  }

  double step() const { return steps_.step(); }

  SolidLayout rounded(const std::vector<SolidPose>& poses, double snap) const {
    SolidLayout layout;
    std::vector<int> copies(problem_.parts.size());
    for (const SolidPose& pose : poses) {
      const SolidVariant& v = table_.variants()[pose.variant];
      SolidPlaced& item = layout.items.emplace_back(SolidPlaced{v.part, ++copies[v.part], v.form, {}});
      const SolidBox& box = boxes_[pose.variant];
      const double edge = table_.edge(), at[] = {pose.at.x + edge, pose.at.y + edge, pose.at.z + edge};
      for (std::size_t k = 0; k < 3; ++k) {
        int128 place = steps_.nearest(at[k], snap);
        if (k < 2)
          place =
              std::min(place, steps_.below((k == 0 ? problem_.width : problem_.depth) - problem_.edge - box.high[k]));
        item.at[k] = Fraction(std::max(place, steps_.above(problem_.edge - box.low[k])), steps_.in_one());
      }
      layout.height = std::max(layout.height, item.at[2] + box.high[2] + problem_.edge);
    }
    return layout;
  }

 private:
  const SolidProblem& problem_;
  const SolidTable& table_;
  std::vector<SolidBox> boxes_;  // of variants
  DecimalSteps steps_;
};

}  // namespace

std::optional<SolidLayout> finished(const SolidProblem& problem, const SolidTable& table,
                                    const std::vector<SolidPose>& poses, double height) {
  const SolidFinisher finisher(problem, table);
  const SolidColumn column(table);
  for (const auto& [steps, keep_contacts] : kSolidLoosenings) {
    std::vector<SolidPose> moved = poses;
    if (steps > 0) SolidLinearMoves(table, column).loosen(moved, height, steps * finisher.step(), keep_contacts);
    SolidLayout layout = finisher.rounded(moved, kSolidSnap + 2 * steps);
    if (verify(problem, layout).is_feasible()) return layout;
  }
  return std::nullopt;
}

SolidLayout tower_of(const SolidProblem& problem, const SolidTable& table) {
  SolidLayout layout;
  Fraction z = problem.edge;
  for (std::size_t part = 0; part < problem.parts.size(); ++part) {
    if (problem.parts[part].demand == 0) continue;
    const std::size_t form = table.variants()[table.variants_of(part)[0]].form;
    const SolidBox box = box_of(problem, problem.parts[part].forms[form]);
    for (int copy = 1; copy <= problem.parts[part].demand; ++copy) {
      layout.items.push_back(
          {part, copy, form, {problem.edge - box.low[0], problem.edge - box.low[1], z - box.low[2]}});
      const Fraction top = z + box.high[2] - box.low[2];
      layout.height = top + problem.edge;
      z = top + problem.gap;
    }
  }
  return layout;
}

std::vector<SolidPose> poses_of(const SolidTable& table, const SolidLayout& layout) {
  std::vector<SolidPose> poses;
  for (const SolidPlaced& item : layout.items) poses.push_back(table.pose_of(item));
  return poses;
}

}  // namespace findspace::packing
