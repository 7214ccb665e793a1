// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A line through the origin of the positions, or one half of it, on which a rotated set may move; it stands still, or
// rotates with the set. It meets contact curves as they meet each other, so it comes in the same forms. Guarantee:
// exact forms are exact, rough ones right to some ulps. Keywords: direction of motion.
#pragma once

#include "plane/rotation/contact_curves.h"

namespace findspace::plane {

struct FreeWay {
  RealVector along;  // of any length
  bool both_ways = true;
  bool rotations = false;

  /// The position that far along it (backwards: minus), seen from what it is fixed to.
  RealVector at(const exact::Real& distance) const;
  /// The unit vector along it at an angle.
  RoughPoint rough_unit(double angle) const;

  RoughCurve rough(double angle, double reach) const;
  ExactCurve exact(const exact::ExactAngle& rotation) const;
  SectorCurve sector(double middle) const;
  ExactSectorCurve exact_sector(int quarters) const;
};

}  // namespace findspace::plane
