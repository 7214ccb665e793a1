// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Containers of solids upon each other (packing/nfp/rooms.h): the lower the column, the fewer are used. One that is
// sought has no lid. Fixed solids stand in the column as obstacles that never move, and so do the walls of a container
// that is no box. Cost: linear. Keywords: container loading, three-dimensional bin packing.
#pragma once

#include <vector>

#include "packing/nfp/rooms.h"
#include "packing/solid_depth/solid_table.h"

namespace findspace::packing {

class SolidColumn {
 public:
  /// Containers of these kinds, in this order; none where the height is sought. Throws Error(kBadValue) where that of a
  /// fixed solid is missing.
  SolidColumn(const SolidProblem& problem, const SolidTable& table, const std::vector<std::size_t>& kinds);

  const Rooms<Vector>& rooms() const { return rooms_; }
  /// The fixed solids of the problem, then walls.
  const std::vector<SolidPose>& obstacles() const { return obstacles_; }
  /// The room of each fixed solid.
  const std::vector<std::size_t>& fixed_rooms() const { return fixed_rooms_; }
  /// Whether a room has walls that are not those of its box.
  bool has_walls(std::size_t room) const { return has_walls_[room] != 0; }
  /// Whether a ball holds what stands in it.
  bool is_round(std::size_t room) const { return is_round_[room] != 0; }
  /// No layout is lower: the top of the highest fixed solid, or of the highest part where none may be left out.
  double fixed_end() const { return end_; }
  /// The room in which a part stands.
  std::size_t room_of(const SolidVariant& variant, const Vector& at) const {
    return rooms_.room_of(at + 0.5 * (variant.low + variant.high));
  }
  const Room<Vector>& room_at(const SolidVariant& variant, const Vector& at) const {
    return rooms_[room_of(variant, at)];
  }

 private:
  void add_fixed(const SolidProblem& problem, const SolidTable& table);
  std::size_t room_of(const FixedSolid& fixed) const;
  void add_walls(const SolidProblem& problem, const SolidTable& table);

  Rooms<Vector> rooms_;
  std::vector<SolidPose> obstacles_;
  std::vector<std::size_t> fixed_rooms_;
  std::vector<char> has_walls_, is_round_;  // of each room
  double end_ = 0;
};

/// All containers: those with fixed solids, then the cheapest for their volume first; no more of a kind than there are
/// parts.
std::vector<std::size_t> cheapest_containers(const SolidProblem& problem);

}  // namespace findspace::packing
