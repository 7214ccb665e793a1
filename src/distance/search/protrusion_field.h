// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The body that another protrudes from, as protrusion_rays.h asks for it: by its convex parts, or by the triangles of
// its surface, where a cell is bounded by the distance of its middle and its size, as no distance grows faster than a
// step, and where few triangles can be nearest in it by the linear program of their distances, which are convex
// (solid_max_min.h). What lies surely within is passed over by an octree that all searches share (field_boxes.h).
// Guarantee: doubles, bounds as in solid_max_min.h. Cost: of the surface some microseconds a cell. Keywords: distance
// field, branch and bound.
#pragma once

#include <memory>
#include <span>

#include "distance/search/round_solid.h"
#include "distance/search/solid_max_min.h"
#include "space/body/body.h"
#include "space/convolution/ray_solids.h"

namespace findspace::distance {

class ProtrusionField {
 public:
  virtual ~ProtrusionField() = default;
  /// The length of its diagonal.
  virtual double size() const = 0;
  /// The point of the solids that is farthest out, as in solid_max_min.h.
  virtual SolidMaxMin max_min(const Solids& solids, double slack, double share) const = 0;
  /// How far x may run along the way and stay farther than `cut` from the body, at least, and about that; x is farther.
  /// `size`: of all.
  virtual double run(const space::Vector& x, const space::Vector& way, double cut, double size) const = 0;
};

std::unique_ptr<ProtrusionField> field_of_parts(const space::Body& body);
/// Of the union of solids, which are not too far out. Distances inside are at most 0.
std::unique_ptr<ProtrusionField> field_of_surfaces(const std::vector<space::RaySolid>& solids);

}  // namespace findspace::distance
