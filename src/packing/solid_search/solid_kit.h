// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the search is made of in space: see separation.h, which has the same for the plane.
#pragma once

#include "packing/search/island_team.h"
#include "packing/solid_search/solid_arrangement.h"
#include "packing/solid_search/solid_mover.h"

namespace findspace::packing {

struct SolidKit {
  using Pose = SolidPose;
  using Table = SolidTable;
  using Row = SolidColumn;
  using Arrangement = SolidArrangement;
  using Mover = SolidMover;
  using LinearMoves = SolidLinearMoves;

  static constexpr double kMostShrink = 0.04;  // of the height
  static constexpr double kExploration = 0.8;  // of the whole search
  static constexpr double kApart = 0;          // islands that explore all go on from the best
  static constexpr Changes kChanges{0, 0, 1};  // the others came out two per cent higher
  static constexpr int kFirstPasses = 12;      // of a first try to keep conditions: heights may be too low for them
  static constexpr int kRepairAfter = 5;       // it moves solids along contacts, too, and takes as long as half a pass

  static std::size_t part_of(const SolidTable& table, const SolidPose& pose) {
    return table.variants()[pose.variant].part;
  }
  static Vector middle(const SolidTable& table, const SolidPose& pose) {
    const SolidVariant& v = table.variants()[pose.variant];
    return pose.at + 0.5 * (v.low + v.high);
  }
  static double size_of(const SolidTable& table, const SolidPose& pose) {
    const SolidVariant& v = table.variants()[pose.variant];
    const Vector sides = v.high - v.low;
    return sides.x * sides.y * sides.z;
  }
  static Vector anywhere(const SolidTable& table, const SolidColumn& column, Random& random) {
    const double x = random.between(0, table.size()), y = random.between(0, table.size());
    return {x, y, random.between(0, column.rooms().end())};
  }
  static Vector moved_back(const Vector& at, double by) { return {at.x, at.y, at.z - by}; }
  static Vector exchanged(const Vector& at, const Vector& from, const Vector& to) { return at + (to - from); }
};

}  // namespace findspace::packing
