// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/write/write_json_rays.h"

#include <fmt/format.h>

#include <array>

#include "io/write/json_text.h"

namespace findspace::io {
namespace {

std::string place(const std::array<double, 3>& p, double step) {
  return fmt::format("[{}, {}, {}]", p[0] * step, p[1] * step, p[2] * step);
}

std::string coordinates_text(const distance::Coordinates& p) {
  std::string out;
  for (const exact::Real& c : p) put(out, "{}{}", out.empty() ? "[" : ", ", json_number(c.to_double()));
  return out + "]";
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

namespace {

constexpr std::string_view kNextLine = ",\n    ";

/// A number as text, or "null".
class NumberText {
 public:
  NumberText() : size_(std::string_view("null").copy(text_.data(), kMost)) {}
  explicit NumberText(double value) : size_(fmt::format_to_n(text_.data(), kMost, "{}", value).size) {}
  std::string_view view() const { return {text_.data(), size_}; }

 private:
  static constexpr std::size_t kMost = 32;
  std::array<char, kMost> text_{};
  std::size_t size_;
};

/// The intervals of one line, "[from, to, from_in, to_in], ...".
class IntervalTexts {
 public:
  explicit IntervalTexts(fmt::memory_buffer& out) : out_(out), begin_(out.size()) {}

  void put(const NumberText& from, const NumberText& to, bool from_in, bool to_in) {
    append(empty() ? "[" : ", [");
    append(from.view());
    append(", ");
    append(to.view());
    append(from_in ? ", true" : ", false");
    append(to_in ? ", true]" : ", false]");
  }
  bool empty() const { return out_.size() == begin_; }

 private:
  void append(std::string_view text) { out_.append(text.data(), text.data() + text.size()); }
  fmt::memory_buffer& out_;
  std::size_t begin_;
};

void put_line(const space::RayRow& row, int i, double scale, IntervalTexts& intervals) {
  bool in = row.before[i] <= 0, from_in = false;
  NumberText from;
  for (int e = row.first[i]; e < row.first[i + 1]; ++e) {
    const space::RayEvent& event = row.events[e];
    const bool here = event.here <= 0, after = event.after <= 0;
    const NumberText at(event.at.value * scale);
    if (in && !(here && after)) intervals.put(from, at, from_in, here);
    if (!in || !here || !after) {
      from = at;
      // A place that belongs to the interval before does not to the next.
      from_in = here && !in;
      if (!in && here && !after) intervals.put(from, at, from_in, true);
    }
    in = after;
  }
  if (in) intervals.put(from, NumberText(), from_in, false);
}

}  // namespace

std::string RayLines::row_text(int j, const space::RayRow& row) const {
  fmt::memory_buffer out;
  const NumberText v(static_cast<double>(grid_.v_at(j)) * scale_);
  for (int i = 0; i < grid_.nu; ++i) {
    const std::size_t before = out.size();
    const NumberText u(static_cast<double>(grid_.u_at(i)) * scale_);
    fmt::format_to(fmt::appender(out), "{}[{}, {}, [", before == 0 ? "" : kNextLine, u.view(), v.view());
    IntervalTexts intervals(out);
    put_line(row, i, scale_, intervals);
    if (intervals.empty())
      out.resize(before);
    else
      out.append(std::string_view("]]"));
  }
  return fmt::to_string(out);
}

void RayLines::add(std::string_view row_text) {
  if (row_text.empty()) return;
  if (!text_.empty()) text_.append(kNextLine);
  text_.append(row_text);
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
  if (text.optimum) {
    put_optimum(out, *text.optimum);
    if (text.optimum->exists() && !text.optimum->answer->at.empty())
      put(out, "  \"at\": {},\n", coordinates_text(text.optimum->answer->at));
  }
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
