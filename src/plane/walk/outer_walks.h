// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The closed walks along the outer sides of directed curves, against their way, that turn at every crossing and never
// pass an inner side: those that bound the union of what lies on inner sides are among them. Guarantee: exact. Cost:
// linear in the parts of curves. Source: Behar & Lien 2011. Keywords: outer loops.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plane/walk/meeting_curves.h"

namespace findspace::plane {

class OuterWalks {
 public:
  OuterWalks(const MeetingCurves& curves, Memory memory)
      : curves_(curves), walk_of_(curves.part_count(), kNone, memory), parts_(memory) {
    parts_.reserve(curves.size());
  }

  /// The walk from a part of a curve, if it is closed and new.
  std::span<const CurvePart> walk(CurvePart from);
  /// The first closed walk that is new, of those from parts that come after all that were tried; empty: none is left.
  std::span<const CurvePart> next();

 private:
  static constexpr Index kShort = kNone - 1;  // no walk, but a short way to an inner side

  /// The curves with parts from which a walk may be closed, in order: where there are many curves, ranges of them are
  /// looked at at once, and short ways to an inner side are known afterwards. Nothing where all may have some.
  std::optional<std::vector<Index>> candidates();
  /// Whether some part of the curve is left, after those from which a way soon ends are known as inner.
  bool is_candidate(Index curve);
  void close_short_way(CurvePart from);
  /// The part before, or no curve where the walk would pass an inner side.
  CurvePart before(CurvePart at) const;

  const MeetingCurves& curves_;
  std::pmr::vector<Index> walk_of_;  // part -> the walk that has passed it first, or kNone
  Index walks_ = 0;
  std::optional<std::vector<Index>> candidates_;
  Index tried_ = 0, tried_slots_ = 0;  // candidates, and parts of the next one
  std::pmr::vector<CurvePart> parts_;
};

}  // namespace findspace::plane
