// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of a scene of the plane as exact sets. Cost: side by side, that of building each.
#pragma once

#include <string>
#include <vector>

#include "io/scene/scene.h"
#include "plane/complex/cell_complex.h"

namespace findspace::io {

/// Of these shapes; notes about what had to be rounded are added. Throws Error; kUnsupported in space.
std::vector<plane::Region> regions_of(const Scene& scene, const std::vector<plane::ShapePtr>& shapes,
                                      std::vector<std::string>& notes);
/// The note about so many points of a shape, which rotations put on the grid.
std::string rotated_note(const Scene& scene, const std::string& name, std::size_t points, double largest);

}  // namespace findspace::io
