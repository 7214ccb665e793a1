// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Maps of 3D scenes on parallel lines, for solids of any shape: with --resolution N, or where no exact map is to
// be had.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "common/process_team.h"
#include "formula/language/certain_cells.h"
#include "formula/language/evaluate.h"
#include "formula/solid/solve_rays.h"
#include "in_space/ray_optimum.h"
#include "in_space/space_commands.h"
#include "io/draw/draw_slices.h"
#include "io/mesh/write_mesh.h"
#include "io/write/write_json_rays.h"
#include "space/rays/ray_axes.h"
#include "space/rays/ray_cells.h"
#include "space/rays/ray_sources.h"
#include "space/shape/shape_rays.h"

namespace findspace::app {
namespace {

/// Of the picture in slices.
constexpr int kLayers = 16;

std::string summary_text(const RaySet& set, const space::RaySummary& summary, double step, const std::string& unit) {
  using formula::Side;
  if (summary.empty && !set.unbounded && set.side == Side::kOuter) return set.title + ": proven empty\n";
  if (summary.empty && !set.unbounded)
    return set.title + ": no line meets the region (smaller parts may lie between the lines)\n";
  std::string out = fmt::format("{}: on {} line{}, {} interval{}\n", set.title, summary.lines,
                                summary.lines == 1 ? "" : "s", summary.intervals, summary.intervals == 1 ? "" : "s");
  if (set.unbounded) return out + "  the region is unbounded\n";
  const auto certified = std::count_if(summary.components.begin(), summary.components.end(),
                                       [](const space::RayComponent& c) { return c.certified; });
  return out + fmt::format("  volume {} {:.9g}{}, {} component{} by {}\n",
                           set.side == Side::kInner   ? "at least"
                           : set.side == Side::kOuter ? "at most"
                                                      : "about",
                           summary.volume * step * step * step, unit.empty() ? "" : " " + unit + "³",
                           summary.components.size(), summary.components.size() == 1 ? "" : "s",
                           set.lines.axes ? fmt::format("crossing lines ({} certified)", certified)
                                          : "overlap of neighbouring lines");
}

bool in_region(std::int8_t sign) { return sign <= 0; }

/// Beyond the box distances grow along the lines, so intervals without end are cut there.
void keep_intervals(const RaySet& set, const space::RayGrid& grid, int j, const space::RayRow& row,
                    std::vector<space::RayInterval>& out) {
  const space::Approx3 low = exact::approx(set.low), high = exact::approx(set.high);
  const double from[3] = {low.x, low.y, low.z}, to[3] = {high.x, high.y, high.z};
  space::each_interval(grid, j, row, [&](space::RayInterval r) {
    if (!std::isfinite(r.from)) {
      r.from = std::min(from[r.axis], r.to);
      r.from_in = true;
    }
    if (!std::isfinite(r.to)) {
      r.to = std::max(to[r.axis], r.from);
      r.to_in = true;
    }
    out.push_back(r);
  });
}

RowDigester digester_of(double step) {
  return [step](const space::RayGrid& grid, int j, const space::RayRow& row, bool written) {
    return RowDigest{space::intervals_of(row), written ? io::RayLines(grid, step).row_text(j, row) : std::string()};
  };
}

/// Where positions on the lines are sought, their rows are handed on whole.
void cast_rows(const RaySet& set, const space::RaySource& rays, space::RaySummarizer& summarizer, io::RayLines* lines,
               Cast& out) {
  space::RayExtreme extreme(set.aim.value_or(space::RayAim{}));
  space::each_row(rays, [&](int j, space::RayRow&& row) {
    summarizer.add(j, row);
    if (lines != nullptr) lines->add(j, row);
    extreme.add(out.grid, j, row);
    if (set.objective) keep_intervals(set, out.grid, j, row, out.intervals);
  });
  out.extreme = extreme.found();
}

Cast cast_lines(const RaySet& set, double step, bool written, ProcessTeam* team) {
  Cast out;
  out.grid = set.lines.grid(set.low, set.high);
  space::RaySummarizer summarizer(out.grid);
  io::RayLines lines(out.grid, step);
  formula::RegionOnLines source = set.source(out.grid);
  out.on_lines = formula::both(set.on_lines, source.side);
  if (set.aim || set.objective) {
    if (team != nullptr) source.rays = team->shared(std::move(source.rays));
    cast_rows(set, *source.rays, summarizer, written ? &lines : nullptr, out);
  } else {
    const auto take = [&](int j, RowDigest&& digest) {
      summarizer.add(j, digest.intervals);
      lines.add(digest.text);
    };
    if (team == nullptr)
      each_digest(*source.rays, digester_of(step), written, take);
    else
      team->each_digest(*source.rays, digester_of(step), written, take);
  }
  out.summary = summarizer.finish();
  out.lines = std::move(lines).text();
  return out;
}

Cast cast_axes(const RaySet& set, double step, bool written) {
  Cast out;
  const space::RayLattice lattice = set.lines.lattice(set.low, set.high);
  out.grid = lattice.grid(2);
  io::RayLines lines(out.grid, step);
  space::RayExtreme extreme(set.aim.value_or(space::RayAim{}));
  std::array<int, 3> rows{};
  out.on_lines = set.on_lines;
  space::RayAxes axes = space::ray_axes(
      lattice,
      [&](int axis) {
        formula::RegionOnLines source = set.source(lattice.grid(axis));
        out.on_lines = formula::both(out.on_lines, source.side);
        return std::move(source.rays);
      },
      in_region,
      [&](const space::RayGrid& grid, const space::RayRow& row) {
        const int j = rows[static_cast<std::size_t>(grid.axis)]++;
        if (written && grid.axis == 2) lines.add(j, row);
        extreme.add(grid, j, row);
        if (set.objective) keep_intervals(set, grid, j, row, out.intervals);
      });
  out.summary = std::move(axes.summary);
  out.extreme = extreme.found();
  out.surface = std::move(axes.surface);
  out.lines = std::move(lines).text();
  return out;
}

/// What the slices show: the region with a little around it, within the box of the lines.
std::pair<space::Point, space::Point> shown_box(const RaySet& set, const space::RaySummary& summary) {
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

}  // namespace

exact::Real cell_radius(const RaySet& set) { return space::cell_radius(set.lines.grid(set.low, set.high)); }

void take_side(const Session& session, RaySet& set) {
  const std::string& side = session.options().side;
  if (!side.empty()) set.side = side == "inner" ? formula::Side::kInner : formula::Side::kOuter;
}

namespace {

/// The outputs that such a map can have; anything else is refused.
void check_ray_outputs(const Options& options, const RaySet& set) {
  std::vector<std::string> formats{".json"};
  if (set.side == formula::Side::kNone)
    formats.insert(formats.end(), io::kSurfaceEndings.begin(), io::kSurfaceEndings.end());
  check_outputs(options, formats);
  if (!options.apply.empty()) throw Error(ErrorCode::kUsage, "--apply needs an exact map, not one on rays");
}

/// The set, its lines and its best value, as they are written; ends on the grid, `step` in the scene's unit.
struct RaysShown {
  const Session& session;
  const RaySet& set;
  std::shared_ptr<const Cast> cast;
  std::optional<distance::OptimalValue> optimum;
  double step;

  /// Does not refer to the session or the set: it may be written after them.
  std::function<void(const io::Sink&)> json() const {
    return [cast = cast, step = step, optimum = optimum, unit = session.unit(), axes = set.lines.axes,
            unbounded = set.unbounded, on_lines = formula::name(cast->on_lines), side = formula::name(set.side),
            somewhere = set.somewhere](const io::Sink& sink) {
      const io::RaysText text{unit, &cast->lines, axes, unbounded, on_lines, side, somewhere, optimum};
      io::rays_json(cast->summary, cast->grid, step, text, sink);
    };
  }
  io::Surface surface() const {
    if (set.lines.axes) return io::ray_surface_mesh(cast->surface, step);
    const space::RayLattice lattice = set.lines.lattice(set.low, set.high);
    const auto source = [&](int axis) { return set.source(lattice.grid(axis)).rays; };
    return io::ray_surface_mesh(space::ray_surface(lattice, source, in_region), step);
  }
  std::string slices() const {
    const auto [low, high] = shown_box(set, cast->summary);
    const space::RayGrid slices = io::slice_grid(low, high, kLayers, std::max(cast->grid.nu, cast->grid.nv));
    io::SlicesPicture picture{set.title, set.subtitle, session.unit(), set.meaning, slices, low, high, step, {}, {}};
    picture.rows = space::all_rows(*set.source(slices).rays);
    for (const plane::ShapePtr& shape : set.fixed)
      picture.fixed.push_back(space::all_rows(*space::shape_rays(*shape, slices)));
    return io::slices_svg(picture);
  }
  Writers writers() const {
    Writers out;
    for (const char* ending : io::kSurfaceEndings)
      out.emplace(ending, [this, ending] { return io::surface_text(surface(), set.title, ending, session.unit()); });
    out[".svg"] = [this] { return slices(); };
    return out;
  }
};

/// The set with rows that all processes of the team make.
RaySet shared_by(ProcessTeam& team, const RaySet& set) {
  RaySet out = set;
  out.source = [&team, source = set.source](const space::RayGrid& grid) {
    formula::RegionOnLines region = source(grid);
    region.rays = team.shared(std::move(region.rays));
    return region;
  };
  return out;
}

}  // namespace

Outcome rays_outcome(const Session& session, const RaySet& asked) {
  const Options& options = session.options();
  check_ray_outputs(options, asked);
  if (options.team != nullptr && !options.team->leads()) {
    const LineChoice& lines = asked.lines;
    const space::RayGrid first =
        lines.axes ? lines.lattice(asked.low, asked.high).grid(0) : lines.grid(asked.low, asked.high);
    options.team->serve(asked.source, first, digester_of(session.step().to_double()));
    return {};
  }
  const RaySet set = options.team == nullptr ? asked : shared_by(*options.team, asked);
  const double step = session.step().to_double();
  session.reporter().stage("casting rays");
  const bool written = options.json || std::any_of(options.outputs.begin(), options.outputs.end(),
                                                   [](const auto& file) { return file.extension() == ".json"; });
  const auto cast = std::make_shared<Cast>(set.lines.axes ? cast_axes(set, step, written)
                                                          : cast_lines(asked, step, written, options.team));
  if (options.team != nullptr)
    if (const std::string account = options.team->account(); !account.empty()) session.reporter().note(account);
  if (set.objective) session.reporter().stage("looking for the best place");
  const auto optimum = set.objective ? std::optional(best_of(set, *cast, step))
                       : set.aim     ? std::optional(optimum_of(set, *cast, step))
                                     : set.least;
  const RaysShown shown{session, set, cast, optimum, step};
  session.reporter().stage("writing");
  write_outputs(options, shown.writers(), {{".json", shown.json()}});
  const bool proven_empty = set.side == formula::Side::kOuter && cast->summary.empty && !set.unbounded;
  const ExitStatus status = proven_empty ? kEmpty : kDone;
  if (options.json) return {{}, status, shown.json()};
  std::string text = summary_text(set, cast->summary, step, session.unit());
  if (optimum && optimum->value()) text += optimum_text(*optimum);
  return {std::move(text), status};
}

namespace {

/// The formula whose places on the lines have cells on that side of the region.
formula::Formula for_cells(const RaySet& set, const formula::Formula& formula, const exact::Real& step) {
  const exact::Real radius = cell_radius(set) * step;
  return set.side == formula::Side::kOuter ? widened(formula, radius) : narrowed(formula, radius);
}

/// The shapes of a formula that stay where they are.
std::vector<plane::ShapePtr> fixed_shapes(const Session& session, const formula::Formula& formula) {
  std::set<std::string> names = formula.shapes();
  for (const std::string& moving : session.scene().moving) names.erase(moving);
  std::vector<plane::ShapePtr> out;
  for (const std::string& name : names) out.push_back(session.scene().shape(name));
  return out;
}

/// A question about positions on lines, with what its set refers to.
struct AskedRays {
  std::optional<formula::SpaceSolver> solver;
  formula::RayWorld world;
  formula::QuestionOnLines question;
  formula::Formula formula;  // the question's, or for its cells
  RaySet set;
};

std::unique_ptr<const AskedRays> asked_rays(const Session& session, const LineChoice& lines,
                                            const formula::Formula& where) {
  auto out = std::make_unique<AskedRays>();
  AskedRays& asked = *out;
  const auto goal = session.goal();
  session.reporter().stage("building the shapes");
  asked.world = ray_world(session);
  const auto solver = [&]() -> const formula::SpaceSolver& {
    session.reporter().stage("looking for least values");
    return asked.solver.emplace(space_world(session));
  };
  asked.question = formula::question_on_lines(asked.world, solver, where);
  const formula::QuestionOnLines& question = asked.question;
  asked.formula = question.levels.formula;
  RaySet& set = asked.set;
  set.title = fmt::format("Positions of {}", fmt::join(session.scene().moving, ", "));
  set.subtitle = session.scene().where.text;
  set.meaning = "positions";
  set.fixed = fixed_shapes(session, where);
  set.lines = lines;
  set.low = question.window.low;
  set.high = question.window.high;
  set.unbounded = question.unbounded;
  set.on_lines = question.levels.side;
  set.somewhere = question.somewhere;
  if (!question.levels.minima.empty()) set.least = least_of(question.levels.minima[0]);
  take_side(session, set);
  if (set.side != formula::Side::kNone) asked.formula = for_cells(set, asked.formula, session.step());
  if (goal && goal->objective.kind == formula::Objective::Kind::kDistance) {
    if (!asked.solver) asked.solver.emplace(space_world(session));
    set.objective = objective_of(*asked.solver, *goal);
  } else if (goal)
    set.aim = aim_of(session, *goal);
  set.source = [&asked](const space::RayGrid& grid) { return asked.question.on(asked.world, asked.formula, grid); };
  if (question.one_position) session.reporter().note("the minimisers have no map on lines: one of them is given");
  return out;
}

}  // namespace

Outcome map_rays(const Session& session, const LineChoice& lines) {
  return rays_outcome(session, asked_rays(session, lines, session.where())->set);
}

RaysDrawn draw_rays(const Session& session, const LineChoice& lines, const formula::Formula& where) {
  const auto asked = asked_rays(session, lines, where);
  const double step = session.step().to_double();
  const Cast cast = cast_axes(asked->set, step, false);
  io::RaysText text;
  const std::string unit = session.unit();
  text.unit = unit;
  text.axes = true;
  text.unbounded = asked->set.unbounded;
  text.on_lines = formula::name(cast.on_lines);
  text.side = formula::name(asked->set.side);
  text.somewhere = asked->set.somewhere;
  return {io::rays_json(cast.summary, cast.grid, step, text), io::ray_surface_mesh(cast.surface, step)};
}

io::Surface shape_on_lines(const Session& session, const plane::Shape& shape, int count) {
  const space::ShapeBox box = space::shape_box(shape);
  const space::RayLattice lattice = space::ray_lattice(box.low, box.high, count);
  const auto source = [&](int axis) { return space::shape_rays(shape, lattice.grid(axis)); };
  return io::ray_surface_mesh(space::ray_surface(lattice, source, in_region), session.step().to_double());
}

}  // namespace findspace::app
