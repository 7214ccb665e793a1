// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What must hold between two parts besides their gap: {t : the conditions hold for the first at the origin and the
// second at t}, and whether t is in it. Conditions are formulas of docs/formula.md: `self` is a copy of the condition's
// first part, `other` one of its second. Guarantee: exact, arcs of level curves included. Cost: that of a formula over
// two shapes. Keywords: pairwise constraint, greatest distance, relative position.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "formula/planar/solve.h"
#include "packing/problem/problem.h"
#include "plane/complex/shared_region.h"

namespace findspace::packing {

/// The formula of a condition; throws Error with line and column.
formula::Formula parse_condition(const std::string& where, int dimension = 2);

/// The same where `other` moves: one way is that of `self`, so it goes back.
formula::Formula for_other(const formula::Formula& where);

/// A condition of two parts as one of the two turned by -90 degrees: its directions are turned with them.
std::string turned_back(const std::string& where);

/// The greatest level that a condition compares a distance with, or 0. Two parts farther apart than that are as good
/// as infinitely far apart.
double greatest_level(const std::vector<PairCondition>& conditions, int dimension = 2);

class PairFormula {
 public:
  /// Both shapes on one grid with steps of this size, in the problem's unit.
  PairFormula(const Problem& problem, std::size_t first, const plane::SharedRegion& a, std::size_t second,
              const plane::SharedRegion& b, const exact::Real& step);
  /// The condition that the interiors do not meet, and that the two keep this distance.
  static PairFormula apart(const plane::SharedRegion& a, const plane::SharedRegion& b, const Fraction& distance,
                           const exact::Real& step);

  /// Whether all conditions hold with the second part at (x, y).
  bool holds(const Fraction& x, const Fraction& y) const;
  /// Where each of them holds, in steps of the grid.
  std::vector<plane::Region> regions() const;

 private:
  PairFormula() = default;
  /// One of the two, `moving`, is at the position asked for.
  void add(const std::string& where, const plane::SharedRegion& self, const plane::SharedRegion& other,
           const char* moving, const exact::Real& step);

  struct Condition {
    std::shared_ptr<const formula::Solver> solver;
    formula::Formula where;
  };
  std::vector<Condition> conditions_;
};

}  // namespace findspace::packing
