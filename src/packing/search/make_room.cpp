// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/search/make_room.h"

#include <cmath>
#include <utility>
#include <vector>

#include "exact/margins/packing.h"
#include "packing/compaction/finish.h"
#include "packing/search/arrangement.h"

namespace findspace::packing {
namespace {

/// The layout with its overlaps taken out, in a strip as much longer as that needs.
std::optional<Layout> separated(const Problem& problem, const Layout& layout) {
  constexpr std::array<double, 7> kLonger{1, 1.02, 1.05, 1.1, 1.25, 1.5, 2};
  const FieldTable table(problem);
  const Row row(problem, table, {});
  const double length = (layout.length - problem.edge - problem.edge).to_double();
  for (const double longer : kLonger) {
    std::vector<Pose> poses = poses_of(problem, table, row, layout);
    const Arrangement strip(table, row, poses, length * longer);
    for (Pose& pose : poses) pose.at = strip.inside(pose.variant, pose.at);
    LinearMoves moves(table, row);
    double reached = length * longer;
    if (!moves.separate(poses, reached, length * longer)) continue;
    if (auto made = finished(problem, table, row, poses, moves.shorten(poses, reached))) return made;
  }
  return std::nullopt;
}

/// The layout with what overlaps an item set behind the end of the strip, then shortened.
std::optional<Layout> set_aside(const Problem& problem, const Layout& layout, std::size_t item) {
  const FieldTable table(problem);
  const Row row(problem, table, {});
  double length = (layout.length - problem.edge - problem.edge).to_double();
  std::vector<Pose> poses = poses_of(problem, table, row, layout);
  const Arrangement strip(table, row, poses, length);
  poses[item].at = strip.inside(poses[item].variant, poses[item].at);
  const double touching = table.height() * margin::kNoOverlap;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (k == item || table.depth(poses[k], poses[item]) <= touching) continue;
    const Variant& variant = table.variants()[poses[k].variant];
    poses[k].at = {length + table.gap() - variant.low.x, -variant.low.y};
    length = poses[k].at.x + variant.high.x;
  }
  LinearMoves moves(table, row);
  return finished(problem, table, row, poses, moves.shorten(poses, length));
}

}  // namespace

std::optional<Layout> with_room(const Problem& problem, const Layout& layout, std::size_t item,
                                std::array<double, 2> at) {
  Layout moved = layout;
  const double steps = double(problem.steps());
  moved.items[item].x = Fraction(int128(std::llround(at[0] * steps)), problem.steps());
  moved.items[item].y = Fraction(int128(std::llround(at[1] * steps)), problem.steps());
  auto made = separated(problem, moved);
  return made ? made : set_aside(problem, moved, item);
}

}  // namespace findspace::packing
