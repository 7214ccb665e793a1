// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Which demands of a formula contradict each other. `cells` lists, for every cell of the overlay of its sign maps,
// which demands are met there; they come from exact signs, so what is decided from them is exact. A set C of demands is
// a conflict if the formula holds in no cell even when all demands outside C are dropped.
//
// Guarantee: the result is minimal, every proper subset leaves room (a deletion filter). It is also smallest, of least
// count, where the search for smaller ones ended within its steps: a cell that leaves room without demands must be hit
// by one more demand that fails there, so conflicts are hitting sets. Cost: a pass over the cells for each demand for a
// minimal one; the search for a smaller one takes at most kMostSteps passes, and no more than the work limit leaves.
// Source: Chinneck, "Feasibility and infeasibility in optimization" (2008), chapter 6; Reiter (1987) for hitting sets.
// Keywords: minimal unsatisfiable subset, irreducible infeasible subsystem, IIS, unsat core.
#pragma once

#include <cstddef>
#include <vector>

#include "formula/explain/failing_cells.h"

namespace findspace::formula {

struct Conflict {
  std::vector<std::size_t> atoms;  // in the formula's order
  bool smallest = false;           // no conflict has fewer
};

/// Precondition: the formula holds in no cell. Empty if it is false without any atom.
Conflict find_conflict(FailingCells& cells);

/// A minimal set of demands without which the formula holds in a cell, of those that the cell does not meet.
std::vector<std::size_t> find_correction(const Demands& demands, const MetDemands& cell);

}  // namespace findspace::formula
