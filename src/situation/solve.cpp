// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>

#include "distance/directional.h"
#include "distance/directional_least.h"
#include "distance/extremum.h"
#include "distance/level_extremum.h"
#include "distance/over_time.h"
#include "distance/turning_positions.h"
#include "findspace/error.h"
#include "plane/nearest.h"
#include "plane/overlay.h"
#include "plane/parallel.h"
#include "plane/swept.h"
#include "plane/topology.h"
#include "situation/evaluate.h"
#include "situation/text.h"
#include "situation/which.h"

namespace findspace::situation {

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

/// gamma1 for gamma2, eta1 for eta2, delta1 for delta2: where the base map is.
Which signed_base(Kind kind) {
  const bool gamma = kind == Kind::kGamma1 || kind == Kind::kGamma2;
  const bool eta = kind == Kind::kEta1 || kind == Kind::kEta2;
  return gamma ? Which::kGamma1 : eta ? Which::kEta1 : Which::kDelta1;
}

bool is_farthest(Kind kind) { return kind == Kind::kGamma2 || kind == Kind::kEta2 || kind == Kind::kDelta2; }

[[noreturn]] void refuse(const Distance& d, const char* what) {
  throw Error(ErrorCode::kUnsupported, text(d) + ": " + what);
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
    if (box) boxes_.emplace(name, *box);
  }
}

Solver::~Solver() = default;

Which Solver::which(const Distance& d) const { return situation::which(d.kind, second_moves(d, world_)); }

plane::Region Solver::shape(const std::vector<std::string>& names) const {
  std::vector<const plane::Region*> parts;
  for (const std::string& n : names) {
    auto found = world_.shapes.find(n);
    if (found == world_.shapes.end()) throw Error(ErrorCode::kUnknownName, "there is no shape '" + n + "'");
    parts.push_back(&found->second);
  }
  plane::Region whole = parts.size() == 1 ? *parts[0] : plane::unite(parts);
  if (plane::is_empty(whole) && !world_.worn)
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
  r.second_moves = situation::second_moves(d, world_);
  r.names = r.second_moves ? Names{d.second, d.first} : Names{d.first, d.second};
  if (!world_.motion.given()) return r;
  r.path = relative_path(world_.motion, r.names.first, r.names.second);
  r.turning =
      turns(common_trajectory(world_.motion, r.names.first)) || turns(common_trajectory(world_.motion, r.names.second));
  return r;
}

TDistancePointer Solver::plain(const Roles& r) const {
  return pair(r.names)->pair().distance(situation::which(r.wanted.kind, r.second_moves));
}

distance::PositionFunctionPointer Solver::of_instant(const Roles& r) const {
  const Distance& d = r.wanted;
  if (d.mode == Mode::kPlain) return plain(r);
  if (d.mode == Mode::kTurning) refuse(d, "distances in rotation are not computed over a motion, nor as objectives");
  auto base = pair(r.names)->pair().distance(signed_base(d.kind));
  const plane::SignMap& map = static_cast<const distance::SignedDistance&>(*base).base();
  if (is_farthest(d.kind)) return std::make_shared<distance::DirectionalFarthest>(map, track(d));
  return std::make_shared<distance::DirectionalSigned>(map, track(d));
}

distance::PositionFunctionPointer Solver::function(const Distance& wanted) const {
  const Roles r = roles(wanted);
  if (!world_.motion.given()) return of_instant(r);
  if (r.turning) refuse(wanted, "shapes that turn in time have no exact region here");
  if (world_.instant && wanted.prefix == Extremum::kNone)
    return distance::at_instant(of_instant(r), position_at(r.path, *world_.instant));
  const bool least = natural_extremum(r.wanted) == Extremum::kInf;
  const distance::Sense sense = least ? distance::Sense::kMinimum : distance::Sense::kMaximum;
  if (r.wanted.mode != Mode::kPlain) return distance::jumping_over_time(of_instant(r), r.path.path, sense);
  return distance::over_time(plain(r), r.path.path, sense);
}

TDistancePointer Solver::distance(const Distance& wanted) const {
  if (wanted.mode != Mode::kPlain) refuse(wanted, "distances along a direction or in rotation are no objectives");
  if (world_.motion.given())
    refuse(wanted, "the least and greatest values over positions are not computed with a motion");
  return plain(roles(wanted));
}

namespace {

/// A rotational distance is on the same side of 0 as the plain one (and of the second kind nothing is known so simply).
bool is_plain_level(const SignMap& wanted) {
  return wanted.distance.mode == Mode::kTurning && wanted.level.sign() == 0 && !is_farthest(wanted.distance.kind);
}

}  // namespace

plane::SignMap Solver::sign_map(const SignMap& wanted) const {
  if (is_plain_level(wanted) && !wanted.minimum) {
    SignMap plain = wanted;
    plain.distance.mode = Mode::kPlain, plain.distance.vector.clear();
    return sign_map(plain);
  }
  if (!wanted.minimum) return function(wanted.distance)->sign_map(wanted.level / world_.step);
  distance::Extremum e = least(wanted.distance);
  if (!e.exists) return CellComplex::uniform(1);
  return plane::remark(std::move(e.at), [](Mark k) { return Mark(k > 0 ? 0 : 1); });
}

distance::Extremum Solver::least_directional(const Distance& wanted) const {
  const Roles r = roles(wanted);
  auto base = pair(r.names)->pair().distance(signed_base(r.wanted.kind));
  return distance::least_directional(static_cast<const distance::SignedDistance&>(*base).base(), track(r.wanted),
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
  distance::Extremum e = world_.motion.given()    ? least_over_time(wanted)
                         : is_directional(wanted) ? least_directional(wanted)
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

DistanceAt Solver::value(const Distance& wanted, const RealPoint& p) const {
  DistanceAt out;
  out.text = text(wanted);
  const Roles r = roles(wanted);
  if (r.turning) {
    const auto v = turning_value(r, p);
    if (v) out.value = v->value * world_.step.to_double(), out.bound = v->bound * world_.step.to_double();
    return out;
  }
  if (!world_.motion.given() && r.wanted.mode == Mode::kPlain) {
    auto pair = this->pair(r.names);
    if (auto m = pair->measure(situation::which(r.wanted.kind, r.second_moves), p))
      add_witness(out, wanted, r.names, *pair, *m, p);
    return out;
  }
  auto v = function(wanted)->value(p);
  if (v && v->minus_infinity)
    out.value = -std::numeric_limits<double>::infinity();
  else if (v)
    out.value = (v->value * world_.step).to_double(), out.nearest = v->nearest;
  return out;
}

void Solver::add_witness(DistanceAt& out, const Distance& wanted, const Names& names, const distance::AtPosition& pair,
                         const distance::Measured& m, const RealPoint& p) const {
  out.value = (m.value * world_.step).to_double();
  out.nearest = m.nearest, out.farthest = m.farthest;
  for (const distance::Feature& f : m.witness)
    out.witness.push_back(named_feature(f, f.of_moving ? pair.pair().moving() : pair.pair().fixed(),
                                        f.of_moving ? names.first : names.second, world_.shapes, world_.parts, p));
  bool turned =
      wanted.first == names.second && !out.witness.empty() && m.witness[0].of_moving != m.witness[1].of_moving;
  if (turned) std::swap(out.witness[0], out.witness[1]);
}

std::optional<NearestFeasible> Solver::nearest_feasible(const Formula& formula, const RealPoint& position) const {
  RealPoint p = steps(position);
  plane::Region region = feasible(formula), closed = plane::closure(region);
  auto in = [](Mark m) { return m > 0; };
  auto here = mark_of(closed, locate(closed, p)) > 0;
  auto n = here ? std::optional(plane::Nearest{Real(), p, {}}) : plane::nearest(closed, in, p);
  if (!n) return std::nullopt;
  return NearestFeasible{n->at, n->distance * world_.step, mark_of(region, locate(region, n->at)) > 0};
}

std::vector<distance::TurningPose> Solver::turning_poses(const Roles& r, bool instant) const {
  const Motion& motion = world_.motion;
  const Trajectory b = common_trajectory(motion, r.names.first), a = common_trajectory(motion, r.names.second);
  std::vector<distance::TurningPose> poses;
  for (const Real& t : instant ? std::vector{*world_.instant} : common_times(motion, b, a)) {
    const RealPoint q = position_at(a, t), o = position_at(b, t);
    poses.push_back({{o.x - q.x, o.y - q.y}, angle_at(b, t), angle_at(a, t)});
  }
  return poses;
}

bool Solver::turns_in(const Formula& formula) const {
  const auto& maps = formula.sign_maps();
  return !world_.instant && std::any_of(maps.begin(), maps.end(), [&](const SignMap& m) {
    return roles(m.distance).turning || (m.distance.mode == Mode::kTurning && !is_plain_level(m));
  });
}

distance::BoundedMaps Solver::bounded_maps(const SignMap& wanted) const {
  const Roles r = roles(wanted.distance);
  const bool in_rotation = r.wanted.mode == Mode::kTurning && !is_plain_level(wanted);
  if (!r.turning && !in_rotation) {
    plane::SignMap exact = sign_map(wanted);
    return {exact, exact};
  }
  if (in_rotation && !world_.motion.given() && !wanted.minimum)
    return distance::turning_position_maps(shape(r.names.first), shape(r.names.second),
                                           situation::which(r.wanted.kind, r.second_moves),
                                           steps({r.wanted.vector.at(0), r.wanted.vector.at(1)}), wanted.level);
  if (wanted.minimum) refuse(wanted.distance, "the least value over positions is not computed with a motion");
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "only distances in all directions are computed of shapes that turn in time");
  Which kind = situation::which(r.wanted.kind, r.second_moves);
  // Containment down from level 0 is the directed Hausdorff distance, which changes no faster than the shapes do.
  if ((kind == Which::kEta1 || kind == Which::kDelta1) && wanted.level.sign() <= 0)
    kind = kind == Which::kEta1 ? Which::kMu : Which::kMuBack;
  const auto sense =
      natural_extremum(r.wanted) == Extremum::kInf ? distance::Sense::kMinimum : distance::Sense::kMaximum;
  const auto bounds = [&](Which of, const Real& level) {
    return distance::turning_maps(shape(r.names.first), shape(r.names.second), of, turning_poses(r, false), sense,
                                  level / world_.step);
  };
  const bool eta = kind == Which::kEta1 || kind == Which::kEta2, first = kind == Which::kEta1 || kind == Which::kDelta1;
  if (!eta && !first && kind != Which::kDelta2) return bounds(kind, wanted.level);
  // The places where a shape fits come and go with its angle. But eta is at least mu, and eta1 not above 0 where mu is
  // not.
  const Which mu = eta ? Which::kMu : Which::kMuBack;
  distance::BoundedMaps out{bounds(mu, wanted.level).low, plane::SignMap::uniform(1)};
  if (first) out.high = plane::remark(bounds(mu, Real()).high, [](Mark k) { return Mark(k <= 0 ? -1 : 1); });
  return out;
}

Solver::Bounds Solver::feasible_bounds(const Formula& formula) const {
  const std::size_t n = formula.sign_maps().size();
  std::vector<distance::BoundedMaps> maps(n);
  for (std::size_t k = 0; k < n; ++k) maps[k] = bounded_maps(formula.sign_maps()[k]);
  std::vector<const CellComplex*> operands;
  for (const auto& m : maps) operands.insert(operands.end(), {&m.low, &m.high});
  // 2 where every choice of signs between the bounds satisfies the formula, 1 where some does.
  const CellComplex both =
      plane::overlay(operands, [&](std::span<const Mark> marks) { return certainty(formula, marks); });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

std::optional<distance::BoundedValue> Solver::turning_value(const Roles& r, const RealPoint& p) const {
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "only distances in all directions are computed of shapes that turn in time");
  const bool one = world_.instant && r.wanted.prefix == Extremum::kNone;
  const distance::TurningMotion f(shape(r.names.first), shape(r.names.second),
                                  situation::which(r.wanted.kind, r.second_moves), turning_poses(r, one));
  if (one) return f.instant(p, 0, Real());
  const bool least = natural_extremum(r.wanted) == Extremum::kInf;
  return f.extremum(p, least ? distance::Sense::kMinimum : distance::Sense::kMaximum);
}

std::int8_t Solver::sign(const SignMap& wanted, const RealPoint& p) const {
  const Roles r = roles(wanted.distance);
  if (!r.turning) {
    const plane::SignMap m = sign_map(wanted);
    return mark_of(m, locate(m, p));
  }
  if (wanted.minimum) refuse(wanted.distance, "the least value over positions is not computed with a motion");
  const auto v = turning_value(r, p);
  if (!v) return 1;
  const double over = v->value - (wanted.level / world_.step).to_double();
  if (std::abs(over) <= v->bound)
    refuse(wanted.distance, "of shapes that turn in time, too near to the level for its bound to decide");
  return over > 0 ? 1 : -1;
}

Solver::Check Solver::check(const Formula& formula, const RealPoint& position) const {
  RealPoint p = steps(position);
  std::vector<std::int8_t> signs(formula.sign_maps().size());
  plane::parallel_for(signs.size(), [&](std::size_t k) { signs[k] = sign(formula.sign_maps()[k], p); });
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    AtomAt a{atom, value(atom.distance, p), holds(atom, signs[formula.sign_map_of(k)]), std::nullopt};
    if (!a.holds && a.distance.value && std::isfinite(*a.distance.value) && !atom.minimum)
      a.lacks = std::abs(*a.distance.value - atom.level.to_double());
    out.atoms.push_back(std::move(a));
  }
  return out;
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

plane::Section Solver::instants(const SignMap& wanted, const RealPoint& p) const {
  const Motion& motion = world_.motion;
  const bool whole_time = wanted.distance.prefix != Extremum::kNone;
  const Roles r = roles(wanted.distance);
  if (r.turning) refuse(wanted.distance, "the instants of shapes that turn are known between bounds only");
  if (whole_time) {
    const plane::SignMap map = sign_map(wanted);
    return plane::Section::constant(motion.start, motion.end, mark_of(map, locate(map, p)));
  }
  const plane::SignMap map = of_instant(r)->sign_map(wanted.level / world_.step);
  return plane::section_of_path(map, p, r.path.path, r.path.times);
}

}  // namespace findspace::situation
