// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Boxes of things that lie in a row, one next to the other in the plane as well, as the edges of a ring do: a tree over
// the row as it is, nothing sorted. Where the row does not turn back much, neighbours share a corner of their boxes and
// others are apart. Guarantee: none missing. Cost: O(n) to build; O(n) box tests for all pairs of a smooth ring, few
// where chains of things are known not to meet each other.
// Keywords: hierarchy of bounding boxes, monotone chain.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "plane/complex/broad_phase.h"

namespace findspace::plane {

class SequenceBoxes {
 public:
  /// `chains`, where it is given: the chain of each thing. Pairs of one chain are left out.
  explicit SequenceBoxes(std::vector<PieceBox> boxes, std::vector<Index> chains = {})
      : boxes_(std::move(boxes)), chains_(std::move(chains)) {
    first_[0] = 0;
    count_[0] = boxes_.size();
    boxes_.resize(size_with_joined(boxes_.size()));
    for (levels_ = 1; count_[levels_ - 1] > 1; ++levels_) {
      const std::size_t low = first_[levels_ - 1], n = count_[levels_ - 1];
      first_[levels_] = low + n;
      count_[levels_] = (n + 1) / 2;
      PieceBox* to = boxes_.data() + low + n;
      for (std::size_t k = 0; k < n; k += 2)
        *to++ = k + 1 < n ? joined(boxes_[low + k], boxes_[low + k + 1]) : boxes_[low + k];
      join_chains(low, n);
    }
  }

  /// How many boxes there will be of so many things: a list with room for them is not copied.
  static std::size_t size_with_joined(std::size_t things) {
    std::size_t all = things;
    for (std::size_t n = things; n > 1; all += n) n = (n + 1) / 2;
    return all;
  }

  /// Calls visit(i, j), i < j, for all pairs whose boxes meet.
  template <class Visit>
  void meeting_pairs(Visit&& visit) const {
    for (std::size_t level = 0; level < levels_; ++level)
      for (std::size_t k = 0; k + 1 < count_[level]; k += 2)
        if (may_meet(level, k, k + 1)) between(level, k, k + 1, visit);
  }

  /// Calls visit(i) for the boxes that meet the given one, until it returns true.
  template <class Visit>
  bool any_meeting(const PieceBox& with, Visit&& visit) const {
    return count_[0] > 0 && box(levels_ - 1, 0).meets(with) && any_under(levels_ - 1, 0, with, visit);
  }

 private:
  static constexpr std::size_t kMostLevels = 34;  // of a number of boxes that an Index can count

  const PieceBox& box(std::size_t level, std::size_t k) const { return boxes_[first_[level] + k]; }

  bool may_meet(std::size_t level, std::size_t i, std::size_t j) const {
    if (!box(level, i).meets(box(level, j))) return false;
    if (chains_.empty()) return true;
    const Index chain = chains_[first_[level] + i];
    return chain == kNone || chain != chains_[first_[level] + j];
  }

  /// Of the n boxes of a level from `low` on: two that are joined have a chain if both are of it.
  void join_chains(std::size_t low, std::size_t n) {
    if (chains_.empty()) return;
    for (std::size_t k = 0; k < n; k += 2) {
      const Index chain = chains_[low + k];
      chains_.push_back(k + 1 == n || chains_[low + k + 1] == chain ? chain : kNone);
    }
  }

  /// Of two different boxes of a level that meet.
  template <class Visit>
  void between(std::size_t level, std::size_t i, std::size_t j, Visit& visit) const {
    if (level-- == 0) return visit(Index(i), Index(j));
    const std::size_t i_end = std::min(2 * i + 2, count_[level]), j_end = std::min(2 * j + 2, count_[level]);
    for (std::size_t k = 2 * i; k < i_end; ++k)
      for (std::size_t l = 2 * j; l < j_end; ++l)
        if (may_meet(level, k, l)) between(level, k, l, visit);
  }

  template <class Visit>
  bool any_under(std::size_t level, std::size_t i, const PieceBox& with, Visit& visit) const {
    if (level-- == 0) return visit(Index(i));
    for (std::size_t k = 2 * i; k < std::min(2 * i + 2, count_[level]); ++k)
      if (box(level, k).meets(with) && any_under(level, k, with, visit)) return true;
    return false;
  }

  std::vector<PieceBox> boxes_;                         // of one, then of two, of four ...
  std::vector<Index> chains_;                           // of these boxes, kNone for several; or none are known
  std::array<std::size_t, kMostLevels> first_, count_;  // of a level
  std::size_t levels_ = 0;
};

}  // namespace findspace::plane
