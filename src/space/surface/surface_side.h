// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// On which side of a closed surface a point lies, by the triangles above it; where the line up from the point meets an
// edge, the line is displaced by infinitesimals. Guarantee: exact. Cost: the triangles over the point. Keywords: point
// in polyhedron, winding number, symbolic perturbation.
#pragma once

#include "space/convolution/ray_boxes.h"
#include "space/polytope/real_vector.h"

namespace findspace::space {

enum class SurfaceSide { kInside, kOn, kOutside };

/// Inside: behind the surface, which bounds a solid. `near`: the point, rounded. The tree is that of the body.
SurfaceSide side_of(const RayBody& body, const BoxTree& tree, const RealVector& point, const Vector& near);

}  // namespace findspace::space
