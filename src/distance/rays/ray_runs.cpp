// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/ray_runs.h"

#include <algorithm>

#include "distance/planar/translation_value.h"
#include "exact/margins/rounding.h"

namespace findspace::distance {

using exact::Real;
using plane::Section;
using space::RayEvent;
using space::RayPosition;
using space::RayRow;

RayRuns::RayRuns(Rows zero, bool searched, const RunQuery& query, const Real& level, const space::RayGrid& grid)
    : zero_(std::move(zero)), searched_(searched), query_(query), level_(level), grid_(grid) {}

/// The line as the direction sees it.
Section RayRuns::section(const RayRow& row, int i) const {
  const auto line = static_cast<std::size_t>(i);
  Section out{row.before[line], {}};
  for (int e = row.first[line]; e < row.first[line + 1]; ++e) {
    const RayEvent& event = row.events[static_cast<std::size_t>(e)];
    out.stops.push_back({event.at.to_real(), event.here, event.after});
  }
  if (query_.forward || query_.both_ways) return out;
  Section back{out.stops.empty() ? out.before : out.stops.back().after, {}};
  for (std::size_t k = out.stops.size(); k-- > 0;)
    back.stops.push_back({-out.stops[k].t, out.stops[k].at, k > 0 ? out.stops[k - 1].after : out.before});
  return back;
}

/// Of the distance less the level at a place; 0 also where a search does not tell it.
int RayRuns::sign(const Section& line, const Real& at) const {
  Section seen = line;
  for (Section::Stop& stop : seen.stops) stop.t -= at;
  if (searched_) return translation_bounds(seen, query_.farthest, query_.both_ways).sign(level_, query_.farthest);
  return sign_of(translation_value(seen, query_.farthest, query_.both_ways), level_);
}

RayPosition RayRuns::position(const Real& at, int number, int i, int j) const {
  RayPosition out;
  out.value = at.to_double();
  constexpr auto kSmall = exact::int128(1) << 62;
  const auto parts = at.fraction();
  if (parts && (*parts)[0] < kSmall && (*parts)[0] > -kSmall && (*parts)[1] < kSmall) {
    out.exact = {(*parts)[0], (*parts)[1]};
    return out;
  }
  out.radius = margin::kFewRoundings * std::abs(out.value);
  out.roots = this;
  out.patch = number;
  out.i = i;
  out.j = j;
  const std::lock_guard lock(guard_);
  places_.insert_or_assign({number, i, j}, at);
  return out;
}

Real RayRuns::root(int patch, int, int i, int j) const {
  const std::lock_guard lock(guard_);
  return places_.at({patch, i, j});
}

exact::Tried<RayRow> RayRuns::try_row(int j) const {
  const exact::Tried<RayRow> found = zero_(j);
  if (!found) return found;
  const RayRow& zero = *found;
  const bool backwards = !query_.forward && !query_.both_ways;
  RayRow out;
  for (int i = 0; i < grid_.nu; ++i) {
    const Section line = section(zero, i);
    std::vector<Real> stops;
    for (const Section::Stop& stop : line.stops) {
      for (const Real& by : {-level_, Real(), level_}) stops.push_back(stop.t + by);
    }
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    const auto between = [&](std::size_t k) {  // before stop k
      return k == 0             ? stops.front() - Real(1)
             : k < stops.size() ? (stops[k - 1] + stops[k]) / Real(2)
                                : stops.back() + Real(1);
    };
    std::vector<int> after{stops.empty() ? sign(line, Real()) : sign(line, between(0))}, here;
    for (std::size_t k = 0; k < stops.size(); ++k) {
      here.push_back(sign(line, stops[k]));
      after.push_back(sign(line, between(k + 1)));
    }
    const std::size_t count = stops.size();
    out.before.push_back(static_cast<std::int8_t>(backwards ? after.back() : after.front()));
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t k = backwards ? count - 1 - n : n;
      const int before_it = backwards ? after[k + 1] : after[k], after_it = backwards ? after[k] : after[k + 1];
      if (before_it == here[k] && here[k] == after_it) continue;
      const int number = static_cast<int>(out.events.size()) - out.first.back();
      out.events.push_back({position(backwards ? -stops[k] : stops[k], number, i, j), static_cast<std::int8_t>(here[k]),
                            static_cast<std::int8_t>(after_it)});
    }
    out.first.push_back(static_cast<int>(out.events.size()));
  }
  return out;
}

}  // namespace findspace::distance
