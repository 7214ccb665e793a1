// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What must hold between two solids besides their gap, at any relative position, as pair_formula.h in the plane: `self`
// is a copy of the condition's first part, `other` one of its second. holds() decides. slack() steers a search: by how
// much a formula holds, or minus by how much it fails; an atom counts by how far its distance is from its level, `and`
// is the least and `or` the greatest. What is only just possible, as a contact, may fail by a little. A distance
// changes by no more than a solid moves, so a move shorter than the slack keeps the formula true; not so those along a
// direction, which are known of solids with axis-parallel faces. Guarantee: holds() is exact, slack() is that of
// doubles. Cost: gaps and reaches of solids with flat faces in doubles; other distances by their exact values.
// Keywords: pairwise constraint, greatest distance, 1-Lipschitz.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formula/solid/solve_space.h"
#include "packing/solid_problem/solid_problem.h"
#include "space/phi/phi_union.h"

namespace findspace::packing {

/// Throws Error where a formula is none, or of solids in a form of which its distances are not known.
void check_conditions(const SolidProblem& problem, const std::string& place);

class SolidPairFormula {
 public:
  /// Of a copy of `first` in the form a and one of `second` in the form b. Both must live as long.
  SolidPairFormula(const SolidProblem& problem, std::size_t first, const SolidForm& a, std::size_t second,
                   const SolidForm& b);

  /// Whether all conditions hold with b moved by u, in units.
  bool holds(const std::array<Fraction, 3>& u) const;
  /// What it holds by beyond `room`; of atoms that no place holds by that much, beyond minus `contact`.
  double slack(const space::Vector& u, double room, double contact) const;
  /// Whether a distance is along a direction: it may change by more than a solid moves.
  bool jumps() const { return jumps_; }

 private:
  struct Condition {
    std::shared_ptr<const formula::SpaceSolver> solver;
    formula::Formula where;
  };

  struct Margins {
    double room, contact;
  };
  /// Of a node that is to be true, or false.
  double slack(const Condition& c, const formula::Node& node, bool wanted, const space::Vector& u,
               const Margins& margins) const;
  double slack(const Condition& c, const formula::Atom& atom, bool wanted, const space::Vector& u,
               const Margins& margins) const;
  /// Whether it holds in contact alone, or at one level.
  bool is_tight(const formula::Atom& atom, bool wanted, double room) const;
  double value(const Condition& c, const formula::Distance& distance, const space::Vector& u) const;
  double reach(const space::Vector& u) const;

  double steps_;                        // in a unit
  double gap_;                          // of the two at least
  std::optional<space::PhiUnion> phi_;  // where all parts are polytopes on a common grid
  double phi_steps_ = 1;
  std::vector<space::Vector> corners_a_, corners_b_;  // in units; none where a part is round
  std::vector<Condition> conditions_;
  bool jumps_ = false;
};

}  // namespace findspace::packing
