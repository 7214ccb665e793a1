// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "in_plane/planar_map.h"

#include <algorithm>
#include <cmath>

#include "findspace/error.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/optimize.h"
#include "formula/planar/sums.h"
#include "plane/build/path_region.h"
#include "plane/complex/overlay.h"
#include "plane/query/in_order.h"
#include "plane/query/locate.h"
#include "plane/query/topology.h"
#include "report/report.h"

namespace findspace::app {
namespace {

plane::Region applied(plane::Region region, const std::string& operation) {
  if (operation == "interior") return plane::interior(std::move(region));
  if (operation == "closure") return plane::closure(std::move(region));
  if (operation == "boundary") return plane::boundary(std::move(region));
  if (operation == "regularize") return plane::regularize(std::move(region));
  if (operation == "complement") return plane::complement(std::move(region));
  return region;
}

/// Two points of the line, about 2^36 steps either way from where it goes through: beyond them nothing is looked for.
std::array<exact::RealPoint, 2> ends_of_line(const io::Free& free) {
  const std::int64_t most = std::max({std::abs(free.direction[0]), std::abs(free.direction[1]), std::int64_t(1)});
  const std::int64_t times = std::max<std::int64_t>(1, (std::int64_t(1) << 36) / most);
  const auto end = [&](std::int64_t way) {
    return exact::RealPoint{exact::Real(free.through[0] + way * free.direction[0]),
                            exact::Real(free.through[1] + way * free.direction[1])};
  };
  return {end(-times), end(times)};
}

}  // namespace

plane::Region on_line(const plane::Region& region, const io::Free& free) {
  const plane::Region line = plane::region_of_path(ends_of_line(free));
  const std::array<const plane::Region*, 2> both{&region, &line};
  return plane::intersect(both);
}

std::vector<plane::LineInterval> intervals_on_line(const plane::Region& region, const io::Free& free) {
  return plane::along_line(region, {free.through[0], free.through[1]}, {free.direction[0], free.direction[1]});
}

namespace {

constexpr const char* kNoRoots =
    "the optimum is not a number that square roots express: given to 13 digits, with one position each";
constexpr const char* kBetweenBounds = "the optimum is known between the value, which some position has, and \"bound\"";

constexpr const char* kRotating =
    "shapes rotate, or distances are in rotation: certainly feasible positions, and in \"outer\" the possible ones";
constexpr const char* kCompared =
    "distances are equal along a curve that is neither a line nor a circle: certainly feasible positions, and in "
    "\"outer\" "
    "the possible ones";

/// `bounded`: where shapes rotate, or distances are summed.
io::ExtremeValue value_of(const formula::Optimum& optimum, bool maximum, Reporter& reporter, bool bounded = false) {
  if (optimum.value && !optimum.proven) reporter.note(bounded ? kBetweenBounds : kNoRoots);
  io::ExtremeValue out = io::extreme_value(optimum, maximum);
  out.proven = out.proven || optimum.unbounded || (!bounded && !optimum.value);
  if (out.proven || optimum.unbounded) return out;
  if (bounded || optimum.within != 0) out.bound = optimum.bound;
  if (optimum.within != 0 && std::isfinite(optimum.within)) out.within = optimum.within;
  return out;
}

/// An optimum at an end of the line is none: it goes on.
formula::Optimum within_line(formula::Optimum best, const io::Free& free) {
  for (const exact::RealPoint& end : ends_of_line(free)) {
    if (!best.value || mark_of(best.at, plane::locate(best.at, end)) == 0) continue;
    best.value.reset();
    best.unbounded = true;
    best.attained = false;
    best.at = plane::Region::uniform(0);
  }
  return best;
}

/// Of shapes that rotate, or distances compared with each other: regions, and what is best in them, between bounds.
PlanarMap map_between_bounds(const Session& session, const formula::Solver& solver, const formula::Formula& formula,
                             const formula::RegionBounds* known) {
  Reporter& reporter = session.reporter();
  const std::optional<Session::Goal> goal = session.goal();
  if (!session.options().apply.empty())
    throw Error(
        ErrorCode::kUnsupported,
        "--apply: only bounds of the region are known, as shapes rotate or distances are compared with each other",
        session.scene().file);
  formula::RegionBounds bounds = known != nullptr ? *known : solver.feasible_bounds(formula);
  const bool sums = formula::has_sums(formula);
  if (!goal && sums && formula::same_sets(bounds))
    return {plane::in_order(bounds.inner), std::nullopt, std::nullopt, std::nullopt};
  if (!goal) {
    reporter.note(sums ? kCompared : kRotating);
    std::optional<io::ExtremeValue> extreme;
    if (const auto least = formula::minimum_of(formula, solver)) extreme = value_of(*least, false, reporter, true);
    return {plane::in_order(bounds.inner), std::nullopt, extreme, plane::in_order(bounds.outer)};
  }
  reporter.stage("optimizing");
  if (session.scene().free.kind == io::Free::Kind::kLine) {
    bounds.inner = on_line(bounds.inner, session.scene().free);
    bounds.outer = on_line(bounds.outer, session.scene().free);
  }
  formula::Optimum best = formula::optimize(bounds, goal->objective, goal->sense, solver);
  const io::ExtremeValue extreme = value_of(best, goal->sense == distance::Sense::kMaximum, reporter, true);
  return {plane::in_order(best.at), plane::in_order(bounds.outer), extreme, std::nullopt};
}

}  // namespace

PlanarMap planar_map(const Session& session, const formula::Solver& solver, const formula::Formula& formula,
                     const formula::RegionBounds* known) {
  Reporter& reporter = session.reporter();
  const std::optional<Session::Goal> goal = session.goal();
  reporter.stage("solving");
  if (solver.known_between_bounds(formula) || (goal && formula::is_bounded(goal->objective, solver)))
    return map_between_bounds(session, solver, formula, known);
  PlanarMap map{known != nullptr ? known->inner : formula::feasible_near(solver, formula), std::nullopt, std::nullopt,
                std::nullopt};
  if (goal) {
    reporter.stage("optimizing");
    const bool line = session.scene().free.kind == io::Free::Kind::kLine;
    if (line) map.region = on_line(map.region, session.scene().free);
    formula::Optimum best = formula::optimize(map.region, goal->objective, goal->sense, solver);
    if (line) best = within_line(std::move(best), session.scene().free);
    const bool sum = goal->objective.kind == formula::Objective::Kind::kSum;
    map.extreme = value_of(best, goal->sense == distance::Sense::kMaximum, reporter, sum);
    map.feasible = plane::in_order(std::exchange(map.region, std::move(best.at)));
  } else if (const auto least = formula::minimum_of(formula, solver)) {
    map.extreme = value_of(*least, false, reporter);
  }
  // What is known has its order.
  if (known == nullptr || goal || !session.options().apply.empty())
    map.region = plane::in_order(applied(std::move(map.region), session.options().apply));
  return map;
}

std::string planar_map_json(const Session& session, const PlanarMap& map) {
  const io::ExtremeValue* extreme = map.extreme ? &*map.extreme : nullptr;
  const bool line = session.scene().free.kind == io::Free::Kind::kLine;
  const auto json = [&](const plane::Region& region, const io::ExtremeValue* best, bool exact) {
    if (line)
      return io::intervals_json(intervals_on_line(region, session.scene().free), session.step(), session.unit(), best);
    const plane::Summary summary = plane::summarize(region, session.step());
    return io::region_json(region, summary, session.step(), session.unit(), best, exact);
  };
  std::string text = json(map.region, extreme, session.options().exact);
  return map.outer ? bounded_json(std::move(text), json(*map.outer, nullptr, false)) : text;
}

std::string Instants::json() const {
  std::string text = io::intervals_json(intervals, exact::Real(1), "");
  return outer ? bounded_json(std::move(text), io::intervals_json(*outer, exact::Real(1), "")) : text;
}

Instants planar_instants(const formula::Solver& solver, const formula::Formula& formula, const exact::RealPoint& at) {
  const auto in_time = [](const plane::Section& line) { return plane::intervals(line, exact::Real(1)); };
  const formula::SolvedInstants found = solver.solve_instants(formula, at);
  Instants out{in_time(found.instants), std::nullopt};
  if (found.outer) out.outer = in_time(*found.outer);
  return out;
}

}  // namespace findspace::app
