// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A region on the lattice lines of three axes at once: its surface, and what lines of one axis alone tell badly:
//   connectivity   two intervals that share a lattice point of the region are certainly one component; a component
//                  whose lattice points are all joined so is `certified`. Beyond that, intervals of neighbouring lines
//                  that overlap count as joined, as in ray_summary.h, and splinters go with what is near them
//                  (ray_connect.h);
//   volume         of the surface, so walls parallel to an axis stand where they are; a component that holds no lattice
//                  point has the greatest of the volumes that the lines of one axis give it (those across a thin wall).
// Guarantee: the lattice points of a certified component lie in one connected set, exactly; whether two components are
// one is not claimed. Cost: three ray maps, and the lattice points in the region. Keywords: connected components,
// tri-dexel.
#pragma once

#include "space/rays/ray_summary.h"
#include "space/rays/ray_surface.h"

namespace findspace::space {

struct RayAxes {
  RaySummary summary;
  RaySurface surface;
};

/// As ray_surface(). Intervals without end are cut at the lattice.
RayAxes ray_axes(const RayLattice& lattice, const std::function<std::unique_ptr<RaySource>(int axis)>& source,
                 const std::function<bool(std::int8_t)>& inside,
                 const std::function<void(const RayGrid&, const RayRow&)>& watch = {});

}  // namespace findspace::space
