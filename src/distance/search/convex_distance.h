// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Distances of points to closed convex sets, in doubles, for searches that confirm exactly what they find.
// Guarantee: to about 2^-44 of the coordinates, 2^-36 beside edges as sharp as 2^-16; sharper ones by exact corners, to
// 2^-44 again. Cost: some hundred nanoseconds; the corners of a sharp set are made once. Keywords: point to polytope
// distance, point to polygon distance.
#pragma once

#include "distance/search/solid_max_min.h"
#include "space/polytope/convex_region.h"

namespace findspace::distance {

/// {x : unit . x + shift <= 0}, the unit of length 1.
struct NearPlane {
  space::Vector unit;
  double shift = 0;
  double approx_value(const space::Vector& x) const { return space::dot(unit, x) + shift; }
};

/// {x : every plane <= 0}, bounded or not.
ConvexDistance distance_to(std::span<const space::HalfSpace> planes);
/// From a point to the place of the set that is nearest to it.
std::function<space::Vector(const space::Vector&)> way_to(std::span<const space::HalfSpace> planes);
std::function<space::Vector(const space::Vector&)> way_to(std::vector<NearPlane> planes);
/// A polygon, segment or point.
ConvexDistance distance_to_flat(const space::ConvexRegion& set);

}  // namespace findspace::distance
