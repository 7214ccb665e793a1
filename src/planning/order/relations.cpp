// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/order/relations.h"

#include <algorithm>

#include "formula/language/evaluate.h"
#include "formula/planar/least_values.h"
#include "formula/planar/position_functions.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/query/locate.h"
#include "plane/query/moved.h"
#include "plane/sum/minkowski.h"

namespace findspace::planning {

using exact::RealPoint;
using formula::Distance;
using plane::CellComplex;
using plane::Mark;
using plane::Region;

namespace {

/// The body of a list of names, if they move.
std::optional<std::size_t> body_of(const std::vector<std::string>& names, const Roles& roles) {
  auto found = roles.find(names.front());
  return found == roles.end() ? std::nullopt : std::optional(found->second.body);
}

std::vector<std::string> world_names(const std::vector<std::string>& names, const Roles& roles, const Problem& problem,
                                     const Poses& angles) {
  std::vector<std::string> out;
  for (const std::string& name : names) {
    auto found = roles.find(name);
    if (found == roles.end()) {
      out.push_back(name);
      continue;
    }
    const Role& role = found->second;
    const auto& variant = problem.bodies[role.body].variants[angles[role.body]->angle];
    if (role.shape)
      out.push_back(variant[*role.shape]);
    else
      out.insert(out.end(), variant.begin(), variant.end());
  }
  return out;
}

RealPoint minus(const RealPoint& p, const RealPoint& q) { return {p.x - q.x, p.y - q.y}; }

}  // namespace

std::vector<std::size_t> bodies_of(const formula::Formula& formula, const Roles& roles) {
  std::set<std::size_t> found;
  for (const formula::SignMap& m : formula.sign_maps())
    for (const auto* names : {&m.distance.first, &m.distance.second})
      if (auto body = body_of(*names, roles)) found.insert(*body);
  return {found.begin(), found.end()};
}

bool is_single(const Condition& condition) {
  const std::size_t all = bodies_of(*condition.formula, condition.roles).size();
  if (all <= 1) return true;
  if (all > 2) return false;
  return std::all_of(condition.formula->sign_maps().begin(), condition.formula->sign_maps().end(), [&](const auto& m) {
    return body_of(m.distance.first, condition.roles) && body_of(m.distance.second, condition.roles);
  });
}

Relations::Relations(const Problem& problem) : problem_(problem), solver_(problem.world) {}

Relations::Bound Relations::bind(const Distance& distance, const Roles& roles, const Poses& angles) const {
  Bound out{distance, body_of(distance.first, roles), body_of(distance.second, roles)};
  out.distance.first = world_names(distance.first, roles, problem_, angles);
  out.distance.second = world_names(distance.second, roles, problem_, angles);
  return out;
}

plane::SignMap Relations::sign_map(const Distance& distance, const formula::SignMap& wanted) const {
  if (!wanted.minimum)
    return position_function(solver_.prepared(), distance)->sign_map(wanted.level / problem_.world.step);
  return formula::minimiser_map(formula::least(solver_.prepared(), distance));
}

BoxedPointer Relations::set(const Condition& condition, const Poses& angles) const {
  Key key{condition.formula.get(), {}, {}};
  auto& [formula, names, subtracted] = key;
  // The roles decide which name is which body, and which body's position is subtracted; the names of their variants
  // decide the rest.
  const std::vector<std::size_t> bodies = bodies_of(*condition.formula, condition.roles);
  for (const auto& [name, role] : condition.roles) {
    const auto& variant = problem_.bodies[role.body].variants[angles[role.body] ? angles[role.body]->angle : 0];
    names.push_back(name);
    names.insert(names.end(), variant.begin(), variant.end());
    subtracted.push_back(bodies.size() > 1 && role.body == bodies.back());
  }
  {
    std::lock_guard lock(guard_);
    if (auto found = sets_.find(key); found != sets_.end()) return found->second;
  }
  Region region = relative(condition, angles);
  auto box = plane::extent(region);
  auto made = std::make_shared<BoxedRegion>(BoxedRegion{std::move(region), box});
  std::lock_guard lock(guard_);
  return sets_.emplace(std::move(key), std::move(made)).first->second;
}

Region Relations::relative(const Condition& condition, const Poses& angles) const {
  const auto& formula = *condition.formula;
  std::vector<plane::SignMap> maps;
  for (const formula::SignMap& m : formula.sign_maps()) {
    const Bound bound = bind(m.distance, condition.roles, angles);
    plane::SignMap map = sign_map(bound.distance, m);
    const bool backwards = bound.first && bound.second && *bound.first > *bound.second;
    maps.push_back(backwards ? plane::mirrored(map) : std::move(map));
  }
  if (maps.empty()) return CellComplex::uniform(evaluate(formula, {}));
  std::vector<const CellComplex*> operands;
  for (const auto& m : maps) operands.push_back(&m);
  return plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
}

plane::SignMap Relations::seen(const formula::SignMap& map, const Condition& condition, std::size_t body,
                               const Poses& poses) const {
  const Bound bound = bind(map.distance, condition.roles, poses);
  plane::SignMap sign = sign_map(bound.distance, map);
  if (bound.first && bound.second) {
    if (*bound.first == body) return plane::moved(std::move(sign), poses[*bound.second]->at);
    if (*bound.second == body) return plane::moved(plane::mirrored(sign), poses[*bound.first]->at);
    return CellComplex::uniform(mark_of(sign, locate(sign, minus(poses[*bound.first]->at, poses[*bound.second]->at))));
  }
  const std::size_t only = bound.first ? *bound.first : *bound.second;
  return only == body ? sign : CellComplex::uniform(mark_of(sign, locate(sign, poses[only]->at)));
}

Region Relations::general(const Condition& condition, std::size_t body, const Poses& poses) const {
  const auto& formula = *condition.formula;
  std::vector<plane::SignMap> maps;
  for (const formula::SignMap& m : formula.sign_maps()) maps.push_back(seen(m, condition, body, poses));
  std::vector<const CellComplex*> operands;
  for (const auto& m : maps) operands.push_back(&m);
  return plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
}

std::optional<Region> Relations::allowed_within(const Condition& condition, std::size_t body, const Poses& poses,
                                                const std::optional<plane::PieceBox>& where) const {
  if (!is_single(condition)) return general(condition, body, poses);
  const std::vector<std::size_t> bodies = bodies_of(*condition.formula, condition.roles);
  const BoxedPointer found = set(condition, poses);
  const bool everywhere = found->region.faces[0].mark > 0;
  if (!found->box) return everywhere ? std::nullopt : std::optional(found->region);
  if (bodies.size() < 2) return found->region;
  const RealPoint& other = poses[bodies[0] == body ? bodies[1] : bodies[0]]->at;
  const bool rotated = bodies[1] == body;  // the set is of p_0 - p_1
  plane::PieceBox box = *found->box;
  if (rotated) box = {-box.x1, -box.y1, -box.x0, -box.y0};
  if (where && !plane::moved(box, other).meets(*where))
    return everywhere ? std::nullopt : std::optional(CellComplex::uniform(0));
  return plane::moved(rotated ? plane::mirrored(found->region) : found->region, other);
}

Region Relations::allowed(const Condition& condition, std::size_t body, const Poses& poses) const {
  auto region = allowed_within(condition, body, poses, std::nullopt);
  return region ? std::move(*region) : CellComplex::uniform(1);
}

}  // namespace findspace::planning
