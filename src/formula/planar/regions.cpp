// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "distance/rotation/motion_maps.h"
#include "distance/rotation/rotational_by_position.h"
#include "exact/margins/formula.h"
#include "formula/language/evaluate.h"
#include "formula/language/level_truth.h"
#include "formula/language/text.h"
#include "formula/planar/least_values.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/rotation_values.h"
#include "plane/base/parallel.h"
#include "plane/base/stage_observer.h"
#include "plane/complex/overlay.h"
#include "plane/complex/refinement.h"

namespace findspace::formula {

using distance::BoundedMaps;
using distance::Which;
using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;

namespace {

const Real kAllRotations(-180);  // below it a rotational distance is -infinity

BoundedMaps bounded_maps(const PreparedWorld& world, const SignMap& asked);

/// The least value lies between bounds, and so do the positions: those where the lower bound of the distance is not
/// above the least value's upper one.
BoundedMaps bounded_minimisers(const PreparedWorld& world, const SignMap& wanted) {
  const distance::Extremum best = least(world, wanted.distance);
  const auto map = [](plane::SignMap m, auto belongs) {
    return plane::remark(std::move(m), [belongs](Mark k) { return Mark(belongs(k) ? 0 : 1); });
  };
  if (best.unbounded && wanted.distance.mode == Mode::kRotation) {
    const BoundedMaps all = bounded_maps(world, {wanted.distance, kAllRotations});
    const auto below = [](Mark k) { return k < 0; };
    return {map(all.low, below), map(all.high, below)};
  }
  if (!best.exists()) return {CellComplex::uniform(best.proven() ? 1 : 0), CellComplex::uniform(1)};
  const bool rotation = wanted.distance.mode == Mode::kRotation;
  const double level = distance::near_value(best.answer->value);
  const Real above = Real::from_double(level + (std::abs(level) + 1) * margin::kAboveLeast);
  const BoundedMaps near = bounded_maps(world, {wanted.distance, rotation ? above : above * world.step()});
  return {map(near.low, [](Mark k) { return k <= 0; }), CellComplex::uniform(1)};
}

/// The lowest and the highest sign that may be at each position.
BoundedMaps bounded_maps(const PreparedWorld& world, const SignMap& asked) {
  const SignMap wanted = plain_level(asked);
  const Roles r = world.roles(wanted.distance);
  if (!r.rotating && !in_rotation(wanted)) {
    plane::SignMap exact = sign_map(world, wanted);
    return {exact, exact};
  }
  if (wanted.minimum) return bounded_minimisers(world, wanted);
  const distance::Sense sense = sense_over_time(r.wanted);
  if (in_rotation(wanted)) {
    const RealPoint centre = world.steps({r.wanted.vector.at(0), r.wanted.vector.at(1)});
    const Which kind = r.which();
    const plane::SharedRegion b = world.shape(r.names.first), a = world.shape(r.names.second);
    const double step = world.step().to_double();
    if (!world.motion().given()) return distance::rotation_position_maps(b, a, kind, centre, wanted.level, step);
    return distance::rotation_position_maps(b, a, kind, centre, wanted.level, rotation_poses(world, r, false), sense,
                                            step);
  }
  if (r.wanted.mode != Mode::kPlain)
    refuse(r.wanted, "only distances in all directions are computed of shapes that rotate in time");
  Which kind = r.which();
  // Containment down from level 0 is the directed Hausdorff distance, which changes no faster than the shapes do.
  if ((kind == Which::kEta1 || kind == Which::kDelta1) && wanted.level.sign() <= 0)
    kind = kind == Which::kEta1 ? Which::kMu : Which::kMuBack;
  const auto bounds = [&](Which of, const Real& level) {
    return distance::motion_maps(world.shape(r.names.first), world.shape(r.names.second), of,
                                 rotation_poses(world, r, false), sense, level / world.step(),
                                 world.step().to_double());
  };
  const bool eta = kind == Which::kEta1 || kind == Which::kEta2, first = kind == Which::kEta1 || kind == Which::kDelta1;
  if (!eta && !first && kind != Which::kDelta2) return bounds(kind, wanted.level);
  // The places where a shape fits come and go with its angle. But eta is at least mu, and eta1 not above 0 where mu is
  // not.
  const Which mu = eta ? Which::kMu : Which::kMuBack;
  BoundedMaps out{bounds(mu, wanted.level).low, plane::SignMap::uniform(1)};
  if (first) out.high = plane::remark(bounds(mu, Real()).high, [](Mark k) { return Mark(k <= 0 ? -1 : 1); });
  return out;
}

/// All cells of the overlay, those of one vector of signs with one mark.
void observe_overlay(plane::StageObserver& observer, const std::vector<const CellComplex*>& operands) {
  constexpr std::size_t kMarks = 127;  // of signs with more vectors some share a mark
  std::map<std::vector<Mark>, std::size_t> number;
  const CellComplex cells = plane::overlay(operands, [&](std::span<const Mark> signs) {
    const auto known = number.emplace(std::vector<Mark>(signs.begin(), signs.end()), number.size());
    return Mark(known.first->second % kMarks);
  });
  observer.cells("overlay", fmt::format("overlay of {} sign maps, a mark for each vector of signs", operands.size()),
                 cells);
}

}  // namespace

plane::SignMap observed(const SignMap& wanted, plane::SignMap map) {
  if (plane::StageObserver* observer = plane::stage_observer()) {
    const std::string level = wanted.minimum ? "its least value" : fmt::format("{:.9g}", wanted.level.to_double());
    observer->cells("signs", fmt::format("sign of {} minus {}", text(wanted.distance), level), map);
  }
  return map;
}

plane::SignMap sign_map(const PreparedWorld& world, const SignMap& asked) {
  const SignMap wanted = plain_level(asked);
  if (!wanted.more.empty()) refuse(wanted.distance, "compared with other distances it has no sign map of its own");
  return observed(wanted, wanted.minimum
                              ? minimiser_map(least(world, wanted.distance))
                              : position_function(world, wanted.distance)->sign_map(wanted.level / world.step()));
}

std::vector<plane::SignMap> sign_maps(const PreparedWorld& world, const Formula& formula) {
  std::vector<plane::SignMap> maps(formula.sign_maps().size());
  plane::parallel_for(maps.size(), [&](std::size_t k) { maps[k] = sign_map(world, formula.sign_maps()[k]); });
  return maps;
}

plane::Region region_of(const Formula& formula, std::vector<plane::SignMap> maps) {
  if (maps.empty()) return CellComplex::uniform(evaluate(formula, {}));
  plane::StageObserver* const observer = plane::stage_observer();
  std::vector<const CellComplex*> operands;
  for (const auto& m : maps) operands.push_back(&m);
  if (observer) observe_overlay(*observer, operands);
  const auto holds = [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); };
  plane::Region region = maps.size() == 1 ? plane::remark(std::move(maps[0]),
                                                          [&](Mark m) {
                                                            return holds({&m, 1});
                                                          })
                                          : plane::overlay(operands, holds);
  if (observer) observer->cells("region", "positions at which the formula, or a part of it, holds", region);
  return region;
}

std::optional<plane::Region> region_of_levels(const Formula& formula, const MakeSignMap& make) {
  if (plane::stage_observer() != nullptr) return std::nullopt;
  const std::optional<LevelTruth> truth = level_truth(formula);
  if (!truth) return std::nullopt;
  if (truth->sign_maps.empty()) {
    make(formula.sign_maps()[0]);  // throws where there is no such distance
    return CellComplex::uniform(truth->sum.first > 0 ? 1 : 0);
  }
  std::vector<SignMap> wanted;
  for (const std::size_t k : truth->sign_maps) wanted.push_back(formula.sign_maps()[k]);
  std::vector<plane::SignMap> maps(wanted.size());
  plane::parallel_for(maps.size(), [&](std::size_t k) { maps[k] = make(wanted[k]); });
  std::vector<const plane::SignMap*> operands;
  for (const auto& m : maps) operands.push_back(&m);
  // A distance in all directions is continuous: it has one value at a place, also in the limit.
  return plane::summed(operands, truth->sum, wanted[0].distance.mode == Mode::kPlain);
}

std::optional<exact::Refusal> between_bounds(const PreparedWorld& world, const Formula& formula) {
  for (const SignMap& asked : formula.sign_maps()) {
    if (!asked.more.empty())
      return refused(asked.distance, "compared with other distances it has a region between two sets");
    if (asked.minimum) continue;  // the least value has positions
    if (auto why = between_bounds(world, plain_level(asked).distance)) return why;
  }
  return std::nullopt;
}

namespace {

/// From so many levels on, a distance of a formula with others has a region of its own.
constexpr std::size_t kManyLevels = 32;

/// The formula's operands as formulas: those of one distance with many levels together, the others in one.
std::vector<Formula> parts_by_distance(const Formula& formula) {
  const bool all = formula.root().op == Node::Op::kAnd;
  const auto joined = [&](std::span<const Formula> some) { return all ? conjunction(some) : disjunction(some); };
  std::vector<std::vector<Formula>> alike;
  for (const Node& node : formula.root().operands) {
    const Formula operand = part_of(formula, node);
    const auto same = std::find_if(alike.begin(), alike.end(),
                                   [&](const std::vector<Formula>& some) { return of_one_distance(some[0], operand); });
    if (same != alike.end())
      same->push_back(operand);
    else
      alike.push_back({operand});
  }
  std::vector<Formula> out, rest;
  for (const std::vector<Formula>& some : alike) {
    const Formula one = joined(some);
    if (one.sign_maps().size() >= kManyLevels && of_one_distance(one, one))
      out.push_back(one);
    else
      rest.push_back(one);
  }
  if (!rest.empty()) out.push_back(joined(rest));
  return out;
}

/// Of a formula of several distances some of which have many levels: each of these by itself. Nothing for another one.
std::optional<plane::Region> region_of_parts(const PreparedWorld& world, const Formula& formula) {
  const Node::Op op = formula.root().op;
  if ((op != Node::Op::kAnd && op != Node::Op::kOr) || formula.sign_maps().size() < kManyLevels ||
      plane::stage_observer() != nullptr)
    return std::nullopt;
  const std::vector<Formula> parts = parts_by_distance(formula);
  if (parts.size() < 2) return std::nullopt;
  std::vector<plane::Region> regions;
  for (const Formula& part : parts) regions.push_back(feasible(world, part));
  std::vector<const plane::Region*> all;
  for (const plane::Region& r : regions) all.push_back(&r);
  return op == Node::Op::kAnd ? plane::intersect(all) : plane::unite_arranged(all);
}

}  // namespace

std::optional<plane::Region> region_by_levels(const PreparedWorld& world, const Formula& formula) {
  auto region = region_of_levels(formula, [&](const SignMap& wanted) { return sign_map(world, wanted); });
  return region ? std::move(region) : region_of_parts(world, formula);
}

plane::Region feasible(const PreparedWorld& world, const Formula& formula) {
  if (auto region = region_by_levels(world, formula)) return *std::move(region);
  return region_of(formula, sign_maps(world, formula));
}

RegionBounds feasible_bounds(const PreparedWorld& world, const Formula& formula) {
  const std::size_t n = formula.sign_maps().size();
  std::vector<BoundedMaps> maps(n);
  for (std::size_t k = 0; k < n; ++k) maps[k] = bounded_maps(world, formula.sign_maps()[k]);
  std::vector<const CellComplex*> operands;
  for (const auto& m : maps) operands.insert(operands.end(), {&m.low, &m.high});
  // 2 where every choice of signs between the bounds satisfies the formula, 1 where some does.
  const CellComplex both =
      plane::overlay(operands, [&](std::span<const Mark> marks) { return certainty(formula, marks); });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

}  // namespace findspace::formula
