// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/compaction/linear_moves.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/packing.h"
#include "packing/compaction/linear_program.h"

namespace findspace::packing {
namespace {

constexpr double kTrust = 0.02;            // of the height
constexpr double kLengthOfOverlap = 0.01;  // what the length costs beside a depth
constexpr int kMostSteps = 40;
constexpr int kMostSeparations = 12;

/// The columns of a program over parts: two a part, then the length.
int column_x(std::size_t item) { return int(2 * item); }
int column_y(std::size_t item) { return int(2 * item + 1); }

}  // namespace

void LinearMoves::collect_pair(const std::vector<Pose>& poses, std::size_t a, std::size_t b, double trust, Goal goal,
                               double gap, bool on_grid) {
  const Pose &first = poses[a], &second = b < poses.size() ? poses[b] : row_.obstacles()[b - poses.size()];
  const Vec t = second.at - first.at;
  const auto& variants = table_.variants();
  const Variant &va = variants[first.variant], &vb = variants[second.variant];
  const double reach = 2 * trust + gap, clearance = reach + 2 * table_.gap();
  if (!table_.are_tied(first.variant, second.variant)) {
    if (t.x - clearance > va.high.x - vb.low.x || t.x + clearance < va.low.x - vb.high.x) return;
    if (t.y - clearance > va.high.y - vb.low.y || t.y + clearance < va.low.y - vb.high.y) return;
  }
  const FieldTable::Link& link = table_.link(first.variant, second.variant);
  const DepthField& field = link.field();
  const Vec at = link.in_field(t);
  const Nearest inside = field.nearest(at);
  const double height = table_.height();
  const bool overlap = inside.depth > height * margin::kNoOverlap;
  const Vec free = inside.depth > 0 ? inside.projection : at;
  free_half_planes(field.polygon(), free, reach + (overlap ? inside.depth : 0), height, planes_);
  for (const HalfPlane& h : planes_) {
    const double lacks = h.offset - dot(h.normal, at);
    const bool slanted = h.normal.x != 0 && h.normal.y != 0;
    const double wanted = goal == Goal::kLoosen && (slanted || !on_grid) ? gap : 0;
    const bool soft = (goal != Goal::kShorten && lacks > 0) || wanted > 0;
    const double need = soft ? lacks + wanted : std::min(lacks, 0.0);
    rows_.push_back({a, b, link.rotated(h.normal), need, std::max(wanted, need), soft});
  }
}

void LinearMoves::collect(const std::vector<Pose>& poses, double trust, Goal goal, double gap, bool on_grid) {
  rows_.clear();
  for (std::size_t a = 0; a < poses.size(); ++a)
    for (std::size_t b = a + 1; b < poses.size() + row_.obstacles().size(); ++b)
      collect_pair(poses, a, b, trust, goal, gap, on_grid);
}

bool LinearMoves::solve(std::vector<Pose>& poses, double& length, double most, double trust, Goal goal) {
  LinearProgram program(table_.height());
  const auto& variants = table_.variants();
  for (const Pose& p : poses) {
    const Variant& v = variants[p.variant];
    const Room<Vec>& room = row_.rooms()[row_.room_of(v, p.at)];
    program.add_column(std::clamp(room.low.x - v.low.x - p.at.x, -trust, 0.0),
                       std::clamp(room.high.x - v.high.x - p.at.x, 0.0, trust), 0);
    program.add_column(std::clamp(-v.low.y - p.at.y, -trust, 0.0),
                       std::clamp(room.high.y - v.high.y - p.at.y, 0.0, trust), 0);
  }
  const int end = program.add_column(row_.fixed_end(), std::max(most, row_.fixed_end()),
                                     goal == Goal::kSeparate ? kLengthOfOverlap : 1);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    program.begin_row(poses[i].at.x + variants[poses[i].variant].high.x);
    program.add(end, 1);
    program.add(column_x(i), -1);
  }
  std::vector<int> slacks;
  for (const Bound& row : rows_) {
    program.begin_row(row.need);
    if (row.b < poses.size()) {
      program.add(column_x(row.b), row.normal.x);
      program.add(column_y(row.b), row.normal.y);
    }
    program.add(column_x(row.a), -row.normal.x);
    program.add(column_y(row.a), -row.normal.y);
    if (!row.soft) continue;
    const double greatest = goal == Goal::kLoosen ? row.most_lacking : table_.height();
    slacks.push_back(program.add_column(0, greatest, goal == Goal::kLoosen ? 100 : 1));
    program.add(slacks.back(), 1);
  }
  ++solved_;
  if (!program.solve()) return false;
  for (std::size_t i = 0; i < poses.size(); ++i)
    poses[i].at = poses[i].at + Vec{program.value(column_x(i)), program.value(column_y(i))};
  left_ = 0;
  for (const int slack : slacks) left_ += program.value(slack);
  length = program.value(end);
  return true;
}

double LinearMoves::shorten(std::vector<Pose>& poses, double length) {
  const double trust = kTrust * table_.height();
  for (int step = 0; step < kMostSteps; ++step) {
    const double before = length;
    collect(poses, trust, Goal::kShorten, 0, false);
    if (!solve(poses, length, length, trust, Goal::kShorten)) break;
    if (before - length < margin::kCompactionGain * length) break;
  }
  return length;
}

bool LinearMoves::separate(std::vector<Pose>& poses, double& length, double most) {
  const double trust = kTrust * table_.height(), enough = table_.height() * margin::kNoOverlap;
  double last = 0;
  for (int step = 0; step < kMostSeparations; ++step) {
    collect(poses, trust, Goal::kSeparate, 0, false);
    if (!solve(poses, length, most, trust, Goal::kSeparate)) return false;
    if (left_ <= enough) return true;
    if (step > 0 && left_ > 0.98 * last) return false;
    last = left_;
  }
  return false;
}

double LinearMoves::loosen(std::vector<Pose>& poses, double length, double gap, bool on_grid) {
  const double trust = std::min(kTrust * table_.height(), 1000 * gap);
  collect(poses, trust, Goal::kLoosen, gap, on_grid);
  solve(poses, length, length + trust, trust, Goal::kLoosen);
  return length;
}

}  // namespace findspace::packing
