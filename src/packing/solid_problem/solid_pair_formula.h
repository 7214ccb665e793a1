// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What must hold between two solids besides their gap, at any relative position, as pair_formula.h in the plane: `self`
// is a copy of the condition's first part, `other` one of its second. holds() decides. slack() steers a search: by how
// much a formula holds, or minus by how much it fails; an atom counts by how far its distance is from its level, `and`
// is the least and `or` the greatest. A distance changes by no more than a solid moves, so a move shorter than the
// slack keeps the formula true. Guarantee: holds() is exact, slack() is that of doubles. Cost: gaps and reaches of
// solids with flat faces in doubles; other distances by their exact values. Keywords: pairwise constraint, greatest
// distance, 1-Lipschitz.
#pragma once

#include <memory>
#include <vector>

#include "formula/solid/solve_space.h"
#include "packing/solid_problem/solid_problem.h"
#include "space/phi/phi_union.h"

namespace findspace::packing {

class SolidPairFormula {
 public:
  /// Of a copy of `first` in the form a and one of `second` in the form b. Both must live as long.
  SolidPairFormula(const SolidProblem& problem, std::size_t first, const SolidForm& a, std::size_t second,
                   const SolidForm& b);

  /// Whether all conditions hold with b moved by u, in units.
  bool holds(const std::array<Fraction, 3>& u) const;
  double slack(const space::Vector& u) const;

 private:
  struct Condition {
    std::shared_ptr<const formula::SpaceSolver> solver;
    formula::Formula where;
    bool reversed;  // `self` is the second part
  };

  double slack(const Condition& c, const formula::Node& node, const space::Vector& u) const;
  double slack(const Condition& c, const formula::Atom& atom, const space::Vector& u) const;
  double value(const Condition& c, const formula::Distance& distance, const space::Vector& u) const;
  double reach(const space::Vector& u) const;

  double steps_;                        // in a unit
  std::optional<space::PhiUnion> phi_;  // where all parts are polytopes on a common grid
  double phi_steps_ = 1;
  std::vector<space::Vector> corners_a_, corners_b_;  // in units; none where a part is round
  std::vector<Condition> conditions_;
};

}  // namespace findspace::packing
