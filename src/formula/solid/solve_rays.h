// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A formula over solids of any shape, on the lines of a grid: each sign map of the formula on rays, laid over each
// other line by line, and the formula read off their signs in one pass. Surfaces are taken as they are
// where they answer (surface_rays.h); everything else goes by the convex parts of the shapes
// (distance/rays/ray_signs.h, which says what is refused). Guarantee: exact on every line. Cost: one convolution a pair
// of solids and axis, or the pieces of the sets of positions. Keywords: feasible region, configuration space.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "distance/answer/way.h"
#include "distance/rays/ray_covers.h"
#include "formula/language/formula.h"
#include "formula/solid/side.h"
#include "plane/query/section.h"
#include "space/body/body.h"
#include "space/convolution/ray_solids.h"
#include "space/rays/ray_map.h"
#include "space/rays/ray_sources.h"

namespace findspace::formula {

/// A shape as closed surfaces, or as convex parts, each made when first asked for.
class RayShape {
 public:
  explicit RayShape(plane::ShapePtr shape) : shape_(std::move(shape)) {}
  /// Null where the shape is not a union of solids.
  const std::vector<space::RaySolid>* solids() const;
  /// Refused for shapes that have none.
  exact::Tried<const space::Body*> try_body() const;
  /// Whether it goes on for ever.
  bool outside() const;
  const plane::ShapePtr& stated() const { return shape_; }
  /// The box around it, or around what it is the complement of.
  void extend_box(space::Point& low, space::Point& high, bool& any) const;

 private:
  struct Made {
    std::once_flag solids_once, body_once;
    std::optional<std::vector<space::RaySolid>> solids;
    std::optional<exact::Tried<std::shared_ptr<const space::Body>>> body;
  };
  plane::ShapePtr shape_;
  std::shared_ptr<Made> made_ = std::make_shared<Made>();
};

/// Bodies of the shapes of two lists of names, the moving ones first, each pair made when first asked for. A copy has
/// none, as its shapes may become others. Threads: safe.
class KeptBodies {
 public:
  using Names = std::vector<std::string>;
  using Pointer = std::shared_ptr<const distance::BodiesOnLines>;
  KeptBodies() = default;
  KeptBodies(const KeptBodies& /*other*/) {}
  KeptBodies& operator=(const KeptBodies& other);

  exact::Tried<Pointer> of(const Names& moving, const Names& fixed,
                           const std::function<exact::Tried<Pointer>()>& make) const;

 private:
  mutable std::mutex guard_;
  mutable std::map<std::pair<Names, Names>, exact::Tried<Pointer>> made_;
};

struct RayWorld {
  std::map<std::string, RayShape> shapes;
  std::vector<std::string> moving;
  exact::Real step;  // one grid step in the scene's unit
  KeptBodies bodies{};
};

/// A box (grid steps) beyond which no sign of the formula changes.
struct RayWindow {
  space::Point low, high;
};
RayWindow window(const RayWorld& world, const Formula& formula);

/// -1 where the formula holds, +1 elsewhere, and on which side of the region the lines may be.
struct RegionOnLines {
  space::RaySourcePointer rays;
  Side side = Side::kExact;
};
/// Keeps a reference to the formula.
exact::Tried<RegionOnLines> try_ray_region(const RayWorld& world, const Formula& formula, const space::RayGrid& grid);
RegionOnLines ray_region(const RayWorld& world, const Formula& formula, const space::RayGrid& grid);

/// The one line along an axis through p; nothing where its coordinates are not fractions of small denominators.
std::optional<space::RayGrid> grid_through(const space::RealVector& p, int axis);

/// The signs of one sign map along a line.
struct LineSigns {
  plane::Section section;
  bool searched = false;  // 0 means near the level as well as at it
  distance::Way way = distance::Way::kLines;
};
/// Along line (0, 0) of the grid, in parts of a step.
exact::Tried<LineSigns> signs_on_line(const RayWorld& world, const SignMap& map, const space::RayGrid& grid);

/// The sign of one sign map at p (grid steps), from the line along z through it; nothing where there is no such
/// grid, or where the sign is not certain.
exact::Tried<std::optional<int>> sign_at_position(const RayWorld& world, const SignMap& map,
                                                  const space::RealVector& p);

/// Whether the formula holds far away.
bool holds_far_away(const RayWorld& world, const Formula& formula);

}  // namespace findspace::formula
