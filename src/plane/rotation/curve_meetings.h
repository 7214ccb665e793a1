// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where moving contact curves meet: places of the half angle in which two meet at a given distance from the origin, or
// three in one point; and the meeting points of curves at an angle, rough and exact. Guarantee: no meeting lies outside
// the places, and every rough meeting says how far it may be off; exact ones are exact.
#pragma once

#include <array>
#include <optional>

#include "plane/rotation/contact_curves.h"

namespace findspace::plane {

std::vector<RootPlace> corner_places(const SectorCurve& c, const SectorCurve& d, double level, double span);
std::vector<RootPlace> meeting_places(const SectorCurve& c, const SectorCurve& d, const SectorCurve& e, double span);

struct RoughMeeting {
  RoughPoint at;
  double off = 0;
};

/// Of the whole lines and circles, which doubles give up to `error`. Nothing of two curves that coincide.
std::vector<RoughMeeting> rough_meetings(const RoughCurve& c, const RoughCurve& d, double error);
std::vector<RealVector> exact_meetings(const ExactCurve& c, const ExactCurve& d);
/// The points of a curve nearest to the origin and farthest from it, within `tolerance`; of a circle about the origin,
/// all of whose points are as far, one of each of its ends.
std::vector<RoughPoint> rough_projections(const RoughCurve& c, double tolerance);
/// Of the whole line or circle, the one that is near `at`.
RealVector exact_projection(const ExactCurve& c, RoughPoint at);
/// The meeting near `at`; nothing where the curves do not meet after all.
std::optional<RealVector> exact_meeting(const ExactCurve& c, const ExactCurve& d, RoughPoint at);
/// The point that all three pass within `tolerance`, if they hold a body there: no direction leads away from all of
/// them.
std::optional<RoughPoint> rough_meeting(const std::array<RoughCurve, 3>& curves, double tolerance);

}  // namespace findspace::plane
