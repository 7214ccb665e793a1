// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_moves/solid_linear_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/margins/packing.h"
#include "packing/compaction/linear_program.h"

namespace findspace::packing {
namespace {

constexpr double kSolidTrust = 0.05;       // of the floor
constexpr double kHeightOfOverlap = 0.01;  // what the height costs beside a depth
constexpr int kMostSolidSteps = 40;
constexpr int kMostSolidSeparations = 12;
constexpr double kLeastProgress = 0.98;   // of what overlaps are left
constexpr double kCostOfTightness = 100;  // beside the height
constexpr double kGapsOfTrust = 1000;

int solid_column(std::size_t item, int axis) { return int(3 * item) + axis; }

/// Fewer where programs are large, none where they would be slower than the search.
int most_steps(std::size_t items, int most) {
  constexpr std::size_t kItemsOfSteps = 4000, kMostInProgram = 1500;
  return items > kMostInProgram ? 0 : std::min(most, int(kItemsOfSteps / std::max<std::size_t>(items, 1)));
}

bool is_along_axis(const Vector& n) { return int(n.x != 0) + int(n.y != 0) + int(n.z != 0) == 1; }

}  // namespace

/// Of rows of one pair with the same normal only the tightest counts.
void SolidLinearMoves::keep(const Bound& bound) {
  for (std::size_t k = first_of_pair_; k < rows_.size(); ++k) {
    Bound& known = rows_[k];
    if (known.normal.x != bound.normal.x || known.normal.y != bound.normal.y || known.normal.z != bound.normal.z)
      continue;
    if (bound.need > known.need) known = bound;
    return;
  }
  rows_.push_back(bound);
}

void SolidLinearMoves::collect_pair(const std::vector<SolidPose>& poses, std::size_t a, std::size_t b, double reach,
                                    Goal goal, double gap, bool on_axes) {
  const SolidPose &first = poses[a], &second = pose(poses, b);
  const SolidTable::Link link = table_.link(first.variant, second.variant);
  const OverlapPair& pair = link.pair;
  const Vector u = link.sign * (second.at - first.at);
  const auto is_near = [&](const Vector& low, const Vector& high) {
    return u.x > low.x - reach && u.y > low.y - reach && u.z > low.z - reach && u.x < high.x + reach &&
           u.y < high.y + reach && u.z < high.z + reach;
  };
  if (!is_near(pair.low, pair.high)) return;
  first_of_pair_ = rows_.size();
  for (const ConvexOverlap& overlap : pair.overlaps) {
    if (!is_near(overlap.low, overlap.high)) continue;
    overlap.for_each_facing(u, 2 * reach, [&](const Facing& facing) {
      const Vector normal = link.sign * facing.normal;
      const double lacks = -facing.value;
      if (lacks < -2 * reach) return;
      const double wanted = goal == Goal::kLoosen && !(on_axes && is_along_axis(normal)) ? gap : 0;
      const bool soft = (goal != Goal::kShorten && lacks > 0) || wanted > 0;
      const double need = soft ? lacks + wanted : std::min(lacks, 0.0);
      keep({a, b, normal, need, std::max(wanted, need), soft});
    });
  }
}

void SolidLinearMoves::collect_tie(const std::vector<SolidPose>& poses, std::size_t a, std::size_t b, double reach) {
  const SolidPose &first = poses[a], &second = pose(poses, b);
  const double way = table_.free_move(first.variant, second.variant, second.at - first.at);
  const double side = way / std::numbers::sqrt3;  // half that of the greatest cube in a ball
  if (side >= reach) return;
  for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}})
    for (const double sign : {1.0, -1.0}) rows_.push_back({a, b, sign * axis, -side, 0, false});
}

void SolidLinearMoves::collect(const std::vector<SolidPose>& poses, double trust, Goal goal, double gap, bool on_axes) {
  rows_.clear();
  for (std::size_t a = 0; a < poses.size(); ++a)
    for (std::size_t b = a + 1; b < poses.size() + column_.obstacles().size(); ++b) {
      collect_pair(poses, a, b, 2 * trust + gap, goal, gap, on_axes);
      if (table_.has_ties() && table_.are_tied(poses[a].variant, pose(poses, b).variant))
        collect_tie(poses, a, b, 2 * trust);
    }
}

bool SolidLinearMoves::solve(std::vector<SolidPose>& poses, double& height, double most, double trust, Goal goal) {
  LinearProgram program(table_.size());
  for (const SolidPose& p : poses) {
    const SolidVariant& v = table_.variants()[p.variant];
    const Room<Vector>& room = column_.room_at(v, p.at);
    program.add_column(std::clamp(room.low.x - v.low.x - p.at.x, -trust, 0.0),
                       std::clamp(room.high.x - v.high.x - p.at.x, 0.0, trust), 0);
    program.add_column(std::clamp(room.low.y - v.low.y - p.at.y, -trust, 0.0),
                       std::clamp(room.high.y - v.high.y - p.at.y, 0.0, trust), 0);
    program.add_column(std::clamp(room.low.z - v.low.z - p.at.z, -trust, 0.0),
                       std::clamp(room.high.z - v.high.z - p.at.z, 0.0, trust), 0);
  }
  const int end = program.add_column(column_.fixed_end(), std::max(most, column_.fixed_end()),
                                     goal == Goal::kSeparate ? kHeightOfOverlap : 1);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    program.begin_row(poses[i].at.z + table_.variants()[poses[i].variant].high.z);
    program.add(end, 1);
    program.add(solid_column(i, 2), -1);
  }
  std::vector<int> slacks;
  for (const Bound& row : rows_) {
    program.begin_row(row.need);
    for (const auto& [item, sign] : {std::pair(row.b, 1.0), std::pair(row.a, -1.0)}) {
      if (item >= poses.size()) continue;
      program.add(solid_column(item, 0), sign * row.normal.x);
      program.add(solid_column(item, 1), sign * row.normal.y);
      program.add(solid_column(item, 2), sign * row.normal.z);
    }
    if (!row.soft) continue;
    const double greatest = goal == Goal::kLoosen ? row.most_lacking : std::max(table_.size(), 2 * row.need);
    slacks.push_back(program.add_column(0, greatest, goal == Goal::kLoosen ? kCostOfTightness : 1));
    program.add(slacks.back(), 1);
  }
  ++solved_;
  if (!program.solve()) return false;
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i].at = poses[i].at + Vector{program.value(solid_column(i, 0)), program.value(solid_column(i, 1)),
                                       program.value(solid_column(i, 2))};
  left_ = 0;
  for (const int slack : slacks) left_ += program.value(slack);
  height = program.value(end);
  return true;
}

double SolidLinearMoves::shorten(std::vector<SolidPose>& poses, double height) {
  const double trust = kSolidTrust * table_.size();
  for (int step = 0; step < most_steps(poses.size(), kMostSolidSteps); ++step) {
    const double before = height;
    collect(poses, trust, Goal::kShorten, 0, false);
    if (!solve(poses, height, height, trust, Goal::kShorten)) break;
    if (before - height < margin::kCompactionGain * height) break;
  }
  return height;
}

bool SolidLinearMoves::separate(std::vector<SolidPose>& poses, double& height, double most) {
  const double trust = kSolidTrust * table_.size(), enough = table_.size() * margin::kNoOverlap;
  double last = 0;
  for (int step = 0; step < most_steps(poses.size(), kMostSolidSeparations); ++step) {
    collect(poses, trust, Goal::kSeparate, 0, false);
    if (!solve(poses, height, most, trust, Goal::kSeparate)) return false;
    if (left_ <= enough) return true;
    if (step > 0 && left_ > kLeastProgress * last) return false;
    last = left_;
  }
  return false;
}

double SolidLinearMoves::loosen(std::vector<SolidPose>& poses, double height, double gap, bool on_axes) {
  const double trust = std::min(kSolidTrust * table_.size(), kGapsOfTrust * gap);
  collect(poses, trust, Goal::kLoosen, gap, on_axes);
  solve(poses, height, height + trust, trust, Goal::kLoosen);
  return height;
}

}  // namespace findspace::packing
