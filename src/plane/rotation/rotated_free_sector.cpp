// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotated_free_sector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plane/base/search_work.h"

namespace findspace::plane {

using exact::ExactAngle;
using exact::Real;
using Kind = ContactPair::Kind;

RotatedEquation rotated_dot(const RealVector& v, const RealVector& w, Real c, bool back) {
  return {plane::dot(v, w), plane::cross(w, v), std::move(c), back};
}

RotatedEquation rotated_gap(const RealVector& v, const RealVector& w, const Real& r) {
  return rotated_dot(Real(2) * v, w, plane::dot(v, v) + plane::dot(w, w) - r * r);
}

RotatedEquation line_equation(const ContactCurves& curves, const ContactPair& k, const Real& away) {
  if (k.kind == Kind::kFixedEdge) {
    const EdgeFeature& a = curves.fixed().edges[k.fixed];
    const RoundFeature& b = curves.rotating().rounds[k.rotating];
    const RealVector n = exact_normal(a);
    return rotated_dot(n, b.center, plane::dot(n, a.p) + times_length(b.radius - away, n));
  }
  const RoundFeature& a = curves.fixed().rounds[k.fixed];
  const EdgeFeature& b = curves.rotating().edges[k.rotating];
  const RealVector n = exact_normal(b);
  return rotated_dot(n, a.center, times_length(a.radius - away, n) + plane::dot(n, b.p), true);
}

FreeSector::FreeSector(const FreeQuestion& question, const ContactTies& ties, std::vector<ContactPair> pairs,
                       double middle, double half)
    : q_(question), middle_(middle), half_(half), level_(question.level.to_double()), pairs_(std::move(pairs)) {
  for (const ContactPair& k : pairs_) {
    forms_.push_back(q_.curves.sector(k, middle_));
    const auto same = [&](const ContactPair& m) { return ties.alike(k, m); };
    alike_.push_back(std::size_t(std::find_if(pairs_.begin(), pairs_.end(), same) - pairs_.begin()));
  }
  spots_ = MeetingSpots(q_, pairs_, middle_, half_);
}

bool FreeSector::possible(double angle, RoughPoint s, double tolerance) const {
  if (!q_.far && std::abs(s) > level_ + tolerance) return false;  // far: F may come into being anywhere
  return !surely_meets(q_.rotating.rotated(std::polar(1.0, angle)), q_.open, s, q_.either_way, tolerance);
}

void FreeSector::add(ExactAngle t, AngleDepth depth) {
  constexpr long kOfEvent = 6;  // cells: it is sorted, and compared
  count_cells(kOfEvent);
  const double d = exact::Angle{t, Real()}.degrees();
  if (holds(d * kPi / 180)) found.push_back({d, std::move(t), depth});
}

void FreeSector::count_root(AngleDepth depth) {
  constexpr long kRational = 5, kClosed = 40, kDeep = 230;  // cells, as measured
  count_cells(depth == AngleDepth::kDeepRoot ? kDeep : depth == AngleDepth::kClosedRoot ? kClosed : kRational);
}

const ExactSectorCurve& FreeSector::exact_form(std::size_t i, int quarters) {
  exact_forms_.resize(4 * pairs_.size());
  auto& form = exact_forms_[std::size_t(quarters & 3) * pairs_.size() + i];
  if (!form) form = q_.curves.exact_sector(pairs_[i], quarters & 3);
  return *form;
}

}  // namespace findspace::plane
