// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes of things that lie in a row, one next to the other in the plane as well, as the edges of a ring do: a tree over
// the row as it is, nothing sorted. Where the row does not turn back much, neighbours share a corner of their boxes and
// others are apart. Guarantee: none missing. Cost: O(n) to build; O(n) box tests for all pairs of a smooth ring.
// Keywords: hierarchy of bounding boxes, monotone chain.
#pragma once

#include <algorithm>
#include <vector>

#include "plane/broad_phase.h"

namespace findspace::plane {

class SequenceBoxes {
 public:
  explicit SequenceBoxes(std::vector<PieceBox> boxes) {
    levels_.push_back(std::move(boxes));
    while (levels_.back().size() > 1) {
      const std::vector<PieceBox>& low = levels_.back();
      std::vector<PieceBox> high((low.size() + 1) / 2);
      for (std::size_t k = 0; k < high.size(); ++k)
        high[k] = 2 * k + 1 < low.size() ? joined(low[2 * k], low[2 * k + 1]) : low[2 * k];
      levels_.push_back(std::move(high));
    }
  }

  /// Calls visit(i, j), i < j, for all pairs whose boxes meet.
  template <class Visit>
  void meeting_pairs(Visit&& visit) const {
    for (std::size_t level = 0; level < levels_.size(); ++level)
      for (std::size_t k = 0; k + 1 < levels_[level].size(); k += 2)
        if (levels_[level][k].meets(levels_[level][k + 1])) between(level, k, k + 1, visit);
  }

  /// Calls visit(i) for the boxes that meet the given one, until it returns true.
  template <class Visit>
  bool any_meeting(const PieceBox& box, Visit&& visit) const {
    return !levels_[0].empty() && any_under(levels_.size() - 1, 0, box, visit);
  }

 private:
  static PieceBox joined(const PieceBox& a, const PieceBox& b) {
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
  }

  /// Of two different boxes of a level that meet.
  template <class Visit>
  void between(std::size_t level, std::size_t i, std::size_t j, Visit& visit) const {
    if (level == 0) return visit(Index(i), Index(j));
    const std::vector<PieceBox>& below = levels_[level - 1];
    const std::size_t i_end = std::min(2 * i + 2, below.size()), j_end = std::min(2 * j + 2, below.size());
    for (std::size_t k = 2 * i; k < i_end; ++k)
      for (std::size_t l = 2 * j; l < j_end; ++l)
        if (below[k].meets(below[l])) between(level - 1, k, l, visit);
  }

  template <class Visit>
  bool any_under(std::size_t level, std::size_t i, const PieceBox& box, Visit& visit) const {
    if (!levels_[level][i].meets(box)) return false;
    if (level == 0) return visit(Index(i));
    const std::size_t n = levels_[level - 1].size();
    return any_under(level - 1, 2 * i, box, visit) || (2 * i + 1 < n && any_under(level - 1, 2 * i + 1, box, visit));
  }

  std::vector<std::vector<PieceBox>> levels_;  // of one, of two, of four ...
};

}  // namespace findspace::plane
