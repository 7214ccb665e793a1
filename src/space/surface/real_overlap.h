// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether the interiors of two solids meet, B moved to any real position: ray_overlap.h, which takes those on rays. So
// a candidate for a position of contact is decided from one at which they overlap, without convex parts. Guarantee:
// exact in every degenerate position. Cost: the pairs of triangles whose boxes meet, less than a microsecond each where
// doubles tell their signs, else some ten. Keywords: collision detection, contact.
#pragma once

#include <memory>
#include <span>

#include "space/convolution/ray_boxes.h"
#include "space/polytope/real_vector.h"
#include "space/surface/surface_set.h"

namespace findspace::space {

/// Where positions of contact are looked for: the solids on two sides of the surface, or the one within the other.
enum class TouchSide { kOutside, kInside };

class RealOverlap {
 public:
  /// Keeps references. `a_inside_out`: A is the complement of the solid that its surface bounds.
  RealOverlap(const SurfaceSet::Sheet& a, const SurfaceSet::Sheet& b, bool a_inside_out);

  /// Pairs of triangles that showed the last overlaps: tried first.
  using Recent = std::vector<std::array<int, 2>>;
  bool interiors_meet(const RealVector& p, Recent& recent) const;
  bool interiors_meet(const RealVector& p) const {
    Recent none;
    return interiors_meet(p, none);
  }

  /// Whether they do at all positions that are off by no more in any coordinate, as the recent pairs tell.
  bool surely_meet(const Vector& p, double off, const Recent& recent) const;
  /// Whether one pair tells that they do in all of the convex hull.
  bool surely_meet(std::span<const Vector> hull, double off, const Recent& recent) const;

  /// A, inside out where that is asked for.
  const RayBody& a() const { return inside_out_ ? *inside_out_ : a_.body; }
  const RayBody& b() const { return b_.body; }

 private:
  bool pieces_inside(const RealVector& p) const;

  const SurfaceSet::Sheet& a_;
  const SurfaceSet::Sheet& b_;
  std::unique_ptr<const RayBody> inside_out_;
};

}  // namespace findspace::space
