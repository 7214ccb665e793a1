// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/turning_positions.h"

#include "plane/moved.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::Region;

namespace {

const Real kLeg(30);  // degrees

class Turned {
 public:
  Turned(const Region& b, const Region& a, Which which, const RealPoint& centre)
      : b_(b), a_(plane::moved(a, {-centre.x, -centre.y})), which_(plain_of(which)), centre_(centre) {}

  /// The extremum of the plain distance while B turns from one angle to another, against 0.
  BoundedMaps over(const Real& from, const Real& to, Sense sense) const {
    std::vector<TurningPose> poses{pose(from)};
    for (Real at = from + kLeg; at < to; at += kLeg) poses.push_back(pose(at));
    poses.push_back(pose(to));
    return turning_maps(b_, a_, which_, poses, sense, Real());
  }

 private:
  TurningPose pose(const Real& degrees) const { return {{-centre_.x, -centre_.y}, Real(), -degrees}; }

  const Region& b_;
  Region a_;
  Which which_;
  RealPoint centre_;
};

}  // namespace

BoundedMaps turning_position_maps(const Region& b, const Region& a, Which which, const RealPoint& centre,
                                  const Real& level) {
  const Turned turned(b, a, which, centre);
  return rotational_bounds(which, level, plane::SignMap::uniform(1),
                           [&](const Real& from, const Real& to, Sense sense) { return turned.over(from, to, sense); });
}

}  // namespace findspace::distance
