// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Events for positions on a way only (free_way.h).

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/plane.h"
#include "plane/rotation/curve_meetings.h"
#include "plane/rotation/rotated_free_finders.h"

namespace findspace::plane {

using exact::Real;
using Kind = ContactPair::Kind;

namespace {

bool passes(const RoughCurve& c, RoughPoint s, double tolerance) {
  const double off = c.line ? dot(c.normal, s) - c.offset() : length(s - c.center) - std::abs(c.radius);
  return std::abs(off) <= tolerance && c.holds(s, tolerance);
}

/// The curve passes a place s of the way.
RotatedEquation passing(const FreeQuestion& q, const ContactPair& k, const RealVector& s) {
  const ContactFeatures &fixed = q.curves.fixed(), &rotating = q.curves.rotating();
  const RealVector f = q.way->rotations ? RealVector{} : s, t = q.way->rotations ? s : RealVector{};
  if (k.kind == Kind::kRounds) {
    const RoundFeature &a = fixed.rounds[k.fixed], &b = rotating.rounds[k.rotating];
    return rotated_gap(a.center - f, b.center + t, a.radius + b.radius);
  }
  if (k.kind == Kind::kFixedEdge) {
    const EdgeFeature& a = fixed.edges[k.fixed];
    const RoundFeature& b = rotating.rounds[k.rotating];
    const RealVector n = exact_normal(a);
    return rotated_dot(n, b.center + t, plane::dot(n, a.p - f) + times_length(b.radius, n));
  }
  const RoundFeature& a = fixed.rounds[k.fixed];
  const EdgeFeature& b = rotating.edges[k.rotating];
  const RealVector n = exact_normal(b);
  return rotated_dot(n, a.center - f, plane::dot(n, b.p + t) + times_length(a.radius, n), true);
}

/// A circle touches the way, or a segment lies along it.
void touching_way(FreeSector& sector, std::size_t i) {
  const FreeQuestion& q = sector.question();
  const ContactPair& k = sector.pairs()[i];
  const auto witness = [&](double angle) {
    const double tolerance = margin::kRotatedSum * q.tolerance;
    const RoughCurve c = q.curves.rough(k, angle);
    if (c.line) return std::abs(c.offset()) <= tolerance && (q.far || c.least() <= sector.level() + tolerance);
    const RoughPoint u = q.way->rough_unit(angle), s = dot(c.center, u) * u;
    return passes(c, s, tolerance) && sector.possible(angle, s, tolerance);
  };
  const RealVector n = left_normal(q.way->along);
  const bool rotations = q.way->rotations;
  if (k.kind == Kind::kRounds) {
    // dot(n, a - rotated b) = +-radius, n being rotated or not.
    const RoundFeature &a = q.curves.fixed().rounds[k.fixed], &b = q.curves.rotating().rounds[k.rotating];
    const Real own = plane::dot(n, rotations ? b.center : a.center), reach = times_length(a.radius + b.radius, n);
    for (const Real& c : {own - reach, own + reach})
      sector.solve(rotated_dot(n, rotations ? a.center : b.center, c, rotations), witness);
    return;
  }
  const bool turning_edge = k.kind == Kind::kTurningEdge;
  const RealVector m =
      exact_normal(turning_edge ? q.curves.rotating().edges[k.rotating] : q.curves.fixed().edges[k.fixed]);
  if (rotations == turning_edge) {
    if (plane::cross(n, m).sign() == 0) sector.solve(line_equation(q.curves, k, Real()), witness);
    return;
  }
  // Parallel at two angles only: the edge's normal along the way's, or against it.
  const RealVector &of_edge = m, &of_way = n;
  const Real length = sqrt(plane::dot(n, n) * plane::dot(m, m));
  const exact::ExactAngle t{plane::dot(of_edge, of_way) / length,
                            (turning_edge ? plane::cross(of_edge, of_way) : plane::cross(of_way, of_edge)) / length};
  for (const exact::ExactAngle& rotation : {t, exact::ExactAngle{-t.cos, -t.sin}}) {
    const double angle = std::atan2(rough(rotation.sin), rough(rotation.cos));
    if (sector.holds(angle) && witness(angle)) sector.add(rotation, AngleDepth::kClosed);
  }
}

bool meet_on_way(const FreeSector& sector, std::size_t i, std::size_t k, double angle, double tolerance) {
  const FreeQuestion& q = sector.question();
  const RoughCurve c = sector.rough_curve(i, angle), d = sector.rough_curve(k, angle), way = q.way->rough(angle, 1);
  const auto held = [&](const RoughCurve& first, const RoughCurve& second) {
    const std::vector<RoughMeeting> all = rough_meetings(way, first, tolerance / 1000);
    return std::any_of(all.begin(), all.end(), [&](const RoughMeeting& m) {
      const double near = tolerance + m.off;
      const bool ahead = q.way->both_ways || dot(q.way->rough_unit(angle), m.at) >= -near;
      return ahead && first.holds(m.at, near) && passes(second, m.at, near) && sector.possible(angle, m.at, near);
    });
  };
  return held(c, d) || held(d, c);
}

}  // namespace

void find_single_on_way(FreeSector& sector, std::size_t i) {
  const FreeQuestion& q = sector.question();
  const bool both = q.way->both_ways;
  for (const Real& at : {q.level, both ? -q.level : Real()}) {
    const double far = rough(at);
    const auto witness = [&](double angle) {
      const RoughPoint s = far * q.way->rough_unit(angle);
      return passes(sector.rough_curve(i, angle), s, q.tolerance) && sector.possible(angle, s, q.tolerance);
    };
    sector.solve(passing(q, sector.pairs()[i], q.way->at(at)), witness);
  }
  touching_way(sector, i);
}

void find_corner_on_way(FreeSector& sector, std::size_t i, std::size_t k) {
  const FreeQuestion& q = sector.question();
  const double span = sector.span(),
               reach = margin::kRootReach *
                       std::max({sector.spots().travel(i), sector.spots().travel(k), sector.half() * sector.level()}) /
                       sector.half();
  const auto polynomial = [&](int quarters) {
    const ExactSectorCurve way = q.way->exact_sector(quarters);
    const auto all = ordered(sector.exact_form(i, quarters), sector.exact_form(k, quarters), way);
    const auto [f, g] = meeting_lines(all);
    const auto at = plane::meeting(f, g);
    return !all[0]->line && at.w.is_zero() ? where_one(at) : meeting_polynomial(*all[0], at);
  };
  for (const RootPlace& place : meeting_places(sector.form(i), sector.form(k), q.way->sector(sector.middle()), span)) {
    const double angle = sector.middle() + 2 * std::atan(place.u),
                 tolerance = margin::kRotatedMeeting * q.tolerance + place.tolerance * reach;
    if (place.tolerance > margin::kWideRootPlace || meet_on_way(sector, i, k, angle, tolerance))
      sector.add_roots(place, polynomial);
  }
}

}  // namespace findspace::plane
