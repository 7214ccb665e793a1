// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/question/ray_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "api/plan/line_map.h"
#include "api/query/world_data.h"
#include "api/values/region_data.h"
#include "formula/language/certain_cells.h"
#include "formula/language/evaluate.h"
#include "io/draw/draw_slices.h"
#include "io/question/space_shapes.h"
#include "space/shape/shape_rays.h"

namespace findspace::io {
namespace {

using exact::Real;

/// Lines each way of each axis where none are asked for.
constexpr int kUsualLines = 128;
constexpr int kMostLines = 16384;

/// Of the picture in slices.
constexpr int kLayers = 16;

/// A set on lines, with all that it refers to.
struct RaysQuestion {
  AskedScene asked;
  std::optional<formula::SpaceSolver> solver{};
  formula::RayWorld world{};
  formula::QuestionOnLines question{};
  formula::Formula formula{};  // the question's, or for its cells
  plane::ShapePtr shape{};     // or this
  RaySet set{};
  bool listed = false;  // JSON has the lines
  std::optional<Cast> cast{};
  std::optional<distance::OptimalValue> optimum{};

  explicit RaysQuestion(AskedScene given) : asked(std::move(given)) {}

  double step() const { return asked.step().to_double(); }
  void ask(const formula::Formula& where, const RayChoice& choice);
  formula::Side side() const;
  std::string text() const;
  void json(const Sink& sink) const;
  Surface surface() const;
  std::string slices() const;
  LineMap lines() const;
  Answer::Found found() const;

 private:
  void aim();
  std::vector<RaySet::Fixed> standing(const formula::Formula& where) const;
  std::pair<space::Point, space::Point> shown_box() const;
};

/// The shapes of a formula that stay where they are.
std::vector<RaySet::Fixed> RaysQuestion::standing(const formula::Formula& where) const {
  std::set<std::string> names = where.shapes();
  for (const std::string& moving : asked.scene().moving) names.erase(moving);
  std::vector<RaySet::Fixed> out;
  const auto add = [&](const std::string& name, const auto& again) -> void {
    const plane::ShapePtr shape = asked.scene().shape(name);
    if (!drawn_by_members(asked, name)) return out.push_back({name, shape});
    for (const plane::ShapePtr& member : shape->children) again(member->name, again);
  };
  for (const std::string& name : names) add(name, add);
  return out;
}

void RaysQuestion::aim() {
  const auto goal = asked.goal();
  if (!goal) return;
  if (goal->objective.kind != formula::Objective::Kind::kDistance) {
    set.aim = aim_of(asked, *goal);
    return;
  }
  if (!solver) solver.emplace(space_world(asked));
  set.objective = objective_of(*solver, *goal);
}

void RaysQuestion::ask(const formula::Formula& where, const RayChoice& choice) {
  asked.stage("building the shapes");
  world = ray_world(asked);
  const auto least = [&]() -> const formula::SpaceSolver& {
    asked.stage("looking for least values");
    return solver.emplace(space_world(asked));
  };
  question = formula::question_on_lines(world, least, where,
                                        choice.lines.axes ? std::vector<int>{0, 1, 2} : std::vector{choice.lines.axis});
  formula = question.levels.formula;
  set.title = fmt::format("Positions of {}", fmt::join(asked.scene().moving, ", "));
  set.subtitle = asked.scene().where.text;
  set.meaning = "positions";
  set.fixed = standing(where);
  set.lines = choice.lines;
  set.low = question.window.low;
  set.high = question.window.high;
  set.unbounded = question.unbounded;
  set.on_lines = question.levels.side;
  set.somewhere = question.somewhere;
  if (!question.levels.minima.empty()) set.least = least_of(question.levels.minima[0]);
  set.side = choice.side;
  if (set.side !=
      formula::Side::kNone) {  // the formula whose places on the lines have cells on that side of the region
    const Real radius = cell_radius(set) * asked.step();
    formula = set.side == formula::Side::kOuter ? widened(formula, radius) : narrowed(formula, radius);
  }
  aim();
  set.source = [this](const space::RayGrid& grid) { return question.on(world, formula, grid); };
  if (question.one_position && question.somewhere)
    asked.note("the minimisers have no map on lines: one of them is given");
}

/// Of the cells about the lines, as asked where the lines themselves do not err to the other side.
formula::Side RaysQuestion::side() const {
  return formula::both(set.side, cast->on_lines) == set.side ? set.side : formula::Side::kNone;
}

std::string RaysQuestion::text() const {
  const space::RaySummary& summary = cast->summary;
  const std::string& title = set.title;
  std::string out;
  if (summary.empty && !set.unbounded) {
    out = side() == formula::Side::kOuter
              ? title + ": proven empty\n"
              : title + ": no line meets the region (smaller parts may lie between the lines)\n";
  } else {
    out = fmt::format("{}: on {} line{}, {} interval{}\n", title, summary.lines, summary.lines == 1 ? "" : "s",
                      summary.intervals, summary.intervals == 1 ? "" : "s");
    const auto certified = std::count_if(summary.components.begin(), summary.components.end(),
                                         [](const space::RayComponent& c) { return c.certified; });
    if (set.unbounded)
      out += "  the region is unbounded\n";
    else
      out += fmt::format(
          "  volume {} {:.9g}{}, {} component{} by {}\n",
          side() == formula::Side::kInner   ? "at least"
          : side() == formula::Side::kOuter ? "at most"
                                            : "about",
          summary.volume * step() * step() * step(), asked.unit().empty() ? "" : " " + asked.unit() + "³",
          summary.components.size(), summary.components.size() == 1 ? "" : "s",
          set.lines.axes ? fmt::format("crossing lines ({} certified)", certified) : "overlap of neighbouring lines");
  }
  return optimum && optimum->value() ? out + ray_optimum_text(*optimum) : out;
}

void RaysQuestion::json(const Sink& sink) const {
  const std::string unit = asked.unit();
  const RaysText text{unit,
                      listed ? &cast->lines : nullptr,
                      set.lines.axes,
                      set.unbounded,
                      formula::name(cast->on_lines),
                      formula::name(side()),
                      set.somewhere,
                      optimum};
  rays_json(cast->summary, cast->grid, step(), text, sink);
}

Surface RaysQuestion::surface() const {
  if (set.lines.axes) return ray_surface_mesh(cast->surface, step());
  const space::RayLattice lattice = set.lines.lattice(set.low, set.high);
  const auto source = [&](int axis) { return set.source(lattice.grid(axis)).rays; };
  return ray_surface_mesh(space::ray_surface(lattice, source, in_ray_set), step());
}

/// What the slices show: the region with a little around it, within the box of the lines.
std::pair<space::Point, space::Point> RaysQuestion::shown_box() const {
  const space::RaySummary& summary = cast->summary;
  space::Point low = set.low, high = set.high;
  if (summary.empty || set.unbounded) return {low, high};
  constexpr double kAround = 0.05;
  const auto shrink = [&](std::int64_t space::Point::*axis, std::size_t k) {
    const double tolerance = std::max(1.0, (summary.high[k] - summary.low[k]) * kAround);
    low.*axis = std::max(low.*axis, static_cast<std::int64_t>(std::floor(summary.low[k] - tolerance)));
    high.*axis = std::min(high.*axis, static_cast<std::int64_t>(std::ceil(summary.high[k] + tolerance)));
  };
  shrink(&space::Point::x, 0);
  shrink(&space::Point::y, 1);
  shrink(&space::Point::z, 2);
  return {low, high};
}

std::string RaysQuestion::slices() const {
  const auto [low, high] = shown_box();
  const space::RayGrid slices = slice_grid(low, high, kLayers, std::max(cast->grid.nu, cast->grid.nv));
  SlicesPicture picture{set.title, set.subtitle, asked.unit(), set.meaning, slices, low, high, step(), {}, {}};
  picture.rows = space::all_rows(*set.source(slices).rays);
  for (const RaySet::Fixed& fixed : set.fixed)
    picture.fixed.push_back({fixed.name, space::all_rows(*space::shape_rays(*fixed.shape, slices))});
  return slices_svg(picture);
}

LineMap RaysQuestion::lines() const {
  const formula::RegionOnLines source = set.source(cast->grid);
  LineMap out = api::line_map(*source.rays, {set.low, set.high}, step());
  out.exact = cast->on_lines == formula::Side::kExact;
  out.unbounded = set.unbounded;
  return out;
}

Answer::Found RaysQuestion::found() const {
  const bool some = !cast->summary.empty || set.unbounded;
  if (!some && side() == formula::Side::kOuter) return Answer::Found::kNo;
  const bool certain =
      set.somewhere || (some && set.side != formula::Side::kOuter &&
                        (cast->on_lines == formula::Side::kExact || cast->on_lines == formula::Side::kInner));
  return certain ? Answer::Found::kYes : Answer::Found::kUndecided;
}

/// The set with rows that all processes of the team make.
void share(RaySet& set, RowTeam& team) {
  set.source = [&team, question = team.question(), source = set.source](const space::RayGrid& grid) {
    formula::RegionOnLines region = source(grid);
    region.rays = team.shared(std::move(region.rays), question);
    return region;
  };
}

void tell(Answer::Data& out, const std::shared_ptr<const RaysQuestion>& q) {
  out.found = q->found();
  out.sampled = true;
  out.text = [q](const Telling&) { return q->text(); };
  out.json_parts = [q](const Telling&, const Sink& sink) { q->json(sink); };
  out.json = [q](const Telling&) {
    std::string all;
    q->json([&](std::string_view part) { all += part; });
    return all;
  };
  out.line_map = [q] { return q->lines(); };
  if (q->optimum)
    out.best = [q] {
      return api::public_optimum(*q->optimum, api::make_region(plane::Region::uniform(0), q->asked.scene().grid));
    };
  if (q->set.side != formula::Side::kNone) return;  // cells have no surface
  out.surface = [q] {
    Surface made = q->surface();
    return findspace::Surface{std::move(made.vertices), std::move(made.faces)};
  };
  for (const char* ending : kSurfaceEndings)
    out.files[ending] = [q, ending](const Telling&) {
      return Region::Drawn{surface_text(q->surface(), q->set.title, ending, q->asked.unit()), {}};
    };
  out.files[".svg"] = [q](const Telling&) { return Region::Drawn{q->slices(), {}}; };
}

/// Of a process that made rows for the one that leads, which has the answer.
Answer::Data nothing_to_tell() {
  Answer::Data out;
  out.text = out.json = [](const Telling&) { return std::string(); };
  return out;
}

Answer::Data answered(const std::shared_ptr<RaysQuestion>& q, bool listed) {
  RaySet& set = q->set;
  q->listed = listed;
  RowTeam* const team = row_team();
  if (team != nullptr && !team->leads()) {
    const LineChoice& lines = set.lines;
    team->serve(set.source, lines.axes ? lines.lattice(set.low, set.high).grid(0) : lines.grid(set.low, set.high),
                row_digester(q->step()));
    return nothing_to_tell();
  }
  if (team != nullptr && set.lines.axes) share(set, *team);
  q->asked.stage("casting rays");
  q->cast = set.lines.axes ? cast_axes(set, q->step(), listed) : cast_lines(set, q->step(), listed);
  if (team != nullptr) {
    if (!set.lines.axes) share(set, *team);  // for its surface
    if (const std::string account = team->account(); !account.empty()) q->asked.note(account);
  }
  if (set.objective) {
    q->asked.stage("looking for the best place");
    q->optimum = best_of(set, *q->cast, q->step());
  } else {
    q->optimum = set.aim ? std::optional(optimum_of(set, *q->cast, q->step())) : set.least;
  }
  Answer::Data out;
  tell(out, q);
  return out;
}

}  // namespace

namespace {

/// In grid steps; nothing where it is no decimal, or not a whole number of them.
std::optional<std::int64_t> steps_between(const AskedScene& asked, const Number& apart) try {
  const auto steps = (api::real_of(apart) / asked.step()).integer();
  if (!steps || *steps < 1 || *steps > exact::kRayLimit) return std::nullopt;
  return static_cast<std::int64_t>(*steps);
} catch (const Error&) {
  return std::nullopt;
}

}  // namespace

RayChoice ray_choice(const AskedScene& asked, const MapLines& lines, std::string_view before, bool listed) {
  using From = MapLines::Side;
  RayChoice out{{},
                lines.side == From::kInner   ? formula::Side::kInner
                : lines.side == From::kOuter ? formula::Side::kOuter
                                             : formula::Side::kNone,
                listed};
  const auto refuse = [&](const std::string& text) { throw Error(ErrorCode::kBadValue, text, asked.scene().file); };
  if (lines.apart ? lines.count != 0 : lines.count < 1 || lines.count > kMostLines)
    refuse(fmt::format("lines: their number, from 1 to {}, or how far they are apart", kMostLines));
  if (lines.axes && lines.side != From::kNone) refuse("lines: cells are those of the lines of one axis, not of three");
  if (lines.apart) {
    const auto steps = steps_between(asked, *lines.apart);
    if (!steps && !before.empty())
      throw Error(ErrorCode::kUsage,
                  fmt::format("{}step wants a decimal number of at least one grid step, and a multiple of it, not '{}'",
                              before, lines.apart->text()));
    if (!steps) refuse("lines are apart by at least one grid step, and a multiple of it");
    out.lines.apart = *steps;
  }
  out.lines.count = lines.count;
  out.lines.axis = static_cast<int>(lines.axis);
  out.lines.axes = lines.axes;
  return out;
}

RayChoice usual_lines(const AskedScene& asked, std::string_view what, std::string_view before, bool listed, int count) {
  if (count < 0 || count > kMostLines)
    throw Error(ErrorCode::kBadValue, fmt::format("lines: their number, from 1 to {}", kMostLines), asked.scene().file);
  RayChoice out{{}, formula::Side::kNone, listed};
  out.lines.count = count > 0 ? count : kUsualLines;
  out.lines.axes = true;
  asked.note(fmt::format("the {0} is taken on {1} x {1} lines of each axis, exact on each ({2} for others)", what,
                         out.lines.count, before.empty() ? "lines" : fmt::format("{}resolution N", before)));
  return out;
}

Answer::Data map_on_lines(AskedScene given, const RayChoice& choice, const Applied& apply) {
  given.require_positions_in_space();
  given.require_question();
  const auto q = std::make_shared<RaysQuestion>(std::move(given));
  q->ask(q->asked.where(), choice);
  if (!apply.operation.empty())
    throw Error(apply.before.empty() ? ErrorCode::kUnsupported : ErrorCode::kUsage,  // that is a command line
                apply.before + "apply needs an exact map, not one on rays");
  return answered(q, choice.listed);
}

Answer::Data shape_on_lines(AskedScene given, const std::string& name, const RayChoice& choice) {
  const auto q = std::make_shared<RaysQuestion>(std::move(given));
  q->shape = q->asked.scene().shape(name);
  const space::ShapeBox box = space::shape_box(*q->shape);
  RaySet& set = q->set;
  set.title = name;
  set.subtitle = q->asked.scene().file;
  set.meaning = "the shape";
  set.lines = choice.lines;
  set.low = box.low;
  set.high = box.high;
  set.unbounded = box.unbounded;
  set.side = choice.side;
  const Real by = set.side == formula::Side::kOuter   ? cell_radius(set)
                  : set.side == formula::Side::kInner ? -cell_radius(set)
                                                      : Real();
  set.source = [&shape = *q->shape, by](const space::RayGrid& grid) {
    return formula::RegionOnLines{space::shape_rays(shape, grid, by)};
  };
  return answered(q, choice.listed);
}

Surface surface_on_lines(const plane::Shape& shape, int count, double step) {
  const space::ShapeBox box = space::shape_box(shape);
  const space::RayLattice lattice = space::ray_lattice(box.low, box.high, count);
  const auto source = [&](int axis) { return space::shape_rays(shape, lattice.grid(axis)); };
  return ray_surface_mesh(space::ray_surface(lattice, source, in_ray_set), step);
}

}  // namespace findspace::io
