// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Rows of lines cast, by all threads and processes, and added up.
#include <cmath>
#include <utility>

#include "io/question/ray_set.h"
#include "io/team/row_team.h"
#include "space/rays/ray_axes.h"
#include "space/rays/ray_cells.h"
#include "space/rays/ray_sources.h"

namespace findspace::io {
namespace {

/// Beyond the box distances grow along the lines, so intervals without end are cut there.
void keep_intervals(const RaySet& set, const space::RayGrid& grid, int j, const space::RayRow& row,
                    std::vector<space::RayInterval>& out) {
  const space::Approx3 low = exact::approx(set.low), high = exact::approx(set.high);
  const double from[3] = {low.x, low.y, low.z}, to[3] = {high.x, high.y, high.z};
  space::each_interval(grid, j, row, [&](space::RayInterval r) {
    r.from_in = r.from_in || !std::isfinite(r.from);
    r.to_in = r.to_in || !std::isfinite(r.to);
    space::cut_at(from[r.axis], to[r.axis], r.from, r.to);
    out.push_back(r);
  });
}

/// Where positions on the lines are sought, their rows are handed on whole.
void cast_rows(const RaySet& set, const space::RaySource& rays, space::RaySummarizer& summarizer, RayLines* lines,
               Cast& out) {
  space::RayExtreme extreme(set.aim.value_or(space::RayAim{}), set.low, set.high);
  space::each_row(rays, [&](int j, space::RayRow&& row) {
    summarizer.add(j, row);
    if (lines != nullptr) lines->add(j, row);
    extreme.add(out.grid, j, row);
    if (set.objective) keep_intervals(set, out.grid, j, row, out.intervals);
  });
  out.extreme = extreme.found();
}

}  // namespace

space::RayGrid LineChoice::grid(const space::Point& low, const space::Point& high) const {
  return apart > 0 ? space::ray_grid_by_step(low, high, axis, apart) : space::ray_grid(low, high, axis, count);
}

space::RayLattice LineChoice::lattice(const space::Point& low, const space::Point& high) const {
  return apart > 0 ? space::ray_lattice_by_step(low, high, apart) : space::ray_lattice(low, high, count);
}

bool in_ray_set(std::int8_t sign) { return sign <= 0; }
exact::Real cell_radius(const RaySet& set) { return space::cell_radius(set.lines.grid(set.low, set.high)); }

RowDigester row_digester(double step) {
  return [step](const space::RayGrid& grid, int j, const space::RayRow& row, bool written) {
    return RowDigest{space::intervals_of(row), written ? RayLines(grid, step).row_text(j, row) : std::string()};
  };
}

Cast cast_lines(const RaySet& set, double step, bool written) {
  RowTeam* const team = row_team();
  Cast out;
  out.grid = set.lines.grid(set.low, set.high);
  space::RaySummarizer summarizer(out.grid, set.low, set.high);
  RayLines lines(out.grid, step);
  formula::RegionOnLines source = set.source(out.grid);
  out.on_lines = formula::both(set.on_lines, source.side);
  if (set.aim || set.objective) {
    if (team != nullptr) source.rays = team->shared(std::move(source.rays), team->question());
    cast_rows(set, *source.rays, summarizer, written ? &lines : nullptr, out);
  } else {
    const auto take = [&](int j, RowDigest&& digest) {
      summarizer.add(j, digest.intervals);
      lines.add(digest.text);
    };
    if (team == nullptr)
      each_digest(*source.rays, row_digester(step), written, take);
    else
      team->each_digest(*source.rays, row_digester(step), written, take);
  }
  out.summary = summarizer.finish();
  out.lines = std::move(lines).text();
  return out;
}

Cast cast_axes(const RaySet& set, double step, bool written) {
  Cast out;
  const space::RayLattice lattice = set.lines.lattice(set.low, set.high);
  out.grid = lattice.grid(2);
  RayLines lines(out.grid, step);
  space::RayExtreme extreme(set.aim.value_or(space::RayAim{}), set.low, set.high);
  std::array<int, 3> rows{};
  out.on_lines = set.on_lines;
  space::RayAxes axes = space::ray_axes(
      lattice,
      [&](int axis) {
        formula::RegionOnLines source = set.source(lattice.grid(axis));
        out.on_lines = formula::both(out.on_lines, source.side);
        return std::move(source.rays);
      },
      in_ray_set,
      [&](const space::RayGrid& grid, const space::RayRow& row) {
        const int j = rows[static_cast<std::size_t>(grid.axis)]++;
        if (written && grid.axis == 2) lines.add(j, row);
        extreme.add(grid, j, row);
        if (set.objective) keep_intervals(set, grid, j, row, out.intervals);
      });
  out.summary = std::move(axes.summary);
  // What the lines hold beyond the region may join what is apart in it.
  if (out.on_lines != formula::Side::kExact && out.on_lines != formula::Side::kInner)
    for (space::RayComponent& component : out.summary.components) component.certified = false;
  out.extreme = extreme.found();
  out.surface = std::move(axes.surface);
  out.lines = std::move(lines).text();
  return out;
}

}  // namespace findspace::io
