// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where moving contact curves meet: the half angles at which two meet at a given distance from the origin, at which
// three meet in one point; and the meeting points of curves at an angle, rough and exact. Guarantee: as of its parts.
// Keywords: concurrency, circumcircle, radical line.
#pragma once

#include <array>
#include <optional>

#include "plane/contact_curves.h"

namespace findspace::plane {

std::vector<double> corner_roots(const SectorCurve& c, const SectorCurve& d, double level, double span);
std::vector<double> meeting_roots(const SectorCurve& c, const SectorCurve& d, const SectorCurve& e, double span);

/// Of the whole lines and circles.
std::vector<RoughPoint> rough_meetings(const RoughCurve& c, const RoughCurve& d);
std::vector<RealVector> exact_meetings(const ExactCurve& c, const ExactCurve& d);
/// The point that all three pass within `room`, if they hold a body there: no direction leads away from all of them.
std::optional<RoughPoint> rough_meeting(const std::array<RoughCurve, 3>& curves, double room);

}  // namespace findspace::plane
