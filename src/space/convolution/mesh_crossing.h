// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a closed surface crosses itself: whether two of its triangles show a place that the solid behind one and the
// solid behind the other both cover (space/convolution/ray_overlap.h, 1 to 4). Parts of a surface that touch, from
// outside or across a slit of no width, do not cross. Guarantee: exact, the same for any number of threads. Cost: the
// pairs of triangles whose boxes meet, in parallel. Keywords: self-intersection, mesh validation.
#pragma once

#include <array>
#include <optional>

#include "space/convolution/ray_boxes.h"

namespace findspace::space {

/// Two faces that cross, the least such pair by number; nothing if there are none.
std::optional<std::array<int, 2>> crossing_faces(const RaySheet& sheet);

}  // namespace findspace::space
