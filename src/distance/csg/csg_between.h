// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// All distances of a solid that round ones are cut out of, where no provider takes it (the other one is such a solid,
// too, or a complement), between those of bodies: of cells that lie in the solid, and of what holds it. Every distance
// grows or falls with the set, so these enclose the true one: values, least values, and signs on lines. Guarantee: the
// value lies between the ends, exactly; they are mostly as far apart as a cell is long, an eighth of the solid, farther
// where the other one has passages as narrow. An end that no body tells is left out; so is one of how something fits
// into the only solid that can be replaced, if cells alone would tell it. Signs are 0 where the ends do not tell them.
// Work is limited (csg_work.h): what is not found then is left between wider ends.
// Cost: two to four answers of the pairs of bodies. Keywords: inner and outer approximation, octree, monotonicity.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "distance/csg/csg_pair.h"
#include "distance/solid/pair_distances.h"
#include "space/body/body.h"
#include "space/body/csg_solid.h"
#include "space/rays/ray_sources.h"

namespace findspace::distance {

/// What is told of a body in the place of a solid, beside the other one; in the same steps. The maps and least values
/// are of B in A as they are asked for, whichever of them the body stands for.
struct BesideBody {
  PairDistances pair;  // the body moves
  std::function<exact::Tried<space::RaySourcePointer>(Which, const exact::Real&, const std::optional<AlongWay>&,
                                                      const space::RayGrid&)>
      map;
  std::function<TriedAnswer(Which)> least;
  std::function<TriedAnswer(Which, const AlongWay&)> least_along;
};

/// A solid that bodies stand for.
struct ReplacedSolid {
  std::shared_ptr<const space::CsgSolid> solid;
  std::function<BesideBody(std::shared_ptr<const space::Body>)> beside;
  bool moves = true;  // in what is asked for, too
};

class DistancesBetween {
 public:
  /// `solids`: of one that can be replaced, or of both: then of that which shall fit into the other, or else of that
  /// which cells fill better. `size`: no two positions at which the boxes about both meet are farther apart.
  DistancesBetween(std::vector<ReplacedSolid> solids, exact::Real size);

  PairDistances pair() const;
  /// On lines, perhaps along a direction.
  exact::Tried<space::RaySourcePointer> map(Which which, const exact::Real& level, const std::optional<AlongWay>& way,
                                            const space::RayGrid& grid) const;
  /// As solid_least().
  TriedAnswer least(Which which) const;
  /// As ray_directional_least().
  TriedAnswer least_along(Which which, const AlongWay& way) const;

 private:
  struct Source;
  class Rays;
  std::shared_ptr<const Source> source_;
};

}  // namespace findspace::distance
