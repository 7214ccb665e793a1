// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The events (rotated_free_events.h) in one sector of angles. Guarantee: all of the sector, exact; some twice, some too
// many. Three curves of which two touch at every angle (contact_joints.h) are passed over: where they hold B, the third
// touches one of the two. Curves on one circle are solved for once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "exact/margins/plane.h"
#include "plane/rotation/contact_joints.h"
#include "plane/rotation/meeting_spots.h"
#include "plane/rotation/rotated_free_events.h"

namespace findspace::plane {

class FreeSector {
 public:
  FreeSector(const FreeQuestion& question, const ContactTies& ties, double middle, double half);

  /// Adds to `found`. `pairs`: those that can touch in the sector.
  void run(std::vector<ContactPair> pairs);
  std::vector<FreeEvent> found;

 private:
  /// a cos + b sin = c; `back`: of minus the angle.
  struct Equation {
    exact::Real a, b, c;
    bool back = false;
  };
  static Equation rotated_dot(const RealVector& v, const RealVector& w, exact::Real c, bool back = false);
  static Equation rotated_gap(const RealVector& v, const RealVector& w, const exact::Real& r);

  void halve(const std::vector<ContactPair>& pairs);
  bool possible(double angle, RoughPoint s, double tolerance) const;
  bool in_sector(double angle) const;

  template <class Witness>
  void solve(const Equation& e, Witness witness);
  void single(std::size_t i);
  Equation line_equation(const ContactPair& k, const exact::Real& away) const;
  void touching(std::size_t i, std::size_t j);
  bool opposite(const RoughCurve& c, const RoughCurve& d) const;
  template <class Witness>
  void parallel_lines(const ContactPair& k, const ContactPair& m, Witness witness);
  template <class Witness>
  void edge_along_edge(const ContactPair& k, const ContactPair& m, Witness witness);
  void corner(std::size_t i, std::size_t k);
  void meeting(std::size_t i, std::size_t k, std::size_t m);

  // On a way only: rotated_free_way.cpp.
  void single_on_way(std::size_t i);
  void touching_way(std::size_t i);
  void corner_on_way(std::size_t i, std::size_t k);
  Equation passing(const ContactPair& k, const RealVector& s) const;
  bool meet_on_way(std::size_t i, std::size_t k, double angle, double tolerance) const;

  const ExactSectorCurve& exact_form(std::size_t i, int quarters);
  template <class Make>
  void add_roots(const RootPlace& place, Make polynomial);
  void add(exact::ExactAngle t);

  const FreeQuestion& q_;
  const ContactTies& ties_;
  double middle_, half_, level_;
  std::vector<ContactPair> pairs_;
  std::vector<SectorCurve> forms_;
  std::vector<std::size_t> alike_;  // by curve: the first one on the same line or circle
  /// The angles at which two or three lines and circles meet; `second`: added to `found`.
  struct Solved {
    bool looked = false;
    std::vector<std::pair<RootPlace, bool>> places;
    template <class Find>
    void look(Find find);
  };
  std::map<std::array<std::size_t, 3>, Solved> solved_;       // by `alike_`, ascending
  std::vector<std::optional<ExactSectorCurve>> exact_forms_;  // by quarters and curve, where they were needed
  MeetingSpots spots_;
};

/// The solutions of the equation in the sector that `witness(angle)` admits.
template <class Witness>
void FreeSector::solve(const Equation& e, Witness witness) {
  const double a = rough(e.a), b = rough(e.b), c = rough(e.c), norm = std::hypot(a, b);
  if (norm == 0 || std::abs(c) > norm * (1 + margin::kSectorSlack)) return;
  const double spread = std::acos(std::clamp(c / norm, -1.0, 1.0)), to = std::atan2(b, a);
  bool wanted = false;
  for (double angle : {to - spread, to + spread}) {
    const double here = e.back ? -angle : angle;
    wanted |= in_sector(here) && witness(here);
  }
  if (!wanted) return;
  for (const exact::ExactAngle& t : rotations_where(e.a, e.b, e.c)) add(e.back ? -t : t);
}

/// The exact roots in a place of those that a rounded polynomial may have.
template <class Make>
void FreeSector::add_roots(const RootPlace& place, Make polynomial) {
  const double from = middle_ + 2 * std::atan(place.u - place.tolerance) - margin::kSectorSlack,
               to = middle_ + 2 * std::atan(place.u + place.tolerance) + margin::kSectorSlack;
  const int quarters = int(std::lround(from / (std::numbers::pi / 2)));
  for (exact::ExactAngle& t : polynomial(quarters).rotations_between(from, to, quarters)) add(std::move(t));
}

}  // namespace findspace::plane
