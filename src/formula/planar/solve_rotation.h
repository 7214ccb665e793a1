// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over all angles of the moving shape, and at one pose. The moving shape B is rotated about a point of its
// own, then moved by a position: { at + about + rotated(b - about) : b in B }. All sign maps of a formula are laid over
// each other on the circle (rotation_maps.h); where only bounds are known: rotation_bounds.h. Keywords: angular
// interval, orientation map, rotational configuration space.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formula/planar/rotation_maps.h"
#include "formula/planar/solve.h"
#include "plane/build/transform.h"

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
  RotationSolver(const Solver& solver, Pose pose) : world_(solver.prepared()), pose_(std::move(pose)) {}

  /// Over all angles, about the point that the pose or the formula names; the angle of the pose plays no part.
  RotationMaps maps(const Formula& formula) const;
  /// Every atom of the formula at the pose. Values of plain distances are those of the rotated shape with its vertices
  /// on the grid.
  Check check(const Formula& formula) const;
  /// All distances of the rotated shape to every other, as Solver::measure(), and those that the formula names besides.
  std::vector<DistanceAt> measure(const Formula& formula, const WantedText& wanted = {}) const;
  /// The point the moving shape rotates about, in grid steps of its own coordinates; after check() or measure().
  const exact::RealPoint& about() const { return about_; }
  /// What was rounded by the last check.
  const plane::Rounding& rounding() const { return rounding_; }

 private:
  struct Met {
    DistanceAt distance;
    std::optional<plane::Mark> sign;  // of the distance minus the level, where it is decided
  };
  Met rotation_at(const RotationMaps& maps, const Distance& rotating, const exact::Real& level) const;
  /// About another point than the shape has been rotated about, at an angle that rounds it.
  Met rotation_elsewhere(const RotationMaps& maps, const Distance& rotating, const exact::Real& level) const;
  /// `-> min` over all angles, at the pose's.
  AtomAt check_atom(const RotationMaps& maps, const Formula& formula, std::size_t index) const;
  AtomAt check_least(const RotationMaps& maps, const Atom& atom) const;
  AtomAt check_plain(const RotationMaps& maps, const Formula& whole, std::size_t atom) const;
  exact::RealPoint point_of_rotation(const Formula& formula) const;
  const Solver& rotated_solver() const;

  const PreparedWorld& world_;
  Pose pose_;
  mutable exact::RealPoint about_;  // in grid steps, of the moving shape
  mutable std::unique_ptr<Solver> rotated_;
  mutable plane::Rounding rounding_;
};

/// Whether some distance of the formula is one in rotation.
bool has_rotations(const Formula& formula);

/// The world with its moving shapes rotated about a point of the grid.
World rotated_world(World world, const exact::RealPoint& about, const exact::Real& degrees, plane::Rounding& rounding);
using SharedSolver = std::shared_ptr<const Solver>;
/// One for each angle.
std::vector<SharedSolver> solvers_at(const World& world, const exact::RealPoint& about,
                                     std::span<const exact::Real> degrees, plane::Rounding& rounding);

}  // namespace findspace::formula
