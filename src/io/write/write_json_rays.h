// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A region on rays as JSON: the summary of docs/results.md as far as samples tell it, and every line with its marked
// intervals. Written line by line to a file of its own: neither the rows nor the text is kept in memory. Keywords:
// serialisation, linear ray representation.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "distance/answer/optimum.h"
#include "io/mesh/write_mesh.h"
#include "io/text/spool.h"
#include "space/rays/ray_summary.h"
#include "space/rays/ray_surface.h"

namespace findspace::io {

/// The lines that meet the region: [[u, v, [[from, to, from_in, to_in], ...]], ...]; an end is null where there is
/// none.
class RayLines {
 public:
  RayLines(const space::RayGrid& grid, double step) : grid_(grid), scale_(step / static_cast<double>(grid.parts)) {}
  void add(int j, const space::RayRow& row) { add(row_text(j, row)); }
  /// The lines of one row, which any process can make; and rows in order.
  std::string row_text(int j, const space::RayRow& row) const;
  void add(std::string_view row_text);
  const Spool& text() const& { return text_; }
  Spool text() && { return std::move(text_); }

 private:
  space::RayGrid grid_;
  double scale_;
  Spool text_;
};

struct RaysText {
  std::string_view unit;
  const Spool* lines = nullptr;                   // null or empty: only the summary is written
  bool axes = false;                              // lines along all three axes (space/rays/ray_axes.h)
  bool unbounded = false;                         // the region goes on beyond the window
  std::string_view on_lines = "exact";            // how the lines stand to the region, and
  std::string_view side = "none";                 // how the cells about them do (docs/results.md)
  bool somewhere = false;                         // the region is known not to be empty, whether a line meets it or not
  std::optional<distance::OptimalValue> optimum;  // in the scene's unit
};
void rays_json(const space::RaySummary& summary, const space::RayGrid& grid, double step, const RaysText& text,
               const Sink& sink);
std::string rays_json(const space::RaySummary& summary, const space::RayGrid& grid, double step, const RaysText& text);

/// In the scene's unit.
Surface ray_surface_mesh(const space::RaySurface& surface, double step);

}  // namespace findspace::io
