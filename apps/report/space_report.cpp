// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "report/space_report.h"

#include <fmt/format.h>

#include "report/report_text.h"

namespace findspace::app {
namespace {

using io::shown;

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

std::string space_summary_text(std::string_view title, const space::SpaceSummary& s, std::string_view unit,
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

}  // namespace findspace::app
