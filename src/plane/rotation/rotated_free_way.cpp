// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The events of FreeSector for positions on a way only (free_way.h): where a contact curve passes the ends of what
// counts of the way, where it touches the way or lies along it, where two curves meet on it.

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/plane.h"
#include "plane/rotation/curve_meetings.h"
#include "plane/rotation/rotated_free_sector.h"

namespace findspace::plane {

using exact::Real;
using Kind = ContactPair::Kind;

namespace {

bool passes(const RoughCurve& c, RoughPoint s, double tolerance) {
  const double off = c.line ? dot(c.normal, s) - c.offset() : length(s - c.center) - std::abs(c.radius);
  return std::abs(off) <= tolerance && c.holds(s, tolerance);
}

}  // namespace

void FreeSector::single_on_way(std::size_t i) {
  const bool both = q_.way->both_ways;
  for (const Real& at : {q_.level, both ? -q_.level : Real()}) {
    const double far = rough(at);
    const auto witness = [&](double angle) {
      const RoughPoint s = far * q_.way->rough_unit(angle);
      return passes(q_.curves.rough(pairs_[i], angle), s, q_.tolerance) && possible(angle, s, q_.tolerance);
    };
    solve(passing(pairs_[i], q_.way->at(at)), witness);
  }
  touching_way(i);
}

/// The curve passes a place s of the way.
FreeSector::Equation FreeSector::passing(const ContactPair& k, const RealVector& s) const {
  const ContactFeatures &fixed = q_.curves.fixed(), &rotating = q_.curves.rotating();
  const RealVector f = q_.way->rotations ? RealVector{} : s, t = q_.way->rotations ? s : RealVector{};
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
void FreeSector::touching_way(std::size_t i) {
  const ContactPair& k = pairs_[i];
  const auto witness = [&](double angle) {
    const double tolerance = 10 * q_.tolerance;
    const RoughCurve c = q_.curves.rough(k, angle);
    if (c.line) return std::abs(c.offset()) <= tolerance && (q_.far || c.least() <= level_ + tolerance);
    const RoughPoint u = q_.way->rough_unit(angle), s = dot(c.center, u) * u;
    return passes(c, s, tolerance) && possible(angle, s, tolerance);
  };
  const RealVector n = left_normal(q_.way->along);
  const bool rotations = q_.way->rotations;
  if (k.kind == Kind::kRounds) {
    // dot(n, a - rotated b) = +-radius, n being rotated or not.
    const RoundFeature &a = q_.curves.fixed().rounds[k.fixed], &b = q_.curves.rotating().rounds[k.rotating];
    const Real own = plane::dot(n, rotations ? b.center : a.center), reach = times_length(a.radius + b.radius, n);
    for (const Real& c : {own - reach, own + reach})
      solve(rotated_dot(n, rotations ? a.center : b.center, c, rotations), witness);
    return;
  }
  const bool turning_edge = k.kind == Kind::kTurningEdge;
  const RealVector m =
      exact_normal(turning_edge ? q_.curves.rotating().edges[k.rotating] : q_.curves.fixed().edges[k.fixed]);
  if (rotations == turning_edge) {
    if (plane::cross(n, m).sign() == 0) solve(line_equation(k, Real()), witness);
    return;
  }
  // Parallel at two angles only: the edge's normal along the way's, or against it.
  const RealVector &of_edge = m, &of_way = n;
  const Real length = sqrt(plane::dot(n, n) * plane::dot(m, m));
  const exact::ExactAngle t{plane::dot(of_edge, of_way) / length,
                            (turning_edge ? plane::cross(of_edge, of_way) : plane::cross(of_way, of_edge)) / length};
  for (const exact::ExactAngle& rotation : {t, exact::ExactAngle{-t.cos, -t.sin}}) {
    const double angle = std::atan2(rough(rotation.sin), rough(rotation.cos));
    if (in_sector(angle) && witness(angle)) add(rotation);
  }
}

/// Two curves that meet on the way.
void FreeSector::corner_on_way(std::size_t i, std::size_t k) {
  const double span = std::tan(half_ / 2) * (1 + margin::kSectorSlack),
               reach = 4 * std::max({spots_.travel(i), spots_.travel(k), half_ * level_}) / half_;
  const auto polynomial = [&](int quarters) {
    const ExactSectorCurve way = q_.way->exact_sector(quarters);
    const auto all = ordered(exact_form(i, quarters), exact_form(k, quarters), way);
    const auto [f, g] = meeting_lines(all);
    const auto at = plane::meeting(f, g);
    return !all[0]->line && at.w.is_zero() ? exact::RotationPolynomial() : meeting_polynomial(*all[0], at);
  };
  for (const RootPlace& place : meeting_places(forms_[i], forms_[k], q_.way->sector(middle_), span)) {
    const double angle = middle_ + 2 * std::atan(place.u), tolerance = 100 * q_.tolerance + place.tolerance * reach;
    if (place.tolerance > margin::kWideRootPlace || meet_on_way(i, k, angle, tolerance)) add_roots(place, polynomial);
  }
}

bool FreeSector::meet_on_way(std::size_t i, std::size_t k, double angle, double tolerance) const {
  const RoughCurve c = q_.curves.rough(pairs_[i], angle), d = q_.curves.rough(pairs_[k], angle),
                   way = q_.way->rough(angle, 1);
  const auto held = [&](const RoughCurve& first, const RoughCurve& second) {
    const std::vector<RoughMeeting> all = rough_meetings(way, first, tolerance / 1000);
    return std::any_of(all.begin(), all.end(), [&](const RoughMeeting& m) {
      const double near = tolerance + m.off;
      const bool ahead = q_.way->both_ways || dot(q_.way->rough_unit(angle), m.at) >= -near;
      return ahead && first.holds(m.at, near) && passes(second, m.at, near) && possible(angle, m.at, near);
    });
  };
  return held(c, d) || held(d, c);
}

}  // namespace findspace::plane
