// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "io/draw/draw_layout.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::app {
namespace {

using io::shown;
using plane::Place;
using plane::Twofold;

constexpr std::size_t kMostListed = 20;  // components, points

template <class... Args>
void put(std::string& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

std::string point(const Place& p) { return fmt::format("({}, {})", shown(p[0]), shown(p[1])); }
std::string box(const plane::Bounds& b) { return fmt::format("{} to {}", point(b.low), point(b.high)); }

std::string length(double value, std::string_view unit, const char* power = "") {
  return unit.empty() ? shown(value) : fmt::format("{} {}{}", shown(value), unit, power);
}

std::string count(std::size_t n, const char* one, const char* many) {
  return n == 0 ? fmt::format("no {}", many) : n == 1 ? fmt::format("1 {}", one) : fmt::format("{} {}", n, many);
}

std::string component_text(const plane::Component& c, std::string_view unit) {
  if (c.dimension == 0) return "point " + point(c.sample);
  std::string out;
  if (c.dimension == 1)
    put(out, "curve of length {}", length(c.dangling_length, unit));
  else if (c.area)
    put(out, "area {}", length(*c.area, unit, "²"));
  else
    out += "unbounded";
  if (c.dimension == 2 && c.dangling_length > 0)
    put(out, ", with curves of length {}", length(c.dangling_length, unit));
  if (c.holes > 0) put(out, ", {}", count(std::size_t(c.holes), "hole", "holes"));
  if (c.bbox) put(out, ", {}", box(*c.bbox));
  put(out, ", e.g. {}", point(c.sample));
  return out;
}

void put_components(std::string& out, const plane::Summary& s, std::string_view unit) {
  const std::size_t n = std::min(s.components.size(), kMostListed);
  for (std::size_t i = 0; i < n; ++i) put(out, "  {:>3}  {}\n", i + 1, component_text(s.components[i], unit));
  if (n < s.components.size()) put(out, "  and {} more (--json lists all)\n", s.components.size() - n);
}

std::string extreme_text(const io::ExtremeValue& e, std::string_view unit) {
  const char* name = e.maximum ? "maximum" : "minimum";
  if (e.unbounded) return fmt::format("{}: there is none, the values have no bound\n", name);
  if (!e.value) return "";
  return fmt::format("{} {}{}\n", name, length(*e.value, unit),
                     e.attained ? "" : ", not attained: these are the positions on the closure");
}

}  // namespace

std::string summary_text(std::string_view title, const plane::Summary& s, std::string_view unit,
                         const io::ExtremeValue* extreme) {
  std::string out = fmt::format("{}\n", title);
  if (extreme != nullptr) out += extreme_text(*extreme, unit);
  if (s.empty) return out + "empty: there is none\n";
  if (s.whole) return out + "the whole plane\n";
  put(out, "{}, {}, {}, {}; {}, {}\n", s.bounded ? "bounded" : "unbounded", s.open ? "open" : "not open",
      s.closed ? "closed" : "not closed", s.regular ? "regular" : "not regular",
      count(s.components.size(), "component", "components"), count(std::size_t(s.holes), "hole", "holes"));
  if (s.area && *s.area > 0) put(out, "area    {}\n", length(*s.area, unit, "²"));
  if (s.dangling_length > 0) put(out, "curves  {} of length without area\n", length(s.dangling_length, unit));
  if (s.crack_length > 0) put(out, "cracks  {} of length missing inside\n", length(s.crack_length, unit));
  if (!s.isolated.empty()) put(out, "points  {}\n", count(s.isolated.size(), "isolated point", "isolated points"));
  if (s.bbox) put(out, "box     {}\n", box(*s.bbox));
  put_components(out, s, unit);
  return out;
}

std::string intervals_text(std::string_view title, const std::vector<plane::LineInterval>& intervals,
                           const exact::Real& step, std::string_view unit) {
  std::string out = fmt::format("{}\n", title);
  if (intervals.empty()) return out + "empty: there is none on the line\n";
  const Twofold factor(step);
  for (const plane::LineInterval& i : intervals) {
    auto end = [&](const std::optional<exact::Real>& t, const char* none) {
      return t ? shown((Twofold(*t) * factor).value()) : std::string(none);
    };
    put(out, "  {}{}, {}{}\n", i.from_in ? '[' : '(', end(i.from, "-∞"), end(i.to, "∞"), i.to_in ? ']' : ')');
  }
  if (!unit.empty()) put(out, "in {} along the line from the point it goes through\n", unit);
  return out;
}

std::string bounded_json(std::string inner, const std::string& outer) {
  inner.erase(inner.rfind('}'));
  return inner + ",\n  \"side\": \"inner\",\n  \"outer\": " + outer + "}\n";
}

}  // namespace findspace::app
