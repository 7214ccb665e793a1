// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The distances of a moving shape at a fixed position as functions of its angle: it is rotated about a point of its
// own, then moved. Plain distances: rotated_pair.h; along a direction: rotated_directional.h; with rotating=(x, y)
// degrees to the next contact: rotation.h. Guarantee: the exact set of angles, single ones and sliding contacts
// included. Throws Error(kUnsupported) for distances that are not computed over all angles. Keywords: angular interval,
// orientation map.
#pragma once

#include "distance/rotation/rotation_least.h"
#include "formula/planar/prepared_world.h"
#include "plane/rotation/rotation_map.h"

namespace findspace::formula {

class RotationMaps {
 public:
  /// `about` in the moving shape's own coordinates, both in grid steps. Keeps a reference to the world.
  RotationMaps(const PreparedWorld& world, exact::RealPoint about, exact::RealPoint at)
      : world_(world), about_(std::move(about)), at_(std::move(at)) {}

  const PreparedWorld& world() const { return world_; }
  const exact::RealPoint& about() const { return about_; }
  /// Where the point that the shape rotates about is in the scene.
  exact::RealPoint centre() const;

  /// The signs at the angles of a set; elsewhere any.
  plane::RotationMap sign_map(const SignMap& wanted,
                              const plane::RotationMap& within = plane::RotationMap::uniform(1)) const;
  /// {angle : the formula holds}. Distances that cost more are asked for where the others do not decide it.
  plane::RotationMap feasible(const Formula& formula) const;
  /// Where in a set of angles a distance is least or greatest; the value in the scene's unit, or in degrees.
  distance::RotationOptimum best(const Distance& distance, const plane::RotationMap& within,
                                 distance::Sense sense) const;

  /// The map of -, 0, + that a rotating distance about the centre is measured in.
  struct Contacts {
    plane::RotationMap base;
    bool farthest = false;  // measured to the farthest contact
  };
  Contacts contacts(const Distance& rotating) const;

  /// A distance in rotation about another point than the shape rotates about.
  bool rotations_twice(const Distance& distance) const;
  /// The same, where that matters at the level: feasible() is refused, rotation_bounds() is not.
  bool rotations_twice(const SignMap& wanted) const;
  bool rotations_twice(const Formula& formula) const;

 private:
  /// The more, the more its map costs. Throws what sign_map() does of the distance.
  int cost(const SignMap& wanted) const;
  plane::RotationMap directional_map(const Distance& wanted, const exact::Real& level) const;

  const PreparedWorld& world_;
  exact::RealPoint about_, at_;
};

/// The point that a distance in rotation names, in grid steps.
exact::RealPoint centre_of(const PreparedWorld& world, const Distance& rotating);
/// Throws Error(kUnsupported) for a distance over time.
void require_static(const Distance& distance);

}  // namespace findspace::formula
