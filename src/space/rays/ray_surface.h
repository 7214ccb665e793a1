// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The surface of a region given on rays: marching cubes on the lattice of three ray maps, one along each axis, whose
// corners are inside or outside as the lines along x say, and whose vertices are the ends of intervals on the lattice
// lines: points of the true frontier. Guarantee: closed (every side of a face is run through once each way), outward;
// what is thinner than the lattice and meets no corner is missed. A region that goes on beyond the lattice is cut
// there, half a step outside. Cost: a bit a corner, and the faces. Source: Lorensen and Cline 1987; tri-dexel:
// Benouamer and Michelucci 1997; ambiguous faces part the inside, which makes neighbours agree. Keywords: isosurface,
// polygonisation, watertight mesh.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "space/rays/ray_map.h"

namespace findspace::space {

/// Points origin + step (i, j, k), 0 <= i < count[0] and so on, in parts of a grid step.
struct RayLattice {
  std::int64_t parts = 1;
  Point origin;
  std::int64_t step = 1;
  std::array<int, 3> count{};

  RayGrid grid(int axis) const;
  std::int64_t at(int axis, int k) const { return (axis == 0 ? origin.x : axis == 1 ? origin.y : origin.z) + k * step; }
};

/// Cubes, n along the longest side of the box (grid steps) and one more each way.
RayLattice ray_lattice(const Point& low, const Point& high, int n);
/// Cubes with sides of `step` grid steps.
RayLattice ray_lattice_by_step(const Point& low, const Point& high, std::int64_t step);

struct RaySurface {
  std::vector<std::array<double, 3>> vertices;  // in grid steps
  std::vector<std::array<int, 3>> faces;
  std::vector<std::array<int, 3>> inside;  // of each vertex: the lattice point beside it that is in the region
};

/// `source(axis)` gives the ray map on lattice.grid(axis); `inside(sign)` says which signs belong to the region. Where
/// given, `watch` sees every row, those of an axis in order.
RaySurface ray_surface(const RayLattice& lattice, const std::function<std::unique_ptr<RaySource>(int axis)>& source,
                       const std::function<bool(std::int8_t)>& inside,
                       const std::function<void(const RayGrid&, const RayRow&)>& watch = {});

}  // namespace findspace::space
