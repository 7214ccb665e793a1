// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Loops in one arrangement, those in an even depth counter-clockwise and the others clockwise, with the number of times
// that they wind around each face. Guarantee: exact, whatever the loops are. Cost: one arrangement. Keywords: winding
// number, non-zero rule.
#pragma once

#include <span>
#include <vector>

#include "plane/build/loose_nesting.h"
#include "plane/complex/arrangement.h"

namespace findspace::plane {

/// Whether the loop runs the other way here than it was given.
inline bool is_turned(const Loop& loop) { return (loop.area > 0) != (loop.depth % 2 == 0); }

class WoundLoops {
 public:
  /// `chosen`: of the loops, whose reference it does not keep.
  WoundLoops(const std::vector<Loop>& loops, std::span<const std::size_t> chosen);

  /// Whether these loops touch nothing, themselves neither.
  bool are_apart(std::span<const std::size_t> some) const;

  /// The closure of the faces with such a number.
  template <class Is>
  Region faces(Is is) const {
    Marks m = no_marks();
    for (Index f = 0; f < a_.face_count; ++f) m.faces[f] = Mark(is(windings_[f]));
    return closed_set(m);
  }
  /// The edges along which the number is the same on both sides, but for those where two outer loops of different
  /// rings lie side by side.
  Region run_back(const std::vector<Loop>& loops) const;

 private:
  Arrangement arranged(const std::vector<Loop>& loops, std::span<const std::size_t> chosen);
  Marks no_marks() const;
  Region closed_set(const Marks& marks) const;
  bool is_shared_side(const std::vector<Loop>& loops, Index edge) const;

  std::vector<std::size_t> loop_;  // of each piece
  std::vector<char> forward_;      // the same
  Arrangement a_;
  std::vector<std::int32_t> windings_;  // of each face
};

}  // namespace findspace::plane
