// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether a solid is the hull of equal balls: a ball, a capsule, a box with all edges rounded. Its faces are spheres,
// cylinders and planes, the spheres' centres C have one radius r, and each face lies in the boundary of Q = hull(C) +
// r. A closed surface that lies in the boundary of the convex Q is all of it. A face lies there where its edges do, and
// it is on their inner side: on a sphere the normals of the edges are in the cone of normals at its centre, on a
// cylinder in that of an edge of hull(C), and on a plane they lie over a face of hull(C). Edges are lines and
// circles, along which extreme values have closed forms. Guarantee: proved, up to 1e-9 of the sizes. Keywords: rounded
// polytope, offset, fillet.
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>

#include "io/cad/cad_model.h"

namespace findspace::cad {

std::optional<io::CadRounded> rounded_of(const TopoDS_Shape& solid);

}  // namespace findspace::cad
