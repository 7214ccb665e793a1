// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/solve_rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "distance/rotation/rotation_in_time.h"
#include "distance/rotation/rotational_distance.h"
#include "exact/margins/formula.h"
#include "findspace/error.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/planar/measure.h"
#include "formula/planar/rotation_bounds.h"
#include "plane/base/real_vector.h"
#include "plane/base/stopwatch.h"
#include "plane/query/moved.h"

namespace findspace::formula {

using exact::Angle;
using exact::Real;
using exact::RealPoint;
using plane::RotationMap;
using plane::operator-;
using plane::operator==;

namespace {

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

bool is_grid(const RealPoint& p) { return p.x.integer() && p.y.integer(); }

bool is_quarters(const Real& degrees) { return (degrees / Real(90)).integer().has_value(); }

/// A number of degrees, which no closed form gives.
DistanceAt angle_answer(const Distance& d, double value) {
  std::optional<distance::SceneAnswer> answer;
  if (value < exact::kInfinity) {
    answer.emplace();
    answer->way = distance::Way::kMap;
    answer->minus_infinity = std::isinf(value);
    if (!answer->minus_infinity && value != 0) answer->set_unproven();
    if (!answer->minus_infinity) answer->value = Real::from_double(value);
    if (!answer->proven) answer->error = margin::kAngleValue * (std::abs(value) + 1);
  }
  DistanceAt out = distance_at(text(d), std::move(answer));
  out.in_degrees = true;
  return out;
}

AtomAt by_angles(const Atom& atom, DistanceAt distance, int sign) {
  AtomAt out = atom_at(atom, std::move(distance), sign);
  out.way = distance::Way::kAngles;
  return out;
}

/// The least that the value may be; nothing where undefined.
std::optional<double> lowest(const DistanceAt& d) {
  const auto value = d.value();
  if (!value || std::isinf(*value) || d.answer->proven) return value;
  const auto& lower = d.answer->bounds().lower;
  return lower ? lower->to_double() : -exact::kInfinity;
}

}  // namespace

bool has_rotations(const Formula& formula) {
  return std::any_of(formula.atoms().begin(), formula.atoms().end(),
                     [](const Atom& a) { return a.distance.mode == Mode::kRotation; });
}

World rotated_world(World world, const RealPoint& about, const Real& degrees, plane::Rounding& rounding) {
  if ((degrees / Real(360)).integer()) return world;
  if (!is_grid(about))
    throw Error(ErrorCode::kUnsupported,
                "at an angle, the centre of the rotation must be a point of the grid, seen from the position");
  const plane::GridPoint centre{std::int64_t(*about.x.integer()), std::int64_t(*about.y.integer())};
  for (const std::string& name : world.moving) {
    plane::SharedRegion& shape = world.shapes.at(name);
    shape = plane::rotated(shape, centre, degrees, world.step.to_double(), rounding);
  }
  return world;
}

std::vector<SharedSolver> solvers_at(const World& world, const RealPoint& about, std::span<const Real> degrees,
                                     plane::Rounding& rounding) {
  std::vector<SharedSolver> out;
  for (const Real& d : degrees) out.push_back(std::make_shared<const Solver>(rotated_world(world, about, d, rounding)));
  return out;
}

RealPoint RotationSolver::point_of_rotation(const Formula& formula) const {
  if (pose_.about) return world_.steps(*pose_.about);
  std::optional<RealPoint> found;
  for (const Atom& a : formula.atoms()) {
    if (a.distance.mode != Mode::kRotation) continue;
    const RealPoint c = centre_of(world_, a.distance);
    if (found && !(*found == c) && pose_.degrees.sign() != 0)
      refuse(a.distance,
             "with distances that rotate about different points an angle has no meaning; say \"free\": \"angle\" and "
             "\"about\"");
    found = c;
  }
  return found ? *found - world_.steps(pose_.at) : RealPoint{};
}

const Solver& RotationSolver::rotated_solver() const {
  if (rotated_) return *rotated_;
  rotated_ = std::make_unique<Solver>(rotated_world(world_.world(), about_, pose_.degrees, rounding_));
  return *rotated_;
}

RotationMaps RotationSolver::maps(const Formula& formula) const {
  if (has_sums(formula)) throw Error(ErrorCode::kUnsupported, "distances are not compared with each other over angles");
  return {world_, point_of_rotation(formula), world_.steps(pose_.at)};
}

RotationSolver::Met RotationSolver::rotation_at(const RotationMaps& maps, const Distance& d, const Real& level) const {
  const RealPoint to = centre_of(world_, d), at = world_.steps(pose_.at);
  Angle here;
  RotationMaps::Contacts c;
  if (!(to == maps.centre()) && !is_quarters(pose_.degrees)) return rotation_elsewhere(maps, d, level);
  if (to == maps.centre()) {
    here = Angle::of_degrees(pose_.degrees);
    c = maps.contacts(d);
  } else {
    // About another point: the shape is rotated first, once for all.
    const bool upright = (pose_.degrees / Real(360)).integer().has_value();
    c = RotationMaps(upright ? world_ : rotated_solver().prepared(), to - at, at).contacts(d);
  }
  const RotationMap map =
      c.farthest ? distance::farthest_rotation_sign_map(c.base, level) : distance::rotation_sign_map(c.base, level);
  const double value =
      c.farthest ? distance::farthest_rotation(c.base, here) : distance::rotation_distance(c.base, here);
  return {angle_answer(d, value), mark_at(map, here)};
}

RotationSolver::Met RotationSolver::rotation_elsewhere(const RotationMaps& maps, const Distance& wanted,
                                                       const Real& level) const {
  const Distance d = moving_first(wanted, world_.world().moving);
  const RealPoint& about = maps.about();
  const distance::RotationInTime f(plane::moved(world_.shape(d.first), {-about.x, -about.y}), world_.shape(d.second),
                                   world_.which(d), centre_of(world_, d), maps.centre(), {{{}, pose_.degrees, {}}},
                                   world_.step().to_double());
  const distance::ValueRange v = f.instant(0, Real());
  const bool undefined = v.low == exact::kInfinity;
  Met out{ranged_answer(world_, wanted, undefined ? std::nullopt : std::optional(v)), std::nullopt};
  const distance::SignRange s = f.signs({0, Real(), Real()}, level);
  if (s.low == s.high)
    out.sign = s.low;
  else if (is_plain_level({wanted, level}))
    out.sign = mark_at(maps.sign_map({wanted, level}), Angle::of_degrees(pose_.degrees));
  if (out.sign && out.distance.answer)
    out.distance.answer = distance::narrowed(*std::move(out.distance.answer), level, *out.sign);
  return out;
}

AtomAt RotationSolver::check_plain(const RotationMaps& maps, const Formula& whole, std::size_t index) const {
  const Atom& atom = whole.atoms()[index];
  AtomAt out = rotated_solver().check(Formula(atom), pose_.at).atoms.at(0);
  if (is_quarters(pose_.degrees) || atom.minimum || atom.distance.mode == Mode::kRotation) return out;
  if (atom.distance.prefix != Extremum::kNone) return out;  // over time there is no circle
  // The truth from the exact circle: rounding must not decide a contact.
  const RotationMap map = maps.sign_map(whole.sign_maps()[whole.sign_map_of(index)]);
  return by_angles(atom, std::move(out.distance), mark_at(map, Angle::of_degrees(pose_.degrees)));
}

AtomAt RotationSolver::check_least(const RotationMaps& maps, const Atom& atom) const {
  const Distance& d = atom.distance;
  const bool rotating = d.mode == Mode::kRotation;
  AtomAt out{atom,
             rotating ? rotation_at(maps, d, Real()).distance : rotated_solver().distance_at(d, pose_.at),
             false,
             {},
             maps.rotations_twice(d) ? distance::Way::kSearch : distance::Way::kAngles};
  const BestAngles best = best_angles(maps, d, {RotationMap::uniform(1), std::nullopt}, distance::Sense::kMinimum);
  std::optional<double> least_value;  // not proven
  if (best.exists() && best.proven())
    out.holds = mark_at(best.at.angles, exact::Angle::of_degrees(pose_.degrees)) > 0;
  else if (const auto value = best.value())
    least_value = value->to_double();
  else if (best.at.outer)
    least_value = -std::numeric_limits<double>::infinity();
  const auto value = lowest(out.distance);
  if (least_value && value && *value <= *least_value + margin::kBestOfAngles * (1 + std::abs(*least_value)))
    refuse(d,
           "its least value over the angles is not a whole number of steps; whether it is taken here is not decided");
  return out;
}

std::vector<DistanceAt> RotationSolver::measure(const Formula& formula, const WantedText& wanted) const {
  const RotationMaps maps = this->maps(formula);
  about_ = maps.about();
  std::vector<DistanceAt> out = rotated_solver().measure(pose_.at, {}, wanted);
  for (const Atom& a : formula.atoms()) {
    const std::string name = text(a.distance);
    if (wanted && !wanted(name)) continue;
    if (std::any_of(out.begin(), out.end(), [&](const DistanceAt& d) { return d.text == name; })) continue;
    const bool rotating = a.distance.mode == Mode::kRotation;
    out.push_back(rotating ? rotation_at(maps, a.distance, Real()).distance
                           : rotated_solver().distance_at(a.distance, pose_.at));
  }
  return out;
}

AtomAt RotationSolver::check_atom(const RotationMaps& maps, const Formula& formula, std::size_t index) const {
  const Atom& atom = formula.atoms()[index];
  const bool rotating = atom.distance.mode == Mode::kRotation;
  if (atom.minimum && (pose_.about || rotating)) return check_least(maps, atom);
  if (!rotating) return check_plain(maps, formula, index);
  require_static(atom.distance);
  Met met = rotation_at(maps, atom.distance, atom.level);
  if (!met.sign)
    refuse(atom.distance,
           "about another point than the shape has been rotated about, it is too near to the level here "
           "to decide");
  return by_angles(atom, std::move(met.distance), *met.sign);
}

Check RotationSolver::check(const Formula& formula) const {
  const RotationMaps maps = this->maps(formula);
  about_ = maps.about();
  Check out;
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const plane::Stopwatch watch;
    out.atoms.push_back(check_atom(maps, formula, k));
    out.atoms.back().milliseconds = watch.milliseconds();
  }
  out.holds = truth(formula.root(), out.atoms);
  return out;
}

}  // namespace findspace::formula
