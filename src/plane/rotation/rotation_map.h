// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The result type on the circle of angles: a finite partition into single angles and open arcs, each with a mark; what
// a CellComplex is in the plane. With marks 0/1 a set of angles, with -1/0/+1 the sign of a distance minus its level.
//
// Guarantee: exact, isolated angles and missing ones included. Cost: linear but for the sorting of angles.
// Source: distances.md 7.2. Keywords: circular intervals, periodic set, angular interval.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "exact/planar/angle.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// Invariant: `at` ascends in [0, 360); here[k] is the mark at at[k], after[k] that of the open arc from there to the
/// next. Nothing can be merged: no angle has its own mark on both sides.
struct RotationMap {
  std::vector<exact::Angle> at;
  std::vector<Mark> here, after;
  Mark everywhere = 0;  // where `at` is empty

  static RotationMap uniform(Mark mark) { return {{}, {}, {}, mark}; }
  Mark before(std::size_t k) const { return k > 0 ? after[k - 1] : after.back(); }
};

/// Without the angles that carry the mark of both sides.
RotationMap merged(RotationMap map);
/// The map with marks rule(marks), marks[k] being that of operand k.
RotationMap overlay(std::span<const RotationMap* const> operands,
                    const std::function<Mark(std::span<const Mark>)>& rule);
RotationMap remark(const RotationMap& map, const std::function<Mark(Mark)>& rule);
/// A set with the ends that it lacks.
RotationMap closure(RotationMap set);
/// The mark at a single angle: the k-th of some events, with the place 2 k, or one on the arc after it, 2 k + 1.
using AngleMark = std::function<Mark(std::size_t place, const exact::ExactAngle&)>;
/// The marks at angles that ascend, each once, and between them, where a set has them or some that lie there; elsewhere
/// any. `look` makes what one thread asks. Work that looks count is counted for the question. Threads: uses several.
RotationMap marks_within(const RotationMap& set, const std::vector<exact::ExactAngle>& events,
                         const std::function<AngleMark()>& look);
/// The map as seen after all angles grew by that many degrees.
RotationMap shifted(const RotationMap& map, const exact::Real& degrees);
/// The map of -angle.
RotationMap mirrored(const RotationMap& map);
Mark mark_at(const RotationMap& map, const exact::Angle& angle);

/// From an angle counter-clockwise to another, which is the same for a single angle, or for the circle without it if
/// both ends are out.
struct RotationInterval {
  exact::Angle from, to;
  bool from_in = false, to_in = false;
  bool round = false;  // from and to are one angle, and all others lie between

  /// Both ends: `from` in [0, 360), `to` in [from, from + 360].
  std::array<double, 2> degrees() const;
};

/// The maximal intervals of the angles with marks other than 0, by their place in [0, 360). The whole circle is [0, 0),
/// round.
std::vector<RotationInterval> intervals(const RotationMap& set);

}  // namespace findspace::plane
