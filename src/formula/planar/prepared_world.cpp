// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/prepared_world.h"

#include <fmt/format.h>

#include <algorithm>

#include "distance/planar/at_position.h"
#include "distance/planar/shape_pair.h"
#include "findspace/error.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

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

KeptMaps::Pointer KeptMaps::find(const SignMap& wanted) const {
  std::lock_guard lock(guard_);
  for (const auto& [map, made] : kept_)
    if (map == wanted) return made;
  return nullptr;
}

KeptMaps::Pointer KeptMaps::keep(const SignMap& wanted, plane::CellComplex map) {
  const auto made = std::make_shared<const plane::CellComplex>(std::move(map));
  std::lock_guard lock(guard_);
  if (kept_.size() == kMost) kept_.erase(kept_.begin());
  kept_.emplace_back(wanted, made);
  return made;
}

void LeastValues::take_over(const LeastValues& others, const std::vector<std::string>& without) {
  std::scoped_lock lock(guard_, others.guard_);
  for (const auto& [text, value] : others.known_) {
    const auto named = [&text = text](const std::string& name) { return text.find(name) != std::string::npos; };
    if (std::none_of(without.begin(), without.end(), named)) known_.emplace(text, value);
  }
}

PreparedWorld::PreparedWorld(World world) : world_(std::move(world)) {
  for (const auto& [name, region] : world_.shapes) prepare(name);
}

PreparedWorld::PreparedWorld(const PreparedWorld& before, ShapeChanges changes)
    : world_(before.world_), boxes_(before.boxes_) {
  std::vector<std::string> names;
  for (auto& [name, region] : changes) {
    names.push_back(name);
    boxes_.erase(name);
    if (!region) {
      world_.shapes.erase(name);
      continue;
    }
    world_.shapes.insert_or_assign(name, *std::move(region));
    prepare(name);
  }
  const auto changed = [&](const std::vector<std::string>& of) {
    return std::any_of(of.begin(), of.end(), [&](const std::string& name) { return changes.count(name) != 0; });
  };
  least_values_.take_over(before.least_values_, names);
  const std::lock_guard lock(before.guard_);
  for (const auto& [of, pair] : before.pairs_)
    if (!changed(of.first) && !changed(of.second)) pairs_.emplace(of, pair);
  for (const auto& [name, components] : before.boundary_components_)
    if (changes.count(name) == 0) boundary_components_.emplace(name, components);
}

/// Distances are those of closed sets.
void PreparedWorld::prepare(const std::string& name) {
  plane::SharedRegion& shape = world_.shapes.at(name);
  if (!plane::is_closed(shape)) shape = plane::closure(shape);
  const plane::Region& region = shape;
  const auto box = plane::is_bounded(region) ? plane::extent(region) : std::nullopt;
  if (box) boxes_.emplace(name, *box);
}

plane::SharedRegion PreparedWorld::shape(const std::vector<std::string>& names) const {
  std::vector<plane::SharedRegion> parts;
  for (const std::string& n : names) {
    auto found = world_.shapes.find(n);
    if (found == world_.shapes.end()) throw Error(ErrorCode::kUnknownName, "there is no shape '" + n + "'");
    parts.push_back(found->second);
  }
  std::vector<const plane::Region*> regions;
  for (const plane::SharedRegion& part : parts) regions.push_back(&*part);
  plane::SharedRegion whole = parts.size() == 1 ? parts[0] : plane::SharedRegion(plane::unite(regions));
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
  if (box(name) == nullptr) return nullptr;
  const plane::Region& region = world_.shapes.at(name);
  if (region.faces[0].inner.size() + region.faces[0].isolated.size() < 2) return nullptr;
  const std::lock_guard lock(guard_);
  Components& known = boundary_components_[name];
  if (!known) known = std::make_shared<const plane::BoundaryComponents>(region);
  return known.get();
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

PreparedWorld::Turning PreparedWorld::turning(const ShapeNames& names, const std::function<Turning()>& make) const {
  const std::lock_guard lock(guard_);
  Turning& slot = turning_[names];
  if (!slot) slot = make();
  return slot;
}

}  // namespace findspace::formula
