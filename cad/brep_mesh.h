// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A solid of Open CASCADE as triangles with proved bounds. Its mesher proposes (read_faces.h); what is promised is
// checked here. In the plane of parameters of each face the triangles and the boundary polygon are the same chain:
// every inner edge runs both ways. Corners on shared edges are one corner for both faces. Each triangle has its bound
// (face_promise.h), and is divided until that is within the tolerance (refine_faces.h). Faces on planes keep the
// vertices of the file. Cost: that of the mesher, a few times where its first proposal is too coarse. Keywords:
// tessellation, B-rep.
#pragma once

#include <TopoDS_Shape.hxx>

#include "io/cad/cad_model.h"

namespace findspace::cad {

/// The solid with B-spline faces cut along their creases, where it has such.
TopoDS_Shape smooth_faces(const TopoDS_Shape& solid);

/// Throws Problem.
io::CadMesh mesh_of(const TopoDS_Shape& solid, double tolerance, std::size_t most);

}  // namespace findspace::cad
