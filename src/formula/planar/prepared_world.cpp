// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/prepared_world.h"

#include <fmt/format.h>

#include "distance/planar/shape_pair.h"
#include "findspace/error.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::formula {

std::optional<distance::Extremum> LeastValues::find(const std::string& text) const {
  std::lock_guard lock(guard_);
  auto found = known_.find(text);
  return found == known_.end() ? std::nullopt : std::optional(found->second);
}

distance::Extremum LeastValues::keep(const std::string& text, distance::Extremum value) {
  std::lock_guard lock(guard_);
  return known_.emplace(text, std::move(value)).first->second;
}

PreparedWorld::PreparedWorld(World world) : world_(std::move(world)) {
  // Distances are those of closed sets.
  for (auto& [name, region] : world_.shapes) {
    region = plane::closure(std::move(region));
    const auto box = plane::is_bounded(region) ? plane::extent(region) : std::nullopt;
    if (!box) continue;
    boxes_.emplace(name, *box);
    if (region.faces[0].inner.size() + region.faces[0].isolated.size() > 1)
      boundary_components_.emplace(name, plane::BoundaryComponents(region));
  }
}

plane::Region PreparedWorld::shape(const std::vector<std::string>& names) const {
  std::vector<const plane::Region*> parts;
  for (const std::string& n : names) {
    auto found = world_.shapes.find(n);
    if (found == world_.shapes.end()) throw Error(ErrorCode::kUnknownName, "there is no shape '" + n + "'");
    parts.push_back(&found->second);
  }
  plane::Region whole = parts.size() == 1 ? *parts[0] : plane::unite(parts);
  if (plane::is_empty(whole) && !world_.eroded)
    throw Error(ErrorCode::kGeometry,
                fmt::format("shape '{}' is empty: there is no distance to it", fmt::join(names, "+")));
  return whole;
}

const plane::PieceBox* PreparedWorld::box(const std::string& name) const {
  auto found = boxes_.find(name);
  return found == boxes_.end() ? nullptr : &found->second;
}

const plane::BoundaryComponents* PreparedWorld::boundary_components(const std::string& name) const {
  auto found = boundary_components_.find(name);
  return found == boundary_components_.end() ? nullptr : &found->second;
}

Roles PreparedWorld::roles(const Distance& wanted) const {
  Roles r;
  r.wanted = moving_first(wanted, world_.moving);
  const Distance& d = r.wanted;
  r.second_moves = second_is_moving(d, world_.moving);
  r.names = r.second_moves ? ShapeNames{d.second, d.first} : ShapeNames{d.first, d.second};
  if (!world_.motion.given()) return r;
  r.path = relative_path(world_.motion, r.names.first, r.names.second);
  r.rotating = rotations(common_trajectory(world_.motion, r.names.first)) ||
               rotations(common_trajectory(world_.motion, r.names.second));
  return r;
}

distance::Which PreparedWorld::which(const Distance& d) const {
  return formula::which(d.kind, second_is_moving(d, world_.moving));
}

std::shared_ptr<const distance::AtPosition> PreparedWorld::pair(const ShapeNames& names) const {
  std::lock_guard lock(guard_);
  auto& slot = pairs_[names];
  if (!slot)
    slot = std::make_shared<distance::AtPosition>(
        std::make_shared<distance::ShapePair>(shape(names.first), shape(names.second)));
  return slot;
}

}  // namespace findspace::formula
