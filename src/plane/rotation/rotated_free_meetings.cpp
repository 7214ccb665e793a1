// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "exact/margins/plane.h"
#include "plane/rotation/curve_meetings.h"
#include "plane/rotation/rotated_free_finders.h"

namespace findspace::plane {

template <class Find>
void MeetingFinder::Solved::look(Find find) {
  if (std::exchange(looked, true)) return;
  for (const RootPlace& place : find()) places.emplace_back(place, false);
}

void MeetingFinder::corner(std::size_t i, std::size_t k) {
  const FreeQuestion& q = s_.question();
  const double span = s_.span(),
               reach = margin::kRootReach * std::max(s_.spots().travel(i), s_.spots().travel(k)) / s_.half();
  const auto polynomial = [&](int quarters) {
    const auto [f, g] =
        corner_lines(s_.exact_form(s_.alike(i), quarters), s_.exact_form(s_.alike(k), quarters), q.level);
    const auto m = plane::meeting(f, g);
    return m.w.is_zero() ? where_one(m) : corner_polynomial(m, q.level);
  };
  const std::size_t first = s_.alike(i), second = s_.alike(k);
  Solved& solved = solved_[{std::min(first, second), std::max(first, second), s_.pairs().size()}];
  solved.look([&] { return corner_places(s_.form(first), s_.form(second), s_.level(), span); });
  for (auto& [place, done] : solved.places) {
    if (done) continue;
    const double angle = s_.middle() + 2 * std::atan(place.u),
                 tolerance = margin::kRotatedSum * q.tolerance + place.tolerance * reach;
    const RoughCurve c = s_.rough_curve(i, angle), d = s_.rough_curve(k, angle);
    const std::vector<RoughMeeting> all = rough_meetings(c, d, q.tolerance);
    const auto witness = [&](const RoughMeeting& m) {
      const double near = margin::kRotatedSum * m.off + tolerance;
      return std::abs(std::abs(m.at) - s_.level()) <= near && c.holds(m.at, near) && d.holds(m.at, near) &&
             s_.possible(angle, m.at, near);
    };
    done = place.tolerance > margin::kWideRootPlace || std::any_of(all.begin(), all.end(), witness);
    if (done) s_.add_roots(place, polynomial);
  }
}

void MeetingFinder::meeting(std::size_t i, std::size_t k, std::size_t m) {
  const FreeQuestion& q = s_.question();
  const double span = s_.span(), reach = margin::kRootReach *
                                         std::max({s_.spots().travel(i), s_.spots().travel(k), s_.spots().travel(m)}) /
                                         s_.half();
  std::array<std::size_t, 3> key{s_.alike(i), s_.alike(k), s_.alike(m)};
  std::sort(key.begin(), key.end());
  const auto polynomial = [&](int quarters) {
    const auto all =
        ordered(s_.exact_form(key[0], quarters), s_.exact_form(key[1], quarters), s_.exact_form(key[2], quarters));
    const auto [f, g] = meeting_lines(all);
    const auto at = plane::meeting(f, g);
    return !all[0]->line && at.w.is_zero() ? where_one(at) : meeting_polynomial(*all[0], at);
  };
  Solved& solved = solved_[key];
  solved.look([&] { return meeting_places(s_.form(key[0]), s_.form(key[1]), s_.form(key[2]), span); });
  for (auto& [place, done] : solved.places) {
    if (done) continue;
    const double angle = s_.middle() + 2 * std::atan(place.u),
                 tolerance = margin::kRotatedMeeting * q.tolerance + place.tolerance * reach;
    const std::array<RoughCurve, 3> c{s_.rough_curve(i, angle), s_.rough_curve(k, angle), s_.rough_curve(m, angle)};
    const auto s = place.tolerance > margin::kWideRootPlace ? std::nullopt : rough_meeting(c, tolerance);
    done = place.tolerance > margin::kWideRootPlace || (s && s_.possible(angle, *s, tolerance));
    if (done) s_.add_roots(place, polynomial);
  }
}

}  // namespace findspace::plane
