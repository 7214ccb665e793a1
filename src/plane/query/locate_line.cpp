// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/locate_line.h"

#include "plane/query/section.h"

namespace findspace::plane {

using exact::Real;

std::vector<LineInterval> intervals(const Section& line, const Real& scale) {
  std::vector<LineInterval> out;
  // In turn: the ray before the first stop, a stop, what lies between, ..., the ray after the last one.
  bool inside = line.before != 0;
  if (inside) out.push_back({});
  for (const Section::Stop& stop : line.stops) {
    const bool here = stop.at != 0, after = stop.after != 0;
    const Real t = stop.t * scale;
    if (inside && !(here && after)) {
      out.back().to = t;
      out.back().to_in = here;
    }
    if (after && !(here && inside)) out.push_back({t, std::nullopt, here && !inside, false});
    if (here && !inside && !after) out.push_back({t, t, true, true});
    inside = after;
  }
  return out;
}

std::vector<LineInterval> along_line(const Region& region, const GridPoint& through, const GridPoint& direction) {
  const Section line = section(region, {Real(through.x), Real(through.y)}, {Real(direction.x), Real(direction.y)});
  return intervals(line, sqrt(Real(direction.x) * Real(direction.x) + Real(direction.y) * Real(direction.y)));
}

}  // namespace findspace::plane
