// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/rotation_maps.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "distance/rotation/rotated_directional.h"
#include "distance/rotation/rotated_pair.h"
#include "distance/rotation/rotational_distance.h"
#include "formula/language/evaluate.h"
#include "plane/base/real_vector.h"

namespace findspace::formula {

using distance::RotatedPair;
using distance::Which;
using exact::Real;
using exact::RealPoint;
using plane::Mark;
using plane::RotationMap;
using plane::operator+;
using plane::operator==;

namespace {

/// Gamma, eta and delta each have a second kind, which takes the greatest angle.
Which base_of(Which which, bool& farthest) {
  farthest = which == Which::kGamma2 || which == Which::kEta2 || which == Which::kDelta2;
  if (which == Which::kGamma2) return Which::kGamma1;
  if (which == Which::kEta2) return Which::kEta1;
  if (which == Which::kDelta2) return Which::kDelta1;
  return which;
}

struct PairAndDistance {
  RotatedPair pair;
  Which which;
};

/// The pair of a distance over the angles of the moving shape, its centre brought to `centre`.
PairAndDistance rotated_pair(const RotationMaps& maps, const Distance& wanted) {
  const PreparedWorld& world = maps.world();
  Distance d = moving_first(wanted, world.world().moving);
  const Which which = world.which(d);
  if (second_is_moving(d, world.world().moving)) std::swap(d.first, d.second);
  return {RotatedPair(world.shape(d.first), world.shape(d.second), maps.about(), maps.centre()), which};
}

/// Whether a limit of angles can have a better value than those near it: where places to fit come and go, and for a gap
/// places to be free, which in the limit may be there.
bool jumps(const Distance& d, distance::Sense sense) {
  if (d.mode != Mode::kPlain) return is_directional(d);
  const bool least = sense == distance::Sense::kMinimum;
  return !has_rate(d.kind) || d.kind == (least ? Kind::kPenetration : Kind::kGamma1);
}

/// Where the maps that are known leave the truth open.
RotationMap undecided(const Formula& formula, const std::vector<RotationMap>& maps,
                      std::span<const std::size_t> known) {
  std::vector<const RotationMap*> operands;
  for (const std::size_t k : known) operands.push_back(&maps[k]);
  std::vector<Mark> bounds;
  for (std::size_t k = 0; k < maps.size(); ++k) bounds.insert(bounds.end(), {-1, 1});
  return plane::overlay(operands, [&](std::span<const Mark> marks) {
    for (std::size_t i = 0; i < known.size(); ++i) bounds[2 * known[i]] = bounds[2 * known[i] + 1] = marks[i];
    return Mark(certainty(formula, bounds) == 1);
  });
}

void refuse_twice(const Distance& d) {
  refuse(d, "about another point than \"about\" names it is known between bounds only");
}

/// The least step of values that a search of extrema tells apart.
Real step_of_values(const PreparedWorld& world, const Distance& d) {
  return d.mode == Mode::kRotation ? Real::ratio(1, 1000000) : world.step();  // no sign: values are tried on it
}

}  // namespace

RealPoint centre_of(const PreparedWorld& world, const Distance& rotating) {
  return world.steps({rotating.vector.at(0), rotating.vector.at(1)});
}

void require_static(const Distance& d) {
  if (d.prefix != Extremum::kNone) refuse(d, "a distance over time is not computed over all angles, nor at an angle");
}

RealPoint RotationMaps::centre() const { return about_ + at_; }

bool RotationMaps::rotations_twice(const SignMap& wanted) const {
  const Distance& d = wanted.distance;
  if (d.mode != Mode::kRotation || (is_plain_level(wanted) && !wanted.minimum)) return false;
  return !(centre_of(world_, d) == centre());
}

bool RotationMaps::rotations_twice(const Distance& distance) const {
  return rotations_twice(SignMap{distance, Real(1)});
}

bool RotationMaps::rotations_twice(const Formula& formula) const {
  const auto& maps = formula.sign_maps();
  return std::any_of(maps.begin(), maps.end(), [&](const SignMap& m) { return rotations_twice(m); });
}

RotationMaps::Contacts RotationMaps::contacts(const Distance& rotating) const {
  Contacts out;
  const PairAndDistance t = rotated_pair(*this, rotating);
  const Which base = base_of(t.which, out.farthest);
  out.base = t.pair.sign_map(base, Real());
  return out;
}

RotationMap RotationMaps::directional_map(const Distance& wanted, const Real& level) const {
  const Distance d = moving_first(wanted, world_.world().moving);
  const Which which = world_.which(d);
  bool farthest = false;
  const Which base = base_of(which, farthest);
  if (level.sign() == 0 && !farthest) return rotated_pair(*this, d).pair.sign_map(base, level);
  return distance::rotated_directional({world_.shape(d.first), world_.shape(d.second), about_, centre()}, which,
                                       direction(d), level);
}

RotationMap RotationMaps::sign_map(const SignMap& wanted, const RotationMap& within) const {
  const Distance& d = wanted.distance;
  require_static(d);
  if (wanted.minimum) {
    const RotationMap all = RotationMap::uniform(1);
    return plane::remark(best(d, all, distance::Sense::kMinimum).at, [](Mark k) { return Mark(k > 0 ? 0 : 1); });
  }
  if (d.mode == Mode::kRotation && !is_plain_level(wanted)) {
    if (rotations_twice(wanted)) refuse_twice(d);
    const Contacts c = contacts(d);
    return c.farthest ? distance::farthest_rotation_sign_map(c.base, wanted.level)
                      : distance::rotation_sign_map(c.base, wanted.level);
  }
  if (is_directional(d)) return directional_map(d, wanted.level / world_.step());
  const PairAndDistance t = rotated_pair(*this, d);
  return t.pair.within(within).sign_map(t.which, wanted.level / world_.step());
}

int RotationMaps::cost(const SignMap& wanted) const {
  const Distance& d = wanted.distance;
  require_static(d);
  if (rotations_twice(wanted)) refuse_twice(d);
  if (wanted.minimum) return 3;
  if (d.mode == Mode::kRotation) return 0;
  if (is_directional(d)) return 2;
  const Which which = world_.which(moving_first(d, world_.world().moving));
  return RotatedPair::asks_for_corners(which, wanted.level) ? 1 : 0;
}

RotationMap RotationMaps::feasible(const Formula& formula) const {
  const auto& wanted = formula.sign_maps();
  std::vector<int> costs;
  for (const SignMap& m : wanted) costs.push_back(cost(m));
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return costs[p] < costs[q]; });
  std::vector<RotationMap> maps(wanted.size(), RotationMap::uniform(0));
  RotationMap open = RotationMap::uniform(1);
  for (std::size_t known = 0; known < order.size(); ++known) {
    // After every map would cost the square of their number.
    if (known > 0 && std::has_single_bit(known)) open = undecided(formula, maps, std::span(order).first(known));
    if (plane::intervals(open).empty()) break;
    maps[order[known]] = sign_map(wanted[order[known]], open);
  }
  std::vector<const RotationMap*> operands;
  for (const RotationMap& m : maps) operands.push_back(&m);
  return plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
}

distance::RotationOptimum RotationMaps::best(const Distance& d, const RotationMap& within,
                                             distance::Sense sense) const {
  const bool least = sense == distance::Sense::kMinimum;
  const RotationMap there = plane::closure(within);
  const auto sign = [&](const Real& level) {
    return least ? sign_map({d, level}, there)
                 : plane::remark(sign_map({d, -level}, there), [](Mark k) { return Mark(-k); });
  };
  distance::RotatedLevels levels(sign, step_of_values(world_, d));
  const auto search = [&](bool jumping) { return distance::least_rotation(levels, within, jumping); };
  distance::RotationOptimum best = search(false);
  // The greatest gap, where it is above 0, is the limit of those near it.
  const bool is_apart =
      d.mode == Mode::kPlain && d.kind == Kind::kGamma1 && !least && best.value() && best.value()->sign() < 0;
  if (jumps(d, sense) && !is_apart) best = search(true);
  if (least) return best;
  if (best.unbounded) return distance::no_optimum(sense, true, RotationMap::uniform(0));
  best.negate();
  return best;
}

}  // namespace findspace::formula
