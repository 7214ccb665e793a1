// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Regions of the primitive shapes: rings, discs, points, chains; all closed sets. Guarantee: exact.
#pragma once

#include <span>
#include <vector>

#include "plane/complex/cell_complex.h"
#include "plane/contour/shape.h"

namespace findspace::plane {

/// The closed set between an outer ring (counter-clockwise) and holes (clockwise), validated before (contour.h).
Region region_of_rings(std::span<const Contour> rings);
/// The union of such sets, each given by its rings, whose boxes are apart.
Region region_of_polygons(std::span<const std::span<const Contour>> polygons);
Region region_of_disc(const exact::Real& cx, const exact::Real& cy, const exact::Real& radius);
Region region_of_points(std::span<const GridPoint> points);
/// An open chain: its edges and vertices, a set without interior. The last edge of the contour is only its end point.
Region region_of_chain(const Contour& chain);

}  // namespace findspace::plane
