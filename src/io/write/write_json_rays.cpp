// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/write/write_json_rays.h"

#include <fmt/format.h>

#include <array>

namespace findspace::io {
namespace {

std::string place(const std::array<double, 3>& p, double step) {
  return fmt::format("[{}, {}, {}]", p[0] * step, p[1] * step, p[2] * step);
}

void put_optimum(const RayOptimum& optimum, std::string& out) {
  out += fmt::format("  \"{}\": {}, \"attained\": {},", optimum.maximum ? "maximum" : "minimum",
                     optimum.value ? fmt::format("{}", *optimum.value) : "null", optimum.attained);
  if (optimum.bound) out += fmt::format(" \"proven\": false, \"bound\": {},", *optimum.bound);
  out += "\n";
  if (optimum.value) out += fmt::format("  \"at\": {},\n", place(optimum.at, 1));
}

void put_components(const space::RaySummary& summary, double step, bool axes, std::string& out) {
  out += "  \"components\": [";
  for (std::size_t k = 0; k < summary.components.size(); ++k) {
    const space::RayComponent& c = summary.components[k];
    out += fmt::format("{}\n    {{\"volume\": {}, \"sample\": {}, \"bbox\": [{}, {}]{}}}", k == 0 ? "" : ",",
                       c.volume * (step * step * step), place(c.sample, step), place(c.low, step), place(c.high, step),
                       axes ? fmt::format(", \"certified\": {}", c.certified) : "");
  }
  out += summary.components.empty() ? "],\n" : "\n  ],\n";
}

/// What the lines were and found, up to the lines themselves.
void put_grid(const space::RaySummary& summary, const space::RayGrid& grid, double step, const RaysText& text,
              std::string& out) {
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  const double part = step / static_cast<double>(grid.parts);
  out += fmt::format("  \"rays\": {{\"axis\": \"{}\", \"counts\": [{}, {}], \"spacing\": [{}, {}], \"precision\": {}, ",
                     kAxes[grid.axis], grid.nu, grid.nv, static_cast<double>(grid.du) * part,
                     static_cast<double>(grid.dv) * part, summary.precision * step);
  out += fmt::format(
      "\"intervals\": {}, \"points\": {},\n    \"on_lines\": \"{}\", \"axes\": {}, \"connectivity\": \"{}\"",
      summary.intervals, summary.points, text.on_lines, text.axes ? 3 : 1,
      text.axes ? "crossing lines of three axes where certified, else overlapping intervals of neighbouring lines"
                : "overlapping intervals of neighbouring lines");
}

}  // namespace

void RayLines::add(int j, const space::RayRow& row) {
  for (int i = 0; i < grid_.nu; ++i) {
    std::string intervals;
    bool in = row.before[i] <= 0, from_in = false;
    std::string from = "null";
    const auto close = [&](const std::string& to, bool to_in) {
      intervals += fmt::format("{}[{}, {}, {}, {}]", intervals.empty() ? "" : ", ", from, to, from_in, to_in);
    };
    for (int e = row.first[i]; e < row.first[i + 1]; ++e) {
      const space::RayEvent& event = row.events[e];
      const bool here = event.here <= 0, after = event.after <= 0;
      const std::string at = fmt::format("{}", event.at.value * scale_);
      if (in && !(here && after)) close(at, here);
      if (!in || !here || !after) {
        from = at;
        // A place that belongs to the interval before does not to the next.
        from_in = here && !in;
        if (!in && here && !after) close(at, true);
      }
      in = after;
    }
    if (in) close("null", false);
    if (intervals.empty()) continue;
    text_.append(fmt::format("{}[{}, {}, [{}]]", text_.empty() ? "" : ",\n    ",
                             static_cast<double>(grid_.u_at(i)) * scale_, static_cast<double>(grid_.v_at(j)) * scale_,
                             intervals));
  }
}

std::string rays_json(const space::RaySummary& summary, const space::RayGrid& grid, double step, const RaysText& text) {
  std::string out;
  rays_json(summary, grid, step, text, [&](std::string_view part) { out += part; });
  return out;
}

void rays_json(const space::RaySummary& summary, const space::RayGrid& grid, double step, const RaysText& text,
               const Sink& sink) {
  const bool empty = summary.empty && !text.unbounded && !text.somewhere;
  std::string out = "{\n  \"dimension\": 3,\n";
  if (!text.unit.empty()) out += fmt::format("  \"unit\": \"{}\",\n", text.unit);
  out += fmt::format("  \"empty\": {}, \"whole\": false, \"bounded\": {},\n", empty, !text.unbounded);
  out += fmt::format("  \"exact\": false, \"side\": \"{}\",\n", text.side);
  out += text.unbounded ? std::string("  \"volume\": null,\n")
                        : fmt::format("  \"volume\": {},\n", summary.volume * (step * step * step));
  if (!summary.empty)
    out += fmt::format("  \"bbox\": [{}, {}],\n", place(summary.low, step), place(summary.high, step));
  if (text.optimum) put_optimum(*text.optimum, out);
  put_components(summary, step, text.axes, out);
  put_grid(summary, grid, step, text, out);
  if (text.lines != nullptr) {
    sink(out + ",\n    \"lines\": [");
    if (!text.lines->empty()) {
      sink("\n    ");
      text.lines->copy_to(sink);
    }
    out.assign(1, ']');
  }
  sink(out + "}\n}\n");
}

Surface ray_surface_mesh(const space::RaySurface& surface, double step) {
  Surface out;
  for (const auto& v : surface.vertices) out.vertices.push_back({v[0] * step, v[1] * step, v[2] * step});
  for (const auto& f : surface.faces) out.faces.push_back({f[0], f[1], f[2]});
  return out;
}

}  // namespace findspace::io
