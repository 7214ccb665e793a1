// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over all angles of the moving shape, and at one pose. The moving shape B is turned about a point of its
// own, then moved by a position: { at + about + turned(b - about) : b in B }. Plain distances are functions of the
// angle (turned_pair.h), those along a direction as well (turned_directional.h); those with turning=(x, y) count
// degrees to the next contact (turning.h). All sign maps of a
// formula are laid over each other on the circle. Guarantee: the exact set of angles, single ones and sliding contacts
// included. Throws Error(kUnsupported) for distances that are not computed over all angles. Keywords: angular interval,
// orientation map, rotational configuration space.
#pragma once

#include <map>
#include <memory>

#include "distance/rotation/turned_pair.h"
#include "distance/rotation/turning_levels.h"
#include "plane/build/transform.h"
#include "plane/rotation/turn_least.h"
#include "situation/planar/solve.h"

namespace findspace::situation {

/// Lengths in the scene's unit.
struct Pose {
  exact::RealPoint at;
  exact::Real degrees;
  std::optional<exact::RealPoint> about;  // without it the point about which distances of the formula turn, or the pole
};

class TurnSolver {
 public:
  /// At the pose's position; its angle is where check() looks.
  TurnSolver(const Solver& solver, Pose pose) : solver_(solver), pose_(std::move(pose)) {}

  /// {angle : the formula holds}; the angle of the pose plays no part.
  plane::TurnMap feasible(const Formula& formula) const;
  /// Some distance turns about another point than the shape does, at a level other than 0: feasible() is refused,
  /// feasible_bounds() is not.
  bool turns_twice(const Formula& formula) const;
  /// Angles that certainly and that possibly belong to feasible(formula).
  struct Bounds {
    plane::TurnMap inner, outer;
  };
  Bounds feasible_bounds(const Formula& formula) const;
  /// The least or greatest value over a set of angles that is known between bounds, or of a distance that is.
  struct Best {
    std::optional<double> value;  // in the scene's unit, or in degrees: of an angle of within.inner; or none
    double bound = 0;             // no angle of within.outer has a better one
    bool none = false;            // proven: there are no values, or none is the last
    plane::TurnMap possible;      // all best angles are among these
  };
  /// After feasible_bounds() or turns_twice().
  Best best(const Distance& distance, const Bounds& within, distance::Sense sense) const;
  /// A distance in rotation about another point than the shape turns about.
  bool turns_twice(const Distance& distance) const;
  /// Where in a set of angles a distance is least; with its least value in the scene's unit, or in degrees.
  plane::TurnLeast least(const Distance& distance, const plane::TurnMap& within) const;
  /// Where it is greatest, likewise.
  plane::TurnLeast greatest(const Distance& distance, const plane::TurnMap& within) const;
  /// Every atom of the formula at the pose. Values of plain distances are those of the turned shape with its vertices
  /// on the grid.
  Solver::Check check(const Formula& formula) const;
  /// All distances of the turned shape to every other, as Solver::measure(), and those that the formula names besides.
  std::vector<DistanceAt> measure(const Formula& formula) const;
  /// The point the moving shape turns about, in grid steps of its own coordinates; after check(), measure() or
  /// feasible().
  const exact::RealPoint& about() const { return about_; }
  /// What was rounded by the last check.
  const plane::Rounding& rounding() const { return rounding_; }

 private:
  struct Turned {
    distance::TurnedPair pair;
    distance::Which which;
  };
  plane::TurnMap sign_map(const SignMap& wanted) const;
  bool turns_twice(const SignMap& wanted) const;
  distance::BoundedTurns bounded_map(const SignMap& wanted) const;
  /// Its values over a set of angles: the better end is taken by an angle of `within`.
  distance::ValueRange values_twice(const Distance& distance, const plane::TurnMap& within,
                                    distance::Sense sense) const;
  distance::ValueRange values_over(const Distance& distance, const plane::TurnInterval& angles,
                                   distance::Sense sense) const;
  plane::TurnMap directional_map(const Distance& wanted, const exact::Real& level) const;
  /// The map of -, 0, + that a turning distance is measured in, and where on it the pose is.
  struct Circle {
    plane::TurnMap base;
    exact::Angle at;
    bool farthest = false;
  };
  Circle circle(const Distance& turning) const;
  Turned turned(const Distance& distance, const exact::RealPoint& about, const exact::RealPoint& to) const;
  exact::RealPoint centre(const Formula& formula) const;
  const Solver& turned_solver() const;
  struct Met {
    DistanceAt distance;
    plane::Mark sign;  // of the distance minus the level
  };
  Met turning_at(const Distance& turning, const exact::Real& level) const;
  /// `-> min` over all angles, at the pose's.
  AtomAt check_least(const Atom& atom) const;
  AtomAt check_plain(const Formula& whole, std::size_t atom) const;

  const Solver& solver_;
  Pose pose_;
  mutable exact::RealPoint about_;  // in grid steps, of the moving shape
  mutable std::unique_ptr<Solver> turned_;
  mutable plane::Rounding rounding_;
};

/// The world with its moving shapes turned about a point of the grid.
World turned_world(World world, const exact::RealPoint& about, const exact::Real& degrees, plane::Rounding& rounding);

}  // namespace findspace::situation
