// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sets behind sign maps on rays: U, the positions at which the interiors of two bodies meet, and the complement of
// E, the positions at which B lies in A, as unions of open convex sets with a box around what is not simple about them.
// Guarantee: exact. Cost: the pairs of convex parts. Source: distances.md 1.4.
#pragma once

#include <vector>

#include "space/body/body.h"
#include "space/body/open_union.h"
#include "space/polytope/convex_region.h"

namespace findspace::distance {

struct RayCover {
  std::vector<std::vector<space::HalfSpace>> sets;  // all < 0
  std::vector<space::Extent> extents;
  space::RealVector low, high;    // the frontier lies inside
  bool beyond = false;            // what lies outside this box is covered
  bool all = false;               // everything is: nothing fits
  space::OpenUnion lazy() const;  // the same sets
};

/// U. Both bodies bounded, without radii.
RayCover overlap_sets(const space::Body& b, const space::Body& a);
/// The complement of E. A bounded and without radii, B without its radii unless A is convex.
RayCover outside_sets(const space::Body& b, const space::Body& a);

/// {a - b} without the parts' radii.
space::ConvexRegion difference_core(const space::BodyPart& a, const space::BodyPart& b);

space::ConvexRegion cut_from(const space::RealVector& low, const space::RealVector& high,
                             std::span<const space::HalfSpace> planes);

}  // namespace findspace::distance
