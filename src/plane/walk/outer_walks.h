// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The closed walks along the outer sides of directed curves, against their way, that turn at every crossing and never
// pass an inner side: those that bound the union of what lies on inner sides are among them. Guarantee: exact. Cost:
// linear in the parts of curves. Source: Behar & Lien 2011. Keywords: outer loops.
#pragma once

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

  /// Where there are many curves, ranges of them are looked at at once, and short ways to an inner side are known
  /// afterwards.
  void close_short_ways();
  void close_short_way(CurvePart from);
  /// The part before, or no curve where the walk would pass an inner side.
  CurvePart before(CurvePart at) const;

  const MeetingCurves& curves_;
  ArenaVector<Index> walk_of_;  // part -> the walk that has passed it first, or kNone
  Index walks_ = 0;
  Index tried_ = 0, curve_ = 0;  // parts, and the curve of one that was tried
  ArenaVector<CurvePart> parts_;
};

}  // namespace findspace::plane
