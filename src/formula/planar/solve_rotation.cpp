// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/solve_rotation.h"

#include <algorithm>

#include "distance/rotation/rotated_directional.h"
#include "distance/rotation/rotation.h"
#include "findspace/error.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/language/which.h"
#include "plane/base/real_vector.h"

namespace findspace::formula {

using distance::farthest_rotation;
using distance::farthest_rotation_sign_map;
using distance::RotatedPair;
using distance::rotation_distance;
using distance::rotation_sign_map;
using distance::Which;
using exact::Angle;
using exact::ExactAngle;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::RotationMap;
using plane::operator+;
using plane::operator-;
using plane::operator==;

namespace {

bool is_grid(const RealPoint& p) { return p.x.integer() && p.y.integer(); }

bool is_quarters(const Real& degrees) { return (degrees / Real(90)).integer().has_value(); }

RealPoint in_steps(const RealPoint& p, const Real& step) { return {p.x / step, p.y / step}; }

RealPoint centre_of(const Distance& rotating, const Real& step) {
  return in_steps({rotating.vector.at(0), rotating.vector.at(1)}, step);
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

World rotated_world(World world, const RealPoint& about, const Real& degrees, plane::Rounding& rounding) {
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

RotationSolver::Rotated RotationSolver::rotated(const Distance& wanted, const RealPoint& about,
                                                const RealPoint& to) const {
  Distance d = moving_first(wanted, solver_.world().moving);
  const Which which = solver_.which(d);
  const auto& moving = solver_.world().moving;
  if (std::find(moving.begin(), moving.end(), d.first.at(0)) == moving.end()) std::swap(d.first, d.second);
  return {RotatedPair(solver_.shape(d.first), solver_.shape(d.second), about, to), which};
}

RealPoint RotationSolver::centre(const Formula& formula) const {
  const Real& step = solver_.world().step;
  if (pose_.about) return in_steps(*pose_.about, step);
  std::optional<RealPoint> found;
  for (const Atom& a : formula.atoms()) {
    if (a.distance.mode != Mode::kRotation) continue;
    const RealPoint c = centre_of(a.distance, step);
    if (found && !(*found == c) && pose_.degrees.sign() != 0)
      refuse(a.distance,
             "with distances that turn about different points an angle has no meaning; say \"free\": \"angle\" and "
             "\"about\"");
    found = c;
  }
  return found ? *found - in_steps(pose_.at, step) : RealPoint{};
}

const Solver& RotationSolver::rotated_solver() const {
  if (rotated_) return *rotated_;
  rotated_ = std::make_unique<Solver>(rotated_world(solver_.world(), about_, pose_.degrees, rounding_));
  return *rotated_;
}

RotationSolver::Circle RotationSolver::circle(const Distance& d) const {
  const Real& step = solver_.world().step;
  const RealPoint to = centre_of(d, step), at = in_steps(pose_.at, step);
  Circle out;
  const auto solve = [&](const Rotated& t) { out.base = t.pair.sign_map(base_of(t.which, out.farthest), Real()); };
  if (to == about_ + at) {
    out.at = Angle::of_degrees(pose_.degrees);
    solve(rotated(d, about_, to));
    return out;
  }
  // About another point: the shape is rotated first, once for all.
  if ((pose_.degrees / Real(360)).integer()) {
    solve(rotated(d, to - at, to));
    return out;
  }
  const RotationSolver there(rotated_solver(), Pose{pose_.at, Real(), std::nullopt});
  there.about_ = to - at;
  return there.circle(d);
}

RotationMap RotationSolver::directional_map(const Distance& wanted, const Real& level) const {
  const RealPoint to = about_ + in_steps(pose_.at, solver_.world().step);
  const Distance d = moving_first(wanted, solver_.world().moving);
  const Which which = solver_.which(d);
  bool farthest = false;
  const Which base = base_of(which, farthest);
  if (level.sign() == 0 && !farthest) return rotated(d, about_, to).pair.sign_map(base, level);
  const plane::Region b = solver_.shape(d.first), a = solver_.shape(d.second);
  return distance::rotated_directional({b, a, about_, to}, which, direction(d), level);
}

RotationMap RotationSolver::sign_map(const SignMap& wanted) const {
  const Distance& d = wanted.distance;
  require_static(d);
  if (wanted.minimum) {
    const plane::RotationLeast best = least(d, RotationMap::uniform(1));
    return plane::remark(best.at, [](Mark k) { return Mark(k > 0 ? 0 : 1); });
  }
  const Real& step = solver_.world().step;
  if (d.mode == Mode::kRotation && !is_plain_level(wanted)) {
    if (rotations_twice(wanted)) refuse(d, "about another point than \"about\" names it is known between bounds only");
    const Circle c = circle(d);
    return c.farthest ? farthest_rotation_sign_map(c.base, wanted.level) : rotation_sign_map(c.base, wanted.level);
  }
  if (is_directional(d)) return directional_map(d, wanted.level / step);
  const Rotated t = rotated(d, about_, about_ + in_steps(pose_.at, step));
  auto map = exact::tried([&] { return t.pair.sign_map(t.which, wanted.level / step); });
  if (!map) refuse(d, map.refusal().error.message());
  return *std::move(map);
}

bool RotationSolver::rotations_twice(const SignMap& wanted) const {
  const Distance& d = wanted.distance;
  if (d.mode != Mode::kRotation || (is_plain_level(wanted) && !wanted.minimum)) return false;
  const Real& step = solver_.world().step;
  return !(centre_of(d, step) == about_ + in_steps(pose_.at, step));
}

plane::RotationLeast RotationSolver::least(const Distance& d, const RotationMap& within) const {
  const Real step = d.mode == Mode::kRotation ? Real::ratio(1, 1000000) : solver_.world().step;
  return plane::least_rotation([&](const Real& level) { return sign_map({d, level}); }, within, step);
}

plane::RotationLeast RotationSolver::greatest(const Distance& d, const RotationMap& within) const {
  const Real step = d.mode == Mode::kRotation ? Real::ratio(1, 1000000) : solver_.world().step;
  plane::RotationLeast best = plane::least_rotation(
      [&](const Real& level) {
        return plane::remark(sign_map({d, -level}), [](Mark k) { return Mark(-k); });
      },
      within, step);
  best.value = -best.value;
  return best;
}

RotationMap RotationSolver::feasible(const Formula& formula) const {
  about_ = centre(formula);
  const std::vector<SignMap>& wanted = formula.sign_maps();
  std::vector<RotationMap> maps(wanted.size());
  for (std::size_t k = 0; k < maps.size(); ++k) maps[k] = sign_map(wanted[k]);
  std::vector<const RotationMap*> operands;
  for (const RotationMap& m : maps) operands.push_back(&m);
  return plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
}

AtomAt RotationSolver::check_plain(const Formula& whole, std::size_t index) const {
  const Atom& atom = whole.atoms()[index];
  AtomAt out = rotated_solver().check(Formula(atom), pose_.at).atoms.at(0);
  if (is_quarters(pose_.degrees) || atom.minimum || atom.distance.mode == Mode::kRotation) return out;
  // The truth from the exact circle, where there is one: rounding must not decide a contact.
  const auto sign = exact::tried(
      [&] { return mark_at(sign_map(whole.sign_maps()[whole.sign_map_of(index)]), Angle::of_degrees(pose_.degrees)); });
  if (sign) out.holds = holds(atom, *sign);
  return out;
}

RotationSolver::Met RotationSolver::rotation_at(const Distance& d, const Real& level) const {
  const Circle c = circle(d);
  const RotationMap map = c.farthest ? farthest_rotation_sign_map(c.base, level) : rotation_sign_map(c.base, level);
  Met out{{}, mark_at(map, c.at)};
  out.distance.text = text(d);
  out.distance.in_degrees = true;
  out.distance.value = c.farthest ? farthest_rotation(c.base, c.at) : rotation_distance(c.base, c.at);
  return out;
}

std::vector<DistanceAt> RotationSolver::measure(const Formula& formula) const {
  about_ = centre(formula);
  std::vector<DistanceAt> out = rotated_solver().measure(pose_.at);
  for (const Atom& a : formula.atoms()) {
    const std::string name = text(a.distance);
    if (std::any_of(out.begin(), out.end(), [&](const DistanceAt& d) { return d.text == name; })) continue;
    const bool rotating = a.distance.mode == Mode::kRotation;
    out.push_back(rotating ? rotation_at(a.distance, Real()).distance
                           : rotated_solver().distance_at(a.distance, pose_.at));
  }
  return out;
}

Solver::Check RotationSolver::check(const Formula& formula) const {
  about_ = centre(formula);
  Solver::Check out;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    if (atom.minimum && (pose_.about || atom.distance.mode == Mode::kRotation)) {
      out.atoms.push_back(check_least(atom));
      continue;
    }
    if (atom.distance.mode != Mode::kRotation) {
      out.atoms.push_back(check_plain(formula, k));
      continue;
    }
    require_static(atom.distance);
    Met met = rotation_at(atom.distance, atom.level);
    out.atoms.push_back({atom, std::move(met.distance), holds(atom, met.sign), std::nullopt});
  }
  out.holds = truth(formula.root(), out.atoms);
  return out;
}

}  // namespace findspace::formula
