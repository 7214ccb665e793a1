// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sheets side by side as one strip with walls, so that one search serves both: the shorter the row, the fewer sheets
// are used, and the emptier the last one is. A strip is a row of one container without an end. Obstacles of the sheets
// and fixed parts stand in the row as parts that never move. Cost: linear. Keywords: bin packing, cutting stock.
#pragma once

#include <vector>

#include "packing/nfp/field_table.h"

namespace findspace::packing {

/// Between the edges; x in the row.
struct Container {
  double x = 0, width = 0, height = 0;
  std::size_t kind = 0;  // of sheet
};

class Row {
 public:
  /// Sheets of these kinds, in this order; none for a strip.
  Row(const Problem& problem, const FieldTable& table, const std::vector<std::size_t>& kinds);

  const std::vector<Container>& containers() const { return containers_; }
  const std::vector<Pose>& obstacles() const { return obstacles_; }
  /// No layout is shorter: where the last fixed part ends, or 0.
  double fixed_end() const { return fixed_end_; }
  /// The container of each fixed part of the problem.
  const std::vector<std::size_t>& fixed_containers() const { return fixed_containers_; }
  /// Where the last container ends.
  double end() const { return containers_.back().x + containers_.back().width; }
  /// The container in which a part stands; of one that is in none, the one before.
  std::size_t container_of(const Variant& variant, Vec at) const;

 private:
  void add_fixed(const Problem& problem, const FieldTable& table);

  std::vector<Container> containers_;
  std::vector<Pose> obstacles_;
  std::vector<std::size_t> fixed_containers_;
  double fixed_end_ = 0;
};

/// All sheets: those with fixed parts, then the cheapest for their area first; no more of a kind than there are parts.
std::vector<std::size_t> cheapest_sheets(const Problem& problem);

}  // namespace findspace::packing
