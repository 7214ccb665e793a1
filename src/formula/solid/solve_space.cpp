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
#include "formula/solid/solve_rays.h"
#include "formula/solid/space_pair.h"
#include "plane/base/parallel.h"
#include "space/box/box_operations.h"

namespace findspace::formula {

using distance::BoxPair;
using distance::SolidValue;
using distance::Which;
using exact::Real;
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

SpaceSolver::Named SpaceSolver::named(const Distance& wanted) const {
  Distance d = moving_first(wanted, world_.moving);
  if (d.mode != Mode::kPlain || d.prefix != Extremum::kNone) {
    throw Error(
        ErrorCode::kUnsupported,
        text(d) +
            ": regions of distances along a direction, and distances in rotation or over time, are not computed in 3D");
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
  return {slot, which(d.kind, second)};
}

std::optional<SolidValue> SpaceSolver::value(const Distance& wanted, const RealVector& p) const {
  if (is_directional(wanted)) return directional_value(wanted, p);
  const Named n = named(wanted);
  try {
    return n.pair->value(n.which, p);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    throw e.within(text(wanted));
  }
}

SpaceDistanceAt SpaceSolver::shown(const Distance& wanted, const std::optional<SolidValue>& v) const {
  SpaceDistanceAt out{text(wanted), std::nullopt, std::nullopt, std::nullopt, {}};
  if (!v) return out;
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

int SpaceSolver::sign(const SignMap& wanted, const std::optional<SolidValue>& v) const {
  if (!v) return 1;
  if (v->lowest) return -1;
  const Real level = wanted.level / world_.step;
  if (!v->proven) {
    const double gap = std::fabs((v->value - level).to_double());
    if (gap <= std::max(0x1p-34 * std::fabs(v->value.to_double()), v->error)) {
      throw Error(ErrorCode::kUnsupported, text(wanted.distance) +
                                               ": the value, found by search, is too near the level " +
                                               "to tell on which side of it it lies");
    }
  }
  return compare(v->value, level);
}

/// Whether p is a minimiser, by the whole set of them where that is known, else by its value.
SpaceSolver::SignedValue SpaceSolver::minimal(const SignMap& map, const RealVector& p) const {
  const auto v = value(map.distance, p);
  if (is_directional(map.distance)) return {shown(map.distance, v), takes_least(map.distance, v, p) ? 0 : 1};
  const Named n = named(map.distance);
  if (const auto whole = n.pair->least(n.which)) return {shown(map.distance, v), whole->at.mark(p) == 0 ? 1 : 0};
  const auto least = n.pair->nearly_least(n.which);
  const auto order = [&] {
    if (!v || !least || least->value < v->value) return 1;
    if (least->proven && v->proven) return 0;
    throw Error(ErrorCode::kUnsupported, text(map.distance) +
                                             ": the value is too near the least one, which is known to " +
                                             "rounding only, to tell whether the position is a minimiser");
  };
  return {shown(map.distance, v), order()};
}

std::optional<distance::SolidLeast> SpaceSolver::nearly_least(const Distance& wanted) const {
  if (is_directional(wanted)) return directional_nearly_least(wanted);
  const Named n = named(wanted);
  auto found = n.pair->nearly_least(n.which);
  if (!found) return found;
  found->value *= world_.step;
  found->bound *= world_.step;
  found->at = space::scaled(world_.step, found->at);
  return found;
}

/// By the exact map of all positions, where there is one.
std::optional<int> SpaceSolver::sign_on_map(const SignMap& map, const RealVector& p) const {
  try {
    return sign_map(map).mark(p);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    return std::nullopt;
  }
}

/// Where the value is not computed, its sign may be.
SpaceSolver::SignedValue SpaceSolver::signed_value(const SignMap& map, const RealVector& p) const {
  if (map.minimum) return minimal(map, p);
  try {
    const auto v = value(map.distance, p);
    return {shown(map.distance, v), sign(map, v)};
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    auto sign = sign_on_map(map, p);
    if (!sign && world_.rays) sign = sign_at_position(*world_.rays, map, p);
    if (!sign) throw;
    SpaceDistanceAt at{text(map.distance), {}, {}, {}, e.message()};
    return {std::move(at), *sign};
  }
}

SpaceSolver::Check SpaceSolver::check(const Formula& formula, const RealVector& position) const {
  const RealVector p = space::scaled(Real(1) / world_.step, position);
  std::vector<std::int8_t> signs;
  std::vector<SpaceDistanceAt> values;
  for (const SignMap& m : formula.sign_maps()) {
    const SignedValue found = signed_value(m, p);
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
    try {
      out[k] = shown(wanted[k], value(wanted[k], p));
    } catch (const Error& e) {
      if (e.code() != ErrorCode::kUnsupported) throw;
      out[k].text = text(wanted[k]);
      out[k].refused = e.message();
    }
  });
  return out;
}

BoxPair::Least SpaceSolver::least(const Distance& wanted) const {
  if (is_directional(wanted)) return directional_least(wanted).value_or(BoxPair::Least{Real(), BoxComplex()});
  const Named n = named(wanted);
  auto found = n.pair->least(n.which);
  if (!found) {
    throw Error(ErrorCode::kUnsupported, text(wanted) + " -> min is not computed in 3D for these shapes");
  }
  return *found;
}

BoxComplex SpaceSolver::sign_map(const SignMap& wanted) const {
  if (wanted.minimum) return least(wanted.distance).at.remarked([](Mark m) { return Mark(m == 0); });
  if (is_directional(wanted.distance)) return directional_map(wanted);
  const Named n = named(wanted.distance);
  try {
    return n.pair->boxes().sign_map(n.which, wanted.level / world_.step);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::kUnsupported) throw;
    throw e.within(text(wanted.distance));
  }
}

BoxComplex SpaceSolver::feasible(const Formula& formula) const {
  std::vector<BoxComplex> maps;
  for (const SignMap& m : formula.sign_maps()) maps.push_back(sign_map(m));
  std::vector<const BoxComplex*> operands;
  for (const BoxComplex& m : maps) operands.push_back(&m);
  return overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); }).simplified();
}

std::optional<SpaceSolver::ConvexMap> SpaceSolver::feasible_convex(const Formula& formula) const {
  if (formula.sign_maps().size() != 1 || formula.sign_maps()[0].minimum) return std::nullopt;
  const SignMap& map = formula.sign_maps()[0];
  if (is_directional(map.distance)) return std::nullopt;
  const Named n = named(map.distance);
  auto found = n.pair->sublevel(n.which, map.level / world_.step);
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
      if (const auto infimum = directional_least(m.distance)) out.value = infimum->value * world_.step;
    }
    BoxPair::Least found = least(m.distance);
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
