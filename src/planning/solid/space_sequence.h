// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bodies placed one after another in space (distances.md 6.2), as sequential.h does in the plane. The positions of a
// body are taken in the first of three forms that the shapes and the formula have: boxes (all faces parallel to the
// axes), polyhedra among polyhedra (space_flat.h), or lines (any shape). Guarantee: the first two are exact, and so is
// the position; on lines the position belongs to the set, exactly, but between them there may be better ones, or some
// where no line meets any. Keywords: bottom-left placement, first fit, packing in 3D.
#pragma once

#include <memory>
#include <vector>

#include "planning/order/placement.h"
#include "planning/solid/space_flat.h"
#include "planning/solid/space_goals.h"

namespace findspace::planning {

/// The positions of a body at one of its angles, in one of the forms.
struct SpacePositions {
  std::size_t angle = 0;
  std::optional<space::BoxComplex> boxes;
  std::shared_ptr<const FlatPositions> flat;
  std::shared_ptr<const formula::RayWorld> rays;  // of the lines
  std::shared_ptr<const formula::Formula> formula;
  bool none = false;  // on lines: there are none for certain

  bool on_lines() const { return !boxes && !flat; }
  /// A box that holds what is bounded of them, in grid steps. Not for boxes.
  formula::RayWindow window() const;
  /// At most 0 in the set, and how the lines stand to it. Not for boxes.
  formula::RegionOnLines lines(const space::RayGrid& grid) const;
};

struct SpaceStep {
  std::optional<SpacePose> pose;
  SpaceBest best;
  std::vector<SpacePositions> positions;  // by angle
};

using SpacePlacement = SequenceOf<SpaceStep, space::RealVector>;

SpacePlacement place_in_space(const SpaceProblem& problem, const Limit& limit);

}  // namespace findspace::planning
