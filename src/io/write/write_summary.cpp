// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/draw/draw_layout.h"
#include "io/text/put.h"
#include "plane/query/measure_cells_twofold.h"

namespace findspace::io {
namespace {

using plane::Place;
using plane::Twofold;

std::string point(const Place& p) { return fmt::format("({}, {})", shown(p[0]), shown(p[1])); }
std::string box(const plane::Bounds& b) { return fmt::format("{} to {}", point(b.low), point(b.high)); }

std::string count(std::size_t n, const char* one, const char* many) {
  return n == 0 ? fmt::format("no {}", many) : n == 1 ? fmt::format("1 {}", one) : fmt::format("{} {}", n, many);
}

/// A line for each of the first components.
template <class Components, class Text>
void put_components(std::string& out, const Components& components, const Text& text) {
  constexpr std::size_t kMostListed = 20;
  const std::size_t n = std::min(components.size(), kMostListed);
  for (std::size_t i = 0; i < n; ++i) put(out, "  {:>3}  {}\n", i + 1, text(components[i]));
  if (n < components.size()) put(out, "  and {} more (--json lists all)\n", components.size() - n);
}

std::string component_text(const plane::Component& c, std::string_view unit) {
  if (c.dimension == 0) return "point " + point(c.sample);
  std::string out;
  if (c.dimension == 1)
    put(out, "curve of length {}", size_text(c.dangling_length, unit));
  else if (c.area)
    put(out, "area {}", size_text(*c.area, unit, "²"));
  else
    out += "unbounded";
  if (c.dimension == 2 && c.dangling_length > 0)
    put(out, ", with curves of length {}", size_text(c.dangling_length, unit));
  if (c.holes > 0) put(out, ", {}", count(std::size_t(c.holes), "hole", "holes"));
  if (c.bbox) put(out, ", {}", box(*c.bbox));
  put(out, ", e.g. {}", point(c.sample));
  return out;
}

}  // namespace

std::string size_text(double value, std::string_view unit, const char* power) {
  return unit.empty() ? shown(value) : fmt::format("{} {}{}", shown(value), unit, power);
}

std::string optimum_text(const distance::OptimalValue& best, std::string_view unit) {
  const char* name = best.maximum() ? "maximum" : "minimum";
  if (best.unbounded) return fmt::format("{}: there is none, the values have no bound\n", name);
  const auto value = best.value(), bound = best.bound();
  if (!value) return "";
  const std::string beyond =
      bound ? fmt::format(", certain to {}: no position passes {}", size_text(abs(*value - *bound).to_double(), unit),
                          size_text(bound->to_double(), unit))
      : best.proven() ? ""
                      : ", and others may be better";
  const char* taken = best.attained   ? ""
                      : best.proven() ? ", not attained: these are the positions on the closure"
                                      : ", perhaps not attained";
  return fmt::format("{} {}{}{}\n", name, size_text(value->to_double(), unit), beyond, taken);
}

std::string summary_text(std::string_view title, const plane::Summary& s, std::string_view unit,
                         const distance::OptimalValue* best) {
  std::string out = fmt::format("{}\n", title);
  if (best != nullptr) out += optimum_text(*best, unit);
  if (s.empty) return out + "empty: there is none\n";
  if (s.whole) return out + "the whole plane\n";
  put(out, "{}, {}, {}, {}; {}, {}\n", s.bounded ? "bounded" : "unbounded", s.open ? "open" : "not open",
      s.closed ? "closed" : "not closed", s.regular ? "regular" : "not regular",
      count(s.components.size(), "component", "components"), count(std::size_t(s.holes), "hole", "holes"));
  if (s.area && *s.area > 0) put(out, "area    {}\n", size_text(*s.area, unit, "²"));
  if (s.dangling_length > 0) put(out, "curves  {} of length without area\n", size_text(s.dangling_length, unit));
  if (s.crack_length > 0) put(out, "cracks  {} of length missing inside\n", size_text(s.crack_length, unit));
  if (!s.isolated.empty()) put(out, "points  {}\n", count(s.isolated.size(), "isolated point", "isolated points"));
  if (s.bbox) put(out, "box     {}\n", box(*s.bbox));
  put_components(out, s.components, [&](const plane::Component& c) { return component_text(c, unit); });
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

// ---- of space

namespace {

std::string point(const space::Place3& p) { return fmt::format("({}, {}, {})", shown(p[0]), shown(p[1]), shown(p[2])); }

std::string component_text(const space::SpaceComponent& c, std::string_view unit) {
  if (c.dimension == 0) return "point " + point(c.sample);
  std::string out;
  if (!c.volume)
    out += "unbounded";
  else if (c.dimension == 3)
    put(out, "volume {}", size_text(*c.volume, unit, "³"));
  else
    put(out, "no volume");
  if (c.dangling_area > 0) put(out, ", sheets of area {}", size_text(c.dangling_area, unit, "²"));
  if (c.dangling_length > 0) put(out, ", lines of length {}", size_text(c.dangling_length, unit));
  if (c.holes > 0) put(out, ", {} {}", c.holes, c.holes == 1 ? "cavity" : "cavities");
  if (c.bbox) put(out, ", {} to {}", point(c.bbox->low), point(c.bbox->high));
  put(out, ", e.g. {}", point(c.sample));
  return out;
}

}  // namespace

std::string summary_text(std::string_view title, const space::SpaceSummary& s, std::string_view unit,
                         const distance::OptimalValue* best) {
  std::string out = fmt::format("{}\n", title);
  if (best != nullptr) out += optimum_text(*best, unit);
  if (s.empty) return out + "empty: there is none\n";
  if (s.whole) return out + "everywhere\n";
  put(out, "set     {}{}\n",
      s.closed ? "closed"
      : s.open ? "open"
               : "neither open nor closed",
      s.bounded ? "" : ", unbounded");
  if (s.volume) put(out, "volume  {}\n", size_text(*s.volume, unit, "³"));
  if (s.dangling_area > 0) put(out, "sheets  {} of area without volume\n", size_text(s.dangling_area, unit, "²"));
  if (s.dangling_length > 0) put(out, "lines   {} of length without area\n", size_text(s.dangling_length, unit));
  if (s.crack_area > 0) put(out, "slits   {} of area missing inside\n", size_text(s.crack_area, unit, "²"));
  if (s.crack_length > 0) put(out, "cracks  {} of length missing inside\n", size_text(s.crack_length, unit));
  if (s.holes > 0) put(out, "cavities {}\n", s.holes);
  if (!s.isolated.empty()) put(out, "points  {}\n", s.isolated.size());
  if (s.bbox) put(out, "box     {} to {}\n", point(s.bbox->low), point(s.bbox->high));
  put_components(out, s.components, [&](const space::SpaceComponent& c) { return component_text(c, unit); });
  return out;
}

}  // namespace findspace::io
