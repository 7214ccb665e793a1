// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/question/planar_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "api/values/region_data.h"
#include "findspace/error.h"
#include "io/write/write_summary.h"
#include "plane/base/real_vector.h"
#include "plane/query/in_order.h"
#include "plane/query/topology.h"

namespace findspace::io {

using plane::operator-;

namespace {

plane::Region applied(plane::Region region, const std::string& operation) {
  if (operation == "interior") return plane::interior(std::move(region));
  if (operation == "closure") return plane::closure(std::move(region));
  if (operation == "boundary") return plane::boundary(std::move(region));
  if (operation == "regularize") return plane::regularize(std::move(region));
  if (operation == "complement") return plane::complement(std::move(region));
  if (operation.empty()) return region;
  throw Error(ErrorCode::kBadValue,
              fmt::format("apply: {} is none of interior, closure, boundary, regularize and complement", operation));
}

formula::PlanarLine line_of(const Free& free) {
  return {{free.through[0], free.through[1]}, {free.direction[0], free.direction[1]}};
}

}  // namespace

formula::SolvedRegion on_line(const formula::SolvedRegion& region, const Free& free) {
  return formula::on_line(region, reaching(line_of(free), region));
}

std::vector<plane::LineInterval> intervals_on_line(const PlanarMap& map, const plane::Region& region,
                                                   const Free& free) {
  const plane::GridPoint through{free.through[0], free.through[1]};
  std::vector<plane::LineInterval> out = plane::along_line(region, through, {free.direction[0], free.direction[1]});
  if (!map.line) return out;
  // What goes on to where a line is cut off goes on.
  const plane::RealVector way = formula::ends_of(*map.line)[1] - plane::RealVector{through.x, through.y};
  const exact::Real far = sqrt(plane::dot(way, way));
  for (plane::LineInterval& i : out) {
    if (i.from && i.to && *i.from == *i.to) continue;
    if (i.from && *i.from == -far) i.from.reset();
    if (i.to && *i.to == far) i.to.reset();
    i.from_in = i.from_in && i.from;
    i.to_in = i.to_in && i.to;
  }
  return out;
}

namespace {

constexpr const char* kNoRoots =
    "the optimum is not a number that square roots express: given to 13 digits, with one position each";
constexpr const char* kBetweenBounds = "the optimum is known between the value, which some position has, and \"bound\"";
constexpr const char* kBoundAlone = "no position is certain: of the optimum only \"bound\" is known";

constexpr const char* kRotating =
    "shapes rotate, or distances are in rotation: certainly feasible positions, and in \"outer\" the possible ones";
constexpr const char* kCompared =
    "distances are equal along a curve that is neither a line nor a circle: certainly feasible positions, and in "
    "\"outer\" "
    "the possible ones";

/// What is said about an optimum that is enclosed, by the way that found it.
void note_enclosed(const formula::Optimum& best, const AskedScene& asked) {
  if (best.proven()) return;
  asked.note(!best.exists() ? kBoundAlone : best.answer->way == distance::Way::kMap ? kNoRoots : kBetweenBounds);
}

/// The region of the formula on the scene's line, and its best positions.
PlanarMap best_map(const AskedScene& asked, const formula::Solver& solver, formula::SolvedRegion found,
                   const AskedScene::Goal& goal) {
  asked.stage("optimizing");
  formula::BestQuery query{goal.objective, goal.sense, std::nullopt};
  if (asked.scene().free.kind == Free::Kind::kLine) {
    query.line = reaching(line_of(asked.scene().free), found, goal.objective, solver);
    found = formula::on_line(found, *query.line);
  }
  formula::Optimum best = formula::optimize(solver, found, query);
  note_enclosed(best, asked);
  PlanarMap map{std::move(best.at), std::nullopt, best, std::nullopt, query.line};
  map.feasible = plane::in_order(found.outer ? *std::move(found.outer) : std::move(found.region));
  return map;
}

/// Whether a least value is part of the formula.
bool has_least(const formula::Formula& formula) {
  const auto& maps = formula.sign_maps();
  return std::any_of(maps.begin(), maps.end(), [](const formula::SignMap& m) { return m.minimum; });
}

}  // namespace

PlanarMap planar_map(const AskedScene& asked, std::shared_ptr<const formula::Solver> solver,
                     const formula::Formula& formula, const Applied& apply, const formula::SolvedRegion* known) {
  const std::optional<AskedScene::Goal> goal = asked.goal();
  asked.stage("solving");
  std::shared_ptr<const formula::Solver> again;  // where it is asked a second time
  if (goal || has_least(formula)) again = solver;
  formula::SolvedRegion found = known != nullptr ? *known : formula::solve_region(std::move(solver), formula);
  if (found.outer && !apply.operation.empty())
    throw Error(
        ErrorCode::kUnsupported,
        apply.before +
            "apply: only bounds of the region are known, as shapes rotate or distances are compared with each other",
        asked.scene().file);
  if (found.outer && !goal) asked.note(found.compared ? kCompared : kRotating);
  PlanarMap map;
  if (goal) {
    map = best_map(asked, *again, std::move(found), *goal);
    if (!map.extreme->proven() && !apply.operation.empty())
      throw Error(ErrorCode::kUnsupported, apply.before + "apply: only bounds of the best value are known",
                  asked.scene().file);
  } else {
    map.region = std::move(found.region);
    if (found.outer) map.outer = plane::in_order(*std::move(found.outer));
    if (again) {
      const auto least = formula::minimum_of(formula, *again);
      note_enclosed(*least, asked);
      map.extreme = *least;
    }
  }
  solver.reset();
  again.reset();
  // What is known has its order.
  if (known == nullptr || goal || !apply.operation.empty())
    map.region = plane::in_order(applied(std::move(map.region), apply.operation));
  return map;
}

namespace {

KeptRegion as_kept(formula::SolvedRegion found, const AskedScene& asked) {
  const auto region = [&](plane::Region cells) {
    return api::make_region(std::move(cells), asked.scene().grid, asked.unit());
  };
  KeptRegion out{region(std::move(found.region)), std::nullopt, found.compared};
  if (found.outer) out.outer = region(*std::move(found.outer));
  return out;
}

/// What `make` makes, or has made before for the same scene.
template <class Make>
std::shared_ptr<const KeptRegion> kept_region(const AskedScene& asked, Kept<KeptRegion> KeptWork::*of,
                                              const Make& make) {
  const std::shared_ptr<const KeptWork>& kept = asked.kept();
  if (!kept || asked.at_instant()) return std::make_shared<const KeptRegion>(make());
  return {kept, &((*kept).*of).get(make)};
}

}  // namespace

formula::SolvedRegion solved_region(const KeptRegion& kept) {
  formula::SolvedRegion out{kept.region.data().cells, std::nullopt, kept.compared};
  if (kept.outer) out.outer = kept.outer->data().cells;
  return out;
}

std::shared_ptr<const KeptRegion> region_of(const AskedScene& asked, const formula::Formula& formula,
                                            const std::shared_ptr<const formula::Solver>& solver) {
  return kept_region(asked, &KeptWork::region, [&] {
    return as_kept(formula::solve_region(solver ? *solver : *asked.solver_of(formula, false), formula), asked);
  });
}

std::shared_ptr<const KeptRegion> positions_of(const AskedScene& asked, const formula::Formula& formula,
                                               const std::shared_ptr<const formula::Solver>& solver) {
  if (asked.scene().free.kind != Free::Kind::kLine) return region_of(asked, formula, solver);
  return kept_region(asked, &KeptWork::positions_on_line, [&] {
    const formula::SolvedRegion region = solved_region(*region_of(asked, formula, solver));
    formula::PlanarLine line = line_of(asked.scene().free);
    line.reach = double(plane::Grid::kLimit);
    return as_kept(formula::on_line(region, reaching(line, region)), asked);
  });
}

std::string planar_map_json(const AskedScene& asked, const PlanarMap& map, bool exact, const plane::Summary* known) {
  const distance::OptimalValue* extreme = map.extreme ? &*map.extreme : nullptr;
  const bool line = asked.scene().free.kind == Free::Kind::kLine;
  const auto json = [&](const plane::Region& region, const distance::OptimalValue* best, bool with_cells) {
    if (line)
      return intervals_json(intervals_on_line(map, region, asked.scene().free), asked.step(), asked.unit(), best);
    if (known != nullptr && &region == &map.region)
      return region_json(region, *known, asked.step(), asked.unit(), best, with_cells);
    const plane::Summary summary = plane::summarize(region, asked.step());
    return region_json(region, summary, asked.step(), asked.unit(), best, with_cells);
  };
  std::string text = json(map.region, extreme, exact);
  return map.outer ? bounded_json(std::move(text), json(*map.outer, nullptr, false)) : text;
}

void planar_map_json(const AskedScene& asked, const PlanarMap& map, bool exact, const plane::Summary* known,
                     const Sink& sink) {
  if (known == nullptr || map.outer) return sink(planar_map_json(asked, map, exact, known));
  const distance::OptimalValue* extreme = map.extreme ? &*map.extreme : nullptr;
  region_json(map.region, *known, asked.step(), asked.unit(), extreme, exact, sink);
}

std::string PlanarInstants::json() const {
  std::string text = intervals_json(intervals, exact::Real(1), "");
  return outer ? bounded_json(std::move(text), intervals_json(*outer, exact::Real(1), "")) : text;
}

PlanarInstants planar_instants(const formula::Solver& solver, const formula::Formula& formula,
                               const exact::RealPoint& at) {
  const auto in_time = [](const plane::Section& line) { return plane::intervals(line, exact::Real(1)); };
  const formula::SolvedInstants found = solver.solve_instants(formula, at);
  PlanarInstants out{in_time(found.instants), std::nullopt};
  if (found.outer) out.outer = in_time(*found.outer);
  return out;
}

}  // namespace findspace::io
