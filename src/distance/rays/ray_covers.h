// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The sets behind sign maps on rays: U, the positions at which the interiors of two bodies meet, and the complement of
// E, the positions at which B lies in A, as unions of open convex sets with a box around what is not simple about them.
// Guarantee: exact. Cost: the pairs of convex parts. Source: distances.md 1.4.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "plane/base/lazy.h"
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

/// A convex set grown by a ball.
struct GrownRegion {
  space::ConvexRegion core;
  exact::Real radius;
};

/// A union of closed convex sets: grown regions, and half spaces beyond the box that holds the rest.
struct ClosedSets {
  std::vector<GrownRegion> regions;
  std::vector<space::HalfSpace> beyond;
};

/// The closures of the open sets.
ClosedSets closures(const RayCover& cover);

/// A moving body B, bounded, and a fixed one A, of one scale. Their covers, and what these leave, are the same on all
/// lines: each is made when first needed and kept. Threads: safe.
class BodiesOnLines {
 public:
  BodiesOnLines(space::Body moving, space::Body fixed) : b_(std::move(moving)), a_(std::move(fixed)) {}

  const space::Body& b() const { return b_; }
  const space::Body& a() const { return a_; }

  /// Of U, of the complement of E in A or in what it is the complement of, or of that of D.
  enum class Of { kOverlap, kOutside, kOutsideBack };
  const RayCover& cover(Of of) const;
  /// What the cover leaves.
  const ClosedSets& rest(Of of) const;

 private:
  struct Kept {
    plane::Lazy<RayCover> cover;
    plane::Lazy<ClosedSets> rest;
  };
  const Kept& kept(Of of) const { return kept_[static_cast<std::size_t>(of)]; }

  space::Body b_, a_;
  std::array<Kept, 3> kept_;
};

/// {a - b} without the parts' radii.
space::ConvexRegion difference_core(const space::BodyPart& a, const space::BodyPart& b);

space::ConvexRegion cut_from(const space::RealVector& low, const space::RealVector& high,
                             std::span<const space::HalfSpace> planes);

}  // namespace findspace::distance
