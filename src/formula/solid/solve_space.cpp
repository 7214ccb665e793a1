// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/solid/solve_space.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/number/margins.h"
#include "findspace/error.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/language/which.h"
#include "formula/solid/solve_rays.h"
#include "formula/solid/space_pair.h"
#include "plane/base/parallel.h"
#include "space/box/box_operations.h"

namespace findspace::formula {

using distance::Answer;
using distance::BoxPair;
using distance::Way;
using distance::Which;
using exact::Real;
using exact::Refusal;
using exact::Tried;
using space::BoxComplex;
using space::dot;
using space::Mark;
using space::RealVector;

struct SpaceSolver::Cache {
  using Names = std::pair<std::vector<std::string>, std::vector<std::string>>;  // moving, fixed
  std::mutex guard;
  std::map<Names, std::shared_ptr<const SpacePair>> pairs;
};

SpaceSolver::SpaceSolver(SpaceWorld world) : world_(std::move(world)), cache_(std::make_unique<Cache>()) {}

SpaceSolver::~SpaceSolver() = default;

Tried<SpaceSolver::Named> SpaceSolver::named(const Distance& wanted) const {
  Distance d = moving_first(wanted, world_.moving);
  if (d.mode != Mode::kPlain || d.prefix != Extremum::kNone) {
    return refused(
        d, "regions of distances along a direction, and distances in rotation or over time, are not computed in 3D");
  }
  const bool second = std::find(world_.moving.begin(), world_.moving.end(), d.first.at(0)) == world_.moving.end();
  if (second) std::swap(d.first, d.second);
  const auto shapes = [&](const std::vector<std::string>& names) {
    std::vector<const SpaceShape*> parts;
    for (const std::string& n : names) {
      const auto found = world_.shapes.find(n);
      if (found == world_.shapes.end()) throw Error(ErrorCode::kUnknownName, "there is no shape '" + n + "'");
      if (!found->second.boxes || !found->second.boxes->empty()) parts.push_back(&found->second);
    }
    if (parts.empty())
      throw Error(ErrorCode::kGeometry,
                  fmt::format("shape '{}' is empty: there is no distance to it", fmt::join(names, "+")));
    return parts;
  };
  const std::lock_guard lock(cache_->guard);
  auto& slot = cache_->pairs[{d.first, d.second}];
  if (!slot) slot = std::make_shared<const SpacePair>(shapes(d.first), shapes(d.second));
  if (const auto& why = slot->refusal()) return *why;
  return Named{slot, which(d.kind, second)};
}

Tried<std::optional<Answer>> SpaceSolver::try_value(const Distance& wanted, const RealVector& p) const {
  if (is_directional(wanted)) return directional_value(wanted, p);
  const Tried<Named> n = named(wanted);
  if (!n) return n.refusal();
  Tried<std::optional<Answer>> v = n->pair->value(n->which, p);
  return v ? std::move(v) : v.refusal().within(text(wanted));
}

std::optional<Answer> SpaceSolver::value(const Distance& wanted, const RealVector& p) const {
  return try_value(wanted, p).or_throw();
}

SpaceDistanceAt SpaceSolver::shown(const Distance& wanted, const std::optional<Answer>& v) const {
  SpaceDistanceAt out{text(wanted), std::nullopt, std::nullopt, std::nullopt, {}};
  if (!v) return out;
  out.way = v->way;
  out.value = v->lowest ? -exact::kInfinity : (v->value * world_.step).to_double();
  const auto place = [&](const RealVector& q) {
    return SpacePlace{(q[0] * world_.step).to_double(), (q[1] * world_.step).to_double(),
                      (q[2] * world_.step).to_double()};
  };
  if (v->nearest) out.nearest = place(*v->nearest);
  if (v->points) out.points = {place((*v->points)[0]), place((*v->points)[1])};
  const bool moves = std::find(world_.moving.begin(), world_.moving.end(), wanted.first.at(0)) != world_.moving.end();
  if (out.points && !moves) std::swap((*out.points)[0], (*out.points)[1]);
  return out;
}

Tried<int> SpaceSolver::sign(const SignMap& wanted, const std::optional<Answer>& v) const {
  if (!v) return 1;
  if (v->lowest) return -1;
  const Real level = wanted.level / world_.step;
  if (!v->proven && std::fabs((v->value - level).to_double()) <= v->slack())
    return refused(wanted.distance,
                   "the value, found by search, is too near the level to tell on which side of it it lies");
  return compare(v->value, level);
}

/// Whether p is a minimiser, by the whole set of them where that is known, else by its value.
Tried<SpaceSolver::SignedValue> SpaceSolver::minimal(const SignMap& map, const RealVector& p) const {
  const auto tried = try_value(map.distance, p);
  if (!tried) return tried.refusal();
  const std::optional<Answer>& v = *tried;
  const auto outcome = [&](bool least) { return SignedValue{shown(map.distance, v), least ? 0 : 1}; };
  if (is_directional(map.distance)) {
    const Tried<bool> takes = takes_least(map.distance, v, p);
    if (!takes) return takes.refusal();
    return outcome(*takes);
  }
  const Tried<Named> n = named(map.distance);
  if (!n) return n.refusal();
  const auto whole = n->pair->least(n->which);
  if (!whole) return whole.refusal();
  if (*whole) return outcome((*whole)->at.mark(p) != 0);
  const auto nearly = n->pair->nearly_least(n->which);
  if (!nearly) return nearly.refusal();
  const std::optional<distance::Answer>& least = *nearly;
  if (!v || !least || least->value < v->value) return outcome(false);
  if (least->proven && v->proven) return outcome(true);
  return refused(map.distance,
                 "the value is too near the least one, which is known to rounding only, to tell whether the position "
                 "is a minimiser");
}

Tried<std::optional<distance::Answer>> SpaceSolver::try_nearly_least(const Distance& wanted) const {
  if (is_directional(wanted)) return directional_nearly_least(wanted);
  const Tried<Named> n = named(wanted);
  if (!n) return n.refusal();
  auto found = n->pair->nearly_least(n->which);
  if (!found || !*found) return found;
  distance::Answer& least = **found;
  least.value *= world_.step;
  least.bound *= world_.step;
  least.at = space::scaled(world_.step, least.at);
  return found;
}

std::optional<distance::Answer> SpaceSolver::nearly_least(const Distance& wanted) const {
  return try_nearly_least(wanted).or_throw();
}

/// By the value; where that is not computed, or too near the level, by the exact map or the ray through p.
Tried<SpaceSolver::SignedValue> SpaceSolver::signed_value(const SignMap& map, const RealVector& p) const {
  if (map.minimum) return minimal(map, p);
  const auto v = try_value(map.distance, p);
  const Tried<int> by_value = v ? sign(map, *v) : v.refusal();
  if (by_value) return SignedValue{shown(map.distance, *v), *by_value};
  const auto signs_alone = [&](int sign, Way way) {
    return SignedValue{{text(map.distance), {}, {}, {}, by_value.refusal().error.message(), way}, sign};
  };
  if (const auto on_map = sign_map(map)) return signs_alone(on_map->mark(p), Way::kMap);
  if (!world_.rays) return by_value.refusal();
  const auto on_ray = sign_at_position(*world_.rays, map, p);
  if (!on_ray) return on_ray.refusal();
  if (!*on_ray) return by_value.refusal();
  return signs_alone(**on_ray, Way::kLines);
}

SpaceSolver::Check SpaceSolver::check(const Formula& formula, const RealVector& position) const {
  const RealVector p = space::scaled(Real(1) / world_.step, position);
  std::vector<std::int8_t> signs;
  std::vector<SpaceDistanceAt> values;
  for (const SignMap& m : formula.sign_maps()) {
    const SignedValue found = signed_value(m, p).or_throw();
    values.push_back(found.shown);
    signs.push_back(static_cast<std::int8_t>(found.sign));
  }
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    const std::size_t map = formula.sign_map_of(k);
    SpaceAtomAt a{atom, values[map], holds(atom, signs[map]), std::nullopt};
    if (!a.holds && a.distance.value && std::isfinite(*a.distance.value) && !atom.minimum)
      a.lacks = std::abs(*a.distance.value - atom.level.to_double());
    out.atoms.push_back(std::move(a));
  }
  return out;
}

std::vector<SpaceDistanceAt> SpaceSolver::measure(const RealVector& position) const {
  const RealVector p = space::scaled(Real(1) / world_.step, position);
  std::vector<Distance> wanted;
  for (const std::string& b : world_.moving) {
    for (const auto& [a, shape] : world_.shapes) {
      if (std::find(world_.moving.begin(), world_.moving.end(), a) != world_.moving.end()) continue;
      for (std::size_t k = 0; k < kKindCount; ++k) {
        Distance d;
        d.kind = Kind(k);
        d.first = {b};
        d.second = {a};
        wanted.push_back(d);
        const bool both = d.kind == Kind::kMu || d.kind == Kind::kH || d.kind == Kind::kDstar;
        if (both) {
          std::swap(d.first, d.second);
          wanted.push_back(d);
        }
      }
    }
  }
  std::vector<SpaceDistanceAt> out(wanted.size());
  plane::parallel_for(out.size(), [&](std::size_t k) {
    const auto v = try_value(wanted[k], p);
    if (v)
      out[k] = shown(wanted[k], *v);
    else
      out[k] = {text(wanted[k]), {}, {}, {}, v.refusal().error.message()};
  });
  return out;
}

Tried<BoxPair::Least> SpaceSolver::least(const Distance& wanted) const {
  if (is_directional(wanted)) {
    auto found = directional_least(wanted);
    if (!found) return found.refusal();
    return found->value_or(BoxPair::Least{Real(), BoxComplex()});
  }
  const Tried<Named> n = named(wanted);
  if (!n) return n.refusal();
  auto found = n->pair->least(n->which);
  if (!found) return found.refusal();
  if (!*found) return Refusal(text(wanted) + " -> min is not computed in 3D for these shapes");
  return **std::move(found);
}

Tried<BoxComplex> SpaceSolver::sign_map(const SignMap& wanted) const {
  if (wanted.minimum) {
    const auto found = least(wanted.distance);
    if (!found) return found.refusal();
    return found->at.remarked([](Mark m) { return Mark(m == 0); });
  }
  if (is_directional(wanted.distance)) return directional_map(wanted);
  const Tried<Named> n = named(wanted.distance);
  if (!n) return n.refusal();
  const Tried<const BoxPair*> boxes = n->pair->boxes();
  const auto map =
      boxes ? exact::tried([&] { return (*boxes)->sign_map(n->which, wanted.level / world_.step); }) : boxes.refusal();
  return map ? map : map.refusal().within(text(wanted.distance));
}

Tried<BoxComplex> SpaceSolver::try_feasible(const Formula& formula) const {
  std::vector<BoxComplex> maps;
  for (const SignMap& m : formula.sign_maps()) {
    Tried<BoxComplex> map = sign_map(m);
    if (!map) return map;
    maps.push_back(*std::move(map));
  }
  std::vector<const BoxComplex*> operands;
  for (const BoxComplex& m : maps) operands.push_back(&m);
  return exact::tried([&] {
    return overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); }).simplified();
  });
}

BoxComplex SpaceSolver::feasible(const Formula& formula) const { return try_feasible(formula).or_throw(); }

Tried<std::optional<SpaceSolver::ConvexMap>> SpaceSolver::feasible_convex(const Formula& formula) const {
  if (formula.sign_maps().size() != 1 || formula.sign_maps()[0].minimum) return std::nullopt;
  const SignMap& map = formula.sign_maps()[0];
  if (is_directional(map.distance)) return std::nullopt;
  const Tried<Named> n = named(map.distance);
  if (!n) return n.refusal();
  auto found = n->pair->sublevel(n->which, map.level / world_.step);
  if (!found) return std::nullopt;
  const auto holds_at = [&](std::int8_t sign) { return evaluate(formula, std::array<std::int8_t, 1>{sign}); };
  return ConvexMap{{std::move(found->region), holds_at(-1), holds_at(0), holds_at(1), found->radius},
                   world_.step / found->scale};
}

std::optional<SpaceOptimum> SpaceSolver::minimum_of(const Formula& formula) const {
  for (const SignMap& m : formula.sign_maps()) {
    if (!m.minimum) continue;
    SpaceOptimum out;
    // An infimum that no position takes is decided as well.
    if (is_directional(m.distance)) {
      if (const auto infimum = directional_least(m.distance).or_throw()) out.value = infimum->value * world_.step;
    }
    BoxPair::Least found = least(m.distance).or_throw();
    if (!found.at.empty()) {
      out.value = found.value * world_.step;
      out.attained = true;
    }
    out.at = std::move(found.at);
    return out;
  }
  return std::nullopt;
}

}  // namespace findspace::formula
