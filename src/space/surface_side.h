// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// On which side of a closed surface a point lies, by the number of triangles above it. Guarantee: exact. Cost: the
// triangles over the point. Keywords: point in polyhedron, parity.
#pragma once

#include <optional>

#include "space/ray_boxes.h"
#include "space/real_vector.h"

namespace findspace::space {

/// Whether the surface encloses the point (`near`: rounded), which does not lie on it; nothing where the line up from
/// the point meets an edge. The tree is that of the body.
std::optional<bool> encloses(const RayBody& body, const BoxTree& tree, const RealVector& point, const Vector& near);

}  // namespace findspace::space
