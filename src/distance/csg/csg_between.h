// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All distances of a solid that round ones are cut out of, where no provider takes it (the other one is such a solid,
// too, or a complement), between those of bodies: of cells that lie in the solid, and of what holds it. Every distance
// of a provider grows or falls with the set, so these enclose the true one. Guarantee: the value lies between the ends,
// exactly; they are mostly as far apart as a cell is long, an eighth of the solid, farther where the other one has
// passages as narrow. An end that no body tells is left out; so is one of how something fits into the only solid that
// can be replaced, if cells alone would tell it. Cost: two to four values of the pairs of bodies. Keywords: inner and
// outer approximation, octree, monotonicity.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "distance/solid/pair_distances.h"
#include "space/body/body.h"
#include "space/body/csg_solid.h"

namespace findspace::distance {

/// A solid that bodies stand for, and the pair of such a body, which moves, with the other one; in the same steps.
struct ReplacedSolid {
  std::shared_ptr<const space::CsgSolid> solid;
  std::function<PairDistances(std::shared_ptr<const space::Body>)> pair;
  bool moves = true;  // in what is asked for, too
};

/// `solids`: of one that can be replaced, or of both: then of that which shall fit into the other, or else of that
/// which cells fill better.
PairDistances pair_between(std::vector<ReplacedSolid> solids);

}  // namespace findspace::distance
