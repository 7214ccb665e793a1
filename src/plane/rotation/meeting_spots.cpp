// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/meeting_spots.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"
#include "plane/rotation/curve_meetings.h"

namespace findspace::plane {
namespace {

using Kind = ContactPair::Kind;

/// How far a point is from a segment or a whole circle.
double away(const RoughCurve& c, RoughPoint from) {
  if (!c.line) return std::abs(length(from - c.center) - std::abs(c.radius));
  const RoughPoint way = c.q - c.p;
  const double square = std::norm(way), part = square > 0 ? std::clamp(dot(from - c.p, way) / square, 0.0, 1.0) : 0.0;
  return length(from - (c.p + part * way));
}

}  // namespace

double MeetingSpots::travel(const ContactCurves& curves, const ContactPair& k, double half) {
  const ContactFeatures &a = curves.fixed(), &b = curves.rotating();
  if (k.kind != Kind::kTurningEdge) {
    const RoundFeature& r = b.rounds[k.rotating];
    return half * std::hypot(r.x, r.y) * margin::kLongerTravel;
  }
  const EdgeFeature& e = b.edges[k.rotating];
  const double reach = std::max(std::hypot(e.x0, e.y0), std::hypot(e.x1, e.y1)) + std::abs(a.rounds[k.fixed].r);
  return half * reach * margin::kLongerTravel;
}

MeetingSpots::MeetingSpots(const FreeQuestion& q, std::span<const ContactPair> pairs, double middle, double half)
    : half_(half), tolerance_(q.tolerance), level_(q.level.to_double()), spots_(pairs.size() * pairs.size()) {
  for (const ContactPair& k : pairs) {
    curves_.push_back(q.curves.rough(k, middle));
    travels_.push_back(travel(q.curves, k, half));
  }
  const RoughSet there = q.rotating.rotated(std::polar(1.0, middle));
  const double rotated = half * q.rotating.reach() * margin::kLongerTravel;  // what B's points travel
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t k = i + 1; k < pairs.size(); ++k) {
      Spot& s = spots_[i * pairs.size() + k] = place(i, k);
      if (s.travel == std::numeric_limits<double>::infinity()) continue;
      const double tolerance = s.travel + tolerance_;
      s.possible = away(curves_[i], s.at) <= tolerance + travels_[i] &&
                   away(curves_[k], s.at) <= tolerance + travels_[k] && (q.far || length(s.at) <= level_ + tolerance) &&
                   !well_inside(there, q.open, s.at, tolerance + rotated);
    }
  }
}

/// Two lines: where they meet in the middle, unless they are nearly parallel; else within a radius of a centre.
MeetingSpots::Spot MeetingSpots::place(std::size_t i, std::size_t k) const {
  const RoughCurve &c = curves_[i], &d = curves_[k];
  Spot out;
  if (c.line && d.line) {
    const double sine = std::abs((std::conj(c.normal) * d.normal).imag());
    if (sine < 4 * half_) return {};
    out.at = rough_meetings(c, d, tolerance_).at(0).at;
    out.travel = 2 * std::max(travels_[i], travels_[k]) / (sine - 2 * half_) * 1.5;
    return out;
  }
  const bool first = !c.line && (d.line || std::abs(c.radius) <= std::abs(d.radius));
  out.at = first ? c.center : d.center;
  out.travel = std::abs(first ? c.radius : d.radius) + travels_[first ? i : k] + tolerance_;
  return out;
}

bool MeetingSpots::may_meet_at_level(std::size_t i, std::size_t k) const {
  const Spot& s = spot(i, k);
  return s.possible && std::abs(length(s.at) - level_) <= s.travel + tolerance_;
}

/// Whether the third curve comes to the spot of two.
bool MeetingSpots::may_come(std::size_t i, std::size_t k, std::size_t third) const {
  const Spot& s = spot(i, k);
  return s.possible && away(curves_[third], s.at) <= s.travel + travels_[third] + tolerance_;
}

}  // namespace findspace::plane
