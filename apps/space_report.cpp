// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "space_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "io/draw/draw_layout.h"

namespace findspace::app {
namespace {

using io::shown;

constexpr std::size_t kMostListed = 20;

template <class... Args>
void put(std::string& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

std::string size(double value, std::string_view unit, const char* power = "") {
  return unit.empty() ? shown(value) : fmt::format("{} {}{}", shown(value), unit, power);
}

std::string point(const space::Place3& p) { return fmt::format("({}, {}, {})", shown(p[0]), shown(p[1]), shown(p[2])); }

std::string component_text(const space::SpaceComponent& c, std::string_view unit) {
  if (c.dimension == 0) return "point " + point(c.sample);
  std::string out;
  if (!c.volume)
    out += "unbounded";
  else if (c.dimension == 3)
    put(out, "volume {}", size(*c.volume, unit, "³"));
  else
    put(out, "no volume");
  if (c.dangling_area > 0) put(out, ", sheets of area {}", size(c.dangling_area, unit, "²"));
  if (c.dangling_length > 0) put(out, ", lines of length {}", size(c.dangling_length, unit));
  if (c.holes > 0) put(out, ", {} {}", c.holes, c.holes == 1 ? "cavity" : "cavities");
  if (c.bbox) put(out, ", {} to {}", point(c.bbox->low), point(c.bbox->high));
  put(out, ", e.g. {}", point(c.sample));
  return out;
}

}  // namespace

std::string space_summary_text(std::string_view title, const space::SpaceSummary& s, std::string_view unit,
                               const io::ExtremeValue* extreme) {
  std::string out = fmt::format("{}\n", title);
  if (extreme != nullptr && extreme->unbounded)
    put(out, "{}: there is none, the values have no bound\n", extreme->maximum ? "maximum" : "minimum");
  else if (extreme != nullptr && extreme->value)
    put(out, "{} {}{}\n", extreme->maximum ? "maximum" : "minimum", size(*extreme->value, unit),
        extreme->attained ? "" : ", not attained: these are the positions on the closure");
  if (s.empty) return out + "empty: there is none\n";
  if (s.whole) return out + "everywhere\n";
  put(out, "set     {}{}\n",
      s.closed ? "closed"
      : s.open ? "open"
               : "neither open nor closed",
      s.bounded ? "" : ", unbounded");
  if (s.volume) put(out, "volume  {}\n", size(*s.volume, unit, "³"));
  if (s.dangling_area > 0) put(out, "sheets  {} of area without volume\n", size(s.dangling_area, unit, "²"));
  if (s.dangling_length > 0) put(out, "lines   {} of length without area\n", size(s.dangling_length, unit));
  if (s.crack_area > 0) put(out, "slits   {} of area missing inside\n", size(s.crack_area, unit, "²"));
  if (s.crack_length > 0) put(out, "cracks  {} of length missing inside\n", size(s.crack_length, unit));
  if (s.holes > 0) put(out, "cavities {}\n", s.holes);
  if (!s.isolated.empty()) put(out, "points  {}\n", s.isolated.size());
  if (s.bbox) put(out, "box     {} to {}\n", point(s.bbox->low), point(s.bbox->high));
  const std::size_t n = std::min(s.components.size(), kMostListed);
  for (std::size_t i = 0; i < n; ++i) put(out, "  {:>3}  {}\n", i + 1, component_text(s.components[i], unit));
  if (n < s.components.size()) put(out, "  and {} more (--json lists all)\n", s.components.size() - n);
  return out;
}

}  // namespace findspace::app
