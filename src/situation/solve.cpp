// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/solve.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "distance/extremum.h"
#include "findspace/error.h"
#include "plane/nearest.h"
#include "plane/overlay.h"
#include "plane/parallel.h"
#include "plane/topology.h"
#include "situation/evaluate.h"
#include "situation/text.h"

namespace findspace::situation {

using distance::ShapePair;
using distance::TDistancePointer;
using distance::Which;
using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;

namespace {

/// For a distance whose first shape moves, unless `second_moves`.
Which which(Kind kind, bool second_moves) {
  switch (kind) {
    case Kind::kGamma1: return Which::kGamma1;
    case Kind::kGamma2: return Which::kGamma2;
    case Kind::kEta1: return Which::kEta1;
    case Kind::kEta2: return Which::kEta2;
    case Kind::kDelta1: return Which::kDelta1;
    case Kind::kDelta2: return Which::kDelta2;
    case Kind::kMu: return second_moves ? Which::kMuBack : Which::kMu;
    case Kind::kHausdorff: return Which::kHausdorff;
    case Kind::kD1: return Which::kD1;
    case Kind::kD2: return Which::kGamma2;
    case Kind::kH: return second_moves ? Which::kHBack : Which::kH;
    case Kind::kDstar: return second_moves ? Which::kDstarBack : Which::kDstar;
    case Kind::kDiameter: return Which::kDiameter;
    case Kind::kPenetration: return Which::kPenetration;
  }
  return Which::kGamma1;
}

void require_plain(const Distance& d) {
  if (d.mode != Mode::kPlain || d.prefix != Extremum::kNone)
    throw Error(ErrorCode::kUnsupported, text(d) + ": distances along a direction, in rotation or over time are not computed by this version");
}

}  // namespace

struct Solver::Cache {
  std::mutex guard;
  std::map<Names, std::shared_ptr<const distance::AtPosition>> pairs;
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

std::shared_ptr<const distance::AtPosition> Solver::pair(const Names& names) const {
  std::lock_guard lock(cache_->guard);
  auto& slot = cache_->pairs[names];
  if (!slot) slot = std::make_shared<distance::AtPosition>(std::make_shared<ShapePair>(shape(names.first), shape(names.second)));
  return slot;
}

TDistancePointer Solver::distance(const Distance& wanted) const {
  Distance d = moving_first(wanted, world_.moving);
  require_plain(d);
  bool second = d.first.empty() || std::find(world_.moving.begin(), world_.moving.end(), d.first[0]) == world_.moving.end();
  if (second) std::swap(d.first, d.second);
  return pair({d.first, d.second})->pair().distance(which(d.kind, second));
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
  Distance d = moving_first(wanted, world_.moving);
  require_plain(d);
  bool second = d.first.empty() || std::find(world_.moving.begin(), world_.moving.end(), d.first[0]) == world_.moving.end();
  Names names = second ? Names{d.second, d.first} : Names{d.first, d.second};
  auto pair = this->pair(names);
  DistanceAt out{text(wanted), std::nullopt, std::nullopt, std::nullopt, {}};
  if (auto m = pair->measure(which(d.kind, second), p)) add_witness(out, wanted, names, *pair, *m, p);
  return out;
}

void Solver::add_witness(DistanceAt& out, const Distance& wanted, const Names& names, const distance::AtPosition& pair,
                         const distance::Measured& m, const RealPoint& p) const {
  out.value = (m.value * world_.step).to_double();
  out.nearest = m.nearest, out.farthest = m.farthest;
  for (const distance::Feature& f : m.witness)
    out.witness.push_back(named_feature(f, f.of_moving ? pair.pair().moving() : pair.pair().fixed(),
                                        f.of_moving ? names.first : names.second, world_.shapes, world_.parts, p));
  bool turned = wanted.first == names.second && !out.witness.empty() && m.witness[0].of_moving != m.witness[1].of_moving;
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

Solver::Check Solver::check(const Formula& formula, const RealPoint& position) const {
  RealPoint p = steps(position);
  std::vector<plane::SignMap> maps = sign_maps(formula);
  std::vector<std::int8_t> signs;
  for (const auto& m : maps) signs.push_back(mark_of(m, locate(m, p)));
  Check out;
  out.holds = evaluate(formula, signs);
  for (std::size_t k = 0; k < formula.atoms().size(); ++k) {
    const Atom& atom = formula.atoms()[k];
    AtomAt a{atom, value(atom.distance, p), holds(atom, signs[formula.sign_map_of(k)]), std::nullopt};
    if (!a.holds && a.distance.value && !atom.minimum) a.lacks = std::abs(*a.distance.value - atom.level.to_double());
    out.atoms.push_back(std::move(a));
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
