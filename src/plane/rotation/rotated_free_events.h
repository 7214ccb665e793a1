// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The angles at which the least or greatest distance of a free position can cross a level (rotated_free.h): where a
// contact is exactly that far away, where two contact curves touch, where two meet exactly that far away, where three
// meet in one point; on a way, where a curve touches it and where two meet on it. Guarantee: all of them, exact, some
// too many; ascending, each once. Cost: the circle is cut into sectors until few curves are left in each; there pairs
// and triples, by a filter in doubles first. Keywords: critical orientation.
#pragma once

#include "plane/rotation/free_way.h"

namespace findspace::plane {

/// What the cosine of an angle is: the deeper, the more exact work costs there.
enum class AngleDepth { kRational, kClosed, kRationalRoot, kClosedRoot, kDeepRoot };
inline constexpr std::size_t kAngleDepths = 5;

struct FreeEvent {
  double degrees = 0;
  exact::ExactAngle rotation;
  AngleDepth depth = AngleDepth::kRational;
};

struct FreeQuestion {
  const ContactCurves& curves;
  const RoughSet& rotating;  // B
  const RoughSet& open;      // O
  bool either_way;           // surely_meets
  exact::Real level;
  bool far;
  double tolerance;              // lengths below it are nothing to the filter
  const FreeWay* way = nullptr;  // only positions on it
};

std::vector<FreeEvent> free_events(const FreeQuestion& question);

}  // namespace findspace::plane
