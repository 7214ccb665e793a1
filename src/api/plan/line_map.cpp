// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions of space on lines, the bounds of their volume, and their surfaces.

#include "api/plan/line_map.h"

#include <cmath>
#include <limits>

#include "api/query/world_data.h"
#include "formula/language/certain_cells.h"
#include "formula/language/evaluate.h"
#include "formula/solid/ray_minima.h"
#include "formula/solid/solve_rays.h"
#include "space/rays/ray_cells.h"
#include "space/rays/ray_intervals.h"
#include "space/rays/ray_summary.h"
#include "space/rays/ray_surface.h"

namespace findspace {
namespace {

/// A formula over a world of space, ready to be taken on lines.
struct AskedOnLines {
  const formula::RayWorld& world;
  formula::QuestionOnLines question;
  double step;

  AskedOnLines(const World::Data& data, const Formula& text, const std::vector<int>& axes)
      : world(*data.space("a map on lines").world().rays),
        question(formula::question_on_lines(
            world, [&]() -> const formula::SpaceSolver& { return *data.solid; }, data.formula(text.text()), axes)),
        step(data.grid.step_size()) {}
  space::RayGrid grid(const Lines& lines) const {
    return space::ray_grid(question.window.low, question.window.high, static_cast<int>(lines.axis), lines.count);
  }
  formula::RegionOnLines on(const formula::Formula& formula, const space::RayGrid& grid) const {
    return question.on(world, formula, grid);
  }
};

std::optional<double> end_of(double place, double step) {
  return std::isfinite(place) ? std::optional(place * step) : std::nullopt;
}

void add_row(const space::RayGrid& grid, int j, const space::RayRow& row, double step, LineMap& map) {
  const LineMap::Line* last = nullptr;
  space::each_interval(grid, j, row, [&](const space::RayInterval& r) {
    Position3 through{};
    for (std::size_t k = 0; k < 3; ++k) through[k] = k == r.axis ? 0 : r.at[k] * step;
    if (last == nullptr || last->through != through) last = &map.lines.emplace_back(LineMap::Line{through, {}});
    map.lines.back().intervals.push_back({end_of(r.from, step), end_of(r.to, step), r.from_in, r.to_in});
    last = &map.lines.back();
  });
}

Position3 scaled(const std::array<double, 3>& p, double step) { return {p[0] * step, p[1] * step, p[2] * step}; }

/// In the unit, cubed.
double volume_on(const AskedOnLines& asked, const formula::Formula& formula, const space::RayGrid& grid) {
  space::RaySummarizer summarizer(grid, asked.question.window.low, asked.question.window.high);
  const formula::RegionOnLines source = asked.on(formula, grid);
  space::each_row(*source.rays, [&](int j, space::RayRow&& row) { summarizer.add(j, row); });
  return summarizer.finish().volume * asked.step * asked.step * asked.step;
}

}  // namespace

LineMap api::line_map(const space::RaySource& rays, const formula::RayWindow& window, double step) {
  space::RaySummarizer summarizer(rays.grid(), window.low, window.high);
  LineMap out;
  space::each_row(rays, [&](int j, space::RayRow&& row) {
    summarizer.add(j, row);
    add_row(rays.grid(), j, row, step, out);
  });
  const space::RaySummary summary = summarizer.finish();
  out.volume = summary.volume * step * step * step;
  out.components = summary.components.size();
  if (!summary.empty) out.bounds = SpaceRegion::Bounds3{scaled(summary.low, step), scaled(summary.high, step)};
  return out;
}

LineMap World::on_lines(const Formula& formula, const Lines& lines) const {
  return api::limited(data_->options, [&] {
    const AskedOnLines asked(*data_, formula, {static_cast<int>(lines.axis)});
    const formula::RegionOnLines source = asked.on(asked.question.levels.formula, asked.grid(lines));
    LineMap out = api::line_map(*source.rays, asked.question.window, asked.step);
    out.exact = formula::both(asked.question.levels.side, source.side) == formula::Side::kExact;
    out.unbounded = asked.question.unbounded;
    return out;
  });
}

VolumeBounds World::volume(const Formula& formula, const Lines& lines) const {
  return api::limited(data_->options, [&] {
    const AskedOnLines asked(*data_, formula, {static_cast<int>(lines.axis)});
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    if (asked.question.unbounded) return VolumeBounds{kInfinite, kInfinite};
    const space::RayGrid grid = asked.grid(lines);
    const exact::Real radius = space::cell_radius(grid) * data_->grid.step();
    return VolumeBounds{volume_on(asked, formula::narrowed(asked.question.levels.formula, radius), grid),
                        volume_on(asked, formula::widened(asked.question.levels.formula, radius), grid)};
  });
}

Surface World::surface(const Formula& formula, int count) const {
  return api::limited(data_->options, [&] {
    const AskedOnLines asked(*data_, formula, {0, 1, 2});
    const space::RayLattice lattice = space::ray_lattice(asked.question.window.low, asked.question.window.high, count);
    const auto source = [&](int axis) { return asked.on(asked.question.levels.formula, lattice.grid(axis)).rays; };
    const space::RaySurface found = space::ray_surface(lattice, source, [](std::int8_t sign) { return sign <= 0; });
    Surface out;
    for (const auto& v : found.vertices) out.vertices.push_back(scaled(v, asked.step));
    for (const auto& f : found.faces) out.faces.emplace_back(f.begin(), f.end());
    return out;
  });
}

}  // namespace findspace
