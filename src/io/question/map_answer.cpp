// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/map_answer.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "io/draw/draw_layout.h"
#include "io/export/write_drawing.h"
#include "io/export/write_wkt.h"
#include "io/question/scenery.h"
#include "io/write/write_summary.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

/// What a map of positions needs for its texts and pictures.
struct PositionsQuestion {
  AskedScene asked;
  formula::Formula formula{};
  std::optional<formula::World> world{};  // for a picture
  PlanarMap map{};
  std::shared_ptr<const KeptRegion> known{};  // what the map is, where a prepared scene keeps it
  Kept<plane::Summary> summarized{};
  Kept<plane::Region> closed{};  // where the best may be, if no position has it
  std::vector<plane::LineInterval> intervals{}, possible{};

  explicit PositionsQuestion(AskedScene given) : asked(std::move(given)) {}

  bool line() const { return asked.scene().free.kind == Free::Kind::kLine; }
  /// Of positions in the plane.
  const plane::Summary& summary() const {
    return summarized.get(
        [&] { return known ? known->region.data().summary() : plane::summarize(map.region, asked.step()); });
  }
  const distance::OptimalValue* extreme() const { return map.extreme ? &*map.extreme : nullptr; }
  /// The best value is known between bounds: where no position is shown, there may be one.
  bool open() const { return map.extreme && !map.extreme->proven(); }
  /// A region that holds all positions asked for; null: it is the map's.
  const plane::Region* possible_region() const {
    if (map.outer) return &*map.outer;
    if (!open() || !map.feasible) return nullptr;
    // A best value that no position has: the positions shown may lie beside those that are feasible.
    return map.extreme->attained ? &*map.feasible : &closed.get([&] { return plane::closure(*map.feasible); });
  }
  /// Where that is so, and no position is shown.
  std::string open_text(const std::string& title) const {
    const auto bound = map.extreme->bound();
    const std::string beyond =
        bound ? fmt::format(": no position passes {}", size_text(bound->to_double(), asked.unit())) : "";
    return fmt::format("{}\nnone certain{}\n", title, beyond);
  }
  std::string title(const Applied& apply) const {
    std::string out = fmt::format("Positions of {}", asked.scene().moving_text());
    if (const auto goal = asked.goal())
      out +=
          fmt::format(" with the {} {}", goal->sense == distance::Sense::kMinimum ? "least" : "greatest", goal->text);
    if (line()) return out + " on the line";
    return apply.operation.empty() ? out : fmt::format("{}, {}", out, apply.operation);
  }
  std::string json(const Telling& telling) const {
    return planar_map_json(asked, map, telling.exact, line() ? nullptr : &summary());
  }
  void json(const Telling& telling, const Sink& sink) const {
    planar_map_json(asked, map, telling.exact, &summary(), sink);
  }
  std::string svg(const std::string& title) const {
    Picture picture;
    picture.title = title + (!summary().empty ? "" : open() ? ": none certain" : ": none");
    picture.subtitle = asked.scene().where.text;
    picture.region = &map.region;
    picture.summary = &summary();
    picture.around = map.feasible ? &*map.feasible : map.outer ? &*map.outer : nullptr;
    if (map.outer && !map.feasible) picture.around_text = "positions not excluded";
    add_scenery(asked, picture, *world, &formula);
    return picture_svg(picture);
  }
  Region::Drawn wkt() const {
    WktText text = region_wkt(map.region, asked.step());
    return {std::move(text.text), std::move(text.lost)};
  }
  Region::Drawn dxf(DxfVersion version) const {
    const NamedRegion named{"region", &map.region};
    DrawingText text = shapes_dxf({&named, 1}, asked.step(), asked.scene().unit, version);
    return {std::move(text.text), std::move(text.lost)};
  }
  Region shown(const plane::Region& region) const { return api::make_region(region, asked.scene().grid, asked.unit()); }
  RegionBounds bounds() const {
    if (known) return {known->region, known->outer ? *known->outer : known->region};
    formula::SolvedRegion all{map.region};
    if (const plane::Region* possible = possible_region()) all.outer = *possible;
    if (line() && !map.line) all = on_line(all, asked.scene().free);
    const Region inner = shown(all.region);
    return {inner, all.outer ? shown(*all.outer) : inner};
  }
};

void tell_positions(Answer::Data& out, const std::shared_ptr<const PositionsQuestion>& q, const std::string& title) {
  out.text = [q, title](const Telling&) {
    if (q->open() && q->summary().empty) return q->open_text(title);
    return summary_text(title, q->summary(), q->asked.unit(), q->extreme());
  };
  out.json_parts = [q](const Telling& telling, const Sink& sink) { q->json(telling, sink); };
  out.files[".wkt"] = [q](const Telling&) { return q->wkt(); };
  out.files[".dxf"] = [q](const Telling& telling) { return q->dxf(telling.dxf); };
  if (q->world) out.files[".svg"] = [q, title](const Telling&) { return Region::Drawn{q->svg(title), {}}; };
}

void tell_line(Answer::Data& out, const std::shared_ptr<const PositionsQuestion>& q, const std::string& title) {
  out.text = [q, title](const Telling&) {
    if (q->open() && q->intervals.empty()) return q->open_text(title);
    const std::string text = intervals_text(title, q->intervals, q->asked.step(), q->asked.unit());
    return q->map.extreme ? text + optimum_text(*q->map.extreme, q->asked.unit()) : text;
  };
  out.intervals = [q] { return shown_intervals(q->intervals, q->asked.step()); };
  out.possible = [q] { return shown_intervals(q->possible, q->asked.step()); };
}

}  // namespace

std::vector<Interval> shown_intervals(const std::vector<plane::LineInterval>& all, const exact::Real& step) {
  const auto end = [&](const std::optional<exact::Real>& t) {
    return t ? std::optional((*t * step).to_double()) : std::nullopt;
  };
  std::vector<Interval> out;
  for (const plane::LineInterval& i : all) out.push_back({end(i.from), end(i.to), i.from_in, i.to_in});
  return out;
}

Answer::Found found_in(bool some, bool possibly) {
  return some ? Answer::Found::kYes : possibly ? Answer::Found::kUndecided : Answer::Found::kNo;
}

Answer::Data map_of_positions(AskedScene given, const Applied& apply, bool pictures) {
  given.require_positions(true);
  given.require_question();
  const auto q = std::make_shared<PositionsQuestion>(std::move(given));
  q->formula = q->asked.where();
  const bool drawn = pictures && !q->line();
  {
    std::shared_ptr<const formula::Solver> solver = q->asked.solver_of(q->formula, drawn);
    if (!drawn && !q->asked.kept()) q->asked.forget_shapes();
    std::optional<formula::SolvedRegion> known;
    if (q->asked.kept()) {
      const std::shared_ptr<const KeptRegion> kept = region_of(q->asked, q->formula);
      known = solved_region(*kept);
      if (apply.operation.empty() && !q->asked.goal() && !q->line()) q->known = kept;
    }
    if (drawn) q->world = solver->world();
    q->map = planar_map(q->asked, std::move(solver), q->formula, apply, known ? &*known : nullptr);
  }
  Answer::Data out;
  const std::string title = q->title(apply);
  if (q->line()) {
    q->intervals = intervals_on_line(q->map, q->map.region, q->asked.scene().free);
    const plane::Region* possible = q->possible_region();
    q->possible = possible != nullptr ? intervals_on_line(q->map, *possible, q->asked.scene().free) : q->intervals;
    out.found = found_in(!q->intervals.empty(), q->open() || !q->possible.empty());
    tell_line(out, q, title);
  } else {
    const bool possible = q->open() || (q->map.outer && !plane::is_empty(*q->map.outer));
    out.found = found_in(!plane::is_empty(q->map.region), possible);
    tell_positions(out, q, title);
  }
  out.json = [q](const Telling& telling) { return q->json(telling); };
  out.region = [q] { return q->bounds(); };
  if (q->map.extreme) out.best = [q] { return api::public_optimum(*q->map.extreme, q->shown(q->map.region)); };
  return out;
}

Answer::Data map_of_instants(AskedScene given, const exact::RealPoint& at, const std::string& place) {
  given.require_positions(true);
  if (given.goal()) throw Error(ErrorCode::kUnsupported, "an objective in time is not computed", given.scene().file);
  given.require_question();
  const formula::Formula formula = given.where();
  const std::shared_ptr<const formula::Solver> solver = given.solver_of(formula, false);
  given.stage("solving");
  const auto found = std::make_shared<const PlanarInstants>(planar_instants(*solver, formula, at));
  if (found->outer)
    given.note(
        "shapes rotate, or distances are in rotation: instants that certainly belong, and in \"outer\" the possible "
        "ones");
  Answer::Data out;
  out.found = found_in(!found->intervals.empty(), found->outer && !found->outer->empty());
  out.json = [found](const Telling&) { return found->json(); };
  out.text = [found, title = fmt::format("Instants with {} at {}", given.scene().moving_text(), place)](
                 const Telling&) { return intervals_text(title, found->intervals, exact::Real(1), ""); };
  out.intervals = [found] { return shown_intervals(found->intervals, exact::Real(1)); };
  out.possible = [found] { return shown_intervals(found->outer ? *found->outer : found->intervals, exact::Real(1)); };
  return out;
}

}  // namespace findspace::io
