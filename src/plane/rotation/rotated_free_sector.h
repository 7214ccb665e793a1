// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The contact curves of one sector of angles, and the events (rotated_free_events.h) that are found in it. Equations of
// the angle are solved here; rotated_free_finders.h says which ones. Guarantee: an angle is exact, and lies in the
// sector. Cost: that of a root.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "exact/margins/plane.h"
#include "plane/rotation/contact_joints.h"
#include "plane/rotation/meeting_spots.h"
#include "plane/rotation/rotated_free_events.h"

namespace findspace::plane {

/// a cos + b sin = c; `back`: of minus the angle.
struct RotatedEquation {
  exact::Real a, b, c;
  bool back = false;
};
/// dot(v, rotated w) = c.
RotatedEquation rotated_dot(const RealVector& v, const RealVector& w, exact::Real c, bool back = false);
/// |v - rotated w| = r.
RotatedEquation rotated_gap(const RealVector& v, const RealVector& w, const exact::Real& r);
/// The line of a pair is `away` from the origin.
RotatedEquation line_equation(const ContactCurves& curves, const ContactPair& pair, const exact::Real& away);

class FreeSector {
 public:
  /// Angles between middle - half and middle + half; `pairs`: those that can touch in the sector.
  FreeSector(const FreeQuestion& question, const ContactTies& ties, std::vector<ContactPair> pairs, double middle,
             double half);

  const FreeQuestion& question() const { return q_; }
  double middle() const { return middle_; }
  double half() const { return half_; }
  double level() const { return level_; }
  /// Half the sector as the tangent of a half angle, a little wider.
  double span() const { return std::tan(half_ / 2) * (1 + margin::kSectorSlack); }

  const std::vector<ContactPair>& pairs() const { return pairs_; }
  const SectorCurve& form(std::size_t i) const { return forms_[i]; }
  /// The first curve on the line or circle of curve i.
  std::size_t alike(std::size_t i) const { return alike_[i]; }
  const MeetingSpots& spots() const { return spots_; }
  RoughCurve rough_curve(std::size_t i, double angle) const { return q_.curves.rough(pairs_[i], angle); }
  const ExactSectorCurve& exact_form(std::size_t i, int quarters);

  bool holds(double angle) const {
    return std::abs(std::remainder(angle - middle_, 2 * kPi)) <= half_ + margin::kSectorSlack;
  }
  /// Whether F can have a part within `tolerance` of s, at that angle.
  bool possible(double angle, RoughPoint s, double tolerance) const;

  /// Adds the solutions in the sector that `witness(angle)` admits.
  template <class Witness>
  void solve(const RotatedEquation& e, Witness witness);
  /// Adds the exact roots in a place of those that a rounded polynomial may have.
  template <class Make>
  void add_roots(const RootPlace& place, Make polynomial);
  void add(exact::ExactAngle t, AngleDepth depth);
  std::vector<FreeEvent> found;

 private:
  static void count_root(AngleDepth depth);

  const FreeQuestion& q_;
  double middle_, half_, level_;
  std::vector<ContactPair> pairs_;
  std::vector<SectorCurve> forms_;
  std::vector<std::size_t> alike_;
  std::vector<std::optional<ExactSectorCurve>> exact_forms_;  // by quarters and curve, where they were needed
  MeetingSpots spots_;
};

template <class Witness>
void FreeSector::solve(const RotatedEquation& e, Witness witness) {
  const double a = rough(e.a), b = rough(e.b), c = rough(e.c), norm = std::hypot(a, b);
  if (norm == 0 || std::abs(c) > norm * (1 + margin::kSectorSlack)) return;
  const double spread = std::acos(std::clamp(c / norm, -1.0, 1.0)), to = std::atan2(b, a);
  bool wanted = false;
  for (double angle : {to - spread, to + spread}) {
    const double here = e.back ? -angle : angle;
    wanted |= holds(here) && witness(here);
  }
  if (!wanted) return;
  const bool rational = e.a.is_rational() && e.b.is_rational() && e.c.is_rational();
  for (const exact::ExactAngle& t : rotations_where(e.a, e.b, e.c))
    add(e.back ? -t : t, rational ? AngleDepth::kClosed : AngleDepth::kClosedRoot);
}

/// The exact roots in a place of those that a rounded polynomial may have.
template <class Make>
void FreeSector::add_roots(const RootPlace& place, Make polynomial) {
  const double from = middle_ + 2 * std::atan(place.u - place.tolerance) - margin::kSectorSlack,
               to = middle_ + 2 * std::atan(place.u + place.tolerance) + margin::kSectorSlack;
  const int quarters = int(std::lround(from / (std::numbers::pi / 2)));
  const exact::RotationPolynomial f = polynomial(quarters);
  const AngleDepth depth = f.is_rational() ? AngleDepth::kRationalRoot
                           : f.is_closed() ? AngleDepth::kClosedRoot
                                           : AngleDepth::kDeepRoot;
  count_root(depth);
  for (exact::ExactAngle& t : f.rotations_between(from, to, quarters)) add(std::move(t), depth);
}

}  // namespace findspace::plane
