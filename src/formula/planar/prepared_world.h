// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A world made ready for questions: its shapes closed, with their boxes, and what several questions share made once:
// pairs of shapes, least values, a few sign maps. Everything that answers formulas in the plane reads it. Threads:
// safe. Keywords: context, cache, workspace.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "distance/planar_least/extremum.h"
#include "formula/language/which.h"
#include "formula/planar/world.h"
#include "plane/complex/extent.h"
#include "plane/complex/shared_region.h"
#include "plane/query/boundary_components.h"

namespace findspace::distance {
class AtPosition;
class TurningShapes;
}  // namespace findspace::distance

namespace findspace::formula {

using ShapeNames = std::pair<std::vector<std::string>, std::vector<std::string>>;  // moving, fixed

/// Who moves in a distance, and along which relative path.
struct Roles {
  Distance wanted;  // with the moving shape first, where the distance allows it
  ShapeNames names;
  bool second_moves = false;
  Trajectory path;        // empty without a motion
  bool rotating = false;  // one of the shapes rotates in time
  distance::Which which() const { return formula::which(wanted.kind, second_moves); }
};

/// Least values over all positions, by the distance's text.
class LeastValues {
 public:
  std::optional<distance::Extremum> find(const std::string& text) const;
  /// The first that was kept under this text.
  distance::Extremum keep(const std::string& text, distance::Extremum value);
  /// Those whose text has none of the names in it.
  void take_over(const LeastValues& others, const std::vector<std::string>& without);

 private:
  mutable std::mutex guard_;
  std::map<std::string, distance::Extremum> known_;
};

/// The last sign maps that positions at a level asked for: a part that is dragged along a boundary asks again and
/// again.
class KeptMaps {
 public:
  using Pointer = std::shared_ptr<const plane::CellComplex>;
  /// Null where it is not kept.
  Pointer find(const SignMap& wanted) const;
  Pointer keep(const SignMap& wanted, plane::CellComplex map);

 private:
  static constexpr std::size_t kMost = 4;
  mutable std::mutex guard_;
  std::vector<std::pair<SignMap, Pointer>> kept_;  // the oldest first
};

/// Shapes in grid steps that are new, or replace others of their name; nothing: it is removed.
using ShapeChanges = std::map<std::string, std::optional<plane::Region>>;

class PreparedWorld {
 public:
  explicit PreparedWorld(World world);
  /// The same world but for some shapes; what does not speak of these is taken over. Cost: that of the changes.
  PreparedWorld(const PreparedWorld& before, ShapeChanges changes);

  const World& world() const { return world_; }
  const exact::Real& step() const { return world_.step; }
  const Motion& motion() const { return world_.motion; }
  /// The union of the named shapes, closed.
  plane::SharedRegion shape(const std::vector<std::string>& names) const;
  /// A box around a shape; none for one that is unbounded or empty.
  const plane::PieceBox* box(const std::string& name) const;
  /// A bounded shape's boundary_components, made when first asked for; none where it has not several.
  const plane::BoundaryComponents* boundary_components(const std::string& name) const;

  Roles roles(const Distance& wanted) const;
  /// Which distance of a pair a formula means, the moving shape being the first of the pair.
  distance::Which which(const Distance& moving_first) const;
  std::shared_ptr<const distance::AtPosition> pair(const ShapeNames& names) const;
  /// The shapes of a pair at instants of the motion, made when first asked for.
  using Turning = std::shared_ptr<const distance::TurningShapes>;
  Turning turning(const ShapeNames& names, const std::function<Turning()>& make) const;
  LeastValues& least_values() const { return least_values_; }
  KeptMaps& kept_maps() const { return kept_maps_; }

  /// A position of the scene in grid steps.
  exact::RealPoint steps(const exact::RealPoint& p) const { return {p.x / world_.step, p.y / world_.step}; }

 private:
  void prepare(const std::string& name);

  World world_;
  using Components = std::shared_ptr<const plane::BoundaryComponents>;

  std::map<std::string, plane::PieceBox> boxes_;  // of the bounded shapes
  mutable std::mutex guard_;
  mutable std::map<std::string, Components> boundary_components_;  // of those that have several and were asked for
  mutable std::map<ShapeNames, std::shared_ptr<const distance::AtPosition>> pairs_;
  mutable std::map<ShapeNames, Turning> turning_;
  mutable LeastValues least_values_;
  mutable KeptMaps kept_maps_;
};

}  // namespace findspace::formula
