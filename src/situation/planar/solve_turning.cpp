// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/planar/solve_turning.h"

#include <algorithm>

#include "distance/rotation/turned_directional.h"
#include "distance/rotation/turning.h"
#include "findspace/error.h"
#include "plane/base/real_vector.h"
#include "situation/formula/evaluate.h"
#include "situation/formula/text.h"
#include "situation/formula/which.h"

namespace findspace::situation {

using distance::farthest_turning;
using distance::farthest_turning_sign_map;
using distance::TurnedPair;
using distance::turning_distance;
using distance::turning_sign_map;
using distance::Which;
using exact::Angle;
using exact::Real;
using exact::RealPoint;
using exact::Turn;
using plane::Mark;
using plane::TurnMap;
using plane::operator+;
using plane::operator-;
using plane::operator==;

namespace {

bool is_grid(const RealPoint& p) { return p.x.integer() && p.y.integer(); }

bool is_quarters(const Real& degrees) { return (degrees / Real(90)).integer().has_value(); }

RealPoint in_steps(const RealPoint& p, const Real& step) { return {p.x / step, p.y / step}; }

RealPoint centre_of(const Distance& turning, const Real& step) {
  return in_steps({turning.vector.at(0), turning.vector.at(1)}, step);
}

/// Gamma, eta and delta each have a second kind, which takes the greatest angle.
Which base_of(Which which, bool& farthest) {
  farthest = which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2;
  if (which == Which::kGamma2) return Which::kGamma1;
  if (which == Which::kEta2) return Which::kEta1;
  if (which == Which::kDelta2) return Which::kDelta1;
  return which;
}

bool truth(const Node& node, const std::vector<AtomAt>& atoms) {
  const auto holds = [&](const Node& n) { return truth(n, atoms); };
  switch (node.op) {
    case Node::Op::kTrue:
      return true;
    case Node::Op::kFalse:
      return false;
    case Node::Op::kAtom:
      return atoms[node.atom].holds;
    case Node::Op::kNot:
      return !holds(node.operands.front());
    case Node::Op::kAnd:
      return std::all_of(node.operands.begin(), node.operands.end(), holds);
    case Node::Op::kOr:
      return std::any_of(node.operands.begin(), node.operands.end(), holds);
  }
  return false;
}

void require_static(const Distance& d) {
  if (d.prefix != Extremum::kNone) refuse(d, "a distance over time is not computed over all angles, nor at an angle");
}

}  // namespace

World turned_world(World world, const RealPoint& about, const Real& degrees, plane::Rounding& rounding) {
  if (!is_grid(about))
    throw Error(ErrorCode::kUnsupported,
                "at an angle, the centre of the turn must be a point of the grid, seen from the position");
  const plane::GridPoint centre{std::int64_t(*about.x.integer()), std::int64_t(*about.y.integer())};
  for (const std::string& name : world.moving) {
    plane::Region& shape = world.shapes.at(name);
    shape = plane::rotated(shape, centre, degrees, world.step.to_double(), rounding);
  }
  return world;
}

TurnSolver::Turned TurnSolver::turned(const Distance& wanted, const RealPoint& about, const RealPoint& to) const {
  Distance d = moving_first(wanted, solver_.world().moving);
  const Which which = solver_.which(d);
  const auto& moving = solver_.world().moving;
  if (std::find(moving.begin(), moving.end(), d.first.at(0)) == moving.end()) std::swap(d.first, d.second);
  return {TurnedPair(solver_.shape(d.first), solver_.shape(d.second), about, to), which};
}

RealPoint TurnSolver::centre(const Formula& formula) const {
  const Real& step = solver_.world().step;
  if (pose_.about) return in_steps(*pose_.about, step);
  std::optional<RealPoint> found;
  for (const Atom& a : formula.atoms()) {
    if (a.distance.mode != Mode::kTurning) continue;
    const RealPoint c = centre_of(a.distance, step);
    if (found && !(*found == c) && pose_.degrees.sign() != 0)
      refuse(a.distance,
             "with distances that turn about different points an angle has no meaning; say \"free\": \"angle\" and "
             "\"about\"");
    found = c;
  }
  return found ? *found - in_steps(pose_.at, step) : RealPoint{};
}

const Solver& TurnSolver::turned_solver() const {
  if (turned_) return *turned_;
  turned_ = std::make_unique<Solver>(turned_world(solver_.world(), about_, pose_.degrees, rounding_));
  return *turned_;
}

TurnSolver::Circle TurnSolver::circle(const Distance& d) const {
  const Real& step = solver_.world().step;
  const RealPoint to = centre_of(d, step), at = in_steps(pose_.at, step);
  Circle out;
  const auto solve = [&](const Turned& t) { out.base = t.pair.sign_map(base_of(t.which, out.farthest), Real()); };
  if (to == about_ + at) {
    out.at = Angle::of_degrees(pose_.degrees);
    solve(turned(d, about_, to));
    return out;
  }
  // About another point: the shape is turned first, once for all.
  if ((pose_.degrees / Real(360)).integer()) {
    solve(turned(d, to - at, to));
    return out;
  }
  const TurnSolver there(turned_solver(), Pose{pose_.at, Real(), std::nullopt});
  there.about_ = to - at;
  return there.circle(d);
}

TurnMap TurnSolver::directional_map(const Distance& wanted, const Real& level) const {
  const RealPoint to = about_ + in_steps(pose_.at, solver_.world().step);
  const Distance d = moving_first(wanted, solver_.world().moving);
  const Which which = solver_.which(d);
  bool farthest = false;
  const Which base = base_of(which, farthest);
  if (level.sign() == 0 && !farthest) return turned(d, about_, to).pair.sign_map(base, level);
  const plane::Region b = solver_.shape(d.first), a = solver_.shape(d.second);
  return distance::turned_directional({b, a, about_, to}, which, track(d), level);
}

TurnMap TurnSolver::sign_map(const SignMap& wanted) const {
  const Distance& d = wanted.distance;
  require_static(d);
  if (wanted.minimum) {
    const plane::TurnLeast best = least(d, TurnMap::uniform(1));
    return plane::remark(best.at, [](Mark k) { return Mark(k > 0 ? 0 : 1); });
  }
  const Real& step = solver_.world().step;
  if (d.mode == Mode::kTurning && !is_plain_level(wanted)) {
    if (turns_twice(wanted)) refuse(d, "about another point than \"about\" names it is known between bounds only");
    const Circle c = circle(d);
    return c.farthest ? farthest_turning_sign_map(c.base, wanted.level) : turning_sign_map(c.base, wanted.level);
  }
  if (is_directional(d)) return directional_map(d, wanted.level / step);
  const Turned t = turned(d, about_, about_ + in_steps(pose_.at, step));
  try {
    return t.pair.sign_map(t.which, wanted.level / step);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    refuse(d, e.message());
  }
}

bool TurnSolver::turns_twice(const SignMap& wanted) const {
  const Distance& d = wanted.distance;
  if (d.mode != Mode::kTurning || (is_plain_level(wanted) && !wanted.minimum)) return false;
  const Real& step = solver_.world().step;
  return !(centre_of(d, step) == about_ + in_steps(pose_.at, step));
}

plane::TurnLeast TurnSolver::least(const Distance& d, const TurnMap& within) const {
  const Real step = d.mode == Mode::kTurning ? Real::ratio(1, 1000000) : solver_.world().step;
  return plane::least_turn([&](const Real& level) { return sign_map({d, level}); }, within, step);
}

plane::TurnLeast TurnSolver::greatest(const Distance& d, const TurnMap& within) const {
  const Real step = d.mode == Mode::kTurning ? Real::ratio(1, 1000000) : solver_.world().step;
  plane::TurnLeast best = plane::least_turn(
      [&](const Real& level) {
        return plane::remark(sign_map({d, -level}), [](Mark k) { return Mark(-k); });
      },
      within, step);
  best.value = -best.value;
  return best;
}

TurnMap TurnSolver::feasible(const Formula& formula) const {
  about_ = centre(formula);
  const std::vector<SignMap>& wanted = formula.sign_maps();
  std::vector<TurnMap> maps(wanted.size());
  for (std::size_t k = 0; k < maps.size(); ++k) maps[k] = sign_map(wanted[k]);
  std::vector<const TurnMap*> operands;
  for (const TurnMap& m : maps) operands.push_back(&m);
  return plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
}

AtomAt TurnSolver::check_plain(const Formula& whole, std::size_t index) const {
  const Atom& atom = whole.atoms()[index];
  AtomAt out = turned_solver().check(Formula(atom), pose_.at).atoms.at(0);
  if (is_quarters(pose_.degrees) || atom.minimum || atom.distance.mode == Mode::kTurning) return out;
  // The truth from the exact circle, where there is one: rounding must not decide a contact.
  try {
    const TurnMap map = sign_map(whole.sign_maps()[whole.sign_map_of(index)]);
    out.holds = holds(atom, mark_at(map, Angle::of_degrees(pose_.degrees)));
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
  }
  return out;
}

TurnSolver::Met TurnSolver::turning_at(const Distance& d, const Real& level) const {
  const Circle c = circle(d);
  const TurnMap map = c.farthest ? farthest_turning_sign_map(c.base, level) : turning_sign_map(c.base, level);
  Met out{{}, mark_at(map, c.at)};
  out.distance.text = text(d), out.distance.in_degrees = true;
  out.distance.value = c.farthest ? farthest_turning(c.base, c.at) : turning_distance(c.base, c.at);
  return out;
}

std::vector<DistanceAt> TurnSolver::measure(const Formula& formula) const {
  about_ = centre(formula);
  std::vector<DistanceAt> out = turned_solver().measure(pose_.at);
  for (const Atom& a : formula.atoms()) {
    const std::string name = text(a.distance);
    if (std::any_of(out.begin(), out.end(), [&](const DistanceAt& d) { return d.text == name; })) continue;
    const bool turning = a.distance.mode == Mode::kTurning;
    out.push_back(turning ? turning_at(a.distance, Real()).distance
                          : turned_solver().distance_at(a.distance, pose_.at));
  }
  return out;
}

Solver::Check TurnSolver::check(const Formula& formula) const {
  about_ = centre(formula);
  Solver::Check out;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    if (atom.minimum && (pose_.about || atom.distance.mode == Mode::kTurning)) {
      out.atoms.push_back(check_least(atom));
      continue;
    }
    if (atom.distance.mode != Mode::kTurning) {
      out.atoms.push_back(check_plain(formula, k));
      continue;
    }
    require_static(atom.distance);
    Met met = turning_at(atom.distance, atom.level);
    out.atoms.push_back({atom, std::move(met.distance), holds(atom, met.sign), std::nullopt});
  }
  out.holds = truth(formula.root(), out.atoms);
  return out;
}

}  // namespace findspace::situation
