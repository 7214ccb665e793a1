// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The positions of which an explanation speaks, as far as it asks about them: in the plane by exact regions
// (planar_ground.cpp), in space by boxes or by a search (space_ground.cpp). Over angles the angles, by exact maps of
// the circle (angle_ground.cpp), over time the instants, by exact sections of paths (time_ground.cpp). A ground may
// learn from what it is asked. Threads: one question at a time. Internal to explain.h. Keywords: oracle, feasibility.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "exact/number/tried.h"
#include "formula/explain/explain.h"

namespace findspace::formula {

/// A demand that counts as met everywhere, or nowhere.
struct AssumedDemand {
  std::size_t atom = 0;
  bool met = true;
};

/// What the signs of the sign maps at a place say of the demands.
MetDemands met_at(const Demands& demands, std::span<const plane::Mark> signs);
/// Whether the formula holds there without demand k, and its distance minus the level has `sign`; 0: any.
bool holds_without(const Demands& demands, std::span<const plane::Mark> signs, std::size_t k, int sign);

class Ground {
 public:
  virtual ~Ground() = default;
  /// Whether the formula holds somewhere. Refused where that is not decided.
  virtual exact::Tried<bool> room(const std::optional<AssumedDemand>& assumed) = 0;
  /// Precondition: the formula holds nowhere.
  virtual Conflict conflict() = 0;
  /// The best value of the distance of demand k over the positions that the formula has without this demand, of those
  /// where the distance minus the level has `sign`; 0 for all.
  virtual LevelChange best(std::size_t k, int sign, distance::Sense sense) = 0;
  /// As common_relaxation.h.
  virtual CommonRelaxation together(const std::optional<exact::Real>& enough) = 0;
};

/// Whether the formula holds in one of some cells.
bool has_room(FailingCells& cells, const std::optional<AssumedDemand>& assumed);

/// A ground of finitely many cells, in each of which the same demands are met.
class KnownCells : public Ground {
 public:
  explicit KnownCells(const Demands& demands) : demands_(demands) {}
  exact::Tried<bool> room(const std::optional<AssumedDemand>& assumed) override { return has_room(*cells_, assumed); }
  Conflict conflict() override { return find_conflict(*cells_); }

 protected:
  const Demands& demands() const { return demands_; }
  /// What is met in them; before any question.
  void know(const std::set<MetDemands>& cells) {
    cells_.emplace(demands_, std::vector<MetDemands>(cells.begin(), cells.end()));
  }

 private:
  const Demands& demands_;
  std::optional<FailingCells> cells_;
};

/// The level of demand k goes to the best value of its distance, where there is one.
LevelChange changed(const Demands& demands, std::size_t k, const distance::OptimalValue& best, bool attained);

/// All keep references to the arguments. Of the plane: all positions at some poses.
std::unique_ptr<Ground> planar_ground(Poses poses, const Demands& demands);
/// All angles at a position. Throws Error(kUnsupported) for distances that are not known exactly over them.
std::unique_ptr<Ground> angle_ground(const RotationMaps& maps, const Demands& demands);
/// All instants of the motion at a position, in grid steps. Throws Error(kUnsupported) where shapes rotate in time.
std::unique_ptr<Ground> time_ground(const PreparedWorld& world, const exact::RealPoint& p, const Demands& demands);
/// Boxes where all sign maps are made of them. Throws Error(kUnsupported) for distances that are not those of all
/// directions, and for `-> min`.
std::unique_ptr<Ground> space_ground(const SpaceSolver& solver, const Demands& demands);

}  // namespace findspace::formula
