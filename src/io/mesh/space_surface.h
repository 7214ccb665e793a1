// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The boundary of an exact 3D set as a surface of convex faces: of the closure of its interior, outward, so sheets,
// lines and points that stand alone have none. Guarantee: vertices are the exact ones, rounded once; what is unbounded
// is left open where it leaves the last finite corners. Cost: linear in the cells of the grid, or in the facets.
// Keywords: boundary representation, mesh export.
#pragma once

#include "exact/number/real.h"
#include "formula/solid/solve_region.h"
#include "io/mesh/write_mesh.h"
#include "plane/contour/shape.h"
#include "space/box/box_complex.h"
#include "space/box/convex_set.h"

namespace findspace::io {

/// `step`: the length of a grid step in the scene's unit.
Surface box_surface(const space::BoxComplex& set, const exact::Real& step);
/// Of the polytope; a radius around it is not drawn. No faces below dimension 3.
Surface convex_surface(const space::ConvexSet& set, const exact::Real& step);

/// Of a boundary that is known; of boxes without sheets, lines and points.
Surface surface_of(const formula::ShapeBoundary& boundary, const exact::Real& step);

/// The boundary of a shape of space, and what it has besides that a surface cannot hold, or nothing.
struct SolidSurface {
  Surface surface;
  std::string lost{};
};
/// Of what one closed surface bounds (a mesh, a prism, moved or mirrored), of shapes with axis-parallel faces and of
/// convex polytopes. Throws Error(kUnsupported) for others, kGeometry for what has no volume or no bounds.
SolidSurface solid_surface(const plane::Shape& shape, const exact::Real& step);

}  // namespace findspace::io
