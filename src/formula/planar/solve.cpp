// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "distance/planar/directional.h"
#include "distance/planar_least/directional_least.h"
#include "distance/planar_least/extremum.h"
#include "distance/planar_least/level_extremum.h"
#include "distance/rotation/over_time.h"
#include "findspace/error.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/language/which.h"
#include "plane/base/parallel.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using distance::ShapePair;
using distance::TDistancePointer;
using distance::Which;
using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;

namespace {

bool second_moves(const Distance& d, const World& world) {
  return d.first.empty() || std::find(world.moving.begin(), world.moving.end(), d.first[0]) == world.moving.end();
}

distance::Sense sense_of(const Distance& over_time) {
  return natural_extremum(over_time) == Extremum::kInf ? distance::Sense::kMinimum : distance::Sense::kMaximum;
}

/// gamma1 for gamma2, eta1 for eta2, delta1 for delta2: where the base map is.
Which signed_base(Kind kind) {
  const bool gamma = kind == Kind::kGamma1 || kind == Kind::kGamma2;
  const bool eta = kind == Kind::kEta1 || kind == Kind::kEta2;
  return gamma ? Which::kGamma1 : eta ? Which::kEta1 : Which::kDelta1;
}

/// 0 where the value is least, + elsewhere.
plane::SignMap minimisers(distance::Extremum least) {
  if (!least.exists) return CellComplex::uniform(1);
  return plane::remark(std::move(least.at), [](Mark k) { return Mark(k > 0 ? 0 : 1); });
}

}  // namespace

struct Solver::Cache {
  std::mutex guard;
  std::map<Names, std::shared_ptr<const distance::AtPosition>> pairs;
  std::map<std::string, distance::Extremum> least;  // by the distance's text
};

Solver::Solver(World world) : world_(std::move(world)), cache_(std::make_unique<Cache>()) {
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

Solver::~Solver() = default;

Which Solver::which(const Distance& d) const { return formula::which(d.kind, second_moves(d, world_)); }

plane::Region Solver::shape(const std::vector<std::string>& names) const {
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

std::shared_ptr<const distance::AtPosition> Solver::pair(const Names& names) const {
  std::lock_guard lock(cache_->guard);
  auto& slot = cache_->pairs[names];
  if (!slot)
    slot = std::make_shared<distance::AtPosition>(std::make_shared<ShapePair>(shape(names.first), shape(names.second)));
  return slot;
}

Solver::Roles Solver::roles(const Distance& wanted) const {
  Roles r;
  r.wanted = moving_first(wanted, world_.moving);
  const Distance& d = r.wanted;
  r.second_moves = formula::second_moves(d, world_);
  r.names = r.second_moves ? Names{d.second, d.first} : Names{d.first, d.second};
  if (!world_.motion.given()) return r;
  r.path = relative_path(world_.motion, r.names.first, r.names.second);
  r.rotating = rotations(common_trajectory(world_.motion, r.names.first)) ||
               rotations(common_trajectory(world_.motion, r.names.second));
  return r;
}

TDistancePointer Solver::plain(const Roles& r) const {
  return pair(r.names)->pair().distance(formula::which(r.wanted.kind, r.second_moves));
}

TDistancePointer Solver::searched(const Roles& r) const {
  return pair(r.names)->pair().searched(formula::which(r.wanted.kind, r.second_moves));
}

distance::PositionFunctionPointer Solver::of_instant(const Roles& r) const {
  const Distance& d = r.wanted;
  if (d.mode == Mode::kPlain) return plain(r);
  if (d.mode == Mode::kRotation)
    refuse(d, "distances in rotation are known between bounds only, and have no exact region here");
  auto base = pair(r.names)->pair().distance(signed_base(d.kind));
  const plane::SignMap& map = static_cast<const distance::SignedDistance&>(*base).base();
  if (is_farthest(d.kind)) return std::make_shared<distance::DirectionalFarthest>(map, direction(d));
  return std::make_shared<distance::DirectionalSigned>(map, direction(d));
}

distance::PositionFunctionPointer Solver::function(const Distance& wanted) const {
  const Roles r = roles(wanted);
  if (!world_.motion.given()) return of_instant(r);
  if (r.rotating) refuse(wanted, "shapes that turn in time have no exact region here");
  if (world_.instant && wanted.prefix == Extremum::kNone)
    return distance::at_instant(of_instant(r), position_at(r.path, *world_.instant));
  if (r.wanted.mode != Mode::kPlain) return distance::jumping_over_time(of_instant(r), r.path.path, sense_of(r.wanted));
  return over_its_time(wanted, plain(r));
}

std::vector<RealPoint> Solver::way(const Distance& wanted) const {
  if (!world_.motion.given()) return {RealPoint{}};
  return roles(wanted).path.path;
}

distance::PositionFunctionPointer Solver::over_its_time(const Distance& wanted, TDistancePointer of_pair) const {
  if (!world_.motion.given()) return of_pair;
  const Roles r = roles(wanted);
  return distance::over_time(std::move(of_pair), r.path.path, sense_of(r.wanted));
}

TDistancePointer Solver::distance(const Distance& wanted) const {
  if (wanted.mode != Mode::kPlain) refuse(wanted, "distances along a direction or in rotation are no objectives");
  if (world_.motion.given())
    refuse(wanted, "the least and greatest values over positions are not computed with a motion");
  return searched(roles(wanted));
}

plane::SignMap Solver::sign_map(const SignMap& asked) const {
  const SignMap wanted = plain_level(asked);
  if (!wanted.minimum) return function(wanted.distance)->sign_map(wanted.level / world_.step);
  return minimisers(least(wanted.distance));
}

distance::Extremum Solver::least_of_instant(const Roles& r) const {
  if (is_directional(r.wanted)) return least_directional(r);
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "the least value over positions at an instant is not computed in rotation");
  return distance::least(*searched(r));
}

distance::Extremum Solver::least_directional(const Roles& r) const {
  auto base = pair(r.names)->pair().distance(signed_base(r.wanted.kind));
  return distance::least_directional(static_cast<const distance::SignedDistance&>(*base).base(), direction(r.wanted),
                                     is_farthest(r.wanted.kind));
}

distance::Extremum Solver::least_over_time(const Distance& wanted) const {
  return level_extremum(*function(wanted), CellComplex::uniform(1), distance::Sense::kMinimum,
                        wanted.mode == Mode::kPlain);
}

distance::Extremum Solver::least(const Distance& wanted) const {
  std::string key = text(wanted);
  {
    std::lock_guard lock(cache_->guard);
    auto found = cache_->least.find(key);
    if (found != cache_->least.end()) return found->second;
  }
  const plane::Region whole = CellComplex::uniform(1);
  distance::Extremum e = is_bounded(wanted)       ? best_position(wanted, {whole, whole}, distance::Sense::kMinimum)
                         : world_.motion.given()  ? least_over_time(wanted)
                         : is_directional(wanted) ? least_directional(roles(wanted))
                                                  : distance::least(*distance(wanted));
  std::lock_guard lock(cache_->guard);
  return cache_->least.emplace(key, std::move(e)).first->second;
}

std::vector<plane::SignMap> Solver::sign_maps(const Formula& formula) const {
  std::vector<plane::SignMap> maps(formula.sign_maps().size());
  plane::parallel_for(maps.size(), [&](std::size_t k) { maps[k] = sign_map(formula.sign_maps()[k]); });
  return maps;
}

plane::Region Solver::feasible(const Formula& formula) const {
  std::vector<plane::SignMap> maps = sign_maps(formula);
  std::vector<const CellComplex*> operands;
  for (const auto& m : maps) operands.push_back(&m);
  if (operands.empty()) return CellComplex::uniform(evaluate(formula, {}));
  return plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
}

plane::Section Solver::instants(const Formula& formula, const RealPoint& position) const {
  const RealPoint p = steps(position);
  std::vector<plane::Section> lines(formula.sign_maps().size());
  plane::parallel_for(lines.size(), [&](std::size_t k) { lines[k] = instants(formula.sign_maps()[k], p); });
  lines.push_back(
      plane::Section::constant(world_.motion.start, world_.motion.end, 0));  // also where there are no atoms
  plane::Section line =
      overlay_sections(lines, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
  line.before = line.stops.back().after = 0;  // there is no time outside the motion
  return line;
}

plane::Section Solver::instants(const SignMap& asked, const RealPoint& p) const {
  const SignMap wanted = plain_level(asked);
  const Motion& motion = world_.motion;
  const bool whole_time = wanted.distance.prefix != Extremum::kNone;
  const Roles r = roles(wanted.distance);
  if (r.rotating) refuse(wanted.distance, "the instants of shapes that turn are known between bounds only");
  if (whole_time) {
    const plane::SignMap map = sign_map(wanted);
    return plane::Section::constant(motion.start, motion.end, mark_of(map, locate(map, p)));
  }
  const plane::SignMap map =
      wanted.minimum ? minimisers(least_of_instant(r)) : of_instant(r)->sign_map(wanted.level / world_.step);
  return plane::section_of_path(map, p, r.path.path, r.path.times);
}

}  // namespace findspace::formula
