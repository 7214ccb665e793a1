// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sign maps on rays of solids taken by their surfaces, without convex parts: gamma1 at level 0, above 0 of large ones
// (space/convolution/facet_rays.h), and from 0 of a ball; eta1, mu and delta1 in a single solid at level 0, below 0 of
// large ones, and up to 0 of a ball; gamma2 of polyhedra, and of a single ball. Guarantee: exact on every line. Cost:
// one convolution a pair of solids.
#pragma once

#include <vector>

#include "distance/planar/shape_pair.h"
#include "space/convolution/ray_solids.h"
#include "space/rays/ray_sources.h"

namespace findspace::formula {

/// Pairs of triangles up to which the convex parts of both are quicker.
inline constexpr std::size_t kFewPairs = 1500;

/// One sign map: the least, or the greatest, of several. No sources: surfaces do not answer.
struct SurfaceRays {
  std::vector<space::RaySourcePointer> sources;
  bool least = true;

  exact::Tried<space::RayRow> try_row(int j) const;
  /// Of one map; of none where it is null.
  static SurfaceRays of(space::RaySourcePointer source) {
    SurfaceRays rays;
    if (source) rays.sources.push_back(std::move(source));
    return rays;
  }
  /// As RaySource::searched().
  bool searched() const;
};

/// `which` is kGamma1, kGamma2, kEta1, kMu or kDelta1; the level in grid steps.
SurfaceRays surface_rays(distance::Which which, const std::vector<space::RaySolid>& b,
                         const std::vector<space::RaySolid>& a, const exact::Real& level, const space::RayGrid& grid);

}  // namespace findspace::formula
