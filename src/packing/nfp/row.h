// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sheets side by side (rooms.h). Obstacles of the sheets and fixed parts stand in the row as parts that never move.
// Cost: linear. Keywords: bin packing, cutting stock.
#pragma once

#include <vector>

#include "packing/nfp/field_table.h"
#include "packing/nfp/rooms.h"

namespace findspace::packing {

class Row {
 public:
  /// Sheets of these kinds, in this order; none for a strip.
  Row(const Problem& problem, const FieldTable& table, const std::vector<std::size_t>& kinds);

  const Rooms<Vec>& rooms() const { return rooms_; }
  const std::vector<Pose>& obstacles() const { return obstacles_; }
  /// No layout is shorter: where the last fixed part ends, or 0.
  double fixed_end() const { return fixed_end_; }
  /// The room of each fixed part of the problem.
  const std::vector<std::size_t>& fixed_rooms() const { return fixed_rooms_; }
  /// The room in which a part stands.
  std::size_t room_of(const Variant& variant, Vec at) const {
    return rooms_.room_of(at + 0.5 * (variant.low + variant.high));
  }

 private:
  void add_fixed(const Problem& problem, const FieldTable& table);

  Rooms<Vec> rooms_;
  std::vector<Pose> obstacles_;
  std::vector<std::size_t> fixed_rooms_;
  double fixed_end_ = 0;
};

/// All sheets: those with fixed parts, then the cheapest for their area first; no more of a kind than there are parts.
std::vector<std::size_t> cheapest_sheets(const Problem& problem);

}  // namespace findspace::packing
