// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over all angles of the moving shape, and at one pose. The moving shape B is rotated about a point of its
// own, then moved by a position: { at + about + rotated(b - about) : b in B }. Plain distances are functions of the
// angle (rotated_pair.h), those along a direction as well (rotated_directional.h); those with rotating=(x, y) count
// degrees to the next contact (rotating.h). All sign maps of a
// formula are laid over each other on the circle. Guarantee: the exact set of angles, single ones and sliding contacts
// included. Throws Error(kUnsupported) for distances that are not computed over all angles. Keywords: angular interval,
// orientation map, rotational configuration space.
#pragma once

#include <map>
#include <memory>

#include "distance/rotation/rotated_pair.h"
#include "distance/rotation/rotation_levels.h"
#include "formula/planar/solve.h"
#include "plane/build/transform.h"
#include "plane/rotation/rotation_least.h"

namespace findspace::formula {

/// Lengths in the scene's unit.
struct Pose {
  exact::RealPoint at;
  exact::Real degrees;
  std::optional<exact::RealPoint> about;  // without it the point about which distances of the formula turn, or the pole
};

class RotationSolver {
 public:
  /// At the pose's position; its angle is where check() looks.
  RotationSolver(const Solver& solver, Pose pose) : solver_(solver), pose_(std::move(pose)) {}

  /// {angle : the formula holds}; the angle of the pose plays no part.
  plane::RotationMap feasible(const Formula& formula) const;
  /// Some distance rotates about another point than the shape does, at a level other than 0: feasible() is refused,
  /// feasible_bounds() is not.
  bool rotations_twice(const Formula& formula) const;
  /// Angles that certainly and that possibly belong to feasible(formula).
  struct Bounds {
    plane::RotationMap inner, outer;
  };
  Bounds feasible_bounds(const Formula& formula) const;
  /// The least or greatest value over a set of angles that is known between bounds, or of a distance that is.
  struct Best {
    std::optional<double> value;  // in the scene's unit, or in degrees: of an angle of within.inner; or none
    double bound = 0;             // no angle of within.outer has a better one
    bool none = false;            // proven: there are no values, or none is the last
    plane::RotationMap possible;  // all best angles are among these
  };
  /// After feasible_bounds() or rotations_twice().
  Best best(const Distance& distance, const Bounds& within, distance::Sense sense) const;
  /// A distance in rotation about another point than the shape rotates about.
  bool rotations_twice(const Distance& distance) const;
  /// Where in a set of angles a distance is least; with its least value in the scene's unit, or in degrees.
  plane::RotationLeast least(const Distance& distance, const plane::RotationMap& within) const;
  /// Where it is greatest, likewise.
  plane::RotationLeast greatest(const Distance& distance, const plane::RotationMap& within) const;
  /// Every atom of the formula at the pose. Values of plain distances are those of the rotated shape with its vertices
  /// on the grid.
  Solver::Check check(const Formula& formula) const;
  /// All distances of the rotated shape to every other, as Solver::measure(), and those that the formula names besides.
  std::vector<DistanceAt> measure(const Formula& formula) const;
  /// The point the moving shape rotates about, in grid steps of its own coordinates; after check(), measure() or
  /// feasible().
  const exact::RealPoint& about() const { return about_; }
  /// What was rounded by the last check.
  const plane::Rounding& rounding() const { return rounding_; }

 private:
  struct Rotated {
    distance::RotatedPair pair;
    distance::Which which;
  };
  plane::RotationMap sign_map(const SignMap& wanted) const;
  bool rotations_twice(const SignMap& wanted) const;
  distance::BoundedRotations bounded_map(const SignMap& wanted) const;
  /// Its values over a set of angles: the better end is taken by an angle of `within`.
  distance::ValueRange values_twice(const Distance& distance, const plane::RotationMap& within,
                                    distance::Sense sense) const;
  distance::ValueRange values_over(const Distance& distance, const plane::RotationInterval& angles,
                                   distance::Sense sense) const;
  plane::RotationMap directional_map(const Distance& wanted, const exact::Real& level) const;
  /// The map of -, 0, + that a rotating distance is measured in, and where on it the pose is.
  struct Circle {
    plane::RotationMap base;
    exact::Angle at;
    bool farthest = false;
  };
  Circle circle(const Distance& rotating) const;
  Rotated rotated(const Distance& distance, const exact::RealPoint& about, const exact::RealPoint& to) const;
  exact::RealPoint centre(const Formula& formula) const;
  const Solver& rotated_solver() const;
  struct Met {
    DistanceAt distance;
    plane::Mark sign;  // of the distance minus the level
  };
  Met rotation_at(const Distance& rotating, const exact::Real& level) const;
  /// `-> min` over all angles, at the pose's.
  AtomAt check_least(const Atom& atom) const;
  AtomAt check_plain(const Formula& whole, std::size_t atom) const;

  const Solver& solver_;
  Pose pose_;
  mutable exact::RealPoint about_;  // in grid steps, of the moving shape
  mutable std::unique_ptr<Solver> rotated_;
  mutable plane::Rounding rounding_;
};

/// The world with its moving shapes rotated about a point of the grid.
World rotated_world(World world, const exact::RealPoint& about, const exact::Real& degrees, plane::Rounding& rounding);

}  // namespace findspace::formula
