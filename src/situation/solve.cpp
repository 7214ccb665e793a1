// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/solve.h"

#include <algorithm>
#include <mutex>

#include "distance/extremum.h"
#include "findspace/error.h"
#include "plane/overlay.h"
#include "plane/parallel.h"
#include "plane/topology.h"
#include "situation/evaluate.h"
#include "situation/text.h"
#include "situation/which.h"

namespace findspace::situation {

using distance::ShapePair;
using distance::TDistancePointer;
using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;

namespace {

void require_plain(const Distance& d) {
  if (d.mode != Mode::kPlain || d.prefix != Extremum::kNone)
    throw Error(ErrorCode::kUnsupported,
                text(d) + ": distances along a direction, in rotation or over time are not computed by this version");
}

}  // namespace

struct Solver::Cache {
  std::mutex guard;
  std::map<Names, std::shared_ptr<const ShapePair>> pairs;
  std::map<std::string, distance::Extremum> least;  // by the distance's text
};

Solver::Solver(World world) : world_(std::move(world)), cache_(std::make_unique<Cache>()) {
  // Distances are those of closed sets.
  for (auto& [name, region] : world_.shapes) region = plane::closure(std::move(region));
}

Solver::~Solver() = default;

plane::Region Solver::shape(const std::vector<std::string>& names) const {
  std::vector<const plane::Region*> parts;
  for (const std::string& n : names) {
    auto found = world_.shapes.find(n);
    if (found == world_.shapes.end()) throw Error(ErrorCode::kUnknownName, "there is no shape '" + n + "'");
    parts.push_back(&found->second);
  }
  return parts.size() == 1 ? *parts[0] : plane::unite(parts);
}

std::shared_ptr<const ShapePair> Solver::pair(const Names& names) const {
  std::lock_guard lock(cache_->guard);
  auto& slot = cache_->pairs[names];
  if (!slot) slot = std::make_shared<ShapePair>(shape(names.first), shape(names.second));
  return slot;
}

TDistancePointer Solver::distance(const Distance& wanted) const {
  Distance d = moving_first(wanted, world_.moving);
  require_plain(d);
  bool second =
      d.first.empty() || std::find(world_.moving.begin(), world_.moving.end(), d.first[0]) == world_.moving.end();
  if (second) std::swap(d.first, d.second);
  return pair({d.first, d.second})->distance(which(d.kind, second));
}

plane::SignMap Solver::sign_map(const SignMap& wanted) const {
  if (!wanted.minimum) return distance(wanted.distance)->sign_map(wanted.level / world_.step);
  distance::Extremum e = least(wanted.distance);
  if (!e.exists) return CellComplex::uniform(1);
  return plane::remark(std::move(e.at), [](Mark k) { return Mark(k > 0 ? 0 : 1); });
}

distance::Extremum Solver::least(const Distance& wanted) const {
  std::string key = text(wanted);
  {
    std::lock_guard lock(cache_->guard);
    auto found = cache_->least.find(key);
    if (found != cache_->least.end()) return found->second;
  }
  distance::Extremum e = distance::least(*distance(wanted));
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
  auto v = distance(wanted)->value(p);
  DistanceAt out{text(wanted), std::nullopt, std::nullopt};
  if (v) out.value = (v->value * world_.step).to_double(), out.nearest = v->nearest;
  return out;
}

Solver::Check Solver::check(const Formula& formula, const RealPoint& position) const {
  RealPoint p = steps(position);
  std::vector<plane::SignMap> maps = sign_maps(formula);
  std::vector<std::int8_t> signs;
  for (const auto& m : maps) signs.push_back(mark_of(m, locate(m, p)));
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    out.atoms.push_back({atom, value(atom.distance, p), holds(atom, signs[formula.sign_map_of(k)])});
  }
  return out;
}

std::vector<DistanceAt> Solver::measure(const RealPoint& position) const {
  RealPoint p = steps(position);
  std::vector<Distance> wanted;
  for (const std::string& b : world_.moving)
    for (const auto& [a, region] : world_.shapes) {
      if (std::find(world_.moving.begin(), world_.moving.end(), a) != world_.moving.end()) continue;
      for (std::size_t k = 0; k < kKindCount; ++k) {
        Distance d;
        d.kind = Kind(k);
        d.first = {b}, d.second = {a};
        wanted.push_back(d);
        bool both = d.kind == Kind::kMu || d.kind == Kind::kH || d.kind == Kind::kDstar;
        if (both) std::swap(d.first, d.second), wanted.push_back(d);
      }
    }
  std::vector<DistanceAt> out(wanted.size());
  plane::parallel_for(out.size(), [&](std::size_t k) { out[k] = value(wanted[k], p); });
  return out;
}

}  // namespace findspace::situation
