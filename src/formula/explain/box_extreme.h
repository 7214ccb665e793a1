// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The best value of a signed distance over a set of boxes, where the positions at its level 0 are made of boxes too. On
// the outer side of level 0 the distance is the one to that set, so the least value is that of two boxes. On the inner
// side it is the depth, which is known where the set is made of separate boxes: the depth in each is that below its
// faces. Guarantee: exact. Cost: pairs of boxes. Internal to explain.h. Keywords: signed distance, box union.
#pragma once

#include <optional>

#include "distance/answer/optimum.h"
#include "formula/solid/solve_space.h"

namespace findspace::formula {

struct BoxExtreme {
  exact::Real value;
  space::RealVector at{};  // in the closure of the set
  bool attained = false;   // in the set
};

/// Of gamma1, eta1 or delta1; in grid steps. Nothing where it is not known, or unbounded. The set is not empty.
std::optional<BoxExtreme> box_extreme(const SpaceSolver& solver, const Distance& distance, const space::BoxComplex& set,
                                      distance::Sense sense);

}  // namespace findspace::formula
