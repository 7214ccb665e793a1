// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a convex body B is from the surfaces of A at many positions, in doubles: the least over the triangles and
// balls of A of the signed distance of the position to their difference with B, which is convex. Below 0 B meets a
// surface. Guarantee: right to margin::kNumbersOff of the coordinates. Cost: a few differences with the triangles
// nearby, each some hundred nanoseconds; each is made exactly when first needed. Keywords: mesh distance, GJK, bounding
// volume hierarchy.
#pragma once

#include <memory>
#include <vector>

#include "distance/search/grown_set.h"
#include "plane/base/lazy.h"
#include "space/surface/surface_set.h"

namespace findspace::distance {

class ConvexGap {
 public:
  /// Of A that differences are kept of.
  static constexpr std::size_t kMostTriangles = 1 << 14;
  static bool few(const space::SurfaceSet& a);

  ConvexGap(std::shared_ptr<const space::SurfaceSet> a, space::BodyPart b);

  /// Of B moved by p.
  double operator()(const space::Vector& p) const;
  /// What it may be off there.
  double error(const space::Vector& p) const;

 private:
  using Triangle = plane::Lazy<ConvexDistance>;
  double distance(const space::SurfaceSet::Sheet& sheet, const Triangle& triangle, int face,
                  const space::Vector& p) const;

  std::shared_ptr<const space::SurfaceSet> a_;
  space::BodyPart b_;
  space::GridBox box_;  // of B without its radius
  double radius_, size_ = 0;
  std::vector<std::unique_ptr<Triangle[]>> triangles_;  // of each sheet
  std::vector<ConvexDistance> balls_;
};

}  // namespace findspace::distance
