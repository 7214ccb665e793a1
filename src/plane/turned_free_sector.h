// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The events (turned_free_events.h) in one sector of angles. Guarantee: all of the sector, exact; some twice, some too
// many.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "plane/turned_free_events.h"

namespace findspace::plane {

class FreeSector {
 public:
  FreeSector(const FreeQuestion& question, double middle, double half);

  /// Adds to `found`. `pairs`: those that can touch in the sector.
  void run(std::vector<ContactPair> pairs);
  std::vector<FreeEvent> found;

 private:
  /// a cos + b sin = c; `back`: of minus the angle.
  struct Equation {
    exact::Real a, b, c;
    bool back = false;
  };
  static Equation turned_dot(const RealVector& v, const RealVector& w, exact::Real c, bool back = false);
  static Equation turned_gap(const RealVector& v, const RealVector& w, const exact::Real& r);

  void halve(const std::vector<ContactPair>& pairs);
  /// Where two curves meet in the middle of the sector, and how far that point can travel until its ends.
  struct Spot {
    bool possible = true;
    RoughPoint at;
    double travel = std::numeric_limits<double>::infinity();
  };
  const Spot& spot(std::size_t i, std::size_t k) const { return spots_[i * pairs_.size() + k]; }  // i < k
  void find_spots();
  Spot spot_of(std::size_t i, std::size_t k, const RoughSet& there) const;
  double travel(const ContactPair& k) const;
  bool may_be_at_level(const Spot& spot) const;
  bool may_meet(std::size_t i, std::size_t k, std::size_t third) const;
  bool possible(double angle, RoughPoint s, double room) const;
  bool in_sector(double angle) const;

  template <class Witness>
  void solve(const Equation& e, Witness witness);
  void single(std::size_t i);
  Equation line_equation(const ContactPair& k, const exact::Real& away) const;
  void touching(std::size_t i, std::size_t j);
  template <class Witness>
  void rounds_touch_line(const ContactPair& k, const ContactPair& m, Witness witness);
  bool opposite(const RoughCurve& c, const RoughCurve& d) const;
  template <class Witness>
  void parallel_lines(const ContactPair& k, const ContactPair& m, Witness witness);
  template <class Witness>
  void edge_along_edge(const ContactPair& k, const ContactPair& m, Witness witness);
  void corner(std::size_t i, std::size_t k);
  void meeting(std::size_t i, std::size_t k, std::size_t m);

  const ExactSectorCurve& exact_form(std::size_t i, int quarters);
  template <class Make>
  void add_roots(const RootPlace& place, Make polynomial);
  void add(exact::Turn t);

  const FreeQuestion& q_;
  double middle_, half_, level_, reach_;
  std::vector<ContactPair> pairs_;
  std::vector<SectorCurve> forms_;
  std::vector<std::optional<ExactSectorCurve>> exact_forms_;  // by quarters and curve, where they were needed
  std::vector<RoughCurve> curves_;                            // in the middle
  std::vector<double> travels_;
  std::vector<Spot> spots_;  // by pairs of curves
};

}  // namespace findspace::plane
