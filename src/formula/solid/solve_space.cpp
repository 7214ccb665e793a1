// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/solid/solve_space.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "findspace/error.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"
#include "formula/language/which.h"
#include "formula/solid/prepared_space.h"
#include "plane/base/parallel.h"
#include "plane/base/stopwatch.h"
#include "space/body/observe_body.h"
#include "space/box/box_operations.h"

namespace findspace::formula {

using distance::Answer;
using distance::BoxMaps;
using distance::Way;
using distance::Which;
using exact::Real;
using exact::Refusal;
using exact::Tried;
using plane::Section;
using space::BoxComplex;
using space::Mark;
using space::RealVector;

Tried<PreparedSpace::Named> PreparedSpace::named(const Distance& wanted) const {
  Distance d = moving_first(wanted, world.moving);
  if (d.mode != Mode::kPlain || d.prefix != Extremum::kNone) {
    return refused(
        d, "regions of distances along a direction, and distances in rotation or over time, are not computed in 3D");
  }
  const bool second = second_is_moving(d, world.moving);
  if (second) std::swap(d.first, d.second);
  const auto shapes = [&](const std::vector<std::string>& names) {
    std::vector<const SpaceShape*> parts;
    for (const std::string& n : names) {
      const auto found = world.shapes.find(n);
      if (found == world.shapes.end()) throw Error(ErrorCode::kUnknownName, "there is no shape '" + n + "'");
      if (!found->second.boxes || !found->second.boxes->empty()) parts.push_back(&found->second);
    }
    if (parts.empty())
      throw Error(ErrorCode::kGeometry,
                  fmt::format("shape '{}' is empty: there is no distance to it", fmt::join(names, "+")));
    return parts;
  };
  const std::lock_guard lock(guard_);
  auto& slot = pairs_[{d.first, d.second}];
  if (!slot) slot = std::make_shared<const SpacePair>(shapes(d.first), shapes(d.second));
  if (const auto& why = slot->refusal()) return *why;
  return Named{slot, which(d.kind, second)};
}

Tried<std::optional<Answer>> value_at(const PreparedSpace& prepared, const Distance& wanted, const RealVector& p) {
  if (is_directional(wanted)) return directional_value(prepared, wanted, p);
  const Tried<PreparedSpace::Named> n = prepared.named(wanted);
  if (!n) return n.refusal();
  Tried<std::optional<Answer>> v = n->pair->value(n->which, p);
  return v ? std::move(v) : v.refusal().within(written(wanted));
}

Tried<std::optional<distance::Answer>> nearly_least(const PreparedSpace& prepared, const Distance& wanted) {
  if (is_directional(wanted)) return directional_nearly_least(prepared, wanted);
  const Tried<PreparedSpace::Named> n = prepared.named(wanted);
  if (!n) return n.refusal();
  auto found = n->pair->nearly_least(n->which);
  if (!found || !*found) return found;
  return distance::in_unit(**found, prepared.world.step);
}

Tried<BoxMaps::Least> least(const PreparedSpace& prepared, const Distance& wanted) {
  if (is_directional(wanted)) {
    auto found = directional_least(prepared, wanted);
    if (!found) return found.refusal();
    return found->value_or(BoxMaps::Least{Real(), BoxComplex()});
  }
  const Tried<PreparedSpace::Named> n = prepared.named(wanted);
  if (!n) return n.refusal();
  auto found = n->pair->least(n->which);
  if (!found) return found.refusal();
  if (!*found) return Refusal(written(wanted) + " -> min is not computed in 3D for these shapes");
  return **std::move(found);
}

Tried<BoxComplex> sign_map(const PreparedSpace& prepared, const SignMap& wanted) {
  if (wanted.minimum) {
    const auto found = least(prepared, wanted.distance);
    if (!found) return found.refusal();
    return found->at.remarked([](Mark m) { return Mark(m == 0); });
  }
  if (is_directional(wanted.distance)) return directional_map(prepared, wanted);
  const Tried<PreparedSpace::Named> n = prepared.named(wanted.distance);
  if (!n) return n.refusal();
  const Tried<const BoxMaps*> boxes = n->pair->boxes();
  if (!boxes) return boxes.refusal().within(written(wanted.distance));
  const Tried<BoxComplex> map = (*boxes)->sign_map(n->which, wanted.level / prepared.world.step);
  if (!map) return map.refusal().within(written(wanted.distance));
  observe_boxes("signs",
                fmt::format("positions where the sign of {} minus {:.9g} is not that of far ones",
                            text(wanted.distance), wanted.level.to_double()),
                *map);
  return map;
}

namespace {

struct SignedValue {
  DistanceAt shown;
  int sign = 0;
};

/// Without a value; the sign perhaps by another way.
DistanceAt refused_at(const Distance& wanted, const Refusal& why, Way way) {
  DistanceAt out = distance_at(text(wanted), std::nullopt);
  out.refused = why.error.message();
  out.way = way;
  return out;
}

DistanceAt shown(const PreparedSpace& prepared, const Distance& wanted, const std::optional<Answer>& v) {
  if (!v) return distance_at(text(wanted), std::nullopt);
  DistanceAt out = distance_at(text(wanted), distance::in_scene(*v, prepared.world.step));
  const bool moves = std::find(prepared.world.moving.begin(), prepared.world.moving.end(), wanted.first.at(0)) !=
                     prepared.world.moving.end();
  if (!moves) std::reverse(out.answer->witness.begin(), out.answer->witness.end());
  return out;
}

/// Whether the search for a value ended at its limit: it knows one end, or ends that are far from each other.
bool cut_short(const distance::Enclosure& ends) {
  if (!ends.lower || !ends.upper) return true;
  constexpr double kFar = 0x1p-20;  // no sign: of the value; searches that reach their end leave 2^-30 of the sizes
  return ends.width() > kFar * std::max(std::fabs(ends.lower->to_double()), std::fabs(ends.upper->to_double()));
}

/// Why a level is on no side of a value that is not exact.
std::string between_ends(const PreparedSpace& prepared, const Distance& wanted, const Answer& v) {
  const distance::Enclosure ends = (negated(wanted) ? minus(v) : v).bounds();
  const auto number = [&](const Real& x) { return fmt::format("{:.9g}", (x * prepared.world.step).to_double()); };
  std::string known;
  if (ends.lower && !ends.upper) known = "at least " + number(*ends.lower);
  if (!ends.lower && ends.upper) known = "at most " + number(*ends.upper);
  if (ends.lower && ends.upper && number(*ends.lower) != number(*ends.upper))
    known = "from " + number(*ends.lower) + " to " + number(*ends.upper);
  if (known.empty()) return "the value, found by search, is too near the level to tell on which side of it it lies";
  return "the value is known to be " + known + ", which does not tell on which side of the level it lies";
}

/// Whether all that is asked of a sign map holds alike for two signs.
using Alike = std::function<bool(std::int8_t, std::int8_t)>;

Alike alike_in(const Formula& formula, std::size_t map) {
  return [&formula, map](std::int8_t s, std::int8_t t) {
    bool alike = true;
    for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
      const Atom& atom = formula.atoms()[k];
      alike = alike && (formula.sign_map_of(k) != map || holds(atom, s) == holds(atom, t));
    }
    return alike;
  };
}

/// The sign of a distance minus its level, given its value; of two that hold alike any.
Tried<int> sign(const PreparedSpace& prepared, const SignMap& wanted, const std::optional<Answer>& v,
                const Alike& alike) {
  if (!v) return 1;
  if (v->minus_infinity) return -1;
  const Real level = wanted.level / prepared.world.step;
  if (v->proven) return compare(v->value, level);
  const distance::Enclosure ends = v->bounds();
  if (ends.lower && level < *ends.lower) return 1;
  if (ends.upper && *ends.upper < level) return -1;
  if (ends.lower && level == *ends.lower && alike(0, 1)) return 1;
  if (ends.upper && level == *ends.upper && alike(-1, 0)) return -1;
  std::string why = between_ends(prepared, wanted.distance, *v);
  const Tried<PreparedSpace::Named> pair = prepared.named(wanted.distance);
  const bool searched = !pair || !pair->pair->between();
  if (searched && cut_short(ends)) why += "; a longer search, which --work-limit allows, may tell";
  return refused(wanted.distance, why);
}

/// Whether p is a minimiser, by the whole set of them where that is known, else by its value.
Tried<SignedValue> minimal(const PreparedSpace& prepared, const SignMap& map, const RealVector& p) {
  const auto tried = value_at(prepared, map.distance, p);
  if (!tried) return tried.refusal();
  const std::optional<Answer>& v = *tried;
  const auto outcome = [&](bool least) { return SignedValue{shown(prepared, map.distance, v), least ? 0 : 1}; };
  if (is_directional(map.distance)) {
    const Tried<bool> takes = takes_least(prepared, map.distance, v, p);
    if (!takes) return takes.refusal();
    return outcome(*takes);
  }
  const Tried<PreparedSpace::Named> n = prepared.named(map.distance);
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

/// By the value; where that is not computed, or too near the level, by the exact map or the ray through p.
Tried<SignedValue> signed_value(const PreparedSpace& prepared, const SignMap& map, const RealVector& p,
                                const Alike& alike) {
  if (map.minimum) return minimal(prepared, map, p);
  const auto v = value_at(prepared, map.distance, p);
  const Tried<int> by_value = v ? sign(prepared, map, *v, alike) : v.refusal();
  if (by_value) return SignedValue{shown(prepared, map.distance, *v), *by_value};
  const auto signs_alone = [&](int sign, Way way) {
    return SignedValue{refused_at(map.distance, by_value.refusal(), way), sign};
  };
  if (const auto on_map = sign_map(prepared, map)) return signs_alone(on_map->mark(p), Way::kMap);
  if (!prepared.world.rays) return by_value.refusal();
  const auto on_ray = sign_at_position(*prepared.world.rays, map, p);
  if (!on_ray || !*on_ray) return by_value.refusal();
  return signs_alone(**on_ray, Way::kLines);
}

}  // namespace

SpaceSolver::SpaceSolver(SpaceWorld world) : space_(std::make_unique<const PreparedSpace>(std::move(world))) {}

SpaceSolver::~SpaceSolver() = default;

const SpaceWorld& SpaceSolver::world() const { return space_->world; }

Check SpaceSolver::check(const Formula& formula, const RealVector& position) const {
  const RealVector p = space::scaled(Real(1) / space_->world.step, position);
  std::vector<std::int8_t> signs;
  std::vector<DistanceAt> values;
  std::vector<double> milliseconds;
  for (std::size_t map = 0; map < formula.sign_maps().size(); ++map) {
    const plane::Stopwatch watch;
    const SignedValue found = signed_value(*space_, formula.sign_maps()[map], p, alike_in(formula, map)).or_throw();
    milliseconds.push_back(watch.milliseconds());
    values.push_back(found.shown);
    signs.push_back(static_cast<std::int8_t>(found.sign));
  }
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    const std::size_t map = formula.sign_map_of(k);
    out.atoms.push_back(atom_at(atom, values[map], signs[map]));
    out.atoms.back().way = values[map].way;
    out.atoms.back().milliseconds = milliseconds[map];
  }
  return out;
}

namespace {

/// What the value of a distance follows from: the one that it cuts off at 0, or the two of which it is the greater one.
std::vector<Which> bases(Which which) {
  switch (which) {
    case Which::kD1:
    case Which::kPenetration:
    case Which::kH:
    case Which::kHBack:
      return {distance::cut_off_of(which)->base};
    case Which::kHausdorff:
      return {Which::kMu, Which::kMuBack};
    default:  // containment has ways of its own
      return {};
  }
}

/// It, where it is surely more than 0 and one of them, as it is or negated.
std::optional<Answer> following(Which which, const std::vector<Answer>& of) {
  const auto low = [](const Answer& v) { return v.value.to_double() - v.slack(); };
  const auto cut = distance::cut_off_of(which);
  std::optional<Answer> out;
  for (const Answer& base : of) {
    if (base.minus_infinity) return std::nullopt;
    Answer v = cut ? *distance::cut_off(base, cut->negated) : base;
    if (!out || low(v) > out->value.to_double() + out->slack())
      out = std::move(v);
    else if (!(low(*out) > v.value.to_double() + v.slack()))
      return std::nullopt;
  }
  return out && low(*out) > 0 ? out : std::nullopt;
}

std::vector<Distance> measured(const SpaceWorld& world, const std::vector<Kind>& kinds) {
  std::vector<Distance> out;
  for (const std::string& b : world.moving) {
    for (const auto& [a, shape] : world.shapes) {
      if (std::find(world.moving.begin(), world.moving.end(), a) != world.moving.end()) continue;
      for (std::size_t k = 0; k < kKindCount; ++k) {
        if (!kinds.empty() && std::find(kinds.begin(), kinds.end(), Kind(k)) == kinds.end()) continue;
        Distance d;
        d.kind = Kind(k);
        d.first = {b};
        d.second = {a};
        out.push_back(d);
        const bool both = d.kind == Kind::kMu || d.kind == Kind::kH || d.kind == Kind::kDstar;
        if (both) {
          std::swap(d.first, d.second);
          out.push_back(d);
        }
      }
    }
  }
  return out;
}

}  // namespace

std::vector<DistanceAt> SpaceSolver::measure(const RealVector& position, const std::vector<Kind>& kinds) const {
  const RealVector p = space::scaled(Real(1) / space_->world.step, position);
  const std::vector<Distance> wanted = measured(space_->world, kinds);
  std::vector<Tried<PreparedSpace::Named>> named;
  for (const Distance& d : wanted) named.push_back(space_->named(d));
  // A value that follows from others is found once, with them, mostly.
  std::vector<std::vector<std::size_t>> sources(wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const std::vector<Which> of = named[k] ? bases(named[k]->which) : std::vector<Which>{};
    for (std::size_t j = 0; j < wanted.size(); ++j) {
      if (named[k] && named[j] && named[j]->pair == named[k]->pair &&
          std::find(of.begin(), of.end(), named[j]->which) != of.end())
        sources[k].push_back(j);
    }
    if (sources[k].size() < of.size()) sources[k].clear();
  }
  std::vector<Tried<std::optional<Answer>>> values(wanted.size(), std::optional<Answer>());
  const auto find = [&](std::size_t k) { values[k] = value_at(*space_, wanted[k], p); };
  plane::parallel_for(wanted.size(), [&](std::size_t k) {
    if (sources[k].empty()) find(k);
  });
  plane::parallel_for(wanted.size(), [&](std::size_t k) {
    if (sources[k].empty()) return;
    std::vector<Answer> of;
    for (const std::size_t j : sources[k]) {
      if (values[j] && *values[j]) of.push_back(**values[j]);
    }
    std::optional<Answer> found = of.size() == sources[k].size() ? following(named[k]->which, of) : std::nullopt;
    if (found)
      values[k] = std::move(found);
    else
      find(k);
  });
  std::vector<DistanceAt> out;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    out.push_back(values[k] ? shown(*space_, wanted[k], *values[k])
                            : refused_at(wanted[k], values[k].refusal(), Way::kNone));
  }
  return out;
}

Tried<std::optional<Answer>> SpaceSolver::try_value(const Distance& wanted, const RealVector& p) const {
  return value_at(*space_, wanted, p);
}

SpaceSolver::QuickDistance SpaceSolver::quick_distance(const Distance& wanted) const {
  if (!is_directional(wanted)) {
    if (const Tried<PreparedSpace::Named> n = space_->named(wanted))
      return {n->pair->within(n->which), n->pair->large()};
  }
  return {[](const space::Vector&) { return exact::whole_line(); }};
}

std::optional<RealVector> SpaceSolver::nearest_apart(const Distance& wanted, const Real& level,
                                                     const RealVector& p) const {
  if (is_directional(wanted) || wanted.kind != Kind::kGamma1) return std::nullopt;
  const Tried<PreparedSpace::Named> n = space_->named(wanted);
  return n ? n->pair->nearest_apart(level, p) : std::nullopt;
}

std::optional<Answer> SpaceSolver::value(const Distance& wanted, const RealVector& p) const {
  return try_value(wanted, p).or_throw();
}

Tried<BoxComplex> SpaceSolver::try_feasible(const Formula& formula) const {
  return try_region(formula, [&](std::span<const Mark> marks) { return evaluate(formula, marks); });
}

Tried<BoxComplex> SpaceSolver::try_region(const Formula& formula, const Rule& rule) const {
  std::vector<BoxComplex> maps;
  for (const SignMap& m : formula.sign_maps()) {
    Tried<BoxComplex> map = sign_map(*space_, m);
    if (!map) return map;
    maps.push_back(*std::move(map));
  }
  std::vector<const BoxComplex*> operands;
  for (const BoxComplex& m : maps) operands.push_back(&m);
  const Tried<BoxComplex> cells =
      overlay(operands, [&](std::span<const Mark> marks) { return Mark(rule(marks)); }).checked();
  if (!cells) return cells;
  observe_boxes("cells", "cells of the region, or of its complement where that is bounded", *cells);
  return cells->simplified();
}

BoxComplex SpaceSolver::feasible(const Formula& formula) const { return try_feasible(formula).or_throw(); }

Tried<std::optional<SpaceSolver::ConvexMap>> SpaceSolver::feasible_convex(const Formula& formula) const {
  if (formula.sign_maps().size() != 1 || formula.sign_maps()[0].minimum) return std::nullopt;
  const SignMap& map = formula.sign_maps()[0];
  if (is_directional(map.distance)) return std::nullopt;
  const Tried<PreparedSpace::Named> n = space_->named(map.distance);
  if (!n) return n.refusal();
  auto found = n->pair->sublevel(n->which, map.level / space_->world.step);
  if (!found) return std::nullopt;
  const auto holds_at = [&](std::int8_t sign) { return evaluate(formula, std::array<std::int8_t, 1>{sign}); };
  return ConvexMap{{std::move(found->region), holds_at(-1), holds_at(0), holds_at(1), found->radius},
                   space_->world.step / found->scale};
}

SpaceSolver::OnLine SpaceSolver::feasible_on(const Formula& formula, const SpaceLine& line) const {
  const auto rule = [&](std::span<const Mark> signs) { return Mark(evaluate(formula, signs)); };
  if (formula.sign_maps().empty()) return {{rule({}), {}}, Side::kExact, {}};
  std::vector<Section> all;
  std::vector<bool> searched;
  for (const SignMap& map : formula.sign_maps()) {
    LineSigns signs = signs_on(*space_, map, line).or_throw();
    all.push_back(std::move(signs.section));
    searched.push_back(signs.searched);
  }
  const auto open = [&](std::span<const Mark> signs) {
    std::vector<std::int8_t> between;
    for (std::size_t k = 0; k < signs.size(); ++k) {
      const bool any = searched[k] && signs[k] == 0;
      between.push_back(any ? std::int8_t(-1) : signs[k]);
      between.push_back(any ? std::int8_t(1) : signs[k]);
    }
    return Mark(certainty(formula, between) == 1);
  };
  const Side side = side_of_search(formula, searched);
  return {overlay_sections(all, rule), side, side == Side::kExact ? Section() : overlay_sections(all, open)};
}

std::optional<distance::OptimumOf<BoxComplex>> SpaceSolver::minimum_of(const Formula& formula) const {
  for (const SignMap& m : formula.sign_maps()) {
    if (!m.minimum) continue;
    distance::OptimumOf<BoxComplex> out;
    // An infimum that no position takes is decided as well.
    if (is_directional(m.distance)) {
      if (const auto infimum = directional_least(*space_, m.distance).or_throw())
        out.set_exact(infimum->value * space_->world.step, distance::Way::kBoxes);
    }
    BoxMaps::Least found = least(*space_, m.distance).or_throw();
    if (!found.at.empty()) {
      out.set_exact(found.value * space_->world.step, distance::Way::kBoxes);
      out.attained = true;
    }
    out.at = std::move(found.at);
    return out;
  }
  return std::nullopt;
}

Tried<std::optional<distance::Answer>> SpaceSolver::try_nearly_least(const Distance& wanted) const {
  return formula::nearly_least(*space_, wanted);
}

std::optional<distance::Answer> SpaceSolver::nearly_least(const Distance& wanted) const {
  return try_nearly_least(wanted).or_throw();
}

}  // namespace findspace::formula
